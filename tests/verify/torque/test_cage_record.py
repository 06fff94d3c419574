"""How many instants of a cage's motion are kept."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.cage.steady import whirl_force
from fembearing.verify.torque import cage_record as module
from fembearing.verify.torque.cage_record import FEWEST, INSTANTS_A_TURN, MOST, record_cage
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
