"""Properties of the total torque that hold for any numbers; hypothesis draws them."""

from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given, settings

from analytic import friction_torque, load_scene
from analytic.effects import COMPUTED
from analytic.errors import InputError
from analytic.scene import Autocorrelation, ContactAngle, Decision, Operation, Scene
from tests.analytic.specimens import present

BASE = load_scene(Path(__file__).parents[1] / "validation" / "scenes" / "6205_physical.toml")
# From SKF's catalogue, fitted in millimetres and revolutions per minute: these formulas obey no scaling.
EMPIRICAL = ("inlet_heating", "starvation")
FEW = settings(max_examples=15)  # about 50 ms each

loads = st.floats(1.0, 3.3).map(lambda power: 10**power)  # N
speeds = st.floats(-0.5, 3.0).map(lambda power: 10**power)  # rad/s
oils = st.floats(-2.3, -0.6).map(lambda power: 10**power)  # Pa s
finishes = st.floats(-8, -6).map(lambda power: 10**power)  # m
angles = st.floats(0.05, 0.45)  # rad
scenes = st.builds(
    lambda load, speed, oil, finish, angle: scene_of(load, speed, oil, finish, angle),
    *(loads, speeds, oils, finishes, angles),
)


def scene_of(load: float, speed: float, oil: float, finish: float, angle: float) -> Scene:
    """Every effect is computed, by the method that leaves nothing out; the correction covers races as wide as these."""
    inner, outer = (replace(ring, shoulder_half_width=3.6e-3) for ring in (BASE.bearing.inner, BASE.bearing.outer))
    effects: dict[str, Decision] = {**dict.fromkeys(COMPUTED, "on"), "weight": "off"}
    return replace(
        BASE,
        bearing=replace(BASE.bearing, inner=inner, outer=outer),
        operation=Operation(axial_load=np.array([load]), inner_speed=np.array([speed])),
        lubricant=replace(present(BASE.lubricant), viscosity=oil),
        surface=replace(present(BASE.surface), rms_roughness=finish),
        contact_angle=ContactAngle(rule="solved", free=angle),
        effects=effects,
    )


def torque_of(scene: Scene) -> float:
    return float(friction_torque(scene).torque.total[0])


def enlarged(given: Any, size: float) -> Any:
    """Multiplies every length by `size` and every force by its square, so stresses and speeds stay the same."""
    powers = {
        **dict.fromkeys(("bottom_radius", "groove_radius", "shoulder_half_width", "ball_diameter"), 1),
        **dict.fromkeys(("bore_diameter", "outside_diameter", "width", "rms_roughness", "length", "spacing"), 1),
        **dict.fromkeys(("axial_load", "radial_load", "static_load_rating"), 2),
        # Inertia and heat scale differently: density falls with the square of the size, conductivity grows with it.
        "ball_mass": 1,
        "moment": 3,
        "thermal_conductivity": 2,
    }
    changes: dict[str, Any] = {}
    for part in fields(given):
        value = getattr(given, part.name)
        if hasattr(value, "__dataclass_fields__"):
            changes[part.name] = enlarged(value, size)
        elif part.name in powers and value is not None:
            changes[part.name] = value * size ** powers[part.name]
    return replace(given, **changes)


@FEW
@given(scene=scenes, size=st.floats(0.3, 3))
def test_torque_grows_with_the_cube_of_the_size(scene: Scene, size: float) -> None:
    """At the same stresses and speeds: no formula depends on the unit of length or force.

    The oil is so thick that its film is many molecules thick, which do not grow.
    """
    assert scene.lubricant is not None
    thick = replace(scene.lubricant, viscosity=2.0)
    plain = replace(scene, cage=None, lubricant=thick, effects=dict(scene.effects) | dict.fromkeys(EMPIRICAL, "off"))
    expected = torque_of(plain) * size**3
    # Iterations end at 1e-8 or better, but round-off may cause one more step.
    assert torque_of(enlarged(plain, size)) == pytest.approx(expected, rel=1e-6)


@FEW
@given(scene=scenes)
def test_turning_backwards_gives_the_same_torque(scene: Scene) -> None:
    back = replace(scene, operation=replace(scene.operation, inner_speed=-scene.operation.inner_speed))
    assert torque_of(back) == pytest.approx(torque_of(scene), rel=1e-12)  # round-off


@FEW
@given(scene=scenes, radial=st.floats(-0.5, 0.5), moment=st.floats(-0.003, 0.003))
def test_a_mirrored_load_gives_the_same_torque(scene: Scene, radial: float, moment: float) -> None:
    """Radial load and moment change sign together; with an even number of balls each ball has a mirror image."""
    load = scene.operation.axial_load[0]
    even = replace(scene, bearing=replace(scene.bearing, ball_count=8))
    both = [
        replace(even, operation=replace(even.operation, radial_load=sign * radial * load, moment=sign * moment * load))
        for sign in (1, -1)
    ]
    assert torque_of(both[0]) == pytest.approx(torque_of(both[1]), rel=1e-6)  # the ring converges to 1e-12 of its loads


@FEW
@given(scene=scenes)
def test_the_torque_is_continuous_in_every_input(scene: Scene) -> None:
    """A small change of an input changes the torque a little: no formula has a step, and no input is clipped."""
    assert scene.surface is not None
    before = torque_of(scene)
    operation, oil = scene.operation, present(scene.lubricant)
    more = 1 + 1e-6
    for name, other in {
        "load": replace(scene, operation=replace(operation, axial_load=operation.axial_load * more)),
        "speed": replace(scene, operation=replace(operation, inner_speed=operation.inner_speed * more)),
        "viscosity": replace(scene, lubricant=replace(oil, viscosity=oil.viscosity * more)),
        "free angle": replace(scene, contact_angle=replace(scene.contact_angle, free=scene.contact_angle.free * more)),  # pyright: ignore[reportOptionalOperand]
    }.items():
        change = abs(torque_of(other) / before - 1)
        assert change < 100e-6, name  # exponents are below 10
        assert change > 1e-12, name


@FEW
@given(scene=scenes, more=st.floats(1.05, 3))
def test_a_given_coefficient_costs_more_under_more_load(scene: Scene, more: float) -> None:
    dry = replace(scene, lubricant=None, surface=None, friction_coefficient=0.08)
    dry = replace(dry, effects=dict.fromkeys(("spin", "conformity", "hysteresis"), "on"))
    heavier = replace(dry, operation=replace(dry.operation, axial_load=dry.operation.axial_load * more))
    assert torque_of(heavier) > torque_of(dry)


@FEW
@given(scene=scenes, name=st.sampled_from(["viscosity", "eyring_stress", "axial_load", "inner_speed", "rms_roughness"]))
def test_nan_and_infinity_are_refused(scene: Scene, name: str) -> None:
    """NaN or infinity in one input never gives a result."""
    assert scene.surface is not None
    for bad in (np.nan, np.inf):
        if name in ("axial_load", "inner_speed"):
            broken = replace(scene, operation=replace(scene.operation, **{name: np.array([bad])}))
        elif name == "rms_roughness":
            correlation = Autocorrelation(kind="gaussian", length=30e-6, spacing=2e-6)
            broken = replace(scene, surface=replace(scene.surface, rms_roughness=bad, autocorrelation=correlation))
        else:
            broken = replace(scene, lubricant=replace(present(scene.lubricant), **{name: bad}))
        with pytest.raises(InputError):
            friction_torque(broken)
