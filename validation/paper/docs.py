"""The page of the documentation on the paper: python validation/paper/docs.py

Writes docs/paper.md from reports/paper.json, so that every number in its tables is a stored one. `paper.py` makes that
file, and the pictures. For each figure of [Paper]: the picture, a table of the paper's numbers beside the three
readings, the matches, the calibrated inputs, and the numbers that cannot be reproduced.
"""

import json
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from textwrap import fill
from typing import Any

from validation.paper.cage import RPM
from validation.paper.inputs import CALIBRATED

HERE = Path(__file__).parent
STORED = HERE / "paper.json"
PAGE = HERE.parents[1] / "docs/paper.md"
INTRODUCTION = """\
# The paper, figure by figure

The 6205 of this project comes from a paper on surface roughness and friction [Paper]. This page compares its figures
5 to 9 with ours. `validation/paper/paper.md` has its table 1, all inputs and the reason for each difference; `python
validation/paper/run.py` computes numbers and pictures.

**This is no validation.** The paper's numbers are computed as well. Its text prints numbers at 100 and 500 1/min,
some of them as "about"; its figures were not seen. It does not give elasticity, oil, hardness, boundary friction,
loss factor, autocorrelation, pocket clearance, damping, or the start of the cage. So there are three readings:
"""
AFTERWORD = """\
## What cannot be reproduced

- **The figures.** Only the text of the paper was read. It has no numbers between 100 and 500 1/min.
- **A plausible race torque.** Both sets of inputs that match it within 10 % are implausible: one has a boundary
  friction of 0.035, the other waves of 615 um, longer than the contact along rolling. More inputs were chosen than
  numbers match.
- **The cage torque as a torque.** The lost power is several times smaller. The sum of the friction moments about the
  balls' centres matches, with a coefficient chosen for each speed, but it is no loss
  ([cage](theory/cage.md#what-is-a-friction-torque)).
- **The cage forces of both finishes.** Mass, speed and clearance determine the force of a whirl. Friction, the only
  effect of the finish, hardly changes it, and the paper's forces for both finishes are far apart.
- **The coefficient of ball on pocket.** It does not follow from oil and finish: the pocket is outside the range of
  the film formula, and the curvature of the pocket determines the computed value.

[Validation](validation.md#the-paper-figure-by-figure) has the basis of the calibration.
"""


def main() -> None:
    PAGE.write_text(page(json.loads(STORED.read_text("utf-8"))), encoding="utf-8")


def page(stored: dict[str, Any]) -> str:
    """The page in Markdown, from what `paper.py` stored."""
    readings = stored["readings"]
    parts = [
        [INTRODUCTION, *(f"- *{one['name']}*: {one['kind']}." for one in readings), ""],
        _figure_5(readings),
        _figure("6: total friction torque", "paper_6_total.png", TOTAL, readings, "total_torque", 1e3, "N mm"),
        _figure_7(stored),
        _figure_8(readings),
        _figure(
            "9: largest force of a ball on the cage", "paper_9_forces.png", FORCES, readings, "cage_max_force", 1, "N"
        ),
        _misprints(stored["jumps"]),
        _conclusions(readings),
        _calibrated(readings),
        [AFTERWORD.rstrip()],
    ]
    return "\n".join(line for part in parts for line in part) + "\n"


TOTAL = """\
*Calibrated* is below the paper, because it has the power loss of the cage; the paper's last number needs the friction
moments in place of this power, and they are no loss. *Physical* is above: thicker oil, usual boundary friction, and
hydrodynamic rolling, which the paper neglects."""
FORCES = """\
*Calibrated*: the cage whirls in a clearance chosen for these forces. *As printed*: the pocket of table 1 has several
millimetres of clearance and no damping, so the cage bounces. *Physical*: the cage starts slowly and rests on its
balls. The largest force of a run is erratic at 100 1/min."""


def _figure(
    title: str, picture: str, text: str, readings: Sequence[Any], quantity: str, scale: float, unit: str
) -> Iterator[str]:
    yield from _head(title, picture)
    yield from _beside(readings, quantity, scale, unit)
    yield from ("", text, "")


def _figure_5(readings: Sequence[Any]) -> Iterator[str]:
    yield from _head("5: generated surfaces", "paper_5_surfaces.png")
    assumed = {one["name"]: one["assumed"]["autocorrelation"] for one in readings}
    yield from _text(
        f"""Gaussian heights of the two finishes, as in the paper. The paper gives no autocorrelation; ours is
        {assumed["calibrated"]}, as calibrated; the physical reading has {assumed["physical"]}. A ground race has
        shorter waves: 10 to 100 um. Mixed lubrication uses the statistics and not the map."""
    )


def _figure_7(stored: dict[str, Any]) -> Iterator[str]:
    yield from _head("7: friction coefficients", "paper_7_coefficients.png")
    yield from _text(
        """The text prints no numbers for this figure ([ours](../validation/paper/paper.json)). By the text,
        coefficients are lower for the smoother finish at all contacts, hardly depend on speed at the races, and fall
        with speed at the cage. The first holds at the races in every reading. The second holds within 10 % at Sq 0.1
        um as printed and calibrated, not at 1 um. The calibrated coefficient at the cage is chosen. Mixed lubrication
        under the same forces gives, at 100 and 500 1/min:"""
    )
    yield from _rows(
        ("oil and pocket", "Sq, um", "100", "500"),
        (
            (
                one["pocket"],
                f"{one['rms_roughness'] * 1e6:g}",
                f"{one['coefficient'][0]:.2g}",
                f"{one['coefficient'][-1]:.2g}",
            )
            for one in stored["mixed_pocket_coefficients"]
        ),
    )
    yield ""
    alternative = "Coefficient of ball on pocket: the one that the paper's cage torque needs, and mixed lubrication"
    yield f"![{alternative}]({_at('paper_pocket.png')})"
    yield ""


def _figure_8(readings: Sequence[Any]) -> Iterator[str]:
    yield from _head("8: torque of races, cage and bearing", "paper_8_torques.png")
    yield "(a) Races:"
    yield ""
    yield from _beside(readings, "race_torque", 1e3, "N mm")
    yield ""
    yield from _text(
        """Calibrated inputs match within 10 %. A film that grows with speed unloads the asperities, so the torque
        decreases at Sq 1 um, where the paper's is constant."""
    )
    yield "(b) Cage, the power of sliding over the speed of the ring:"
    yield ""
    yield from _beside(readings, "cage_torque", 1e3, "N mm")
    yield from ("", "The sum of the friction moments about the balls' centres, which is no loss:", "")
    yield from _beside(readings, "cage_moments", 1e3, "N mm")
    yield from (
        "",
        "The calibrated sum matches because its coefficient was chosen for it. The power does not match.",
        "",
    )
    yield "(c) is the sum of (a) and (b): see figure 6. With the moments in place of the power:"
    yield ""
    yield from _beside(readings, "total_with_moments", 1e3, "N mm")
    yield ""


def _misprints(jumps: Sequence[Any]) -> Iterator[str]:
    yield "## Equations 2 to 7 as printed"
    yield ""
    yield from _text(
        """The names of both moments are exchanged at the ends of the range, and equation 2 lacks a factor of 0.322
        ([proof](theory/traction-and-sliding.md#the-misprints-of-equations-2-3-6-and-7)). As printed, the moments of one
        contact and the torque of the bearing jump between the cases. Values on both sides, N mm:"""
    )
    yield from _rows(
        ("where", "quantity", "as printed", "derived"),
        ((one["where"], one["quantity"], _jump(one["printed"]), _jump(one["derived"])) for one in jumps),
    )
    yield ""


def _conclusions(readings: Sequence[Any]) -> Iterator[str]:
    yield "## The paper's conclusions"
    yield ""
    yield from _text(
        """Changes are from 100 to 500 1/min, at Sq 1 um and on the inner race first. A rising quantity rises at every
        step and for both finishes. Flat means within 10 %."""
    )
    yield from _rows(
        ("conclusion", *(one["name"] for one in readings)),
        (
            (trend["claim"], *(_trend(one["trends"][row]) for one in readings))
            for row, trend in enumerate(readings[0]["trends"])
        ),
    )
    yield ""


def _calibrated(readings: Sequence[Any]) -> Iterator[str]:
    fit = next(one["assumed"] for one in readings if one["name"] == "calibrated")
    yield from ("## Calibrated inputs", "", "Inputs chosen to match numbers of the paper predict nothing.", "")
    yield from _rows(
        ("input", "value", "chosen for", "usual"),
        ((one.name, fit[one.name], one.target, one.usual) for one in CALIBRATED),
    )
    yield ""


def _head(title: str, picture: str) -> Iterator[str]:
    yield from (f"## Figure {title}", "", f"![Figure {title}, by three readings of the paper]({_at(picture)})", "")


def _at(picture: str) -> str:
    return f"../validation/paper/{picture}"


def _beside(readings: Sequence[Any], quantity: str, scale: float, unit: str) -> Iterator[str]:
    """The paper's numbers beside ours, at the speeds where the text has numbers."""
    rows = []
    for row, first in enumerate(readings[0]["beside"]):
        if first["ours"] == quantity:
            point = first["point"]
            about = "" if point["note"] == "printed" else "about "
            ours = (_ours(one["beside"][row], scale) for one in readings)
            speed, finish = f"{point['inner_speed'] / RPM:.0f}", f"{point['rms_roughness'] * 1e6:g}"
            rows.append((finish, speed, f"{about}{point['value'] * scale:.4g}", *ours))
    yield from _rows(("Sq, um", "1/min", f"paper, {unit}", *(one["name"] for one in readings)), rows)


def _ours(row: dict[str, Any], scale: float) -> str:
    change = row["deviation"]
    off = f"{100 * change:+.0f} %" if abs(change) < 1 else f"{change + 1:.2g} times"
    return f"{row['computed'] * scale:.3g} ({off})"


def _jump(sides: Sequence[float]) -> str:
    below, above = (f"{side * 1e3:.3g}" if abs(side) > 1e-9 else "0" for side in sides)
    return f"{below}, {above}"


def _trend(trend: dict[str, Any]) -> str:
    return f"{'holds' if trend['held'] else 'does not'}: {trend['detail']}"


def _text(words: str) -> Iterator[str]:
    """A paragraph."""
    yield from (*fill(" ".join(words.split()), width=118, break_on_hyphens=False).splitlines(), "")


def _rows(header: Sequence[str], rows: Iterable[Sequence[str]]) -> Iterator[str]:
    yield f"| {' | '.join(header)} |"
    yield f"|{' --- |' * len(header)}"
    for row in rows:
        yield f"| {' | '.join(row)} |"


if __name__ == "__main__":
    main()
