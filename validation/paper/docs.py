"""The page on the paper: python validation/paper/docs.py

Fills the template figures.md.j2 from paper.json and words.toml and writes figures.md, so that every number in its
tables is a stored one. `run.py` makes paper.json, and the pictures.
"""

import json
import math
import tomllib
from collections.abc import Iterable, Sequence
from pathlib import Path
from textwrap import fill
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from validation.paper.cage import RPM
from validation.paper.comparison import WORDS
from validation.study import markdown, run

HERE = Path(__file__).parent
STORED = HERE / "paper.json"
MATCH = 1.1  # factor; rounding makes some published values uncertain by 7 %, for example 7 N mm
SCALES = {"cage_max_force": (1.0, "N")}  # all else: torques in N mm
POWERS = (  # number, whether it is a loss, quantity
    ("power of sliding in the pockets over the speed of the ring", "yes; the cage torque here", "cage_torque"),
    ("power lost in impacts over the speed of the ring", "yes, but not in our torque", "impact_torque"),
    ("friction moments about the balls' centres, mu (sum N) r, sum of magnitudes", "no", "cage_moments"),
    ("mean magnitude of the moment on the cage about the bearing's axis", "no: its mean is 0", "cage_axial_moment"),
)


def main() -> None:
    (HERE / "figures.md").write_text(page(json.loads(STORED.read_text("utf-8"))), encoding="utf-8")


def page(stored: dict[str, Any]) -> str:
    """The page in Markdown, from what `run.py` stored."""
    made = Environment(
        loader=FileSystemLoader(HERE),
        undefined=StrictUndefined,
        trim_blocks=True,
        keep_trailing_newline=True,
    )
    made.filters["paragraph"] = lambda words: fill(" ".join(words.split()), width=118, break_on_hyphens=False) + "\n"
    made.globals |= {"tables": Tables(stored), "head": head, "table": table}
    return made.get_template("figures.md.j2").render(stored)


def head(title: str, picture: str) -> str:
    return f"## Figure {title}\n\n![Figure {title}, by three readings of the paper]({picture})"


def table(heads: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    return "\n".join(markdown(heads, rows))


class Tables:
    """The tables of the page."""

    def __init__(self, stored: dict[str, Any]) -> None:
        self.stored, self.readings = stored, stored["readings"]
        self.names = [one["name"] for one in self.readings]
        self.words = tomllib.loads((HERE / "words.toml").read_text("utf-8"))

    def beside(self, quantity: str) -> str:
        """The paper's numbers beside ours, at the speeds where the text has numbers."""
        scale, unit = SCALES.get(quantity, (1e3, "N mm"))
        rows = []
        for same in zip(*(one["beside"] for one in self.readings), strict=True):
            if same[0]["ours"] == quantity:
                point = same[0]["point"]
                about = "" if point["note"] == "printed" else "about "
                speed, finish = f"{point['inner_speed'] / RPM:.0f}", f"{point['rms_roughness'] * 1e6:g}"
                rows.append(
                    (finish, speed, f"{about}{point['value'] * scale:.4g}", *(_ours(row, scale) for row in same))
                )
        return table(("Sq, um", "1/min", f"paper, {unit}", *self.names), rows)

    def pockets(self) -> str:
        rows = (
            (one["pocket"], f"{one['rms_roughness'] * 1e6:g}", *(f"{one['coefficient'][end]:.2g}" for end in (0, -1)))
            for one in self.stored["mixed_pocket_coefficients"]
        )
        return table(("oil and pocket", "Sq, um", "100", "500"), rows)

    def powers(self) -> str:
        finishes = [self.readings[1]["series"][name] for name in ("1e-06", "1e-07")]
        rows = ((words, loss, *(_ends(each[name]) for each in finishes)) for words, loss, name in POWERS)
        return table(("number", "a loss?", "Sq 1 um", "Sq 0.1 um"), rows)

    def misses(self) -> str:
        rows, reasons = [], self.words["reasons"]
        for one in self.readings:
            for quantity, words in WORDS.items():
                both = [_verdict(one, quantity, finish) for finish in (1e-6, 1e-7)]
                is_matched = both == ["matched", "matched"]
                why = "Inputs were chosen for it." if is_matched else reasons[one["name"]].get(quantity, "Not known.")
                rows.append((one["name"], words, *both, why))
        return table(("reading", "quantity", "Sq 1 um", "Sq 0.1 um", "why"), rows)

    def jumps(self) -> str:
        rows = (
            (one["where"], one["quantity"], _jump(one["printed"]), _jump(one["derived"]))
            for one in self.stored["jumps"]
        )
        return table(("where", "quantity", "as printed", "derived"), rows)

    def conclusions(self) -> str:
        trends = zip(*(one["trends"] for one in self.readings), strict=True)
        return table(("conclusion", *self.names), ((same[0]["claim"], *map(_trend, same)) for same in trends))

    def calibrated(self) -> str:
        fit = self.readings[1]["assumed"]
        rows = ((one["name"], fit[one["name"]], one["target"], one["usual"]) for one in self.words["calibrated"])
        return table(("input", "value", "chosen for", "usual"), rows)

    def assumed(self) -> str:
        inputs = self.readings[1]["assumed"]
        return table(("input", *self.names), ((key, *(one["assumed"][key] for one in self.readings)) for key in inputs))


def _verdict(reading: dict[str, Any], quantity: str, finish: float) -> str:
    """The larger factor between ours and the paper's at all speeds, or that it is matched."""
    points = [one for one in reading["beside"] if (one["ours"], one["point"]["rms_roughness"]) == (quantity, finish)]
    worst = max(math.exp(abs(math.log(one["computed"] / one["point"]["value"]))) for one in points)
    return "matched" if worst <= MATCH else f"{worst:.3g}"


def _ends(values: Sequence[float]) -> str:
    return ", ".join(f"{1e3 * value:.2g}" for value in (values[0], values[-1]))


def _ours(row: dict[str, Any], scale: float) -> str:
    change = row["deviation"]
    off = f"{100 * change:+.0f} %" if abs(change) < 1 else f"{change + 1:.2g} times"
    return f"{row['computed'] * scale:.3g} ({off})"


def _jump(sides: Sequence[float]) -> str:
    return ", ".join(f"{side * 1e3:.3g}" if abs(side) > 1e-9 else "0" for side in sides)


def _trend(trend: dict[str, Any]) -> str:
    return f"{'holds' if trend['held'] else 'does not'}: {trend['detail']}"


if __name__ == "__main__":
    run(main)
