"""What is kept of a cage's motion: how many instants, its room, its orbit and its forces."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.cage.series import CageSeries
from analytic.cage.steady import whirl_force
from fembearing.check import cage_record as module
from fembearing.check.cage_record import FEWEST, INSTANTS_A_TURN, MOST, CageRecord, exceedance, record_cage
from tests.analytic.cage.specimens import CAGE, CAGED, with_cage


@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_a_circle_of_the_whirl_has_its_instants_as_it_is_seen_from_the_housing(
    monkeypatch: pytest.MonkeyPatch, sign: float
) -> None:
    """The force that holds a whirling cage is m W^2 nabla, which tells W, in turns of the cage in space.

    The pockets are so wide that the turn of the orbit is a twentieth of it.
    """
    kept: dict[str, Any] = {}
    monkeypatch.setattr(module, "CageMotion", lambda *_, **__: None)
    monkeypatch.setattr(module, "recorded_motion", lambda _, **how: kept.update(how))
    cage = replace(
        CAGE,
        half_clearance=0.9e-3,
        **{name: sign * getattr(CAGE, name) for name in ("orbit_speed", "ball_speed", "ring_speed")},
    )
    part = SimpleNamespace(driven=[cage], motion=[SimpleNamespace(start="whirl")], races=[None])
    friction: Any = SimpleNamespace(cage=part)
    record_cage(with_cage(CAGED, duration=0.7), friction, 0)
    whirl = cage.ball_speed * cage.ball_radius / cage.half_clearance  # its surface moves with those of the balls
    force = whirl_force(
        cage_mass=cage.mass, whirl=whirl, orbit_speed=cage.orbit_speed, half_clearance=cage.half_clearance
    )
    turns = kept["duration"] * np.sqrt(float(force) / (cage.mass * cage.half_clearance)) / (2 * np.pi)
    assert FEWEST < kept["samples"] < MOST  # else the limits would tell
    assert abs(kept["samples"] - INSTANTS_A_TURN * turns) <= 1  # a whole number
    assert abs(cage.orbit_speed / whirl) * INSTANTS_A_TURN * turns > 50  # instants: the turn of the orbit counts


def test_a_cage_that_did_not_move_has_no_record() -> None:
    at_rest: Any = SimpleNamespace(cage=SimpleNamespace(driven=[CAGE], motion=[None], races=[None]))
    without: Any = SimpleNamespace(cage=None)
    assert record_cage(CAGED, at_rest, 0) is None
    assert record_cage(CAGED, without, 0) is None


@pytest.fixture(scope="module")
def record() -> CageRecord:
    """A hundred and seven instants at random, 2 ms apart; the first forty are the start-up."""
    rng, size = np.random.default_rng(7), 107
    series = CageSeries(
        time=np.linspace(2e-3, 2e-3 * size, size),
        ball_angle=np.zeros(size),
        centre=1e-4 * rng.standard_normal((size, 3)),
        velocity=np.zeros((size, 3)),
        axis=np.zeros((size, 3)),
        angular_velocity=np.zeros((size, 3)),
        offset=np.zeros((size, 9, 3)),
        force=rng.standard_normal((size, 9, 3)),
        slip_power=np.zeros(size),
        max_force=rng.lognormal(size=size) * (rng.random(size) > 0.3),
    )
    statistics: Any = SimpleNamespace(
        state="whirl", start="rest", torque=3e-3, torque_interval=(2e-3, 5e-3), max_force=1.7,
        max_force_interval=(1.2, 2.3), block=0.011, block_maxima=[1.4, 1.9],
    )  # fmt: skip
    cage = replace(CAGE, ball_lead=0.07e-3)
    return CageRecord(
        scene=CAGED, point=2, cage=cage, statistics=statistics, series=series, start_up=float(series.time[39])
    )


def test_the_start_up_ends_with_its_last_instant(record: CageRecord) -> None:
    assert np.flatnonzero(record.measured)[0] == 40
    orbit = record.drawn().orbit
    np.testing.assert_array_equal(orbit.start_up, record.series.centre[:40, :2])
    np.testing.assert_array_equal(orbit.measured, record.series.centre[40:, :2])
    assert orbit.joined
    assert not record.drawn(most=30).orbit.joined


def test_the_edge_of_the_room_is_where_the_first_ball_stops_the_cage(record: CageRecord) -> None:
    """Every two degrees once round; there a ball is at the edge of its pocket, and no ball is beyond it."""
    room, cage = record.drawn().room, record.cage
    edge = np.array(room.edge)
    around = np.unwrap(np.arctan2(*(edge - room.middle).T[::-1]))
    np.testing.assert_allclose(np.degrees(around), np.arange(0, 362, 2), atol=1e-9)
    balls = (cage.ball_places(0.0) - cage.pocket_places)[:, :2]
    off = np.linalg.norm(balls[:, None] - edge, axis=2)  # of each ball from the middle of its pocket
    np.testing.assert_allclose(off.max(axis=0), cage.half_clearance, rtol=1e-9)  # round-off
    assert np.linalg.norm(room.middle) > 0.1 * cage.half_clearance  # else the room would be round


def test_forces_of_all_balls_are_added_by_their_size(record: CageRecord) -> None:
    forces = record.drawn().forces
    expected = [sum(np.sqrt(each @ each) for each in instant) for instant in record.series.force]
    np.testing.assert_allclose(forces.sum, expected, rtol=1e-12)  # round-off
    np.testing.assert_array_equal(forces.time, record.series.time)
    np.testing.assert_array_equal(forces.largest, record.series.max_force)


@pytest.mark.parametrize("most", [107, 106, 54, 53, 30, 2])
def test_fewer_instants_end_with_the_last_and_lose_no_peak(record: CageRecord, most: int) -> None:
    forces, series = record.drawn(most=most).forces, record.series
    count = len(forces.time)
    assert count == len(forces.largest) == len(forces.sum)
    assert most / 2 <= count <= most  # as few as whole steps allow
    step = -(-107 // most)
    ends = np.arange(106, -1, -step)[::-1]
    np.testing.assert_array_equal(forces.time, series.time[ends])
    for place, end in enumerate(ends):
        assert forces.largest[place] == series.max_force[max(0, end - step + 1) : end + 1].max()


def test_an_exceedance_is_the_share_of_instants_at_that_force_or_more() -> None:
    force = np.array([0.0, 3.0, 0.7, 0.0, 1.9, 0.2, 5.0, 2.6])
    rising, share = exceedance(force)
    assert rising.tolist() == [0.2, 0.7, 1.9, 2.6, 3.0, 5.0]
    np.testing.assert_array_equal(share, [np.mean(force >= each) for each in rising])
    for most in (6, 7):
        np.testing.assert_array_equal(exceedance(force, most), (rising, share))
    few, of = exceedance(force, 5)
    assert few.size <= 5
    assert few.tolist() == sorted(few.tolist())
    assert set(few.tolist()) >= {0.2, 3.0, 5.0}  # the least, and the rarest ones
    np.testing.assert_array_equal(of, [np.mean(force >= each) for each in few])
