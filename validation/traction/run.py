"""The law of traction beside measured traction of twin discs: python validation/traction/run.py [--out FOLDER]

The reference is the printed law of [Arana2019] with its measured rheology, which the paper states to be within 0.005 of
the coefficients that Mann measured. It takes pressure and coefficient of the whole contact and the heat of sliding; the
product takes both at each point, without heating. The program prints a table of ratios, writes traction.md and draws
traction.png into this folder.
"""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic import lubricant, traction_coefficient
from analytic.oil.viscosity import oil_numbers, thickening_at
from analytic.scene import Array, Lubricant
from validation.study import PUBLISHED, Out, figure, markdown, read, run, save, write_text

HERE = Path(__file__).parent
DATA = PUBLISHED / "twin_disc_traction.csv"
PRESSURE, TEMPERATURE = 1e9, 333.15  # Pa, K: of the tests
SLIPS = (0.01, 0.05)  # of the comparison: beyond, the oil heats by up to 56 K, which the product leaves out
STATED = 0.005  # largest difference of the reference from measured coefficients, as stated
HEADS = (
    *("oil", "slip", "product over reference, mean and range"),
    *("stress at the Hertz pressure", "Roelands' viscosity"),
)
COLOURS = {"N100": "tab:green", "M100": "tab:blue", "PAO100": "tab:red"}
KINDS = {"N100": "naphthenic", "M100": "paraffinic mineral", "PAO100": "PAO"}


class Test(NamedTuple):
    """One oil at one rolling speed and slip."""

    oil: str
    speed: float  # m/s
    slip: float
    film: float  # m
    reference: float
    computed: float  # by the product
    hertz: float  # with the Eyring stress of the Hertz pressure everywhere
    roelands: float  # with Roelands' viscosity


def coefficient(oil: str | Lubricant, *, speed: float, slip: ArrayLike, film: float) -> Array:
    """Of two discs, by the product."""
    known = {"pressure": PRESSURE, "temperature": TEMPERATURE, "contact": "line"}
    return traction_coefficient(oil, speed=speed, slip=slip, film=film, **known)


def at_hertz_pressure(oil: Lubricant) -> Lubricant:
    """The oil with 2 Lambda/alpha at the Hertz pressure as its Eyring stress everywhere."""
    numbers = oil_numbers(oil)
    alpha = numbers.pressure_viscosity
    growth, _ = thickening_at(alpha, numbers.rise * alpha, numbers.exponent, PRESSURE)
    return replace(oil, eyring_stress=float(2 * oil.limiting_shear * PRESSURE / growth))


def tests() -> Iterator[Test]:
    """Those of the table, computed."""
    for row in read(DATA):
        oil = lubricant(row["oil"], temperature=TEMPERATURE)
        speed, slip, film = float(row["rolling_speed [m/s]"]), float(row["slip"]), float(row["film [um]"]) * 1e-6
        laws = oil, at_hertz_pressure(oil), replace(oil, thickening="roelands")
        found = (coefficient(each, speed=speed, slip=slip, film=film) for each in laws)
        yield Test(row["oil"], speed, slip, film, float(row["coefficient"]), *(float(each) for each in found))


def geometric(ratios: list[float]) -> float:
    """Geometric mean."""
    return float(np.exp(np.mean(np.log(ratios))))


def table(found: list[Test]) -> Iterator[tuple[str, ...]]:
    """Ratios to the reference."""
    for oil, kind in KINDS.items():
        for slip in sorted({each.slip for each in found}):
            here = [each for each in found if (each.oil, each.slip) == (oil, slip)]
            ratios = [each.computed / each.reference for each in here]
            others = (geometric([getattr(e, name) / e.reference for e in here]) for name in ("hertz", "roelands"))
            span = f"{geometric(ratios):.2f}, {min(ratios):.2f} to {max(ratios):.2f}"
            yield f"{oil}, {kind}", f"{slip:.0%}", span, *(f"{each:.2f}" for each in others)


def mean_ratio(found: list[Test], *oils: str) -> float:
    """Geometric mean of product over reference of these oils, at the slips of the comparison."""
    low, high = SLIPS
    return geometric([t.computed / t.reference for t in found if t.oil in oils and low <= t.slip <= high])


def draw(found: list[Test], path: Path) -> None:
    """Coefficients over the slip at the slowest and the fastest speed."""
    drawn = figure(9.5, 4.2)
    speeds = sorted({each.speed for each in found})
    axes = drawn.subplots(1, 2, sharey=True)
    slips = np.geomspace(0.002, 0.12, 60)
    for axis, speed in zip(axes, (speeds[0], speeds[-1]), strict=True):
        for oil, colour in COLOURS.items():
            here = [each for each in found if (each.oil, each.speed) == (oil, speed)]
            film = geometric([each.film for each in here])
            curve = coefficient(oil, speed=speed, slip=slips, film=film)
            axis.plot(slips * 100, curve, color=colour, label=f"{oil}, {KINDS[oil]}")
            places, values = [each.slip * 100 for each in here], [each.reference for each in here]
            axis.errorbar(places, values, yerr=STATED, color=colour, marker="o", ls="none", capsize=3, ms=4)
        axis.set(xscale="log", xlabel="slip, %", ylim=(0, 0.065), title=f"{speed:g} m/s")
        axis.xaxis.set_major_formatter("{x:g}")
        axis.grid(which="major", color="0.9")
    axes[0].set_ylabel("traction coefficient")
    title = "lines: fembearing; points: the law of [Arana2019], whose distance from measured traction is below 0.005"
    drawn.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=3, fontsize=9, title=title)
    save(drawn, path, dpi=120)


def main(out: Out = HERE) -> None:
    found = list(tests())
    means = {"mineral and naphthenic": mean_ratio(found, "M100", "N100"), "PAO": mean_ratio(found, "PAO100")}
    words = ", ".join(f"{value:.2f} of {name}" for name, value in means.items())
    lines = [*markdown(HEADS, table(found)), "", f"Geometric mean at {SLIPS[0]:.0%} to {SLIPS[1]:.0%} slip: {words}."]
    write_text(out / "traction.md", lines)
    draw(found, out / "traction.png")


if __name__ == "__main__":
    run(main)
