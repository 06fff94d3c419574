"""Gaps between deformed rough surfaces: python validation/film/elastic_gap.py [--check] [--jobs 2]

Presses generated surfaces on an elastic half space, writes the mean of their curves into the catalog's
corrections/elastic_gap.toml, which `analytic.surface.elastic_gap` reads, and prints it. Every surface counts with its
own sigma and slope. Surfaces are periodic and 20 correlation lengths wide. The gaussian autocorrelation has one curve;
the exponential one has one for each of several spacings, because its slope is that seen at the spacing.

With --check nothing is written. It compares the stored gaussian curve with an independent code
(published/elastic_gap.csv), and one surface with Tamaas: periodic, and one continued by its mirror images. It ends with
status 1 if a difference is larger than its tolerance. It also prints what mirror images in place of periods change.
"""

import os
import sys
from collections.abc import Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from importlib.metadata import version
from typing import Annotated, Any

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before numpy loads its threads

import numpy as np
import typer
from rich.progress import track

from analytic import catalog
from analytic.scene import Array, Autocorrelation
from analytic.surface.boundary_elements import pressed
from analytic.surface.elastic_gap import declared_gap_curve, elastic_area, elastic_log_gap
from analytic.surface.roughness import generated_surface
from validation.study import Jobs, numbers, out, progress, published, run, show

WIDTH = 20  # correlation lengths
SEED = 4000
KINDS = (("gaussian", 32, 20), ("exponential", 10, 20), ("exponential", 20, 20))  # points per length, surfaces
PRESSURES = (
    *(1.2, 1.05, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.225, 0.15, 0.1),
    *(0.07, 0.04, 0.02, 0.01, 0.005, 0.002, 0.001, 0.0005),
)
# Against the other code's means over 10 surfaces: so many standard errors of the difference of two means, and a
# floor for what both leave of the iteration, 0.1 % each, and of the mean slope of 640 points.
ERRORS, FLOOR = 3.0, 0.005
# Against Tamaas on one surface: the solver's own error, 1e-3 of the mean gap. Areas are counts of points, and which
# points at the rim of a contact have pressure is less certain.
SAME_GAP, SAME_AREA = 1e-3, 5e-3
TAMAAS_TOLERANCE = 1e-10  # of the complementarity that Tamaas calls its error
TAMAAS_PRESSURES = (0.7, 0.3, 0.1, 0.02)


def main(
    check: Annotated[bool, typer.Option("--check", help="Compare the stored table; write nothing.")] = False,
    jobs: Jobs = 1,
) -> None:
    if check:
        print_mirror_effect()
        sys.exit(not all([against_published(), against_tamaas(periodic=True), against_tamaas(periodic=False)]))
    write([mean_curve(*kind, jobs=jobs) for kind in KINDS])


def surface(kind: Any, points: int, seed: int, width: int = WIDTH) -> Array:
    """Heights of a periodic surface with the correlation length 1; points : per correlation length."""
    autocorrelation = Autocorrelation(kind=kind, length=1.0, spacing=1 / points)
    return generated_surface(
        rms_roughness=1.0, autocorrelation=autocorrelation, points=width * points, seed=seed
    ).heights


def gaps_and_areas(job: tuple[str, int, int]) -> Array:
    """(pressures, 2)"""
    states = pressed(surface(*job), PRESSURES, periodic=True)
    return np.array([(state.mean_gap, state.area_fraction) for state in states])


def mean_curve(kind: str, points: int, surfaces: int, *, jobs: int) -> dict[str, Any]:
    """One curve of the table; pressures rise."""
    todo = [(kind, points, SEED + number) for number in range(surfaces)]
    with ProcessPoolExecutor(jobs) as workers:
        done = track(workers.map(gaps_and_areas, todo), f"{kind}, {points} points", total=surfaces, console=progress)
        gap, area = np.moveaxis(np.array(list(done))[:, ::-1], 2, 0)
    return {
        "kind": kind,
        "spacing": 1 / points,
        "points": WIDTH * points,
        "surfaces": surfaces,
        "gap": gap.mean(axis=0),
        "spread": np.log(gap).std(axis=0, ddof=1),
        "area_fraction": area.mean(axis=0),
    }


def write(curves: list[dict[str, Any]]) -> None:
    path = catalog.path("corrections", "elastic_gap")
    packages = ", ".join(f"{name} {version(name)}" for name in ("fembearing", "numpy", "scipy"))
    lines = [
        "# Mean gap and real area of rough surfaces pressed on an elastic half space, by boundary elements, written by",
        "# validation/film/elastic_gap.py, read by analytic/surface/elastic_gap.py. pressure: nominal, over E* slope;",
        "# slope: rms gradient; gap: over the rms height; spread: standard deviation of ln gap between surfaces.",
        "",
        f"width = {WIDTH}.0 # of the surfaces, in correlation lengths",
        f"pressure = {_numbers(np.array(PRESSURES[::-1]))}",
        "",
        "[provenance]",
        'generator = "python validation/film/elastic_gap.py"',
        f'versions = "{packages}"',
        f"first_seed = {SEED}",
    ]
    for curve in curves:
        lines += ["", "[[curve]]", f'kind = "{curve["kind"]}"']
        lines += [f"spacing = {curve['spacing']:g} # of the points, over the correlation length"]
        lines += [f"{name} = {curve[name]}" for name in ("points", "surfaces")]
        lines += [f"{name} = {_numbers(curve[name])}" for name in ("gap", "spread", "area_fraction")]
    path.write_text("\n".join(lines) + "\n", "utf-8")
    out.print(path.read_text("utf-8"), soft_wrap=True)


def _numbers(values: Array) -> str:
    return "[" + ", ".join(f"{value:.4g}" for value in values) + "]"


def against_published() -> bool:
    """The stored gaussian curve against the independent code's, at its pressures."""
    ours = declared_gap_curve(Autocorrelation(kind="gaussian", length=32.0, spacing=1.0))
    surfaces = next(c["surfaces"] for c in catalog.entry("corrections", "elastic_gap")["curve"])
    rows = published("elastic_gap.csv")
    pressure, gap, sd_gap, area, sd_area = (numbers(rows, name) for name in rows[0])
    at = np.log(pressure)
    gaps, areas = np.exp(elastic_log_gap(*ours.splines, at)[0]), elastic_area(*ours.splines, at)
    standard_error = ERRORS * np.sqrt(1 / 10 + 1 / surfaces)
    allowed = np.array([FLOOR + standard_error * sd_gap / gap, FLOOR + standard_error * sd_area / area])
    differences = np.array([gaps / gap - 1, areas / area - 1])
    columns = (pressure, gaps, gap, differences[0], allowed[0], areas, area, differences[1], allowed[1])
    agrees = bool(np.all(np.abs(differences) < allowed))
    return _judged(
        agrees, "published", zip(*columns, strict=True), "Stored gaussian curve against the independent code"
    )


def against_tamaas(*, periodic: bool) -> bool:
    """One gaussian surface, 10 lengths wide; Tamaas knows periodic surfaces only and gets the mirror images too."""
    heights = surface("gaussian", 20, seed=7, width=10)
    states = list(pressed(heights, TAMAAS_PRESSURES, periodic=periodic))
    heights = heights / heights.std()
    slope = float(np.sqrt(sum(np.mean(np.diff(heights, axis=axis) ** 2) for axis in (0, 1))))
    if not periodic:
        half = np.concatenate([heights, heights[::-1]])
        heights = np.concatenate([half, half[:, ::-1]], axis=1)
    rows, agrees = [], True
    others = tamaas_contacts(heights, [pressure * slope for pressure in TAMAAS_PRESSURES])
    for pressure, state, (gap, area) in zip(TAMAAS_PRESSURES, states, others, strict=True):
        off, off_area = state.mean_gap / gap - 1, state.area_fraction / area - 1
        agrees &= abs(off) < SAME_GAP and abs(off_area) < SAME_AREA
        rows.append((pressure, state.mean_gap, gap, off, SAME_GAP, state.area_fraction, area, off_area, SAME_AREA))
    title = f"One surface of 200 by 200 points, {'periodic' if periodic else 'mirrored'}"
    return _judged(agrees, "Tamaas", rows, title)


def print_mirror_effect() -> None:
    """ln of the gap of a surface continued by mirror images over that of the same surface as a period."""
    surfaces = [surface("gaussian", 10, seed=900 + number) for number in range(8)]
    gaps = np.array(
        [[[s.mean_gap for s in pressed(z, PRESSURES, periodic=p)] for p in (False, True)] for z in surfaces]
    )
    change = np.log(gaps[:, 0] / gaps[:, 1])
    errors = change.std(axis=0, ddof=1) / np.sqrt(len(change))
    rows = zip(PRESSURES, (f"{each:+.2%}" for each in change.mean(axis=0)), (f"{e:.2%}" for e in errors), strict=True)
    show(("p/(E* slope)", "change of the gap", "standard error"), rows, "Mirror images, 8 surfaces of 200 x 200")


def tamaas_contacts(heights: Array, pressures: list[float]) -> Iterator[tuple[float, float]]:
    """Mean gap and area fraction of a periodic surface at mean pressures over E*, with the spacing 1."""
    import tamaas as tm

    tm.set_log_level(tm.LogLevel.error)
    model = tm.ModelFactory.createModel(tm.model_type.basic_2d, [float(n) for n in heights.shape], list(heights.shape))
    model.E, model.nu = 1.0, 0.0  # E* = 1
    solver = tm.PolonskyKeerRey(model, heights, TAMAAS_TOLERANCE)
    for pressure in pressures:
        solver.solve(pressure)
        touching = np.array(model.traction) > 0
        gap = np.array(model.displacement) - heights
        yield float(gap.mean() - gap[touching].mean()), float(touching.mean())


def _judged(agrees: bool, other: str, rows: Iterable[tuple[float, ...]], title: str) -> bool:
    """Print pressures, and gap and area: ours, theirs, difference and what is allowed; whether both agree."""
    heads = ("p/(E* slope)", *(head for what in ("gap", "area") for head in (what, other, "difference", "allowed")))
    form = ("g", *2 * (".4f", ".4f", "+.2%", ".2%"))
    show(heads, ([f"{value:{each}}" for value, each in zip(row, form, strict=True)] for row in rows), title)
    out.print("Agrees within the tolerances\n" if agrees else "DIFFERS by more than a tolerance\n")
    return agrees


if __name__ == "__main__":
    run(main)
