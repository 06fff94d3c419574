"""Corrected Hertz against finite elements in bearings of the catalogue: python validation/catalogue/contacts.py

Takes bearings of several series and makers by their designation, presses each by a thrust of 0.02 to 0.2 of its static
load rating, and solves the contacts of both races by finite elements to 0.1 %. Prints the largest error of Hertz
corrected for finite geometry over its stated uncertainty, and writes catalogue_contacts.csv and catalogue_contacts.png
into this folder. Shoulders that the catalogue does not know are given 0.25 ball diameters. A
contact nearer to its shoulder than the fit allows is listed as outside, and not counted. Takes ten minutes on two
cores; an interrupted run continues where it stopped.
"""

import argparse
from dataclasses import fields, replace
from multiprocessing import Pool
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from rich.console import Console
from rich.progress import track
from rich.table import Table

from analytic.contact.finite_geometry import ContactShape, contact_shape, finite_geometry_factors
from analytic.contact.geometry import RACES, Race, with_shoulders
from analytic.errors import FembearingError
from analytic.progress import silent
from analytic.scene import Scene
from analytic.scenefile.read import parse_scene
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.check.contact.refinement import COMPARED, solve_reference
from fembearing.check.contact.scene_contact import heaviest_contact
from fembearing.mesh.recipe import load_recipe
from validation.rows import Row, read, write

mpl.use("agg")

HERE = Path(__file__).parent
BEARINGS = (
    *("608", "6000", "6004", "6008", "6020", "16005", "16010", "6805", "6905"),
    *("6200", "6203", "6205", "6208", "6220", "6300", "6304", "6308", "6312", "6403"),
    *("7005C", "7205C", "7210C", "7005A5", "7205A5", "7206A"),
    *("7204 BEP", "7205 BEP", "7208 BEP", "7212 BEP", "7305 BEP", "7308 BEP"),
)
SHARES = (0.02, 0.2)  # of C0, the thrust; spread evenly in its logarithm
SEED = 61
ACCURACY, LEVELS = 1e-3, (1, 2, 3)  # as the solves of validation/correction
UNKNOWN_SHOULDER = 0.25  # of the ball diameter
SCENE = """
name = "catalogue"
tolerance = "1 %"
[bearing]
catalog = "{bearing}"
[operation]
axial_load = "{load!r} N"
inner_speed = "0 rpm"
[friction]
coefficient = 0.1
"""
COLUMNS = (
    *("bearing", "race", "load_over_C0", "load", "ball_radius", *(field.name for field in fields(ContactShape))),
    *(f"{name}{part}" for name in COMPARED for part in ("", "_uncertainty", "_error", "_stated")),
    *("covered", "warnings", "trouble"),
)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=HERE, help="folder for the table and the figure")
    parser.add_argument("--jobs", type=int, default=2, help="processes")
    given = parser.parse_args()
    given.out.mkdir(parents=True, exist_ok=True)
    table, shares = given.out / "catalogue_contacts.csv", np.random.default_rng(SEED).random(len(BEARINGS))
    loads = [float(SHARES[0] * (SHARES[1] / SHARES[0]) ** share) for share in shares]
    known = read(table)
    done = {(row["bearing"], row["race"]) for row in known}
    ahead: list[tuple[str, Race, float]] = [
        (bearing, race, load)
        for bearing, load in zip(BEARINGS, loads, strict=True)
        for race in RACES
        if (bearing, race) not in done
    ]
    with Pool(given.jobs) as pool:
        for row in track(pool.imap(solved, ahead), total=len(ahead), console=Console(stderr=True)):
            known.append(row)
            write(known, table, COLUMNS)
    known = [compared(row) for row in known]
    write(known, table, COLUMNS)
    report(known, Console(width=120))
    draw(known, given.out / "catalogue_contacts.png")


def scene_of(bearing: str, load: float) -> Scene:
    """The bearing under a thrust, as a share of C0."""
    rating = parse_scene(SCENE.format(bearing=bearing, load=100.0), origin=bearing).bearing.static_load_rating
    assert rating is not None
    scene = parse_scene(SCENE.format(bearing=bearing, load=load * rating), origin=bearing)
    return replace(scene, bearing=with_shoulders(scene.bearing, UNKNOWN_SHOULDER))


def solved(task: tuple[str, Race, float]) -> Row:
    """One contact: its shape, and each quantity by finite elements over Hertz's."""
    bearing, race, share = task
    scene = scene_of(bearing, share)
    contact = heaviest_contact(scene, race)
    shape = vars(contact_shape(contact))
    row = {"bearing": bearing, "race": race, "load_over_C0": f"{share:.4f}", "load": repr(contact.load)}
    row |= {name: f"{float(value):.9g}" for name, value in shape.items()} | {"ball_radius": repr(contact.ball_radius)}
    try:
        recipe = replace(load_recipe("race"), levels=LEVELS)
        reference = solve_reference(contact, recipe=recipe, accuracy=ACCURACY, progress=silent)
    except FembearingError as problem:
        return row | {"trouble": " ".join(str(problem).split())}
    hertz = vars(hertz_quantities(contact))
    for name in COMPARED:
        part = reference.estimates[name]
        row |= {name: f"{part.value / hertz[name]:.7f}", f"{name}_uncertainty": f"{part.total:.2e}"}
    return row | {"trouble": ""}


def compared(row: Row) -> Row:
    """The row with the correction's error and its stated uncertainty."""
    shape = ContactShape(**{field.name: float(row[field.name]) for field in fields(ContactShape)})
    found = finite_geometry_factors(shape)
    row = row | {"covered": str(bool(found.covered)), "warnings": "; ".join(found.warnings)}
    if row["trouble"]:
        return row
    for name in COMPARED:
        factor, allowed = float(getattr(found.factors, name)), float(found.uncertainty[name])
        row |= {f"{name}_error": f"{factor / float(row[name]) - 1:.2e}", f"{name}_stated": f"{allowed:.2e}"}
    return row


def report(rows: list[Row], out: Console) -> None:
    """The largest errors over the stated uncertainties, of the contacts within the range of the fit."""
    inside = [row for row in rows if row["covered"] == "True" and not row["trouble"]]
    heads = (
        "quantity",
        "Hertz, worst",
        "corrected, rms",
        "worst",
        "stated, least",
        "worst error over stated",
        "within",
    )
    table = Table(*heads, title=f"{len(inside)} contacts of {len({row['bearing'] for row in inside})} bearings")
    for name in COMPARED:
        hertz = np.array([1 / float(row[name]) - 1 for row in inside])
        error, stated = (np.array([float(row[f"{name}_{part}"]) for row in inside]) for part in ("error", "stated"))
        worst = int(np.argmax(np.abs(error) / stated))
        table.add_row(
            name.replace("_", " "),
            f"{np.abs(hertz).max():.2%}",
            f"{np.sqrt(np.mean(error**2)):.3%}",
            f"{np.abs(error).max():.3%}",
            f"{stated.min():.3%}",
            f"{abs(error[worst]) / stated[worst]:.2f}, {inside[worst]['bearing']}, {inside[worst]['race']}",
            f"{np.sum(np.abs(error) <= stated)} of {len(inside)}",
        )
    out.print(table)
    for row in rows:
        if row not in inside:
            out.print(f"{row['bearing']}, {row['race']}: {row['trouble'] or row['warnings']}")


def draw(rows: list[Row], path: Path) -> None:
    """Error over stated uncertainty of every contact, by the size of the contact."""
    inside = [row for row in rows if row["covered"] == "True" and not row["trouble"]]
    figure = Figure(figsize=(7.5, 4.2), layout="constrained")
    panel = figure.subplots()
    size = np.array([float(row["size"]) for row in inside])
    for name, mark in zip(COMPARED, "os^D", strict=True):
        error, stated = (np.array([float(row[f"{name}_{part}"]) for row in inside]) for part in ("error", "stated"))
        panel.plot(size, error / stated, mark, markersize=4, markerfacecolor="none", label=name.replace("_", " "))
    for end in (-1, 1):
        panel.axhline(end, color="black", linewidth=1)
    panel.set_xlabel("b/r, Hertz's semi-axis over the ball's radius")
    panel.set_ylabel("error of corrected Hertz over stated uncertainty")
    panel.legend(fontsize=8)
    figure.savefig(path, dpi=130, metadata={"Software": None})


if __name__ == "__main__":
    main()
