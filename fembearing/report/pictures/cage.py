"""What the off-screen picture of a cage shows: the instant, how far its movement is exaggerated, and the text."""

import textwrap
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from analytic.units import MILLI, MILLISECOND
from analytic.words import RPM
from fembearing.check.cage_record import CageRecord
from fembearing.report.pictures.framing import round_length

SIDE, LINE, FOOT = 900, 28, 90  # pixels of the cage, of a line of the words above, and of those below
TITLE_LONG, LONG = 66, 80  # letters of the first line and of the others that fit the width
AROUND = 2.3  # ball radii beyond the pitch circle that are in the picture, so that an arrow fits
LONGEST = 1.8  # ball radii: the longest arrow
WIDEST = 0.3  # ball radii: how far the ball is drawn from its pocket at most
WALL = 0.12  # ball radii
LEAN = np.radians(20)  # of the bearing's axis towards the eye
LEAST_FORCE = 1e-9  # N: a cage that nothing touches has arrows too, of length 0
LONGEST_SCALE = 200  # pixels of the scale of lengths in the corner
AXES = np.array(  # of the picture: right, up and towards the eye
    [[1.0, 0.0, 0.0], [0.0, np.cos(LEAN), np.sin(LEAN)], [0.0, -np.sin(LEAN), np.cos(LEAN)]]
)


@dataclass(frozen=True, kw_only=True, eq=False)
class CageView:
    """An instant as it is drawn: m, N, and pixels; places are in the fixed frame."""

    time: float  # s
    force: np.ndarray  # (Z, 3) of each ball on the cage
    balls: np.ndarray  # (Z, 3)
    pockets: np.ndarray  # (Z, 3), their distances from the balls exaggerated
    centre: np.ndarray  # (3,) of the cage, likewise
    exaggeration: float
    arrow: float  # length that stands for 1 N, m
    scale: float  # pixels per m

    @property
    def largest(self) -> float:
        """Force of one ball, N."""
        return float(np.linalg.norm(self.force, axis=1).max())


def view_of(record: CageRecord) -> CageView:
    """The instant after the start-up at which one ball presses hardest, of those that the series holds."""
    series, cage = record.series, record.cage
    pressed = np.where(record.measured[:, None], np.linalg.norm(series.force, axis=2), -1.0)
    at = int(np.argmax(pressed.max(axis=1)))
    balls = cage.ball_places(float(series.ball_angle[at]))
    times = max(1.0, round_length(WIDEST * cage.ball_radius / cage.half_clearance))
    return CageView(
        time=float(series.time[at]),
        force=series.force[at],
        balls=balls,
        pockets=balls - times * series.offset[at],
        centre=times * series.centre[at],
        exaggeration=times,
        arrow=LONGEST * cage.ball_radius / max(float(pressed[at].max()), LEAST_FORCE),
        scale=SIDE / (2 * (cage.pitch_radius + AROUND * cage.ball_radius)),
    )


def cage_job(record: CageRecord, file: Path) -> dict[str, Any]:
    """What `fembearing.report.pictures.render_cage` draws."""
    view, cage = view_of(record), record.cage
    length = np.linalg.norm(view.force, axis=1, keepdims=True)
    away = np.divide(view.force, length, out=np.zeros_like(view.force), where=length > 0)
    title, words = _title(record), _lines(view)
    shown = round_length(LONGEST_SCALE / view.scale)
    force = round_length(LONGEST * cage.ball_radius / view.arrow)
    return {
        "kind": "cage",
        "file": str(file),
        "width": SIDE,
        "height": LINE * (len(title) + len(words)) + SIDE + FOOT,
        "scale": view.scale,
        "axes": AXES.tolist(),
        "ball_radius": cage.ball_radius,
        "pitch_radius": cage.pitch_radius,
        "pocket_radius": cage.ball_radius + view.exaggeration * cage.half_clearance,
        "wall": WALL * cage.ball_radius,
        "balls": view.balls.tolist(),
        "pockets": view.pockets.tolist(),
        "centre": view.centre.tolist(),
        "tails": (view.balls + cage.ball_radius * away).tolist(),
        "arrows": (view.arrow * view.force).tolist(),
        "force_scale": {"length": force * view.arrow, "label": f"{force:g} N, ball on cage", "left": 30},
        "length_scale": {"length": shown, "label": f"{MILLI.written(shown, 'g')}, balls and grooves", "left": 370},
        "pull": _pull(record),
        "title": title,
        "lines": words,
    }


def picture_caption(record: CageRecord) -> str:
    """What is drawn, and what is not to scale in it."""
    view = view_of(record)
    return (
        f"The cage (brown) around its balls at {MILLISECOND.written(view.time, '.4g')}, the instant after the "
        f"start-up with the largest force of one ball: {view.largest:.3g} N. View along the bearing's axis, which "
        f"leans by {np.degrees(LEAN):.0f} degrees; the inner ring turns {_sense(record)}. Red: force of each ball on "
        "the cage, at its contact. Balls are to scale; the distances of each pocket from its ball and of the cage's "
        f"centre (brown dot) from the bearing's axis (black dot) are drawn {view.exaggeration:g} times as large, with "
        f"wider pockets accordingly. Regime of all seeds: {record.statistics.state}."
    )


def _title(record: CageRecord) -> list[str]:
    """The first lines over the picture."""
    statistics, speed = record.statistics, RPM.written(record.cage.ring_speed, ".5g")
    words = f'{record.scene.bearing.name} at {speed}, {_sense(record)}: regime "{statistics.state}", '
    return textwrap.wrap(f'{words}started "{statistics.start}"', TITLE_LONG)


def _lines(view: CageView) -> list[str]:
    """The lines of text below the title."""
    sentences = [
        f"at {MILLISECOND.written(view.time, '.4g')}; red: force of each ball on the cage, the largest "
        f"{view.largest:.3g} N",
        f"brown: the cage, displaced {view.exaggeration:g} times as far as computed; brown dot: its centre",
        "black dot: the bearing's axis; grey: the bottoms of the grooves",
    ]
    return [line for sentence in sentences for line in textwrap.wrap(sentence, LONG)]


def _sense(record: CageRecord) -> str:
    return "counterclockwise" if record.cage.ring_speed > 0 else "clockwise"


def _pull(record: CageRecord) -> dict[str, Any]:
    """An arrow for a weight that acts in the plane of the picture, and a word."""
    across, along = np.linalg.norm(record.cage.gravity[:2]), record.cage.gravity[2]
    if across > 0:
        return {"length": record.cage.ball_radius, "label": "gravity", "room": 90}
    return {"length": 0.0, "label": "gravity away from you" if along else "no gravity", "room": 200 if along else 110}
