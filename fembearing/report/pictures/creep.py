"""Pictures of friction in rolling contact: pressure with tractions as arrows, and where the surfaces stick and slip.

`fembearing.report.pictures.render` draws them; the jobs are in m, Pa and pixels.
"""

from contextlib import suppress
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from matplotlib.ticker import MaxNLocator

from analytic.contact.geometry import RACES, Race
from analytic.errors import ConvergenceError
from analytic.units import MILLI, unit_for
from analytic.words import Unit
from fembearing.check.contact.scene_contact import OfPair
from fembearing.check.creep.scene_creep import SceneCreep
from fembearing.creep.ball import Grid, RaceCreep, turn_ball
from fembearing.creep.rolling import STICKS
from fembearing.report.pictures.framing import round_length
from fembearing.report.report import PictureFile
from fembearing.report.sections.contacts import title_of

SEEN = Grid(28, 14)  # in a picture
WIDTH, HEIGHT = 1400, 900  # pixels
WIDE, HIGH = 1160, 290  # pixels of an ellipse at most
LONGEST_ARROW, LONGEST_BAR = 44, 220  # pixels
MILLIMETRES_A_SECOND = Unit("mm/s", 1e3)


class CreepPicture(NamedTuple):
    """The picture of one race."""

    race: Race
    file: str
    caption: str
    job: dict[str, Any]  # of the renderer
    bearing: OfPair | None

    @property
    def listed(self) -> PictureFile:
        """The picture as the document lists it."""
        return PictureFile(
            file=self.file, kind="creep", pair=self.race, geometry="real", caption=self.caption, bearing=self.bearing
        )


def creep_pictures(creep: SceneCreep, folder: Path) -> list[CreepPicture]:
    """One of each race, to be drawn into a folder, on a grid that is fine enough to look at."""
    turned = creep.reference.finest
    if creep.reference.grids[-1].strips < SEEN.strips:
        with suppress(ConvergenceError):
            turned = turn_ball(creep.ball, SEEN, turned)
    coefficient, bearing = creep.numbers.friction_coefficient, creep.numbers.bearing
    begin = f"{bearing}-" if bearing else ""
    law = "oil and surfaces" if coefficient is None else f"friction coefficient {coefficient:.3g}"
    pictures = []
    for race, contact in zip(RACES, turned.races, strict=True):
        file = f"{begin}{race}-creep.png"
        title = title_of(race, "real", abs(contact.angle), f"{contact.load:.4g} N, {law}", bearing)
        job = {"kind": "creep", "file": str(folder / file), "title": title}
        job |= _job(contact, creep.ball.speed * contact.rolling_speed)
        pictures.append(CreepPicture(race, file, _caption(contact), job, bearing))
    return pictures


def _stretch(contact: RaceCreep) -> tuple[float, int]:
    """Pixels per m across the groove, and how many times as much along rolling."""
    a, b = contact.semi_axis_rolling, contact.semi_axis_transverse
    scale = min(WIDE / (2 * b), HIGH / (2 * a))
    return scale, max(1, int(HIGH / (2 * a) / scale))


def _job(contact: RaceCreep, speed: float) -> dict[str, Any]:
    """speed : of rolling, m/s"""
    friction, strips = contact.friction, contact.friction.strips
    scale, stretch = _stretch(contact)
    traction, slip = np.hypot(*friction.traction), speed * np.hypot(*friction.slip)
    half = strips.width / 2
    ahead, across = LONGEST_BAR / 4 / scale / stretch, LONGEST_BAR / scale
    longest = round_length(float(traction.max()))
    return {
        "width": WIDTH,
        "height": HEIGHT,
        "scale": scale,
        "stretch": stretch,
        "semi_axes": [contact.semi_axis_rolling, contact.semi_axis_transverse],
        "edges": strips.edges.tolist(),
        "sides": [(strips.middle - half).tolist(), (strips.middle + half).tolist()],
        "traction": friction.traction.tolist(),
        "pressure": _coloured(friction.pressure, unit_for("Pa", float(friction.pressure.max()))),
        "slip": _coloured(slip, MILLIMETRES_A_SECOND),
        "sticks": (slip <= STICKS * slip.max()).tolist(),
        "per_traction": LONGEST_ARROW / float(traction.max()),
        "arrow": [longest, unit_for("Pa", longest).written(longest, "g")],
        "bars": [
            [round_length(across), f"{MILLI.written(round_length(across), 'g')} across"],
            [round_length(ahead), f"{MILLI.written(round_length(ahead), 'g')} along rolling"],
        ],
    }


def _coloured(values: np.ndarray, unit: Unit) -> dict[str, Any]:
    """Values of the rectangles in a unit, with the end of the colours and round ticks."""
    most = float(values.max()) * unit.factor or 1.0
    ticks = [float(tick) for tick in MaxNLocator(4).tick_values(0, most) if tick <= most]
    return {"values": (unit.factor * values).tolist(), "unit": unit.name, "most": most, "ticks": ticks}


def _caption(contact: RaceCreep) -> str:
    """What the picture shows."""
    _, stretch = _stretch(contact)
    drawn = "drawn to scale" if stretch == 1 else f"drawn {stretch} times as long along rolling as across"
    return (
        f"Friction of the heaviest ball by the reference, {drawn}. Above: pressure; arrows: traction on the ball. "
        "Below: slip speed; blue rectangles stick, the others slip. The surfaces enter the contact at the upper edge, "
        "and traction grows from there up to the limit of friction."
    )
