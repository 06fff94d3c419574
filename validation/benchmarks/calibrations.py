"""The solver's measured constants, measured again: python validation/benchmarks/calibrations.py [--contacts 14]

Each line names a constant, its value and the new measurement, on random contacts of `intervals.py` as half spaces,
where Hertz is exact, or against boundary elements. Not repeated here: `HALF`, `FINEST`, `UNSTEADY` and `LEAST`, which
`intervals.py` tests, and `FADING`, which tests/check/contact/test_solution.py tests.
"""

from dataclasses import replace
from typing import Annotated

import numpy as np
import typer
from rich.progress import track

from analytic.contact.geometry import race_contact
from analytic.contact.hertz import contact_modulus, relative_curvatures
from analytic.scene import Contact
from analytic.scenefile.read import load_scene
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.check.contact.load_series import OFF_MESH
from fembearing.check.contact.refinement import COMPARED, FORMAL_ORDERS, STRIP_LEAST
from fembearing.fem.guess import MAJOR_SHRINKS, MINOR_GROWS, expected_semi_axes
from fembearing.fem.measure import STRIP
from fembearing.fem.series import NARROWEST, WIDEST
from fembearing.fem.solution import GOOD_GUESS, condensed_pair, fitted_solution, pressed, solve_on_mesh
from fembearing.grid_convergence import FINEST, HALF
from fembearing.mesh.recipe import load_recipe
from validation.benchmarks.intervals import random_contact
from validation.study import progress, run, show

SIZES = np.linspace(0.65, 1.35, 33)  # size of an ellipse over the size for which its mesh is made
SEED = 3000
SHOULDERS = (0.4e-3, 0.55e-3, 0.8e-3)  # m; the transverse semi-axis of Hertz's ellipse is 0.95 mm
POINTS = 256  # of the boundary elements, in each direction


def main(contacts: Annotated[int, typer.Option(help="Number of random contacts.")] = 14) -> None:
    drawn = [random_contact(np.random.default_rng(seed)) for seed in range(SEED, SEED + contacts)]
    chosen = [replace(each, shoulder=np.inf, far_shoulder=np.inf) for each in drawn]
    sized = [mesh_size_errors(each) for each in track(chosen, description="sizes", console=progress)]
    change, over_error = np.max(sized, axis=0)
    missed = np.nanmax(list(map(guess_errors, drawn)))
    beyond, plain = np.moveaxis([off_mesh_errors(each) for each in track(chosen, console=progress)], 1, 0)
    inside = (SIZES >= NARROWEST) & (SIZES <= WIDEST)
    rows = [
        ("GOOD_GUESS", f"{GOOD_GUESS}", f"a mesh for an ellipse {GOOD_GUESS:.0%} too large changes a quantity of the "
         f"third level by at most {change:.3%}, and by at most {over_error:.1f} times that level's own error"),
        ("MINOR_GROWS, MAJOR_SHRINKS", f"{MINOR_GROWS:g}, {MAJOR_SHRINKS:g}", "the first guess misses the ellipse of a "
         f"ball in a groove on the second level by up to {missed:.2%}"),
        ("OFF_MESH", f"{OFF_MESH:.2%}", f"at {SIZES.size} sizes from {SIZES[0]:g} to {SIZES[-1]:g} of the mesh's, the "
         f"error beyond the interval from the levels is {np.quantile(beyond, 0.95):.2%} (95 % quantile), worst "
         f"{np.max(beyond):.2%}"),
        ("NARROWEST, WIDEST", f"{NARROWEST:g}, {WIDEST:g}", "between them the largest error of the third level's "
         f"approach is {np.abs(plain[:, inside]).max():.2%}, outside {np.abs(plain[:, ~inside]).max():.2%}"),
    ]  # fmt: skip
    try:
        errors = ", ".join(f"{ours / other - 1:+.1%}" for ours, other in map(strip_shares, SHOULDERS))
    except ModuleNotFoundError as problem:
        errors = f"not measured, {problem.name} is not installed"
    words = "error of the third level's strip share against boundary elements"
    rows.append(("STRIP_LEAST", f"{STRIP_LEAST:.0%}", f"{words}: {errors}"))
    show(("constant", "value", "measured"), rows)


def guess_errors(contact: Contact) -> float:
    """Largest relative error of a guessed semi-axis on the true shapes; NaN for a contact that reaches a shoulder."""
    recipe = load_recipe("race")
    guess = expected_semi_axes(contact, geometry=recipe.geometry)
    found = fitted_solution(contact, recipe=recipe)
    return float(np.nan if found.pair.footprint.cut else np.abs(np.divide(guess, found.semi_axes) - 1).max())


def mesh_size_errors(contact: Contact) -> tuple[float, float]:
    """Two numbers on a mesh made for an ellipse 1 % too large.

    The largest relative change of a quantity of the third level, and its ratio to that level's error.
    """
    recipe, exact = load_recipe("hertzian"), vars(hertz_quantities(contact))
    ellipse = exact["semi_axis_rolling"], exact["semi_axis_transverse"]
    enlarged = (ellipse[0] * (1 + GOOD_GUESS), ellipse[1] * (1 + GOOD_GUESS))
    exact_mesh, other_mesh = (
        vars(solve_on_mesh(contact, recipe=recipe, level=recipe.levels[2], semi_axes=axes).quantities)
        for axes in (ellipse, enlarged)
    )
    change = max(abs(other_mesh[name] / exact_mesh[name] - 1) for name in COMPARED)
    error = max(abs(exact_mesh[name] / exact[name] - 1) for name in COMPARED)
    return change, change / error


def off_mesh_errors(contact: Contact) -> tuple[np.ndarray, np.ndarray]:
    """Of the approach at each of `SIZES`: its error beyond its interval, and the error of the third level."""
    recipe, hertz = load_recipe("hertzian"), hertz_quantities(contact)
    order = FORMAL_ORDERS["approach"]
    assert order is not None
    ellipse = hertz.semi_axis_rolling, hertz.semi_axis_transverse
    middle, fine = (condensed_pair(contact, recipe=recipe, level=n, semi_axes=ellipse) for n in recipe.levels[1:3])
    beyond, plain = [], []
    for size in SIZES:
        load = contact.load * size**3
        expected = size * ellipse[0], size * ellipse[1]
        values = [pressed(part, load=load, expected=expected).quantities.approach for part in (middle, fine)]
        exact = hertz.approach * size**2
        step = (values[1] - values[0]) / ((fine.level / middle.level) ** order - 1)
        left = abs((values[1] + step) / exact - 1) - HALF * abs(step) / exact - FINEST
        beyond.append(max(0.0, left))
        plain.append(values[1] / exact - 1)
    return np.array(beyond), np.array(plain)


def strip_shares(distance: float) -> tuple[float, float]:
    """The share of the load on the strip next to a shoulder, by the third level and by boundary elements.

    distance : of the shoulder from the centre of the contact, m
    """
    bearing, recipe = load_scene("6205-dry").bearing, load_recipe("hertzian")
    contact = replace(race_contact(bearing, "inner", contact_angle=0.3031, ball_load=372.0), shoulder=distance)
    semi_axes = fitted_solution(contact, recipe=recipe).pair.semi_axes
    ours = solve_on_mesh(contact, recipe=recipe, level=recipe.levels[2], semi_axes=semi_axes).shoulder
    return ours.strip_share, boundary_elements(contact, semi_axes=semi_axes, points=POINTS)["strip_share"]


def boundary_elements(contact: Contact, *, semi_axes: tuple[float, float], points: int) -> dict[str, float]:
    """The half space of Tamaas against a paraboloid that ends at the shoulder, where the grid ends as well.

    Raises ModuleNotFoundError where Tamaas is not installed.
    """
    from validation.peers.tamaas_bem import pressed

    low, high = -1.2 * semi_axes[1], contact.shoulder
    sides, middle = [2.4 * semi_axes[0], high - low], (np.arange(points) + 0.5) / points
    x, y = np.meshgrid((middle - 0.5) * sides[0], low + middle * sides[1], indexing="ij")
    curvature_x, curvature_y = relative_curvatures(contact)
    surface = -(float(curvature_x) * x**2 + float(curvature_y) * y**2) / 2
    modulus = contact_modulus(contact.ball_material, contact.race_material)
    # A residual of 1e-9: the conjugate gradients stagnate at 1e-12.
    pressure, moved = pressed(surface, sides=sides, modulus=modulus, load=contact.load, residual=1e-9)
    total, centroid = pressure.sum(), np.average(y, weights=pressure)
    beyond = np.append(0.0, np.cumsum(pressure.sum(axis=0))) / total
    return {
        "semi_axis_rolling": float(np.sqrt(5 * np.average(x**2, weights=pressure))),
        "semi_axis_transverse": float(np.sqrt(5 * np.average((y - centroid) ** 2, weights=pressure))),
        "approach": float(np.average(moved - surface, weights=pressure)),
        "centroid": float(centroid),
        "strip_share": 1 - float(np.interp((1 - STRIP) * high, np.linspace(low, high, points + 1), beyond)),
    }


if __name__ == "__main__":
    run(main)
