"""Warnings about a solved contact, one line each, the same under one load and in a series."""

import math
from collections.abc import Iterator, Sequence

import numpy as np

from analytic.limits import STATIC_LIMIT
from analytic.scene import Contact
from analytic.words import MILLIMETRE, percent_of, pressure_of
from fembearing.check.contact.refinement import Estimates, Reference
from fembearing.fem.pixel_contact import PixelSolution
from fembearing.fem.solution import MeshSolution

EDGE_OF_GROOVE = 1.05  # distance to the shoulder, in semi-axes, below which Hertz no longer applies
ANNULAR = 0.5  # peak pressure over Hertz's, below which a contact on a sheet is near to a ring
# A load on its finest mesh or on pixels, and the estimates from all levels
Solved = tuple[MeshSolution | PixelSolution, Estimates]


def near_shoulder(mesh: MeshSolution | PixelSolution, contact: Contact) -> bool:
    """Whether a solved contact reaches its shoulder, or nearly, where Hertz does not apply."""
    return mesh.shoulder is not None or EDGE_OF_GROOVE * mesh.quantities.semi_axis_transverse > contact.nearer_shoulder


def solve_warnings(
    solved: Sequence[Solved], *, accuracy: float, quantities: Sequence[str], thin: bool
) -> Iterator[str]:
    """Missed accuracy, meshes that do not converge, and yielding, of one contact under one load or several.

    accuracy : required of the `quantities`, which are names, relative half-width
    thin : a sheet takes the place of the race
    """
    mesh, name, part = max(
        ((mesh, name, estimates[name]) for mesh, estimates in solved for name in quantities),
        key=lambda each: each[2].total,
    )
    pair = mesh.contact.pair
    if part.total > accuracy:
        yield (
            f"{pair}: required accuracy {percent_of(accuracy, 2)} not reached: uncertainty of {_words(name)} at "
            f"{mesh.contact.load:g} N {percent_of(part.total, 2)} on level {mesh.level}, {percent_of(part.domain, 2)} "
            "from the block"
        )
    loose = [
        (_words(name), f"{mesh.contact.load:g}")
        for mesh, estimates in solved
        for name, part in estimates.items()
        if not part.settled
    ]
    if loose:
        names, loads = (", ".join(dict.fromkeys(words)) for words in zip(*loose, strict=True))
        yield f"{pair}{', sheet' if thin else ''}: the meshes do not converge in {names} at {loads} N"
    over = [mesh for mesh, _ in solved if mesh.quantities.peak_pressure > STATIC_LIMIT]
    if over:
        least = min(over, key=lambda mesh: mesh.contact.load)
        what = "peak pressure" if least.shoulder is None else "the pressure at y = 0,"
        yield (
            f"{pair}: {what} {pressure_of(least.quantities.peak_pressure)} at {least.contact.load:g} N is above the "
            f"static limit, {pressure_of(STATIC_LIMIT)}, of bearing steel: both models are elastic, the real contact "
            "is not; lower the load"
        )


def sheet_warnings(mesh: MeshSolution, *, hertz: float) -> Iterator[str]:
    """Why a sheet is shown and not judged, and whether it yields under the centre, where the pressure moves to a ring.

    hertz : peak pressure by Hertz, Pa; the centre may bear half of it before a ring is near
    """
    contact, peak = mesh.contact, mesh.quantities.peak_pressure
    assert contact.wall is not None  # otherwise it would not have been meshed
    yield (
        f"{contact.pair}: the sheet of {MILLIMETRE.written(contact.wall.thickness, '.3g')} bends on its rim; Hertz "
        "ignores this, so there is no verdict"
    )
    if peak >= ANNULAR * hertz:
        return
    pressure = np.where(mesh.force > 0, mesh.pressure, 0.0)
    most = int(np.argmax(pressure))
    radius = MILLIMETRE.written(float(np.hypot(mesh.x[most], mesh.y[most])), ".3g")
    yield (
        f"{contact.pair}: under {contact.load:g} N the sheet yields at the centre, where {pressure_of(peak)} are "
        f"{percent_of(peak / hertz, 2)} of Hertz's; the largest pressure, {pressure_of(float(pressure[most]))}, is "
        f"{radius} from there: a ring, outside these quantities"
    )


def shoulder_warning(contact: Contact, reference: Reference) -> str:
    """The warning for a contact that reaches its shoulder, or nearly."""
    near, remedy = MILLIMETRE.written(contact.nearer_shoulder, ".3f"), "lower the load or the contact angle"
    finest = reference.meshes[-1]
    if finest.shoulder is None:
        across = f"the contact reaches {MILLIMETRE.written(finest.quantities.semi_axis_transverse, '.3f')} across"
        return f"{contact.pair}: {across}, the shoulder is at {near}: outside Hertz; {remedy}"
    below, above = finest.pair.footprint.shoulders
    if math.isinf(max(below, above)):
        across = MILLIMETRE.written(finest.semi_axes[1], ".3f")
        cut = f"an ellipse of {across} across is cut off by the shoulder at {near}"
    else:
        cut = (
            f"the contact is cut off on both sides by the shoulders at y = {MILLIMETRE.written(-below, '.3f')} and "
            f"{MILLIMETRE.written(above, '.3f')}"
        )
    share = reference.shoulder["strip_share"]
    return (
        f"{contact.pair}: {cut}: outside Hertz. The tenth of {near} beside the nearer one carries {share.value:.2%} of "
        "the load. The meshed shoulder is sharp, with an unbounded pressure; a real one is rounded. Its pressure may "
        f"exceed the one at the centre and is not computed; {remedy}"
    )


def series_shoulder_warning(contact: Contact, *, load: float) -> str:
    """The warning for a series that reaches its shoulder, or nearly, from `load` (N) on."""
    return (
        f"{contact.pair}: from {load:g} N on the contact reaches its shoulder, "
        f"{MILLIMETRE.written(contact.nearer_shoulder, '.3f')} away: outside Hertz"
    )


def two_loads_warning(contact: Contact) -> str:
    """Why the law of two loads has no uncertainty."""
    return f"{contact.pair}: two loads fit any power law: K, n and tangents have no uncertainty; give a third load"


def _words(quantity: str) -> str:
    return quantity.replace("_", " ")
