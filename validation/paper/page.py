"""The page of the paper, figure by figure: pictures with captions, table 1, calibrated inputs, misses with reasons."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from analytic.cage.statistics import CageStatistics
from analytic.scene import Array
from analytic.surface.heightmap import Measurement
from validation.paper.cage import CLEARANCE, ROUGH, SMOOTH
from validation.paper.comparison import MATCH, WORDS, Comparison, Curve, Series
from validation.paper.inputs import CALIBRATED

FINISHES = (ROUGH, SMOOTH)
PICTURES = {  # name of the file -> title
    "paper_5_surfaces.png": "Figure 5: generated surfaces",
    "paper_6_total.png": "Figure 6: total friction torque",
    "paper_7_coefficients.png": "Figure 7: friction coefficients",
    "paper_8_torques.png": "Figure 8: torque of races, cage and bearing",
    "paper_9_forces.png": "Figure 9: largest force of a ball on the cage",
    "paper_pocket.png": "The coefficient of ball on pocket",
}
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


def write_page(
    readings: list[Comparison],
    table: list[tuple[str, str, str]],
    surfaces: Mapping[float, Measurement],
    mixed: Mapping[tuple[str, float], Array],
    free: CageStatistics,
    path: Path,
) -> None:
    """table : table 1 of the paper;  surfaces, mixed : what figure 5 and the last picture show

    free : the calibrated cage at Sq 0.1 um and 500 rpm on balls that it may brake
    """
    by_name = {one.name: one for one in readings}
    fit = by_name["calibrated"]
    captions = [_surfaces(surfaces), *_captions(by_name), _pocket(mixed)]
    lines = ["# The paper, figure by figure", "", *_introduction(readings), ""]
    for (name, title), caption in zip(PICTURES.items(), captions, strict=True):
        lines += [f"## {title}", "", f"![{title}]({name})", "", caption, ""]
    lines += ["## What is power and what is not", "", *_powers(fit), "", _freed(fit, free), ""]
    lines += ["## Misses and their reasons", "", *_misses(readings), ""]
    lines += ["## Table 1", "", *_rows(("parameter", "paper", "ours"), table), ""]
    lines += ["## Calibrated inputs", "", "Inputs chosen to match numbers of the paper predict nothing.", ""]
    lines += [
        *_rows(
            ("input", "value", "chosen for", "usual"),
            [(one.name, fit.assumed[one.name], one.target, one.usual) for one in CALIBRATED],
        ),
        "",
    ]
    lines += ["## All inputs that the paper does not give", "", *_assumed(readings)]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def _text(words: str) -> str:
    """A paragraph on one line."""
    return " ".join(words.split())


def _rows(header: Sequence[str], rows: Iterable[Sequence[str]]) -> Iterator[str]:
    """A table."""
    yield f"| {' | '.join(header)} |"
    yield f"|{' --- |' * len(header)}"
    for row in rows:
        yield f"| {' | '.join(row)} |"


def _introduction(readings: list[Comparison]) -> Iterator[str]:
    yield _text(
        """Written by `python validation/paper/run.py`. The 6205 under 1000 N of thrust comes from [Paper]. Its text
        prints numbers at 100 and 500 rpm; its figures were not seen. Its numbers are computed as well, so this is a
        cross-check and no validation. Filled marks are printed numbers, hollow ones stand in the text as about.
        Lines are three readings of the paper:"""
    )
    yield ""
    for one in readings:
        yield f"- *{one.name}*: {one.kind}."


def _surfaces(measured: Mapping[float, Measurement]) -> str:
    both = " and ".join(
        f"Sq {measured[sq].moments.rms_roughness * 1e6:.3g} um with 1/e of the autocorrelation at "
        f"{measured[sq].correlation_length * 1e6:.0f} um"
        for sq in FINISHES
    )
    return _text(
        f"""Gaussian heights with the autocorrelation of the calibrated reading; the paper gives none. (a) and (b)
        have colour scales of their own. The two maps measure {both}: maps as narrow as these scatter about their
        ensemble. Mixed lubrication takes the statistics of the ensemble. The waves are nearly as long as the contact
        is along rolling (0.24 mm); a ground race has shorter ones."""
    )


def _captions(readings: Mapping[str, Comparison]) -> Iterator[str]:
    """Of figures 6 to 9."""
    fit, printed, physical = readings["calibrated"], readings["as printed"], readings["physical"]
    ratios = [one.computed / one.point.value for one in physical.points if one.ours == "total_torque"]
    yield _text(
        f"""The calibrated race torque ends at {fit.rough["race_torque"][-1] * 1e3:.1f} N mm at Sq 1 um and 500 rpm,
        and the power of the cage adds {fit.rough["cage_torque"][-1] * 1e3:.1f}. The line reaches the paper's last
        number only if friction moments about the balls' centres stand in place of this power (dotted); they are no
        loss. The usual inputs of the physical reading give {min(ratios):.1f} to {max(ratios):.1f} times the paper's
        torque."""
    )
    yield _text(
        """The paper's text has no numbers for this figure. It says: lower for the smoother finish at all contacts,
        hardly dependent on speed at the races, falling with speed at the cage. As printed and calibrated have the
        same coefficients at the races. At the cage the calibrated coefficient is chosen. The one of as printed is
        mixed lubrication in the pocket of table 1, under the small forces of that reading."""
    )
    yield _text(
        """(a) Four rounded numbers are met within 10 %, by more chosen inputs; one of these, a boundary friction of
        0.035, is not plausible. (b), on a logarithmic scale: the solid line is the power of sliding over the speed
        of the ring. The dotted line is the sum of friction moments about the balls' centres. It meets the paper
        because its coefficient was chosen so, and it is no loss. (c) is the sum of (a) and (b)."""
    )
    lowest = min(float(values["cage_max_force"].min()) for values in (printed.rough, printed.smooth))
    yield _text(
        f"""Lines are medians of the largest force in runs of 0.1 or 0.2 s, bars lowest and highest run. The
        calibrated cage whirls: all four printed forces are within a factor of {_worst_force(fit):.2f} of it. At 100
        rpm the largest force is erratic: clearances of 0.06 to 0.2 mm change it by a factor of 3 (`python
        validation/paper/cage_scan.py`). As printed, the cage bounces without loss at {lowest:.0f} N or more."""
    )


def _pocket(mixed: Mapping[tuple[str, float], Array]) -> str:
    sphere, table = (f"calibrated oil, {name}" for name in (f"clearance {CLEARANCE * 1e3:g} mm", "pocket of table 1"))
    usual = f"physical oil, clearance {CLEARANCE * 1e3:g} mm"
    other = "physical oil, pocket of table 1"
    return _text(
        f"""Black: the coefficient with which the friction moments about the balls' centres are the paper's cage
        torque. It does not follow from oil and finish. With the calibrated oil, of a constant shear stress, the
        coefficient does fall: the force of a whirl grows with the square of the speed, and the area of Hertz's
        contact only with its power 2/3. But its size follows from the curvature of the pocket:
        {_ends(mixed[sphere, ROUGH])} in the clearance that gives the forces, {_ends(mixed[table, ROUGH])} in the
        pocket of table 1, both at Sq 1 um. The finish changes nothing in the narrow clearance, where the computed
        film is as thick as the clearance and no asperities touch; in the pocket of table 1 the smooth finish has
        {_ends(mixed[table, SMOOTH])}, too little. With the oil of the physical reading the coefficient rises with
        speed: {_ends(mixed[usual, ROUGH])} in the narrow clearance, {_ends(mixed[other, ROUGH])} in the pocket of
        table 1. The film formula is outside its range in all these pockets."""
    )


def _worst_force(one: Comparison) -> float:
    return max(curve.worst for curve in one.curves if curve.ours == "cage_max_force")


def _powers(fit: Comparison) -> Iterator[str]:
    yield _text(
        f"""Numbers of the moving cage with the unit of a torque; calibrated reading, whirl in a clearance of
        {CLEARANCE * 1e3:g} mm, N mm:"""
    )
    yield ""
    kinds = (
        ("power of sliding in the pockets over the speed of the ring", "yes; the cage torque here", "cage_torque"),
        ("power lost in impacts over the speed of the ring", "yes, but not in our torque", "impact_torque"),
        ("friction moments about the balls' centres, mu (sum N) r, sum of magnitudes", "no", "cage_moments"),
        ("mean magnitude of the moment on the cage about the bearing's axis", "no: its mean is 0", "cage_axial_moment"),
    )
    rows = [(words, loss, _both(fit.rough, name), _both(fit.smooth, name)) for words, loss, name in kinds]
    paper = [
        ", ".join(
            f"{row.point.value * 1e3:g}"
            for row in fit.points
            if (row.ours, row.point.rms_roughness) == ("cage_torque", roughness)
        )
        for roughness in FINISHES
    ]
    header = ("number", "a loss?", "Sq 1 um: 100, 500 rpm", "Sq 0.1 um: 100, 500 rpm")
    slip = [*fit.rough["slip_share"], *fit.smooth["slip_share"]]
    yield from _rows(header, [*rows, ("the paper's cage torque, about", "", *paper)])
    yield ""
    yield _text(
        f"""The friction moments would cost power only if the pockets stood still against their balls. Then the torque
        would be larger than their sum by the ratio of the ball's speed to the ring's, 2.4. A whirling cage moves with
        the surfaces of its balls and slides with {100 * min(slip):.0f} to {100 * max(slip):.0f} % of their speed, so
        it takes little power. The paper's cage torque agrees with these moments, which load the balls; equation 1 adds
        it to the race torque as if it were a loss. Equation 19, read as the moment about the bearing's axis, gives the
        last number, which does not agree."""
    )
    yield ""
    rough, smooth = (float(values["traction_share"].max()) for values in (fit.rough, fit.smooth))
    yield _text(
        f"""The motion of the balls is prescribed here. At Sq 1 um the mean force of a ball on the cage takes at most
        {rough:.2f} of the traction that the races can give it. At Sq 0.1 um it takes up to {smooth:.2f}: with race
        coefficients as low as the calibrated 0.003, the balls would slide at 500 rpm. There the calibrated reading
        contradicts itself."""
    )


def _freed(fit: Comparison, free: CageStatistics) -> str:
    held = fit.smooth
    return _text(
        f"""Where balls and cage move together there (`ball_dynamics`), the largest force is {free.max_force:.1f} N in
        place of {held["cage_max_force"][-1]:.1f}, while the sum of all forces stays, {free.mean_force:.1f} N in place
        of {held["cage_force"][-1]:.1f}. The pockets take {free.torque * 1e3:.1f} N mm in place of
        {held["cage_torque"][-1] * 1e3:.1f}, and the races lose {free.race_excess_torque * 1e3:.1f} N mm more: the cage
        adds {(free.torque + free.race_excess_torque) * 1e3:.1f} N mm, where the paper has about 6."""
    )


def _misses(readings: list[Comparison]) -> Iterator[str]:
    yield f"Factors are the larger of those at 100 and 500 rpm. Matched means within {100 * (MATCH - 1):.0f} %."
    yield ""
    rows = []
    for one in readings:
        for quantity in WORDS:
            rough, smooth = (_curve(one, quantity, sq) for sq in FINISHES)
            missed = max(rough.worst, smooth.worst) > MATCH
            why = _text(REASONS[one.name, quantity]) if missed else "Inputs were chosen for it."
            rows.append((one.name, WORDS[quantity], _verdict(rough), _verdict(smooth), why))
    yield from _rows(("reading", "quantity", "Sq 1 um", "Sq 0.1 um", "why"), rows)


def _assumed(readings: list[Comparison]) -> Iterator[str]:
    chosen = {one.name for one in CALIBRATED}
    yield from _rows(
        ("input (\\*: calibrated)", *(one.name for one in readings)),
        [
            (f"{name}\\*" if name in chosen else name, *(one.assumed[name] for one in readings))
            for name in readings[0].assumed
        ],
    )


def _curve(one: Comparison, quantity: str, roughness: float) -> Curve:
    return next(curve for curve in one.curves if (curve.ours, curve.rms_roughness) == (quantity, roughness))


def _verdict(curve: Curve) -> str:
    if curve.worst <= MATCH:
        return "matched"
    return f"{curve.worst:.2f}" if curve.worst < 10 else f"{curve.worst:.2g}"


def _both(values: Series, quantity: str) -> str:
    return f"{values[quantity][0] * 1e3:.2g}, {values[quantity][-1] * 1e3:.2g}"


def _ends(values: Array) -> str:
    return f"{values[0]:.2g} to {values[-1]:.2g}"
