"""The report as one HTML page with everything in it: no other file, no address.

A plot of the page is an entry of PLOTS, a `fembearing.report.plot.Plot`: the section that it ends, its heading, and a
function of the document (what report.json holds, plain types, SI) that gives a matplotlib figure and its caption, or
None and in place of the caption why there is nothing to draw. The template shows the plots of each section at its end,
in the order of PLOTS. A file beside report.json that the page embeds is listed in the document's "pictures".
"""

from collections.abc import Callable, Sequence
from itertools import groupby
from operator import itemgetter
from pathlib import Path
from typing import Any

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined

from analytic.scene import Array, Scene
from fembearing.compare.catalogue import BesideCatalogue, beside_catalogue
from fembearing.compare.discrepancy import ContactSolution
from fembearing.compare.provenance import provenance_of
from fembearing.compare.validation import Validation
from fembearing.report.figures import convergence_figure, png
from fembearing.report.ladders import cost_figure
from fembearing.report.pictures import Picture
from fembearing.report.plot import Plot, embedded, plots_of
from fembearing.report.wording import (
    AXES,
    PER_MINUTE,
    QUANTITIES,
    SHARES,
    friction_of,
    place_of,
    quantities_of,
    ring_line,
    share_of,
    shoulder_lines,
    title_of,
    uncertainty_of,
)

LONGEST_LIST = 12  # values in a table's cell
PLOTS: tuple[Plot, ...] = ()  # in their order on the page


def write_page(result: Validation, *, pictures: Sequence[Picture], trouble: str | None, file: Path) -> None:
    """Write the page.

    pictures : of the contacts, already drawn
    trouble : why VTK drew none, if it did not
    """
    environment = Environment(
        loader=PackageLoader("fembearing.report"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    catalogue = beside_catalogue(result.scene)
    ladders = result.ladders
    page = environment.get_template("page.html").render(
        result=result,
        scene=result.scene,
        axes=AXES,
        verdicts=[(title_of(found), _rows(_verdict, found)) for found in result.contacts if found.judged],
        shoulders=[(place_of(found), line) for found in result.contacts for line in shoulder_lines(found)],
        rings=[(place_of(found), ring_line(found.ring)) for found in result.contacts if found.ring is not None],
        pocket=_pocket(result),
        torque=_torque(result, catalogue),
        cage=_cage(result),
        catalogue=catalogue,
        shares=SHARES,
        share_of=share_of,
        uncertainty_of=uncertainty_of,
        meshes=[(place_of(found), _rows(_study, found)) for found in result.contacts],
        convergence=embedded(png(convergence_figure(result))),
        pictures=[(title_of(p.contact), p.caption, embedded(p.file.read_bytes())) for p in pictures],
        trouble=trouble,
        plots=plots_of(result.to_json(), PLOTS),
        ladders=ladders,
        cost=embedded(png(cost_figure(ladders, tolerance=result.tolerance))),
        provenance=provenance_of(result.scene),
        **_scene(result.scene, result),
    )
    file.write_text(page, "utf-8")


def _scene(scene: Scene, result: Validation) -> dict[str, Any]:
    """What the scene's table needs besides the scene itself."""
    bodies = [scene.bearing.ball_material, scene.bearing.inner.material, scene.bearing.outer.material]
    materials = bodies + ([] if scene.cage is None else [scene.cage.material])
    rule, inner = scene.contact_angle, result.contacts[0].contact
    if rule.rule == "given":
        angle = f"given, {rule.value:.4g} rad"
    else:
        free = "that of the clearance" if rule.free is None else f"{rule.free:.4g} rad"
        angle = f"solved from the load, free angle {free}; {inner.contact_angle:.4f} rad at the largest ball load"
    return {
        "materials": list(dict.fromkeys(materials)),
        "loads": _listed(scene.operation.axial_load),
        "sideways": [
            (name, f"{_listed(np.atleast_1d(values))} {unit}")
            for name, values, unit in (
                ("radial load", scene.operation.radial_load, "N"),
                ("moment", scene.operation.moment, "N m"),
            )
            if np.any(values)
        ],
        "speeds": _listed(scene.operation.inner_speed * PER_MINUTE),
        "angle": angle,
        "friction": friction_of(scene),
        "pocket_load": f"{result.contacts[-1].contact.load:g}",
    }


def _listed(values: Array) -> str:
    """Distinct values in their order; a long series by its ends."""
    distinct = list(dict.fromkeys(f"{value:.4g}" for value in values))
    if len(distinct) > LONGEST_LIST:
        return f"{distinct[0]} to {distinct[-1]}, {len(distinct)} values"
    return ", ".join(distinct)


def _rows(row: Callable[[ContactSolution, str], dict[str, Any]], contact: ContactSolution) -> list[dict[str, Any]]:
    return [row(contact, name) for name in QUANTITIES]


def _verdict(contact: ContactSolution, name: str) -> dict[str, Any]:
    shown, part = quantities_of(contact)[name], contact.estimates[name]
    return {
        "quantity": shown.heading(),
        "production": f"{getattr(contact.hertz, name) * shown.factor:.5g}",
        "reference": f"{part.value * shown.factor:.5g}",
        "discrepancy": f"{contact.discrepancy[name]:+.2%}",
        **_corrected(contact, name),
        "uncertainty": f"{part.total:.2%}",
        "exceeds": abs(contact.discrepancy[name]) > part.total,
        "verdict": contact.verdicts[name],
    }


def _corrected(contact: ContactSolution, name: str) -> dict[str, str]:
    """Hertz corrected for finite geometry, and its interpolation error."""
    if contact.corrected is None:
        return {"corrected": "-", "interpolation": "-"}
    value = getattr(contact.corrected.quantities, name) * QUANTITIES[name].factor
    return {"corrected": f"{value:.5g}", "interpolation": f"{contact.interpolation_error[name]:+.2%}"}


def _pocket(result: Validation) -> list[dict[str, Any]]:
    """K_pb by each model, and the approach at the load; empty without a cage."""
    if len(result.contacts) < 4:
        return []
    seat, sheet = result.contacts[2:]
    formula = seat.hertz
    rows = [("Hertz: two half spaces", formula, None)]
    rows += [(place_of(found), found.reference, found.estimates["stiffness"].total) for found in (seat, sheet)]
    return [
        {
            "model": model,
            "stiffness": f"{found.stiffness * QUANTITIES['stiffness'].factor:.4g}",
            "uncertainty": "" if uncertainty is None else f"{uncertainty:.2%}",
            "approach": f"{found.approach * QUANTITIES['approach'].factor:.4g}",
            "change": f"{found.stiffness / formula.stiffness - 1:+.1%}",
        }
        for model, found, uncertainty in rows
    ]


def _torque(result: Validation, catalogue: BesideCatalogue) -> list[dict[str, Any]]:
    """One row for each operating point, points in a row that differ in speed alone together; empty without friction."""
    change = result.torque
    if change is None:
        return []
    hertz, corrected = change.hertz, change.corrected
    fitted = change.fitted.relative
    relative = change.relative("total")
    assert relative is not None  # the total is always there
    rows = [
        {
            "load": f"{hertz.axial_load[point]:.4g}",
            "angles": [f"{hertz.contact_angle[point]:.4f}", f"{corrected.contact_angle[point]:.4f}" if known else "-"],
            "parts": {
                name: f"{part[point] * 1e3:.4g}"
                for name, part in vars(hertz.torque).items()
                if part is not None and name != "race"  # the total less what is declared
            },
            "corrected": f"{corrected.torque.total[point] * 1e3:.4g}" if known else "-",
            "change": f"{relative[point]:+.2%}" if known else "-",
            "catalogue": _in_band(catalogue, point),
            "fitted": f"{fitted[point]:+.2%}" if np.isfinite(fitted[point]) else "-",
        }
        for point, known in enumerate(change.is_solved)
    ]
    # At a constant coefficient all speeds read the same: one row for each run of them.
    runs = [[point for point, _ in run] for _, run in groupby(enumerate(rows), key=itemgetter(1))]
    return [{**rows[run[0]], "speed": _listed(hertz.inner_speed[run] * PER_MINUTE)} for run in runs]


def _cage(result: Validation) -> list[dict[str, str]]:
    """One row for each operating point whose cage moved."""
    part, found = result.moving_cage, result.production
    if part is None or found is None:
        return []

    def between(ends: tuple[float, float], factor: float) -> str:
        return " to ".join(f"{factor * end:.3g}" for end in ends)

    return [
        {
            "speed": f"{found.inner_speed[point] * PER_MINUTE:.5g}",
            "state": motion.state,
            "start": motion.start,
            "torque": f"{motion.torque * 1e3:.3g}",
            "torque_interval": between(motion.torque_interval, 1e3),
            "moment": f"{motion.signed_moment * 1e3:.2g}",
            "mean_force": f"{motion.mean_force:.3g}",
            "max_force": f"{motion.max_force:.3g}",
            "max_force_interval": between(motion.max_force_interval, 1.0),
            "watched": f"{motion.duration:.3g} s in blocks of {motion.block:.3g} s",
            "other": "the cage cannot whirl: one steady motion"
            if motion.other is None
            else f"{motion.other.state} from {motion.other.start}, {motion.other.torque * 1e3:.3g} N mm"
            + ("" if motion.other.state == motion.state else ": the start decides"),
        }
        for point, motion in enumerate(part.motion)
        if motion is not None
    ]


def _in_band(catalogue: BesideCatalogue, point: int) -> str:
    if catalogue.band is None:
        return "-"
    return f"{catalogue.band.low[point] * 1e3:.3g}-{catalogue.band.high[point] * 1e3:.3g}"


def _study(contact: ContactSolution, name: str) -> dict[str, Any]:
    shown, part = quantities_of(contact)[name], contact.estimates[name]
    return {
        "quantity": shown.heading(),
        "values": ", ".join(f"{value * shown.factor:.5g}" for value in part.values),
        "order": "none" if part.order is None else f"{part.order:.1f}",
        "richardson": "" if part.richardson is None else f"{part.richardson * shown.factor:.5g}",
        "mesh": f"{part.mesh:.2%}",
        "domain": f"{part.domain:.2%}",
    }
