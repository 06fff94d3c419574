"""The tilt of a single bearing's ring in the torque of a scene: held, given, or free under a moment."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.function import torque_function
from analytic.result import FrictionTorque
from analytic.scene import ContactAngle, Operation, Scene
from analytic.scenefile.parts import operation
from analytic.torque import friction_torque
from analytic.verdicts import PhysicalCheck, physical_checks
from tests.analytic.scenefile.scene_texts import MINE, changed, refusal, scene
from tests.analytic.specimens import BEARING_6205, dry, present
from tests.refusals import refused

LOADS: dict[str, Any] = {"axial_load": np.array([290.0, 610.0]), "radial_load": np.array([730.0, 340.0])}
SOLVED = ContactAngle(rule="solved")


def at(**given: Any) -> Scene:
    loads = Operation(inner_speed=np.array([70.0, 45.0]), **{**LOADS, **given})
    # The factors of finite geometry belong to the equilibrium by Hertz, where the moment is a little another.
    effects = {"finite_geometry": "off", "weight": "off"}
    return replace(dry(BEARING_6205), contact_angle=SOLVED, operation=loads, effects=effects, spin_rule="balanced")


def torque(**given: Any) -> FrictionTorque:
    return friction_torque(at(**given))


@pytest.mark.parametrize("rule", ["balanced", "free"])
def test_the_moment_that_holds_a_ring_has_the_same_torque_when_it_is_given(rule: Any) -> None:
    for tilt in (None, 0.0, 7e-4):
        held = friction_torque(replace(at(tilt=tilt), spin_rule=rule))
        ring = present(held.ring)
        moment = present(ring.holding_moment)
        assert np.abs(moment).min() > 0.1
        free = friction_torque(replace(at(moment=moment), spin_rule=rule))
        # Free balls are steady to 1e-6 of their forces, on a ring that is soft against tilts.
        soft = 1e-4 if rule == "free" else 1e-9
        np.testing.assert_allclose(present(present(free.ring).displacement)[:, 4], tilt or 0.0, rtol=0, atol=0.1 * soft)
        np.testing.assert_allclose(free.torque.total, held.torque.total, rtol=soft)
        np.testing.assert_array_equal(present(ring.tilt), tilt or 0.0)
        assert present(free.ring).holding_moment is None


def checked(found: FrictionTorque) -> PhysicalCheck | None:
    return next((each for each in physical_checks(found) if each.name == "tilt"), None)


def test_a_tilt_beyond_what_catalogues_allow_fails() -> None:
    assert checked(torque()) is None
    slight = present(checked(torque(tilt=2.9e-3)))
    assert (slight.verdict, slight.limit, slight.unit) == ("pass", 3e-3, "rad")
    found = torque(moment=np.array([0.2, 40.0]))
    far = present(checked(found))
    assert (far.verdict, far.point) == ("fail", 1)
    assert far.value == pytest.approx(present(present(found.ring).tilt)[1], rel=1e-9)


def test_a_moment_and_a_tilt_are_refused() -> None:
    refused(lambda: torque(tilt=0.0, moment=np.array([0.0, 0.7])), "operation.tilt = 0 rad holds the ring")
    given = replace(at(tilt=3e-4), contact_angle=ContactAngle(rule="given", value=0.3))
    refused(lambda: friction_torque(given), "changes the contact angles")
    refused(lambda: operation(inner_speed=3.0, moment=0.0, tilt="1 mrad"), "leave one of them out")


@pytest.mark.parametrize(
    ("more", "tilt"),
    [
        ("", None),
        ('tilt = "0 mrad"', 0.0),
        ('tilt = "-0.3 mrad"', -3e-4),
        ('tilt = "free"', "free"),
        ('moment = "0 N m"', "free"),
        ('moment = "2 N m"\ntilt = "free"', "free"),
    ],
)
def test_a_scene_says_how_its_ring_tilts(more: str, tilt: object) -> None:
    text = changed('"700 N"', f'"700 N"\n{more}').replace('"given", value', '"solved", free')
    assert scene(text).operation.tilt == tilt


def test_a_tilt_goes_with_a_single_bearing_whose_angles_follow_from_it() -> None:
    pair = '[arrangement]\nkind = "O"\npreload = "80 N"\ndistance = "30 mm"\n'
    tilted = changed('"700 N"', '"700 N"\ntilt = "0.3 mrad"')
    assert 'which rule = "given" holds' in refusal(changed('"700 N"', '"700 N"\ntilt = "0.3 mrad"', MINE))
    assert "tilt the shaft of a pair" in refusal(tilted + pair)


def test_a_function_of_a_held_ring_takes_no_moment() -> None:
    held = torque_function(at())
    given = {"axial_load": 290.0, "radial_load": 730.0, "inner_speed": 70.0}
    assert held(**given) == pytest.approx(torque().torque.total[0], rel=1e-6)  # by one method of sliding for all calls
    refused(lambda: held(moment=0.4, **given), "operation.tilt = 0 rad holds the ring")
    with pytest.raises(InputError, match="leave one of them out"):
        held.series(moment=[0.0, 0.4], **given)
    assert "moment" not in held.gradient(**given)
    free = torque_function(at(tilt="free"))
    moment = present(present(torque().ring).holding_moment)[0]
    assert free(moment=moment, **given) == pytest.approx(held(**given), rel=1e-6)
    tilted = torque_function(at(tilt=9e-4))
    alone = {"axial_load": 290.0, "inner_speed": 70.0}
    at_thrust = friction_torque(at(tilt=9e-4, radial_load=0.0)).torque.total[0]
    assert tilted(**alone) == pytest.approx(at_thrust, rel=1e-6)
    np.testing.assert_allclose(tilted.series(**alone), at_thrust, rtol=1e-6)
