"""The tables of a cage in motion, by cells that are worked out by hand."""

import numpy as np

from analytic.columns import OF_CAGE, OF_MOTION, Point, rows_of
from fembearing.report.tables.cage import motion_table, regime_table

RPM = np.pi / 30  # rad/s
MOVES = {
    "inner_speed": 900 * RPM,
    "torque": 2.13e-3,
    "start": "ramp",
    "block": 0.012,
    "other/start": "whirl",
    "other/state": "irregular",
    "other/torque": 2.2e-3,
    "mean_force": 3.21,
    "max_force": 1.34,
    "interval/torque": (2.02e-3, 2.24e-3),
    "interval/max_force": (1.21, 1.47),
    "duration": 0.24,
    "state": "irregular",
    "signed_moment": -0.43e-3,
    "whirl_speed": 360 * RPM,
    "wobble": 4.4e-6,
    "ball_lead": 23.5e-6,
    "grip_share": 0.37,
    "grip_number": 0.83,
    "race_excess": 0.31e-3,
}
UNKNOWN = {name: np.nan if column.unit else None for name, column in (OF_CAGE | OF_MOTION).items()}


def moved(*without: str) -> Point:
    """The cage at a point at which nothing is known of these columns."""
    lacking = {name: unknown for name, unknown in UNKNOWN.items() if name.startswith(without)} if without else {}
    (row,) = rows_of({name: [value] for name, value in (MOVES | lacking).items()})
    return row


def test_forces_and_torque_of_a_cage_have_their_intervals() -> None:
    bare = moved("start", "state", "interval/", "signed_moment")
    table = motion_table({3: moved(), 5: bare})
    assert [head.text for head in table.heads][3:] == [
        *("start", "all forces, N", "largest, N", "95 %", "torque, N mm", "95 %", "signed moment, N mm")
    ]
    assert table.groups[0].rows == [
        ["3", "900", "irregular", "ramp", "3.21", "1.34", "1.21-1.47", "2.13", "2.02-2.24", "-0.43"],
        ["5", "900", "-", "-", "3.21", "1.34", "-", "2.13", "-", "-"],
    ]


def test_the_regime_of_a_cage_tells_whether_the_start_decides() -> None:
    whirls = {**moved("grip_share", "grip_number", "race_excess"), "state": "whirl"}
    steady = {**moved("other/"), "state": "rest"}
    table = regime_table({3: moved(), 4: whirls, 5: steady})
    motion, time = ["360", "4.4", "23.5"], "0.24 s in blocks of 0.012 s"
    other = "irregular from whirl, 2.2 N mm"
    assert table.groups[0].rows == [
        ["3", "900", "irregular", *motion, "37 %", "0.83", "+0.31", time, other],
        ["4", "900", "whirl", *motion, "unknown", "unknown", "", time, f"{other}: the start decides"],
        ["5", "900", "rest", *motion, "37 %", "0.83", "+0.31", time, "no whirl: one steady motion"],
    ]
