"""The page on the paper: python validation/paper/docs.py

Writes figures.md from paper.json, so that every number in its tables is a stored one. `run.py` makes that file, and the
pictures.
"""

import json
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from textwrap import fill
from typing import Any

from validation.paper.cage import RPM
from validation.paper.comparison import WORDS
from validation.paper.inputs import CALIBRATED

HERE = Path(__file__).parent
STORED = HERE / "paper.json"
PAGE = HERE / "figures.md"
REASONS = {  # (reading, quantity) -> why it misses the paper
    ("as printed", "race_torque"): """The misprints of equations 2 to 7 lower the torque by a fifth. A film that grows
        with speed takes load off the asperities, so the torque falls with speed.""",
    ("as printed", "cage_torque"): """The pocket of table 1 leaves the cage 5.96 mm of room. The cage falls and
        bounces, and on average it presses with little more than its weight.""",
    ("as printed", "cage_moments"): "As for the power: all balls together press with 0.1 to 0.4 N on average.",
    ("as printed", "cage_max_force"): """Equation 14 has no loss in impacts, and the paper gives no start. From a
        sudden start the cage goes on bouncing.""",
    ("as printed", "total_torque"): "Race and cage torque are both too low, the cage's by far.",
    ("as printed", "total_with_moments"): "As for the total with the power.",
    ("calibrated", "cage_torque"): """A whirling cage rolls on its balls: it slides too slowly for the paper's
        numbers. Only the friction moments about the balls' centres meet them, and they are no loss.""",
    ("calibrated", "total_torque"): "It lacks what the cage torque lacks.",
    ("calibrated", "cage_max_force"): """Mass, speed and clearance set the force of a whirl. Friction, the only thing
        that the finish changes, hardly moves it. At 500 rpm the paper's forces for the two finishes are a factor of
        2.2 apart, ours nearly equal.""",
    ("physical", "race_torque"): """Boundary friction of 0.12 in place of 0.035, thicker oil, and hydrodynamic
        rolling, which the paper leaves out and which grows with speed.""",
    ("physical", "cage_torque"): """The cage starts slowly, so it rests on its balls. The computed film fills the
        clearance and carries it, and only its shear inside the contact of Hertz counts.""",
    ("physical", "cage_moments"): "As for the power.",
    ("physical", "cage_max_force"): "A resting cage presses with its weight, 0.065 N over all balls.",
    ("physical", "total_torque"): "The race torque is larger than the paper's, see there.",
    ("physical", "total_with_moments"): "As for the total with the power.",
}
INTRODUCTION = """\
# The paper, figure by figure

The 6205 of this project comes from a paper on surface roughness and friction [Paper]. This page compares its figures
5 to 9 and its table 1 with ours; `python validation/paper/run.py` computes numbers and pictures.

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
  ([cage](../../docs/theory/cage.md#what-is-a-friction-torque)).
- **The cage forces of both finishes.** Mass, speed and clearance determine the force of a whirl. Friction, the only
  effect of the finish, hardly changes it, and the paper's forces for both finishes are far apart.
- **The coefficient of ball on pocket.** It does not follow from oil and finish: the pocket is outside the range of
  the film formula, and the curvature of the pocket determines the computed value.

[Validation](README.md#the-basis-of-the-calibration) has the basis of the calibration.
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
        _powers(stored),
        _misses(readings),
        _misprints(stored["jumps"]),
        _conclusions(readings),
        _inputs(stored),
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
        """The text prints no numbers for this figure ([ours](paper.json)). By the text,
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
    yield f"![{alternative}](paper_pocket.png)"
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
        ([proof](../../docs/theory/traction-and-sliding.md#the-misprints-of-equations-2-3-6-and-7)). As printed, the
        moments of one contact and the torque of the bearing jump between the cases. Values on both sides, N mm:"""
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


def _powers(stored: dict[str, Any]) -> Iterator[str]:
    fit, free = stored["readings"][1], stored["free_balls"]
    rough, smooth = fit["series"]["1e-06"], fit["series"]["1e-07"]
    yield from ("## What is power and what is not", "")
    yield from _text(
        """Numbers of the calibrated cage, a whirl, with the unit of a torque; Sq 1 um and 0.1 um, each at 100 and 500
        1/min, N mm:"""
    )
    kinds = (
        ("power of sliding in the pockets over the speed of the ring", "yes; the cage torque here", "cage_torque"),
        ("power lost in impacts over the speed of the ring", "yes, but not in our torque", "impact_torque"),
        ("friction moments about the balls' centres, mu (sum N) r, sum of magnitudes", "no", "cage_moments"),
        ("mean magnitude of the moment on the cage about the bearing's axis", "no: its mean is 0", "cage_axial_moment"),
    )
    yield from _rows(
        ("number", "a loss?", "Sq 1 um", "Sq 0.1 um"),
        ((words, loss, _ends(rough[name]), _ends(smooth[name])) for words, loss, name in kinds),
    )
    yield ""
    slip = [*rough["slip_share"], *smooth["slip_share"]]
    shares = max(rough["traction_share"]), max(smooth["traction_share"])
    yield from _text(
        f"""The friction moments would cost power only if the pockets stood still against their balls. A whirling cage
        moves with the surfaces of its balls and slides with {100 * min(slip):.0f} to {100 * max(slip):.0f} % of their
        speed. Equation 1 adds these moments, which load the balls, as if they were a loss. The motion of the balls is
        prescribed here: the mean force of a ball on the cage takes up to {shares[0]:.2f} of the traction of its races
        at Sq 1 um, and {shares[1]:.2f} at 0.1 um, where the balls would slide. Where balls and cage move together there
        at 500 1/min (`ball_dynamics`), the largest force is {free["max_force"]:.1f} N in place of
        {smooth["cage_max_force"][-1]:.1f}, the sum of all forces {free["mean_force"]:.1f} N in place of
        {smooth["cage_force"][-1]:.1f}. The pockets take {1e3 * free["torque"]:.1f} N mm in place of
        {1e3 * smooth["cage_torque"][-1]:.1f}, and the races lose {1e3 * free["race_excess_torque"]:.1f} N mm more."""
    )


def _misses(readings: Sequence[Any]) -> Iterator[str]:
    yield from ("## Misses and their reasons", "", "Factors are the larger of those at 100 and 500 1/min.", "")
    rows = []
    for one in readings:
        verdicts = {(each["ours"], each["rms_roughness"]): each["verdict"] for each in one["curves"]}
        for quantity, words in WORDS.items():
            both = [verdicts[quantity, finish].removeprefix("within a factor of ") for finish in (1e-6, 1e-7)]
            why = "Inputs were chosen for it."
            if both != ["matched", "matched"]:
                why = " ".join(REASONS[one["name"], quantity].split())
            rows.append((one["name"], words, *both, why))
    yield from _rows(("reading", "quantity", "Sq 1 um", "Sq 0.1 um", "why"), rows)
    yield ""


def _inputs(stored: dict[str, Any]) -> Iterator[str]:
    readings = stored["readings"]
    names, fit = [one["name"] for one in readings], readings[1]["assumed"]
    yield from ("## Table 1", "")
    yield from _rows(("parameter", "paper", "ours"), stored["table_1"])
    yield from ("", "## Calibrated inputs", "", "Inputs chosen to match numbers of the paper predict nothing.", "")
    yield from _rows(
        ("input", "value", "chosen for", "usual"),
        ((one.name, fit[one.name], one.target, one.usual) for one in CALIBRATED),
    )
    yield from ("", "## All inputs that the paper does not give", "")
    yield from _rows(("input", *names), ((key, *(one["assumed"][key] for one in readings)) for key in fit))
    yield ""


def _ends(values: Sequence[float]) -> str:
    return ", ".join(f"{1e3 * value:.2g}" for value in (values[0], values[-1]))


def _head(title: str, picture: str) -> Iterator[str]:
    yield from (f"## Figure {title}", "", f"![Figure {title}, by three readings of the paper]({picture})", "")


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
