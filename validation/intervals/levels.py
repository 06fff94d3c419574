"""Do intervals by the compliance of a pair hold? python validation/intervals/levels.py [--contacts 240] [--seed 50600]

Solves random contacts of true shape by the compliance of the pair on the levels 1, 2 and 3, as `solve_reference` does,
and compares semi-axes, peak pressure and approach with nodal contact on the meshes of the levels 3 and 4, on the same
block. There each quantity is corrected by two half spaces on the same cells, pressed to the same ellipse, whose exact
answer is known, and extrapolated. Plain meshes of the levels 2, 3 and 4, extrapolated with the order that they show,
have no half spaces; they are uncertain by 0.03 %, and the largest distance of the reference from them is printed.
Prints how often the interval of the levels contains the reference, from two levels, from three, and from those that
0.2, 0.1 and 0.05 % take, and how large errors and intervals are, and writes a row for each contact. Where 0.05 % takes
the fourth level, the third is counted. One of eight contacts is a pocket, whose approach has no limit and is left out;
of the others, half have shoulders from 1.06 to 2 semi-axes away, at contact angles up to 40 degrees. The effect of the
far boundary is the same in both and is not tested here: validation/benchmarks/intervals.py does that. An interrupted
run continues where it stopped.

The constants of `fembearing.check.contact.reference` were chosen on seeds 100 to 118, 50000 to 50037, 50400 to
50459 and 50520 to 50579; all others test them.
"""

import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from analytic.errors import FembearingError
from analytic.scene import Contact, Material
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.check.contact.meshed_region import Boundary
from fembearing.check.contact.reference import ends_before_shoulder, estimates_of_pair, on_level
from fembearing.check.contact.refinement import COMPARED, FORMAL_ORDERS
from fembearing.fem.contact import press
from fembearing.fem.elasticity import surface_mass
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.half_space import curvatures_under, exact_quantities
from fembearing.fem.measure import Quantities, measured_quantities, nodal_pressure, product, ratio, within_ellipse
from fembearing.fem.pixel_contact import press_pair
from fembearing.fem.solution import MeshSolution, pressed
from fembearing.fem.twin import QUARTERS, flat_race, twin_of
from fembearing.grid_convergence import UNSTEADY, observed_order
from fembearing.mesh.race import block_of_race
from fembearing.mesh.recipe import load_recipe
from validation.study import Out, Row, continued, numbers, out, run, show

HERE = Path(__file__).parent
RECIPE = load_recipe("race")
MATERIALS = [
    Material(name=name, youngs_modulus=modulus, poisson_ratio=ratio, density=1.0, source="typical")
    for name, modulus, ratio in (
        ("steel", 206e9, 0.3),
        ("silicon nitride", 310e9, 0.26),
        ("bronze", 110e9, 0.34),
        ("PEEK", 3.6e9, 0.38),
    )
]
SHAPE = ("pair", "ball", "race", "conformity", "size", "axis_ratio", "shoulder", "contact_angle")
COLUMNS = (
    *("seed", *SHAPE),
    *(f"{name}_{part}_{level}" for level in (2, 3) for name in COMPARED for part in ("error", "stated")),
    *(f"{name}_plain" for name in COMPARED),
    *("seconds", "trouble"),
)
POCKETS = 8  # one of so many seeds is a pocket
LARGEST = 0.42  # semi-axis over the ball's radius
ACCURACIES = (2e-3, 1e-3, 5e-4)
OF_TWIN = 4.0  # order of what half spaces leave
ROUNDS = 3  # the ellipse of the half spaces follows from their own factors
ORDERS = (2.5, 5.0)  # least and greatest order with which plain levels are extrapolated


def main(
    contacts: Annotated[int, typer.Option(help="Number of contacts.")] = 240,
    seed: Annotated[int, typer.Option(help="First seed.")] = 50600,
    folder: Out = HERE,
) -> None:
    seeds = {(str(each),): each for each in range(seed, seed + contacts)}
    report(continued(folder / "levels_coverage.csv", COLUMNS, seeds, lambda each: [compared(each)]))


def ball_and_race(rng: np.random.Generator) -> dict[str, Any]:
    """Radii, m, of a ball, its groove and the race along rolling, and which race it is; the angle of a contact, rad."""
    radius = 10 ** rng.uniform(-3, np.log10(0.02))
    groove = 2 * radius * (0.5025 + 0.0975 * rng.random() ** 2)
    angle = rng.uniform(0, 0.7)
    ring = radius / rng.uniform(0.06, 0.35) / np.cos(angle)  # half the pitch diameter over the cosine
    pair, rolling = ("inner", ring - radius) if rng.random() < 0.5 else ("outer", -ring - radius)
    return {
        "ball_radius": radius,
        "groove_radius": groove,
        "rolling_radius": rolling,
        "pair": pair,
        "contact_angle": angle,
    }


def drawn_materials(rng: np.random.Generator) -> dict[str, Material]:
    ball, race = (MATERIALS[number] for number in rng.choice(4, 2, p=[0.5, 0.2, 0.15, 0.15]))
    return {"ball_material": ball, "race_material": race}


def pressed_to(contact: Contact, size: float) -> Contact:
    """The contact under the load at which Hertz's larger semi-axis has a size, m; it has 1 N now."""
    unit = hertz_quantities(contact)
    return replace(contact, load=float((size / max(unit.semi_axis_rolling, unit.semi_axis_transverse)) ** 3))


def random_contact(seed: int) -> Contact:
    """Conformity 0.5025 to 0.6, semi-axes of 0.003 to 0.42 of the ball's radius, all pairs of four materials."""
    rng = np.random.default_rng(seed)
    shape = ball_and_race(rng) | drawn_materials(rng)
    groove, angle = shape["groove_radius"], shape["contact_angle"]
    size = shape["ball_radius"] * 10 ** rng.uniform(-2.5, np.log10(LARGEST))
    is_near, distances = rng.random() < 0.5, size * rng.uniform(1.06, 2.0, 2)
    if seed % POCKETS == 0:
        shape |= {"pair": "pocket", "rolling_radius": -groove * rng.uniform(1.0, 1.5)}
        is_near = False
    shoulder = far_shoulder = widest = 0.95 * groove
    if is_near:
        # The far shoulder is no lower than the bottom of the groove.
        far_shoulder = min(max(distances[rng.integers(2)], groove * np.sin(angle)), widest)
        shoulder = min(distances[0], widest)
    shape |= {"shoulder": shoulder, "far_shoulder": far_shoulder, "contact_angle": angle if is_near else 0.0}
    return pressed_to(Contact(**shape, load=1.0), size)


def compared(seed: int) -> Row:
    """One contact: relative errors of the extrapolated values, and their stated uncertainties."""
    contact = random_contact(seed)
    row = {"seed": str(seed), "pair": contact.pair, "ball": contact.ball_material.name}
    row |= {"race": contact.race_material.name, "contact_angle": f"{contact.contact_angle:.3f}"}
    start, solved, plain, axes = time.process_time(), [], [], expected_semi_axes(contact, geometry="real")
    if not ends_before_shoulder(contact):
        return row | {"trouble": "plain levels"}
    try:
        for level in RECIPE.levels:
            on = on_level([contact], [axes], recipe=RECIPE, level=level)
            solved.append(press_pair(on.compliance.at(contact.load), load=contact.load))
            plain.append(pressed(on.bodies[0], load=contact.load, expected=axes))
            axes = solved[-1].semi_axes
    except FembearingError as problem:
        return row | {"trouble": " ".join(str(problem).split())}
    row |= {
        "conformity": f"{contact.groove_radius / contact.ball_radius / 2:.5f}",
        "size": f"{max(axes) / contact.ball_radius:.4f}",
        "axis_ratio": f"{axes[1] / axes[0]:.2f}",
        "shoulder": f"{contact.nearer_shoulder / axes[1]:.2f}",
    }
    whole = dict.fromkeys(FORMAL_ORDERS, Boundary())
    before, last = (product(mesh.quantities, factors_of(mesh)) for mesh in plain[2:])
    coarser = extrapolated(plain[1:])
    for name in COMPARED:
        corrected = getattr(last, name)
        truth = corrected + (corrected - getattr(before, name)) / ((plain[3].level / plain[2].level) ** OF_TWIN - 1)
        row[f"{name}_plain"] = f"{coarser[name] / truth - 1:.2e}"
        for count in (2, 3):  # from the first two levels, and from the second and third
            found = estimates_of_pair(solved[:count], whole, recipe=RECIPE)[name]
            row |= {
                f"{name}_error_{count}": f"{found.limit / truth - 1:.2e}",
                f"{name}_stated_{count}": f"{found.mesh:.2e}",
            }
    return row | {"seconds": f"{time.process_time() - start:.1f}", "trouble": ""}


def factors_of(mesh: MeshSolution) -> Quantities:
    """Exact over computed of each quantity of two half spaces on the cells of a mesh, in an ellipse of that size."""
    pair, (rolling, _) = mesh.pair, mesh.pair.semi_axes
    twin = twin_of(mesh.contact, recipe=RECIPE, level=mesh.level, footprint=pair.footprint)
    x, y = (pair.upper.mesh.doflocs[axis, pair.upper.touching] / rolling for axis in range(2))
    flat = flat_race(block_of_race(mesh.contact, RECIPE, mesh.level, pair.footprint, False))
    mass = surface_mass(flat.mesh, flat.touching) / rolling**2
    found = mesh.quantities
    ellipse = found.semi_axis_rolling / rolling, found.semi_axis_transverse / rolling
    factors = ratio(found, found)
    for _ in range(ROUNDS):
        axes = ellipse[0] * factors.semi_axis_rolling, ellipse[1] * factors.semi_axis_transverse
        curved = curvatures_under(axes, load=1.0, modulus=1.0)
        force, approach, _ = press(
            compliance=twin.compliance,
            drift=QUARTERS * twin.drift,
            gap=(curved[0] * x**2 + curved[1] * y**2) / 2,
            lever=np.ones_like(x),
            load=1 / QUARTERS,
            start=within_ellipse(x, y, axes),
        )
        area = np.asarray(mass.sum(axis=1)).ravel()
        computed = measured_quantities(x, y, force, nodal_pressure(force, mass), area, load=1.0, approach=approach)
        factors = ratio(exact_quantities(axes, load=1.0, modulus=1.0), computed)
    return factors


def extrapolated(meshes: Sequence[MeshSolution]) -> dict[str, float]:
    """Each quantity from three plain levels, with the order that they show."""
    sizes = [1 / mesh.level for mesh in meshes]
    truth = {}
    for name in COMPARED:
        values = [getattr(mesh.quantities, name) for mesh in meshes]
        order = float(np.clip(observed_order(values, sizes) or UNSTEADY, *ORDERS))
        truth[name] = values[-1] + (values[-1] - values[-2]) / ((sizes[-2] / sizes[-1]) ** order - 1)
    return truth


def report(rows: list[Row]) -> None:
    solved = [row for row in rows if not row["trouble"]]
    heads = ("quantity", "interval holds", "error, median", "90 %", "worst", "stated, median", "worst error/stated")
    pocket = np.array([row["pair"] == "pocket" for row in solved])
    errors, stated = (  # (quantities, levels, n); NaN where an error does not count
        np.array([[numbers(solved, f"{name}_{part}_{level}") for level in (2, 3)] for name in COMPARED])
        for part in ("error", "stated")
    )
    errors = np.abs(errors)
    errors[COMPARED.index("approach"), :, pocket] = np.nan
    for number, level in enumerate((2, 3)):
        shown = []
        for name, error, width in zip(COMPARED, errors[:, number], stated[:, number], strict=True):
            counts = ~np.isnan(error)
            parts = (*np.quantile(error[counts], (0.5, 0.9, 1.0)), np.median(width[counts]))
            shares = f"{np.sum(error <= width)} of {counts.sum()}", *(f"{part:.3%}" for part in parts)
            shown.append((name.replace("_", " "), *shares, f"{np.nanmax(error / width):.2f}"))
        show(heads, shown, f"levels to {level}: {len(solved)} contacts")
        hold = ~np.any(errors[:, number] > stated[:, number], axis=0)
        out.print(f"all four hold in {hold.sum()} of {hold.size}")
    for accuracy in ACCURACIES:  # on the second level, or on the third where the second's is wider than asked
        second = np.all(stated[:, 0] <= accuracy, axis=0)
        error, width = (np.where(second, part[:, 0], part[:, 1]) for part in (errors, stated))
        held = (
            f"{name.replace('_', ' ')} {np.sum(each <= wide)} of {np.sum(~np.isnan(each))}"
            for name, each, wide in zip(COMPARED, error, width, strict=True)
        )
        out.print(f"{accuracy:.2%} asked: {'; '.join(held)}; {np.sum(~second)} contacts on the third level")
    plain = np.abs([numbers(solved, f"{name}_plain") for name in COMPARED])
    plain[COMPARED.index("approach"), pocket] = np.nan
    farthest = ", ".join(f"{np.nanmax(each):.3%}" for each in plain)
    out.print(f"farthest from plain levels 2, 3 and 4, extrapolated, in the order of the table: {farthest}")
    for row in rows:
        if row["trouble"]:
            out.print(f"seed {row['seed']}, {row['pair']}: {row['trouble']}")


if __name__ == "__main__":
    run(main)
