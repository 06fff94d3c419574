"""Solves for the correction of Hertz for finite geometry: python validation/correction/solve.py

Solves contacts of true shape by finite elements and stores each quantity over Hertz's, with its uncertainty, in
solves.csv for fit.py. Four sets have equal shoulders at zero contact angle: `fit`, a Sobol sequence over the box below;
`held out`, random contacts of that box; `bearing`, both races of the bearings in bearings.toml under random loads;
`beyond`, steel contacts outside the box, with shoulders nearer than it allows; the range of the fit now holds a half of
them. Two sets have unequal shoulders, down to 1.15 semi-axes, at contact angles up to 0.8 rad: `shoulders`, a Sobol
sequence, and `shoulders held out`, steel contacts of both races under the loads of catalogues. The fit uses `fit` and
`shoulders`.

`analytic.contact.finite_geometry.ContactShape` describes a contact; in elasticity nothing else matters. The rolling
curvatures are those of bearing series: with g = D cos(al)/d_m from 0 (thrust) to 0.325 (the heavy series 64), r/R is
g/(1 - g) on the inner and -g/(1 + g) on the outer race, from -0.25 to 0.48.
An interrupted run continues where it stopped.
"""

import subprocess
import tomllib
from collections.abc import Iterator
from dataclasses import replace
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path

import numpy as np
from scipy.stats import qmc

from analytic.contact.finite_geometry_fit import OFF_SHOULDER
from analytic.contact.hertz import contact_modulus
from analytic.errors import FembearingError
from analytic.scene import Contact, Material
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.check.contact.reference import solve_reference
from fembearing.check.contact.refinement import Wanted
from fembearing.mesh.recipe import load_recipe
from validation.study import Row, continued, read, run

HERE = Path(__file__).parent
SOLVES, BEARINGS = HERE / "solves.csv", HERE / "bearings.toml"
SEED = 20250
KEPT_BACK = 24  # number of the set `beyond` from which on they only test the uncertainty beyond the range
ACCURACY = 1e-3
LEVELS = (1, 2, 3)  # of the recipe; the fourth takes three times as long and halves the uncertainty
BOX = {  # least and greatest value
    "conformity": (0.505, 0.58),  # r_g/D
    "rolling_curvature": (-0.26, 0.48),  # r/R, below 0 on an outer race
    "size": (0.01, 0.45),  # Hertz's b/r; the mesh holds up to 0.5
    "ball_poisson_ratio": (0.2, 0.4),
    "race_poisson_ratio": (0.2, 0.4),
    "ball_share": (0.01, 0.99),  # share of the ball in the compliance 1/E*
    "shoulder": (0.42, 0.9),  # distance from the contact's centre over r
}
SIDES = {  # of the sets with unequal shoulders, in place of `shoulder` above
    "shoulder": (0.1, 0.9),
    "far_shoulder": (0.1, 1.05),
    "contact_angle": (0.0, 0.8),  # rad: the lands are parallel to the axis of the bearing
}
# Of the fit; both shoulders share one range, up to r_g/r. From 0.93 r_g on, where the profile has turned by 1.2 rad,
# the mesh ends the groove anyway.
RANGE = BOX | {"shoulder": (0.1, 2 * BOX["conformity"][1]), "contact_angle": SIDES["contact_angle"]}
QUANTITIES = ("semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach")
COLUMNS = [
    *("set", "number", "name", *BOX, "far_shoulder", "contact_angle", *QUANTITIES),
    *(f"{name}_uncertainty" for name in QUANTITIES),
    *("level", "solver", "date", "trouble"),
]
PRESSURES = (0.007, 0.028)  # p0/E* in the bearings: 0.8 to 3.2 GPa on steel
CATALOGUE = (0.01, 0.0217)  # p0/E* on steel at 0.02 to 0.2 C0, where 4.2 GPa are reached at C0: 1.1 to 2.5 GPa
# Parts of fembearing on which a solve depends
SOLVER = (
    *("fem", "mesh", "grid_convergence.py"),
    *(f"check/contact/{part}.py" for part in ("refinement", "meshed_region")),
)
MATERIALS = {  # E, nu; typical values
    "steel": (206e9, 0.3),
    "silicon nitride": (310e9, 0.26),
    "peek": (3.6e9, 0.38),
}
STEEL = {"ball_poisson_ratio": 0.3, "race_poisson_ratio": 0.3, "ball_share": 0.5}
Drawn = tuple[str, int, str, dict[str, float]]  # set, number, name, shape
RADIUS, MODULUS = 5e-3, 113e9  # r, m; E*, Pa; the ratios do not depend on them


def main() -> None:
    wanted = [
        *drawn("fit", 192),
        *drawn("held out", 48),
        *of_bearings(),
        *with_near_shoulders(36),
        *with_unequal_shoulders(88),
        *under_catalogue_loads(44),
    ]
    origin = {"solver": solver_commit(), "date": datetime.now(UTC).date().isoformat()}

    def row_of(task: Drawn) -> list[Row]:
        group, number, name, shape = task
        return [{"set": group, "number": str(number), "name": name} | origin | solved(shape)]

    tasks = {(group, str(number)): (group, number, name, shape) for group, number, name, shape in wanted}
    continued(SOLVES, COLUMNS, tasks, row_of, about=provenance())


def drawn(group: str, count: int) -> Iterator[Drawn]:
    """Shapes in the box: evenly spread for the fit, random for the held-out set."""
    if group == "fit":
        units = qmc.Sobol(len(BOX), rng=np.random.default_rng(SEED)).random_base2(int(np.ceil(np.log2(max(count, 1)))))
    else:
        units = np.random.default_rng(SEED + 1).random((count, len(BOX)))
    for number, unit in enumerate(units[:count]):
        share = dict(zip(BOX, unit, strict=True))
        shape = {name: low + share[name] * (high - low) for name, (low, high) in BOX.items()}
        low, high = max(BOX["shoulder"][0], OFF_SHOULDER * shape["size"]), BOX["shoulder"][1]
        yield group, number, "", shape | {"shoulder": low + share["shoulder"] * (high - low)}


def of_bearings() -> Iterator[Drawn]:
    """Both races of each bearing, each under two random loads."""
    rng, number = np.random.default_rng(SEED + 2), 0
    for bearing in tomllib.loads(BEARINGS.read_text("utf-8"))["bearing"]:
        angle = np.radians(bearing["contact_angle"])
        gamma = bearing["ball_diameter"] * np.cos(angle) / bearing["pitch_diameter"]
        (ball_modulus, ball_ratio), (race_modulus, race_ratio) = MATERIALS[bearing["ball"]], MATERIALS[bearing["race"]]
        softness = (1 - ball_ratio**2) / ball_modulus, (1 - race_ratio**2) / race_modulus
        for race, sign in (("inner", 1), ("outer", -1)):
            conformity = bearing["conformity"][race]
            top = np.arccos(1 - bearing["shoulder_height"] / conformity)  # the shoulder's angle on the profile
            for pressure in rng.uniform(*PRESSURES, 2):
                shape = {
                    "conformity": conformity,
                    "rolling_curvature": sign * gamma / (1 - sign * gamma),
                    "size": 0.1,
                    "ball_poisson_ratio": ball_ratio,
                    "race_poisson_ratio": race_ratio,
                    "ball_share": softness[0] / sum(softness),
                    "shoulder": 2 * conformity * np.sin(top - angle),
                }
                shape["size"] *= pressure * MODULUS / hertz_quantities(contact_of_shape(shape)).peak_pressure
                yield "bearing", number, f"{bearing['name']}, {race}", shape
                number += 1


def with_near_shoulders(count: int) -> Iterator[Drawn]:
    """Outside the box: two of three with shoulders nearer than it allows, one of three nearer than 1.15 semi-axes.

    Those from the number KEPT_BACK on are larger than the box allows, one of three.
    """
    rng = np.random.default_rng(SEED + 3)
    for number in range(count):
        if number % 3:
            size = rng.uniform(0.05, 0.4)
            shoulder = rng.uniform(max(0.12, size), BOX["shoulder"][0])
        else:
            size = rng.uniform(0.35, 0.48) if number < KEPT_BACK else rng.uniform(0.45, 0.5)
            shoulder = size * rng.uniform(1.0, OFF_SHOULDER)
        shape = STEEL | {
            "conformity": rng.uniform(0.508, 0.55),
            "rolling_curvature": rng.uniform(-0.2, 0.35),
            "size": size,
            "shoulder": max(shoulder, size),
        }
        yield "beyond", number, "", shape


def with_unequal_shoulders(count: int) -> Iterator[Drawn]:
    """Shapes of the box with two shoulders and a contact angle; the shoulders are spread evenly in their logarithm."""
    names = [*BOX, "far_shoulder", "contact_angle"]
    units = qmc.Sobol(len(names), rng=np.random.default_rng(SEED + 4)).random_base2(
        int(np.ceil(np.log2(max(count, 1))))
    )
    for number, unit in enumerate(units[:count]):
        share = dict(zip(names, unit, strict=True))
        shape = {name: low + share[name] * (high - low) for name, (low, high) in (BOX | SIDES).items()}
        yield "shoulders", number, "", shape | placed_shoulders(shape, share)


def placed_shoulders(shape: dict[str, float], share: dict[str, float]) -> dict[str, float]:
    """Both shoulders from 1.15 semi-axes on, at a share of the logarithm of their range.

    The far shoulder stands at the bottom of its groove at least, as in a counterbored ring.
    """
    placed = {}
    for name in ("shoulder", "far_shoulder"):
        low, high = max(SIDES[name][0], OFF_SHOULDER * shape["size"]), SIDES[name][1]
        placed[name] = float(low * (high / low) ** share[name])
    bottom = float(2 * shape["conformity"] * np.sin(shape["contact_angle"]))
    return placed | {"far_shoulder": max(placed["far_shoulder"], bottom)}


def under_catalogue_loads(count: int) -> Iterator[Drawn]:
    """Random steel contacts of both races in turn, with conformities and loads of catalogue bearings."""
    rng = np.random.default_rng(SEED + 5)
    for number in range(count):
        angle, sign = rng.uniform(*SIDES["contact_angle"]), (1, -1)[number % 2]
        gamma = rng.uniform(0.1, 0.3) * np.cos(angle)
        shape = STEEL | {
            "conformity": rng.uniform(0.515, 0.535),
            "rolling_curvature": sign * gamma / (1 - sign * gamma),
            "size": 0.1,
            "shoulder": 0.5,
            "contact_angle": angle,
        }
        shape["size"] *= rng.uniform(*CATALOGUE) * MODULUS / hertz_quantities(contact_of_shape(shape)).peak_pressure
        share = {name: rng.random() for name in ("shoulder", "far_shoulder")}
        yield "shoulders held out", number, "", shape | placed_shoulders(shape, share)


def contact_of_shape(shape: dict[str, float]) -> Contact:
    """A contact with the ratios of `shape`; its load gives Hertz's b/r the value `size`."""
    bodies = []
    for body, share in (("ball", shape["ball_share"]), ("race", 1 - shape["ball_share"])):
        ratio = shape[f"{body}_poisson_ratio"]
        modulus = MODULUS * (1 - ratio**2) / share
        bodies.append(Material(name=body, youngs_modulus=modulus, poisson_ratio=ratio, density=1.0, source="drawn"))
    assert abs(contact_modulus(*bodies) / MODULUS - 1) < 1e-12  # round-off
    curvature = shape["rolling_curvature"]
    contact = Contact(
        pair="inner" if curvature > 0 else "outer",
        ball_radius=RADIUS,
        groove_radius=2 * RADIUS * shape["conformity"],
        rolling_radius=RADIUS / curvature,
        shoulder=RADIUS * shape["shoulder"],
        far_shoulder=RADIUS * shape.get("far_shoulder", shape["shoulder"]),
        contact_angle=shape.get("contact_angle", 0.0),
        load=1.0,
        ball_material=bodies[0],
        race_material=bodies[1],
    )
    unit = hertz_quantities(contact).semi_axis_transverse
    return replace(contact, load=(RADIUS * shape["size"] / unit) ** 3)


def solved(shape: dict[str, float]) -> Row:
    """The shape and each quantity by finite elements over Hertz's."""
    row = {name: repr(float(value)) for name, value in shape.items()}
    contact = contact_of_shape(shape)
    recipe = replace(load_recipe("race"), levels=LEVELS)
    try:
        reference = solve_reference(contact, Wanted(recipe, accuracy=ACCURACY))
    except FembearingError as problem:
        return row | {"trouble": " ".join(str(problem).split())}
    hertz = vars(hertz_quantities(contact))
    for name in QUANTITIES:
        part = reference.estimates[name]
        row |= {name: f"{part.value / hertz[name]:.7f}", f"{name}_uncertainty": f"{part.total:.2e}"}
    unsettled = [name for name in QUANTITIES if not reference.estimates[name].settled]
    return row | {
        "level": str(reference.meshes[-1].level),
        "trouble": f"meshes do not settle in {' '.join(unsettled)}" if unsettled else "",
    }


def read_rows() -> list[Row]:
    """The stored rows; the oldest have no far shoulder and no contact angle."""
    return [
        row
        | {"far_shoulder": row.get("far_shoulder") or row["shoulder"], "contact_angle": row.get("contact_angle") or "0"}
        for row in read(SOLVES)
    ]


def provenance() -> list[str]:
    versions = (f"{package} {version(package)}" for package in ("fembearing", "numpy", "scipy", "scikit-fem"))
    return [
        "Contacts of ball and race: finite elements over Hertz, and relative half-widths of their 95 % intervals",
        "generator: python validation/correction/solve.py",
        f"seeds: {SEED} (fit, scrambled Sobol), {SEED + 1} (held out), {SEED + 2} (bearing), {SEED + 3} (beyond)",
        f"seeds_of_shoulders: {SEED + 4} (shoulders, scrambled Sobol), {SEED + 5} (shoulders held out)",
        f"mesh: recipe race, levels {', '.join(map(str, LEVELS))}, extrapolated",
        f"versions: {', '.join(versions)}",
    ]


def solver_commit() -> str:
    """The last commit that changed the solver, with + if the solver has changed since."""
    files = ["--", *(f"fembearing/{part}" for part in SOLVER), "meshes"]
    git = ["git", "-C", str(HERE.parents[1])]
    last = subprocess.run(
        [*git, "log", "-1", "--no-merges", "--format=%h", *files], capture_output=True, text=True, check=True
    ).stdout
    changed = subprocess.run([*git, "diff", "--quiet", "HEAD", *files], check=False).returncode
    return last.strip() + "+" * changed


if __name__ == "__main__":
    run(main)
