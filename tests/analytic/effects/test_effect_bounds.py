"""Bounds of effects that no trial measures meet what these effects change where they have their input."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.effects.table import PER_CENTRIFUGAL, PER_DISTRIBUTION
from analytic.effects.trial import possible, trial_of, unequal_loads
from analytic.oil.variation import NOMINAL
from analytic.scene import Array, Bearing, ContactAngle, Decision, Operation, Scene
from analytic.torque import friction_torque
from tests.analytic.specimens import EVERYTHING, drawn, idling, without

# Of the change: both torques come from contact angles and shares of load solved to 1e-9 or better.
NOISE = 1e-8
DIRECTIONS = ((1.0, 0.0, 0.0), (0.0, 0.6, -0.8), (0.0, 0.0, 1.0))


def changes(scene: Scene, name: str) -> Array:
    """(n,) relative, of the torque where an effect is left out."""
    return np.abs(friction_torque(without(scene, name)).torque.total / friction_torque(scene).torque.total - 1)


def bounds(scene: Scene) -> dict[str, Array]:
    """(n,) of each effect that may lack its input, as a scene without this input states it."""
    trial = trial_of(scene, scene.operation.as_series(), None, NOMINAL)
    counted = possible(scene)
    own = trial.solved(counted).points
    under_thrust = trial.solved({**counted, "load_distribution": False})
    return {
        "load_distribution": PER_DISTRIBUTION * unequal_loads(scene, trial.operation, under_thrust),
        "centrifugal": PER_CENTRIFUGAL * own["centrifugal_share"],
        "gyroscopic": own["gyroscopic_share"],
        "weight": PER_CENTRIFUGAL * own["weight_share"],
    }


@pytest.mark.parametrize("seed", range(8))
def test_no_effect_is_larger_than_its_bound(bearing_6205: Bearing, seed: int) -> None:
    scene = drawn(bearing_6205, np.random.default_rng(seed), points=4)
    known = bounds(scene)
    for name in ("load_distribution", "centrifugal", "gyroscopic"):
        if possible(scene)[name]:
            assert np.all(changes(scene, name) <= known[name] + NOISE), name
    for down in DIRECTIONS:
        heavy = replace(scene, down=down, effects={**scene.effects, "weight": "on"})
        assert np.all(changes(heavy, "weight") <= known["weight"] + NOISE), down


@pytest.mark.parametrize("seed", range(8))
def test_creep_changes_no_more_than_its_bound(bearing_6205: Bearing, seed: int) -> None:
    """Of balls that turn freely with and without it, in oil and dry."""
    ruled = drawn(bearing_6205, np.random.default_rng(400 + seed), points=3)
    thrust = replace(ruled.operation, radial_load=np.zeros(3))
    effects = {**EVERYTHING, "load_distribution": "off", "creep": "on"} | {
        name: "auto" for name in ("asperities",) if ruled.surface is None
    }
    free = replace(ruled, spin_rule="free", sliding="auto", tolerance=0.01, operation=thrust, effects=effects)
    settled = friction_torque(free).settled(free)
    bound = next(effect.share for effect in friction_torque(free).effects if effect.name == "creep")
    rolling = replace(without(settled, "creep"), sliding="free_ball")
    measured = np.abs(friction_torque(rolling).torque.total / friction_torque(settled).torque.total - 1)
    assert bound is not None
    # Both torques are uncertain by less than their tolerance.
    assert np.all(measured <= bound + 2 * free.tolerance)


@pytest.mark.parametrize("seed", range(6))
def test_balls_turn_by_rule_where_their_inertia_hardly_counts(bearing_6205: Bearing, seed: int) -> None:
    ruled = drawn(bearing_6205, np.random.default_rng(500 + seed), points=4)
    thrust = replace(ruled.operation, radial_load=np.zeros(4), inner_speed=0.2 * ruled.operation.inner_speed)
    scene = replace(ruled, spin_rule="free", sliding="auto", tolerance=0.05, operation=thrust, effects={"creep": "off"})
    auto, free = friction_torque(scene), friction_torque(replace(scene, sliding="free_ball"))
    error = np.abs(auto.torque.total / free.torque.total - 1)
    assert np.all(error <= auto.numerical_uncertainty + free.numerical_uncertainty)


def test_balls_that_the_load_leaves_free_roll_on_the_outer_race_by_centrifugal_force(bearing_6205: Bearing) -> None:
    aside = Operation(
        axial_load=np.array([0.0, 0.0]), inner_speed=np.array([30.0, 4.1]), radial_load=np.array([50.0, 140.0])
    )
    bath = replace(idling(bearing_6205), operation=aside, effects=EVERYTHING)
    assert np.all(changes(bath, "centrifugal") < 1e-3)  # they roll in oil without a load too, against the same force
    alone: dict[str, Decision] = {"unloaded_balls": "off"}
    scene = replace(bath, effects={**EVERYTHING, **alone})
    measured = changes(scene, "centrifugal")
    assert np.all(measured > 0.01)  # by a 1e-4th of the load
    assert np.all(measured <= bounds(scene)["centrifugal"])
    many = Operation(**{name: np.repeat(values, 5) for name, values in vars(aside).items() if np.ndim(values)})
    assert friction_torque(replace(scene, operation=many, effects=alone, tolerance=0.015)).is_on("centrifugal")


def test_a_moment_loads_balls_unequally_by_no_more_than_its_bound(bearing_6205: Bearing) -> None:
    """The largest change that was found beside its bound, and a radial load."""
    operation = Operation(
        axial_load=np.array([218.0, 139.0]),
        inner_speed=np.array([0.32, 1.23]),
        radial_load=np.array([0.0, 190.0]),
        moment=np.array([1.16, 0.0]),
    )
    scene = replace(
        idling(bearing_6205),
        bearing=drawn(bearing_6205, np.random.default_rng(1), points=2).bearing,
        contact_angle=ContactAngle(rule="solved", free=0.43),
        operation=operation,
        spin_rule="inner_control",
        effects=EVERYTHING,
    )
    measured = changes(scene, "load_distribution")
    assert np.all(measured > 0.1)
    assert np.all(measured <= bounds(scene)["load_distribution"])
