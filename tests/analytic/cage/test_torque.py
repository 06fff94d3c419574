"""The cage in the torque of a bearing: its method and the reason, what it adds, and what the JSON says of it."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from analytic import friction_torque, load_scene
from analytic.cage.pocket_friction import friction_in_pocket
from analytic.cage.statistics import measured_motion
from analytic.cage.torque import driven_cage
from analytic.effects.ledger import Effect
from analytic.errors import InputError
from analytic.result import FrictionTorque
from analytic.scene import Bearing, ContactAngle, Land, Operation, Scene
from tests.analytic.scenefile.scene_texts import MINE, changed, refusal
from tests.analytic.scenefile.scene_texts import scene as scene_of
from tests.analytic.specimens import FINISH, OIL, STAMPED_CAGE

RPM = np.pi / 30


@pytest.fixture(scope="module")
def scene(bearing_6205: Bearing) -> Scene:
    return Scene(
        name="test",
        tolerance=0.05,
        bearing=bearing_6205,
        contact_angle=ContactAngle(rule="given", value=0.18),
        operation=Operation(axial_load=np.array([1000.0, 1000.0]), inner_speed=np.array([20.0, 500.0]) * RPM),
        cage=replace(STAMPED_CAGE, seeds=2, duration=0.03),
        friction_coefficient=0.1,
        effects={"finite_geometry": "off", "spin": "on"},
    )


def with_cage(scene: Scene, **change: Any) -> Scene:
    assert scene.cage is not None
    return replace(scene, cage=replace(scene.cage, **change))


def effect_of(result: FrictionTorque, name: str) -> Effect:
    return next(effect for effect in result.effects if effect.name == name)


def assert_rests(result: FrictionTorque, reason: str) -> None:
    """The motion is left out for this reason, and nothing moved."""
    effect = effect_of(result, "cage_dynamics")
    assert effect.decision == "off"
    assert reason in effect.reason
    assert result.cage is not None
    assert not any(result.cage.motion)


def test_without_a_start_the_closed_form_is_used(scene: Scene) -> None:
    result = friction_torque(scene)
    assert result.torque.cage is not None
    assert result.cage is not None
    # mu m g r w_b/w by hand: 0.0604 N mm; friction that leans out of the plane takes less than 2 % of it
    np.testing.assert_allclose(result.torque.cage, 0.1 * 6.58e-3 * 9.80665 * 15.599e-3 * 23.411 / 39.01, rtol=0.02)
    np.testing.assert_allclose(result.torque.total, result.torque.race + result.torque.cage, rtol=1e-12)
    # The cage hangs off the vertical by the angle of friction.
    np.testing.assert_allclose(result.cage.mean_force, 6.58e-3 * 9.80665 * np.cos(np.arctan(0.1)), rtol=1e-9)
    assert_rests(result, "cage.start is not given")
    # (w_b r)^2/(g nabla) at 500 rpm, with w_b r = w R_i R_o/d_m by hand: 52.36 x 15.599 x 23.411/39.01 mm/s
    assert_rests(result, f"{0.49016**2 / (9.80665 * 0.1e-3):.3g}")
    assert any("cage_dynamics is left out and could be" in warning for warning in result.warnings)
    point = result.to_json()["points"][1]
    assert point["cage"]["state"] == "rest"
    assert point["cage"]["max_force"] is None
    assert point["friction_coefficient"]["pocket"] == 0.1


def test_a_cage_that_cannot_whirl_has_the_closed_form(scene: Scene) -> None:
    slow = replace(scene, operation=Operation(axial_load=np.array([1000.0]), inner_speed=np.array([20.0]) * RPM))
    # The whirl number above by (20/500)^2
    assert_rests(friction_torque(with_cage(slow, start="sudden")), "whirl number 0.392")


def test_a_motion_within_the_tolerance_is_left_out(scene: Scene) -> None:
    assert_rests(friction_torque(with_cage(replace(scene, tolerance=0.9), start="sudden")), "within what 0.45 leaves")
    off = replace(with_cage(scene, start="sudden"), effects={**scene.effects, "cage_dynamics": "off"})
    assert_rests(friction_torque(off), "the scene says off")


def test_auto_does_not_move_a_long_series(scene: Scene) -> None:
    many = Operation(axial_load=np.full(3000, 1000.0), inner_speed=np.linspace(100, 500, 3000) * RPM)
    result = friction_torque(with_cage(replace(scene, operation=many), start="rest"))
    assert_rests(result, "3000 points take 540 s of motion")  # twice 0.03 s for two seeds and another start
    (warning,) = (warning for warning in result.warnings if "cage_dynamics is left out" in warning)
    assert "3000 points take 540 s of motion" in warning
    assert 'effects.cage_dynamics = "on"' in warning


def test_with_more_steps_auto_allows_less_motion(scene: Scene) -> None:
    """A second of motion in 25 times the steps is as much work as 25 s."""
    many = Operation(axial_load=np.full(150, 1000.0), inner_speed=np.linspace(100, 500, 150) * RPM)
    given = with_cage(replace(scene, operation=many), start="rest", steps_per_contact=1000)
    assert_rests(friction_torque(given), "27 s of motion, and beyond 20 s at 1000 steps")


def test_the_closed_form_includes_drag(scene: Scene) -> None:
    """Against motions from rest, for a cage whose weight is small next to the drag and one whose weight is not."""
    for drag in (1e-3, 2e-6):
        scene_of = with_cage(replace(scene, tolerance=0.9), drag=drag, start="rest", duration=0.05)
        closed = friction_torque(replace(scene_of, effects={**scene.effects, "cage_dynamics": "off"})).cage
        moved = friction_torque(replace(scene_of, effects={**scene.effects, "cage_dynamics": "on"})).cage
        assert closed is not None
        assert moved is not None
        # The part of the weight, 0.0604 N mm and 0.0642 N, is less where the same forces carry and push. The cage
        # swings: 2 %.
        beyond = closed.torque - moved.torque
        assert np.all((-0.02 * moved.torque < beyond) & (beyond < 0.0604e-3 + 0.02 * moved.torque))
        pressed = closed.mean_force - moved.mean_force
        assert np.all((-0.02 * moved.mean_force < pressed) & (pressed < 0.0642 + 0.02 * moved.mean_force))
        np.testing.assert_allclose(closed.signed_moment, moved.signed_moment, rtol=0.02)
        assert closed.at(1)["signed_moment"] == closed.signed_moment[1]
        back = replace(scene_of.operation, inner_speed=-scene.operation.inner_speed)
        mirrored = friction_torque(
            replace(scene_of, operation=back, effects={**scene.effects, "cage_dynamics": "off"})
        ).cage
        assert mirrored is not None
        np.testing.assert_allclose(mirrored.signed_moment, -closed.signed_moment, rtol=1e-12)


def test_the_closed_form_names_what_it_leaves_out(scene: Scene) -> None:
    aside = with_cage(scene, ball_lead=0.03e-3, land=Land(ring="outer", clearance=0.3e-3, width=9e-3))
    assert friction_torque(aside).provenance["cage"].startswith("closed form at rest, without land and ball_lead,")


@pytest.mark.parametrize("ring", ["inner", "outer"])
def test_the_motion_is_that_of_the_scene(scene: Scene, ring: Any) -> None:
    """Every key of the cage reaches the motion. The land is where the circle of the groove reaches the shoulder."""
    change: dict[str, Any] = {"restitution": 0.37, "drag": 3e-6, "ball_lead": 0.02e-3, "pocket_stiffness": 7.7e9}
    change |= {"pocket_axis": "radial", "gravity": "along", "pocket_depth": 4.05e-3}
    aside = with_cage(scene, land=Land(ring=ring, clearance=0.3e-3, width=9e-3), **change).cage
    assert aside is not None
    driven = driven_cage(
        scene.bearing,
        aside,
        friction_coefficient=0.13,
        inner_speed=-41.0,
        orbit_speed=-16.0,
        ball_speed=-95.0,
        contact_angle=0.21,
    )
    assert {name: getattr(driven, name) for name in ("restitution", "drag", "ball_lead", "pocket_axis")} == {
        name: change[name] for name in ("restitution", "drag", "ball_lead", "pocket_axis")
    }
    assert (driven.stiffness, driven.gravity) == (7.7e9, (0.0, 0.0, -9.80665))
    assert (driven.orbit_speed, driven.ball_speed, driven.ring_speed) == (-16.0, -95.0, -41.0)
    np.testing.assert_allclose([driven.half_clearance, driven.centre_offset], [0.1e-3, 0.02e-3], rtol=1e-9)
    land, bearing = driven.land, scene.bearing
    assert land is not None
    groove = bearing.inner if ring == "inner" else bearing.outer
    assert (land.outside, land.speed) == (ring == "outer", -41.0 if ring == "inner" else 0.0)
    np.testing.assert_allclose([land.half_clearance, land.half_width], [0.15e-3, 4.5e-3], rtol=1e-12)
    # The shoulder is on the groove's circle, towards the balls.
    towards = 1 if ring == "inner" else -1
    middle = groove.bottom_radius + towards * groove.groove_radius
    np.testing.assert_allclose(
        np.hypot(land.radius - middle, groove.shoulder_half_width), groove.groove_radius, rtol=1e-12
    )
    assert 0 < towards * (land.radius - groove.bottom_radius) < groove.groove_radius


def test_a_start_calls_for_the_motion(scene: Scene) -> None:
    found = friction_torque(with_cage(scene, start="whirl"))
    assert found.cage is not None
    assert found.torque.cage is not None
    slow, fast = found.cage.motion
    assert slow is not None
    assert fast is not None
    assert (slow.state, fast.state) == ("irregular", "whirl")  # the slow cage cannot whirl and still swings
    assert found.torque.cage[1] == fast.torque
    np.testing.assert_allclose(found.cage.half_interval, [np.diff(m.torque_interval)[0] / 2 for m in (slow, fast)])
    share = found.cage.half_interval / found.torque.total
    assert np.all(found.numerical_uncertainty >= share)
    point = found.to_json()["points"][1]["cage"]
    assert point["state"] == "whirl"
    assert point["max_force"] == fast.max_force
    assert point["interval"] == {"torque": list(fast.torque_interval), "max_force": list(fast.max_force_interval)}
    np.testing.assert_allclose(point["mean_force"], 15.95, rtol=0.02)  # m (w_b r/nabla + w_c)^2 nabla by hand
    assert point["duration"] == 0.06
    (warning,) = (warning for warning in found.warnings if "more than one steady motion" in warning)
    assert 'cage.start = "whirl" leads to whirl' in warning
    assert '"rest" to rest' in warning
    assert (
        found.provenance["cage"]
        == 'motion from "whirl", 40 steps a contact, pocket stiffness by Hertz, friction by friction.coefficient'
    )
    back = replace(scene.operation, inner_speed=-scene.operation.inner_speed)
    mirrored = friction_torque(with_cage(replace(scene, operation=back), start="whirl"))
    assert mirrored.torque.cage is not None
    # The disturbance is not mirrored, as with other seeds. The slow cage is not steady after so short a time.
    np.testing.assert_allclose(mirrored.torque.cage[1], found.torque.cage[1], rtol=0.03)


def test_at_standstill_the_closed_form_is_the_limit(scene: Scene) -> None:
    still = replace(scene, operation=Operation(axial_load=np.array([1000.0]), inner_speed=np.array([0.0])))
    found = friction_torque(replace(with_cage(still, start="rest"), effects={**scene.effects, "cage_dynamics": "on"}))
    assert found.cage is not None
    assert found.cage.motion == (None,)
    assert found.cage.torque[0] > 0


@pytest.mark.parametrize(("gravity", "part"), [("along", 0.179), ("off", 0.0)])
def test_the_closed_form_follows_gravity(scene: Scene, gravity: Any, part: float) -> None:
    """Along the axis the ball surfaces slide with the share sin(0.18) = 0.179; without gravity they press on nothing."""
    found = friction_torque(with_cage(scene, gravity=gravity)).torque.cage
    assert found is not None
    np.testing.assert_allclose(found, part * 0.0604e-3, rtol=2e-3)


def test_without_cage_or_with_the_cage_left_out_nothing_is_added(scene: Scene) -> None:
    for left in (replace(scene, cage=None), replace(scene, effects={**scene.effects, "cage": "off"})):
        found = friction_torque(left)
        assert found.cage is None
        assert found.torque.cage is None
        assert effect_of(found, "cage").decision == effect_of(found, "cage_dynamics").decision == "off"
        assert set(found.to_json()["points"][0]["cage"].values()) == {None}


def test_a_motion_needs_its_start(scene: Scene) -> None:
    with pytest.raises(InputError, match=r'effects\.cage_dynamics = "on" cannot be had: cage\.start is not given'):
        friction_torque(replace(scene, effects={**scene.effects, "cage_dynamics": "on"}))


def test_friction_comes_from_cage_oil_or_races(scene: Scene) -> None:
    races = friction_in_pocket(scene, load=0.5, surface_speed=0.3)
    assert (float(races.coefficient), races.source) == (0.1, "friction.coefficient")
    own = friction_in_pocket(with_cage(scene, friction_coefficient=0.07), load=0.5, surface_speed=0.3)
    assert (float(own.coefficient), own.source) == (0.07, "cage.friction_coefficient")
    oiled = replace(scene, friction_coefficient=None, lubricant=OIL, surface=FINISH)
    still = friction_in_pocket(oiled, load=0.5, surface_speed=0.0)
    np.testing.assert_allclose(still.coefficient, 0.11, rtol=1e-6)  # asperities carry all
    fast = friction_in_pocket(oiled, load=0.5, surface_speed=[0.003, 0.3])
    assert 0.11 > fast.coefficient[0] > fast.coefficient[1] > 0
    resting = friction_torque(oiled)
    one = friction_in_pocket(oiled, load=6.58e-3 * 9.80665 / 9, surface_speed=0.49016 * np.array([0.04, 1.0]))
    assert resting.friction_coefficient.pocket is not None
    np.testing.assert_allclose(
        resting.friction_coefficient.pocket, one.coefficient, rtol=1e-4
    )  # the digits of the speed
    (warning,) = fast.warnings
    assert "thicker than their clearance" in warning
    with pytest.raises(InputError, match="friction of ball on pocket is not known"):
        friction_in_pocket(replace(scene, friction_coefficient=None), load=0.5, surface_speed=0.3)


CASE = changed("90 rpm", "500 rpm", MINE) + "[cage]\n"


def test_the_motion_is_read_from_the_scene_file() -> None:
    text = CASE + (
        'start = "sudden"\nseeds = 7\nduration = "0.3 s"\nrestitution = 0.6\ngravity = "along"\ndrag = "2e-6 N m s"\n'
        "steps_per_contact = 57\n"
        'pocket_axis = "radial"\nball_lead = "-30 um"\nfriction_coefficient = 0.08\n'
        'pocket_approach = { load = "28 N", approach = "0.9 um" }\n'
        'land = { ring = "outer", clearance = "0.3 mm", width = "9 mm" }\n'
    )
    cage = scene_of(text).cage
    assert cage is not None
    assert (cage.start, cage.seeds, cage.duration, cage.restitution) == ("sudden", 7, 0.3, 0.6)
    assert cage.steps_per_contact == 57
    assert (cage.gravity, cage.drag, cage.pocket_axis, cage.ball_lead) == ("along", 2e-6, "radial", -30e-6)
    assert cage.friction_coefficient == 0.08
    assert cage.land == Land(ring="outer", clearance=0.3e-3, width=9e-3)
    assert cage.pocket_stiffness == pytest.approx(28 / 0.9e-6**1.5, rel=1e-12)


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ('start = "still"', ["cage.start = 'still'", "'sudden'"]),
        ("seeds = 1", ["cage.seeds = 1", "2 to 1000"]),
        ("steps_per_contact = 9", ["cage.steps_per_contact = 9", "10 to 1000"]),
        ("steps_per_contact = 40.5", ["cage.steps_per_contact = 40.5", "whole number"]),
        ('duration = "0 s"', ["cage.duration", "0.0001 to 1000 s"]),
        ("restitution = 1.2", ["cage.restitution = 1.2", "0.05 to 1"]),
        ('ball_lead = "0.21 mm"', ["cage.ball_lead = '0.21 mm'", "beyond the clearance", "0.2 mm or more"]),
        ('pocket_depth = "3.9 mm"', ["cage.pocket_depth = '3.9 mm'", "ball radius 3.97 mm"]),
        ('pocket_approach = { load = "28 N" }', ["cage.pocket_approach.approach is missing"]),
        ('land = { ring = "middle", clearance = "0.3 mm", width = "9 mm" }', ["cage.land.ring = 'middle'"]),
    ],
)
def test_an_impossible_cage_is_refused_by_its_key(line: str, words: list[str]) -> None:
    message = refusal(CASE + line)
    assert not [word for word in words if word not in message], message


def test_a_motion_without_a_cage_is_refused() -> None:
    message = refusal(MINE + '[effects]\ncage_dynamics = "on"')
    assert "effects.cage_dynamics = 'on' needs a table [cage]" in message


def test_a_scene_file_with_a_motion_runs(tmp_path: Path) -> None:
    (tmp_path / "case.toml").write_text(CASE + 'start = "rest"\nseeds = 2\nduration = "20 ms"', "utf-8")
    found = friction_torque(load_scene(tmp_path / "case.toml"))
    assert found.cage is not None
    motion = found.cage.motion[0]
    assert motion is not None
    assert motion.state == "rest"


def test_the_scene_sets_the_steps(scene: Scene) -> None:
    """An irregular motion forgets its beginning, so two numbers of steps give two results."""
    motions = {}
    for steps in (21, 57):
        given = with_cage(replace(scene, effects={**scene.effects, "cage_dynamics": "on"}), steps_per_contact=steps)
        cage = friction_torque(with_cage(given, start="sudden")).cage
        assert cage is not None
        assert f"{steps} steps a contact" in cage.provenance
        driven = cage.driven[1]
        assert driven is not None
        motions[steps] = cage.motion[1]
        assert motions[steps] == measured_motion(
            driven, start="sudden", seeds=2, duration=0.03, steps_per_contact=steps
        )
    assert motions[21] != motions[57]
