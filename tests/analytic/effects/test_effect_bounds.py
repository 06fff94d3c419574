"""Bounds of effects meet measured shares, and auto meets everything on."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.effects import sliding
from analytic.effects.ledger import Ledger
from analytic.effects.table import COMPUTED
from analytic.scene import Autocorrelation, Bearing, ContactAngle, Operation, Scene
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque
from tests.analytic.specimens import EVERYTHING, FINISH, OIL, drawn, idling, without

BOUNDED = COMPUTED[: COMPUTED.index("spin") + 1]


@pytest.fixture(scope="module")
def scene(bearing_6205: Bearing) -> Scene:
    return idling(bearing_6205)


def shares(
    scene: Scene, monkeypatch: pytest.MonkeyPatch, names: tuple[str, ...] = BOUNDED
) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Of each effect: the change of the torque where it alone is off, over the torque, and its bound, (n,)."""
    told: dict[str, np.ndarray] = {}
    original = Ledger.decide

    def remembered(self: Ledger, name: str, *, bound: np.ndarray | None = None, **other: str | None) -> bool:
        if bound is not None:
            told[name] = bound
        return original(self, name, bound=bound, **other)

    with monkeypatch.context() as patch:
        patch.setattr(Ledger, "decide", remembered)
        whole = friction_torque(scene).torque.total
    measured = {
        name: np.abs(friction_torque(without(scene, name)).torque.total / whole - 1) for name in told if name in names
    }
    return {name: (measured[name], told[name]) for name in measured}


# Of the change: both torques come from contact angles and shares of load solved to 1e-9 or better.
NOISE = 1e-8


@pytest.mark.parametrize("seed", range(8))
def test_no_effect_is_larger_than_its_bound(bearing_6205: Bearing, seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Changes are of the torque with everything on, bounds of the least that there can be."""
    scene = drawn(bearing_6205, np.random.default_rng(seed), points=4)
    for name, (measured, bound) in shares(scene, monkeypatch).items():
        assert np.all(measured <= bound + NOISE), name


@pytest.mark.parametrize("seed", range(8))
def test_creep_changes_no_more_than_its_bound(
    bearing_6205: Bearing, seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of balls that turn freely with and without it, in oil and dry."""
    ruled = drawn(bearing_6205, np.random.default_rng(400 + seed), points=3)
    thrust = replace(ruled.operation, radial_load=np.zeros(3))
    effects = {**EVERYTHING, "load_distribution": "off", "creep": "on"} | {
        name: "auto" for name in ("asperities",) if ruled.surface is None
    }
    free = replace(ruled, spin_rule="free", sliding="auto", tolerance=0.01, operation=thrust, effects=effects)
    measured, bound = shares(free, monkeypatch, ("creep",))["creep"]
    # Both torques are uncertain by less than their tolerance.
    assert np.all(measured <= bound + 2 * free.tolerance)


# Scenes in which bounds that looked only at the size of the load once fell short, found among drawn ones.
LIGHTLY_TOUCHING = {"viscosity": 5.54e-3, "eyring_stress": 3.97e6}  # asperities take 9 % of the area, 0.1 % of the load


def test_asperities_that_touch_lightly_take_area_from_the_oil(
    bearing_6205: Bearing, monkeypatch: pytest.MonkeyPatch
) -> None:
    scene = replace(
        drawn(bearing_6205, np.random.default_rng(3), points=1),
        contact_angle=ContactAngle(rule="solved", free=0.1),
        operation=Operation(axial_load=np.array([1530.0, 1320.0]), inner_speed=np.array([18.7, 2.7])),
        lubricant=replace(OIL, **LIGHTLY_TOUCHING),
        surface=replace(
            FINISH, rms_roughness=13e-9, autocorrelation=Autocorrelation(kind="gaussian", length=165e-6, spacing=8e-6)
        ),
        friction_coefficient=None,
        effects=EVERYTHING,
    )
    measured, bound = shares(scene, monkeypatch, ("asperities",))["asperities"]
    assert np.all(measured > 0.03)
    assert np.all(measured <= bound)


def test_balls_that_the_load_leaves_free_roll_on_the_outer_race_by_centrifugal_force(
    scene: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    aside = Operation(
        axial_load=np.array([0.0, 0.0]), inner_speed=np.array([30.0, 4.1]), radial_load=np.array([50.0, 140.0])
    )
    measured, bound = shares(replace(scene, operation=aside, effects=EVERYTHING), monkeypatch, ("centrifugal",))[
        "centrifugal"
    ]
    assert np.all(measured > 0.01)  # a 1e-4th of the load
    assert np.all(measured <= bound)
    found = friction_torque(replace(scene, operation=aside, tolerance=0.05))
    assert {effect.name: effect.decision for effect in found.effects}["centrifugal"] == "on"


def test_a_moment_loads_balls_unequally_by_no_more_than_its_bound(
    bearing_6205: Bearing, scene: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The largest change that was found beside its bound, and a radial load."""
    operation = Operation(
        axial_load=np.array([218.0, 139.0]),
        inner_speed=np.array([0.32, 1.23]),
        radial_load=np.array([0.0, 190.0]),
        moment=np.array([1.16, 0.0]),
    )
    wide = drawn(bearing_6205, np.random.default_rng(1), points=2).bearing
    asked = replace(
        scene,
        bearing=wide,
        contact_angle=ContactAngle(rule="solved", free=0.43),
        operation=operation,
        spin_rule="inner_control",
        effects=EVERYTHING,
    )
    measured, bound = shares(asked, monkeypatch, ("load_distribution",))["load_distribution"]
    assert np.all(measured > 0.1)
    assert np.all(measured <= bound)


def test_oil_that_its_own_heat_thins_lets_spin_cost_more(scene: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    """Half of the film and less is left there: what shears beside spin is twice the isothermal force and more."""
    hot = replace(
        scene,
        contact_angle=ContactAngle(rule="solved", free=0.4),
        operation=Operation(axial_load=np.array([430.0, 1600.0]), inner_speed=np.array([1000.0, 1070.0])),
        lubricant=replace(OIL, viscosity=0.2, eyring_stress=2.1e6),
        sliding="single_coefficient",
        effects={**EVERYTHING, **dict.fromkeys(("centrifugal", "gyroscopic", "rolling", "starvation"), "off")},
    )
    measured, bound = shares(hot, monkeypatch, ("spin",))["spin"]
    assert np.all(measured > 0.3)
    assert np.all(measured <= bound)


def test_spin_of_light_balls_in_thin_oil_that_pressure_thickens_steeply(
    bearing_6205: Bearing, scene: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Newtonian at the mean pressure, far stiffer in the middle; hydrodynamic rolling makes up most of the torque."""
    groove = 0.5385 * bearing_6205.ball_diameter
    rings = {race: replace(getattr(bearing_6205, race), groove_radius=groove) for race in ("inner", "outer")}
    thin = replace(OIL, viscosity=4e-3, pressure_viscosity=2.74e-8, eyring_stress=7.1e6, limiting_shear=0.09)
    light = replace(
        scene,
        bearing=replace(bearing_6205, **rings),
        contact_angle=ContactAngle(rule="solved", free=0.0864),
        operation=Operation(axial_load=np.array([6.6]), inner_speed=np.array([4.86])),
        lubricant=thin,
        sliding="over_ellipse",
        effects=EVERYTHING,
    )
    measured, bound = shares(light, monkeypatch, ("spin",))["spin"]
    assert measured[0] <= bound[0]


@pytest.mark.parametrize("seed", range(20, 26))
def test_auto_meets_everything_on(bearing_6205: Bearing, seed: int) -> None:
    scene = replace(drawn(bearing_6205, np.random.default_rng(seed), points=1), sliding="over_ellipse")
    exact = friction_torque(scene).torque.total
    for tolerance in (0.1, 0.01, 0.001):
        found = friction_torque(replace(scene, effects={}, sliding="auto", tolerance=tolerance))
        error = np.abs(found.torque.total / exact - 1)
        assert np.all(error < tolerance)
        assert np.all(error <= found.numerical_uncertainty)


def test_a_long_series_decides_as_all_of_its_points_do(monkeypatch: pytest.MonkeyPatch) -> None:
    """Far points are looked at first: what they say of an effect that counts is what all points say, less what differs.

    At 5 % the far points settle every effect here; at 30 % some are left out, by the bounds of all points.
    """
    load, speed = np.random.default_rng(3).uniform([90.0, 12.0], [1900.0, 160.0], (600, 2)).T
    scene = load_scene("validation/scenes/6205_physical.toml")
    for tolerance in (0.05, 0.3):
        long = replace(scene, tolerance=tolerance, operation=Operation(axial_load=load, inner_speed=speed))
        looked_at = friction_torque(long)
        with monkeypatch.context() as all_points:
            all_points.setattr(sliding, "SERIES", 10_000)
            known = friction_torque(long)
        np.testing.assert_array_equal(looked_at.torque.total, known.torque.total)
        np.testing.assert_array_equal(looked_at.numerical_uncertainty, known.numerical_uncertainty)
        for mine, theirs in zip(looked_at.effects, known.effects, strict=True):
            assert mine.decision == theirs.decision
            if mine.share is not None and theirs.share is not None and np.isfinite(theirs.share):
                # The far points hold the ends of the series, where a bound is largest, to within their distance.
                assert 0.8 * theirs.share <= mine.share <= theirs.share * (1 + 1e-12)
