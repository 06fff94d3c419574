"""The friction torque as tables for a terminal or a pipe of 80 characters."""

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from analytic.result import FrictionTorque
from fembearing.compare.torque.scene_torque import SceneTorque
from fembearing.report.words import PER_MINUTE, PLAIN, SHARES, friction_of, share_of, uncertainty_of

MOST_POINTS = 12  # shown; the JSON has all
HEADS = {
    "spin": "spin",
    "conformity": "conf.",
    "hysteresis": "hyst.",
    "rolling": "roll.",
    "cage": "cage",
    "declared": "decl.",
}


def print_torque(out: Console, result: SceneTorque) -> None:
    found, count = result.found, result.found.inner_speed.size
    points = np.unique(np.linspace(0, count - 1, min(count, MOST_POINTS)).round().astype(np.intp))
    _print_parts(out, result, points)
    if points.size < count:
        out.print(f"{points.size} of {count} operating points; --json has all of them.", highlight=False)
    band, scene = result.catalogue.note, result.scene
    model = None if found.model_uncertainty is None else float(found.model_uncertainty.max())
    out.print(
        f"In N mm about the bearing axis; +-: numerical uncertainty. {uncertainty_of(model)}\n"
        f"{band[0].upper()}{band[1:]}.\n",
        style="dim",
        highlight=False,
        markup=False,
    )
    _print_contacts(out, found, points)
    _print_cage(out, found, points)
    _print_effects(out, found)
    names = ("loads", "contacts", "sliding", *(() if found.cage is None else ("cage",)))
    rungs = [f"{name} by {found.provenance[name]}".replace("_", " ") for name in names]
    friction = friction_of(coefficient=scene.friction_coefficient, is_lubricated=scene.has_friction)
    out.print(f"Rungs: {'; '.join(rungs)}. Friction: {friction}.\n", highlight=False, markup=False)
    reached = float(np.max(found.numerical_uncertainty, initial=0.0))
    out.print(
        f"{'within' if result.within_tolerance else 'beyond'} the tolerance {result.scene.tolerance:g}: numerical "
        f"uncertainty {_percent(reached)}, {found.seconds:.2g} s",
        highlight=False,
    )


def _print_parts(out: Console, result: SceneTorque, points: NDArray[np.intp]) -> None:
    found, operation, band = result.found, result.scene.operation, result.catalogue.band
    shape = found.inner_speed.shape
    loads = {
        "Fa": (operation.axial_load, "N", "axial load"),
        "Fr": (operation.radial_load, "N", "radial load"),
        "M": (operation.moment, "N m", "moment"),
    }
    series = {head: np.broadcast_to(values, shape) for head, (values, *_) in loads.items()}
    varying = {head: values for head, values in series.items() if np.ptp(values) > 0}
    fixed = [
        f"{name} {series[head][0]:.5g} {unit}"
        for head, (_, unit, name) in loads.items()
        if head not in varying and (series[head][0] or head == "Fa")
    ]
    words = ", ".join([f"Friction torque of {result.scene.bearing.name}", *fixed])
    out.print(words, style="italic", highlight=False, markup=False)
    table = Table(**PLAIN)
    parts = {name: values for name in HEADS if (values := getattr(found.torque, name)) is not None}
    for head in ("#", "rpm", *(f"{head}, {loads[head][1]}" for head in varying), *(HEADS[name] for name in parts)):
        table.add_column(head, justify="right")
    for head in ("total", "+-", *(("catalogue",) if band is not None else ())):
        table.add_column(head, justify="right", no_wrap=True)
    for point in points:
        table.add_row(
            str(point + 1),
            f"{found.inner_speed[point] * PER_MINUTE:.5g}",
            *(f"{values[point]:.4g}" for values in varying.values()),
            *(f"{values[point] * 1e3:.3g}" for values in parts.values()),
            f"{found.torque.total[point] * 1e3:.4g}",
            _percent(float(found.numerical_uncertainty[point])),
            *(() if band is None else (f"{band.low[point] * 1e3:.3g}-{band.high[point] * 1e3:.3g}",)),
        )
    out.print(table)


def _print_contacts(out: Console, found: FrictionTorque, points: NDArray[np.intp]) -> None:
    """Of the ball that presses hardest, on both races."""
    heads = ["#", "race", "load, N", "p0, GPa", "a, mm", "b, mm"]
    coefficients, films, shares = found.friction_coefficient, found.film, found.asperity_share
    optional = {"mu": (coefficients, 1.0), "film, um": (films, 1e6), "asperities": (shares, 1.0)}
    known = {head: (group, factor) for head, (group, factor) in optional.items() if group.inner is not None}
    table = Table(title="Heaviest ball", **PLAIN)
    for head in (*heads, *known):
        table.add_column(head, justify="left" if head == "race" else "right")
    for point in points:
        for race in ("inner", "outer"):
            contact = getattr(found, race)
            table.add_row(
                str(point + 1),
                race,
                f"{contact.load[point]:.4g}",
                f"{contact.peak_pressure[point] * 1e-9:.4g}",
                f"{contact.semi_axis_rolling[point] * 1e3:.4g}",
                f"{contact.semi_axis_transverse[point] * 1e3:.4g}",
                *(f"{getattr(group, race)[point] * factor:.3g}" for group, factor in known.values()),
            )
    out.print(table)
    low, high = found.contact_angle[points].min(), found.contact_angle[points].max()
    angle = f"{low:.4f}" if low == high else f"{low:.4f} to {high:.4f}"
    out.print(
        f"Contact angle {angle} rad, mean of both races. a along rolling, b transverse"
        + ("; asperities: their share of the load" if "asperities" in known else "")
        + ".\n",
        style="dim",
        highlight=False,
    )


def _print_cage(out: Console, found: FrictionTorque, points: NDArray[np.intp]) -> None:
    """Where it was moved."""
    if found.cage is None or not any(found.cage.motion):
        return
    table = Table(title="Cage in motion", **PLAIN)
    for head in ("#", "state", "all forces, N", "largest, N", "95 %", "torque, N mm", "95 %"):
        table.add_column(head, justify="left" if head == "state" else "right")
    blocks = 0.0
    for point in points:
        motion = found.cage.motion[point]
        if motion is None:
            continue
        blocks = motion.block
        table.add_row(
            str(point + 1),
            motion.state,
            f"{motion.mean_force:.3g}",
            f"{motion.max_force:.3g}",
            "-".join(f"{force:.3g}" for force in motion.max_force_interval),
            f"{motion.torque * 1e3:.3g}",
            "-".join(f"{torque * 1e3:.3g}" for torque in motion.torque_interval),
        )
    out.print(table)
    out.print(
        f"All forces: mean of their sum. Largest: of one ball on its pocket, in {blocks:.2g} s (median of blocks).\n",
        style="dim",
        highlight=False,
    )


def _print_effects(out: Console, found: FrictionTorque) -> None:
    table = Table(title="Effects", **PLAIN)
    for head in ("effect", "", "share"):
        table.add_column(head, justify="right" if head == "share" else "left", no_wrap=True)
    table.add_column("reason")
    for effect in found.effects_to_json():
        table.add_row(effect["name"], effect["decision"], share_of(effect), escape(effect["reason"]))
    out.print(table)
    out.print(f"{SHARES}\n", style="dim", highlight=False)


def _percent(value: float) -> str:
    return f"{100 * value:.2g} %" if np.isfinite(value) else "unknown"
