"""Which effects run: the code of those left out is counted, and what cannot be had is refused."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import analytic.effects.sliding
import analytic.loads.balls
import analytic.loads.finite_geometry
import analytic.loads.ring
import analytic.oil.lubricated_races
import analytic.oil.rolling
import analytic.sliding.ball
import analytic.torque
from analytic.effects.ledger import Ledger
from analytic.effects.warnings import torque_warnings
from analytic.errors import InputError
from analytic.result import FrictionTorque
from analytic.scene import Bearing, ContactAngle, Operation, Scene
from analytic.surface.asperity_table import AsperityTable
from analytic.torque import friction_torque
from tests.analytic.specimens import idling


@pytest.fixture(scope="module")
def scene(bearing_6205: Bearing) -> Scene:
    return idling(bearing_6205)


class Calls:
    """Every call of a function in the module that calls it, with its arguments."""

    def __init__(self, patch: pytest.MonkeyPatch, where: Any, name: str) -> None:
        self.arguments: list[dict[str, Any]] = []
        original: Callable = getattr(where, name)

        def counted(*given: Any, **named: Any) -> Any:
            self.arguments.append(named)
            return original(*given, **named)

        patch.setattr(where, name, counted)

    def __len__(self) -> int:
        return len(self.arguments)


def decided(found: FrictionTorque) -> dict[str, str]:
    return {effect.name: effect.decision for effect in found.effects}


def loaded_aside(scene: Scene, radial_load: float) -> Scene:
    return replace(scene, operation=replace(scene.operation, radial_load=radial_load))


@pytest.mark.parametrize("how", ["auto", "off"])
def test_balls_that_are_alike_take_no_ring(scene: Scene, how: str, monkeypatch: pytest.MonkeyPatch) -> None:
    ring = Calls(monkeypatch, analytic.loads.balls, "ring_equilibrium")
    names = "load_distribution", "centrifugal", "gyroscopic"
    asked = replace(loaded_aside(scene, 0.3), effects=dict.fromkeys(names, how))
    found = friction_torque(asked)
    assert [decided(found)[name] for name in names] == ["off"] * 3
    assert len(ring) == 0
    at_speed = Calls(monkeypatch, analytic.loads.balls, "thrust_at_speed")
    for name in names:
        friction_torque(replace(asked, effects={**dict.fromkeys(names, "off"), name: "on", "finite_geometry": "off"}))
        called = ring if name == "load_distribution" else at_speed
        assert called.arguments[-1]["centrifugal"] == (name == "centrifugal")
        assert called.arguments[-1]["gyroscopic"] == (name == "gyroscopic")
    assert (len(ring), len(at_speed)) == (1, 2)
    assert ring.arguments[-1]["radial_load_x"] == pytest.approx(0.3, abs=0)


@pytest.mark.parametrize("how", ["auto", "off"])
def test_balls_without_inertia_do_not_ask_for_their_motion_in_the_ring(
    scene: Scene, how: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The bound takes the motion of one ball beside the ring; the forces need that of each, round by round."""
    motion = Calls(monkeypatch, analytic.loads.ring, "force_and_moment")
    effects = {"load_distribution": "on", "centrifugal": how, "gyroscopic": how}
    asked = replace(loaded_aside(scene, 3.0), effects=effects)
    assert [decided(friction_torque(asked))[name] for name in ("centrifugal", "gyroscopic")] == ["off"] * 2
    assert len(motion) == 0
    friction_torque(replace(asked, effects=effects | {"gyroscopic": "on"}))
    assert len(motion) > 0


@pytest.mark.parametrize("how", ["auto", "off"])
def test_contacts_of_half_spaces_ask_for_no_factors(scene: Scene, how: str, monkeypatch: pytest.MonkeyPatch) -> None:
    factors = Calls(monkeypatch, analytic.loads.finite_geometry, "finite_geometry_factors")
    found = friction_torque(replace(scene, effects={"finite_geometry": how}))
    assert (decided(found)["finite_geometry"], len(factors)) == ("off", 0)
    friction_torque(replace(scene, effects={"finite_geometry": "on"}))
    assert len(factors) == 2  # once a race


@pytest.mark.parametrize("how", ["auto", "off"])
def test_asperities_left_out_share_no_load(scene: Scene, how: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Their bound asks the table for pressure and area at one film; sharing the load asks for separations too."""
    pressure, separation = (Calls(monkeypatch, AsperityTable, name) for name in ("log_pressure", "separation"))
    mixed = Calls(monkeypatch, analytic.oil.lubricated_races, "mixed_contact")
    found = friction_torque(replace(scene, effects={"asperities": how}))
    assert decided(found)["asperities"] == "off"
    assert len(separation) == 0
    assert len(pressure) == 2  # once a race
    assert [named["asperities"] for named in mixed.arguments] == [None]
    assert np.all(found.asperity_share.inner == 0)
    friction_torque(replace(scene, effects={"asperities": "on"}))
    assert len(separation) > 0


@pytest.mark.parametrize("how", ["auto", "off"])
def test_heating_left_out_thins_no_film(scene: Scene, how: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its bound is the formula itself, so that it is evaluated for that, once; no film and no rolling feels it."""
    factor = Calls(monkeypatch, analytic.oil.lubricated_races, "inlet_heating_factor")
    mixed = Calls(monkeypatch, analytic.oil.lubricated_races, "mixed_contact")
    found = friction_torque(replace(scene, effects={"inlet_heating": how}))
    assert decided(found)["inlet_heating"] == "off"
    assert len(factor) == 1
    assert np.all(mixed.arguments[-1]["heating_factor"] == 1)
    friction_torque(replace(scene, effects={"inlet_heating": "on"}))
    assert np.all(np.concatenate([np.ravel(named["heating_factor"]) for named in mixed.arguments[1:]]) < 1)
    dry = replace(scene, surface=None, friction_coefficient=0.07)
    before = len(factor)
    friction_torque(dry)
    assert len(factor) == before  # no film to thin


@pytest.mark.parametrize("how", ["auto", "off"])
def test_starvation_left_out_takes_nothing_from_rolling(
    scene: Scene, how: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its bound is the formula itself: what is skipped is its use."""
    factor = Calls(monkeypatch, analytic.oil.rolling, "replenishment_factor")
    effects = {"inlet_heating": "off", "starvation": how}
    found = friction_torque(replace(scene, effects=effects))
    assert (decided(found)["starvation"], len(factor)) == ("off", 1)
    unknown = replace(scene.bearing, bore_diameter=None)
    flooded = friction_torque(replace(scene, bearing=unknown, effects={"inlet_heating": "off"}))
    assert len(factor) == 1  # without the bore there is no formula to ask
    np.testing.assert_array_equal(found.torque.rolling, flooded.torque.rolling)
    starved = friction_torque(replace(scene, effects=effects | {"starvation": "on"}))
    assert np.all(np.asarray(starved.torque.rolling) < np.asarray(flooded.torque.rolling))


@pytest.mark.parametrize("how", ["auto", "off"])
def test_balls_that_do_not_spin_share_no_spin(scene: Scene, how: str, monkeypatch: pytest.MonkeyPatch) -> None:
    balance = Calls(monkeypatch, analytic.sliding.ball, "contact_moments")
    effects = {"finite_geometry": "off", "load_distribution": "off", "centrifugal": "off", "gyroscopic": "off"}
    flat = replace(scene, contact_angle=ContactAngle(rule="given", value=1e-3), sliding="single_coefficient")
    found = friction_torque(replace(flat, effects=effects | {"spin": how}))
    assert decided(found)["spin"] == "off"
    assert found.torque.spin is None
    still = list(balance.arguments)
    assert all(np.all(named["spin_rate"] == 0) for named in still)
    friction_torque(replace(flat, effects=effects | {"spin": "on"}))
    assert any(np.any(named["spin_rate"] != 0) for named in balance.arguments[len(still) :])


def test_what_is_a_part_of_the_torque_and_left_out_never_runs(scene: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    hysteresis = Calls(monkeypatch, analytic.torque, "hysteresis_moment")
    rolling = Calls(monkeypatch, analytic.torque, "hydrodynamic_rolling")
    oiled = Calls(monkeypatch, analytic.torque, "lubricate_races")
    slides = Calls(monkeypatch, analytic.torque, "race_sliding")
    friction_torque(replace(scene, hysteresis_loss=None, effects={"rolling": "off"}))  # auto: no loss is known
    assert (len(hysteresis), len(rolling), len(oiled), len(slides)) == (0, 0, 1, 1)
    friction_torque(replace(scene, lubricant=None, surface=None, friction_coefficient=0.06))  # auto: there is no oil
    assert (len(hysteresis), len(rolling), len(oiled), len(slides)) == (1, 0, 1, 2)
    friction_torque(replace(scene, effects={"spin": "off", "conformity": "off", "hysteresis": "off"}))
    assert (len(hysteresis), len(rolling), len(oiled), len(slides)) == (1, 1, 1, 2)
    friction_torque(scene)
    assert (len(hysteresis), len(rolling), len(oiled), len(slides)) == (2, 2, 2, 3)


def test_auto_spends_its_half_of_the_tolerance_on_all_effects_together(scene: Scene) -> None:
    ledger = Ledger(replace(scene, tolerance=0.1), 2)
    assert not ledger.decide("centrifugal", bound=np.array([0.03, 0.001]))
    assert not ledger.decide("gyroscopic", bound=np.array([0.001, 0.04]))  # at no point more than 0.05
    assert ledger.decide("finite_geometry", bound=np.array([0.03, 0.0]))
    assert not ledger.decide("spin", bound=np.array([0.015, 0.005]))
    np.testing.assert_allclose(ledger.left_out, [0.046, 0.046], rtol=1e-14)  # round-off
    assert "0.041 already left out" in ledger.made["finite_geometry"].reason


def test_thrust_and_radial_load_in_one_series_do_not_skid(scene: Scene) -> None:
    """Of the first point radial load alone would be no load."""
    both = Operation(
        axial_load=np.array([800.0, 0.0]), inner_speed=np.array([90.0, 70.0]), radial_load=np.array([0.0, 400.0])
    )
    series = friction_torque(replace(scene, operation=both)).torque.total
    for index in range(2):
        points = Operation(
            **{name: values[index : index + 1] for name, values in vars(both).items() if np.ndim(values)}
        )
        alone = friction_torque(replace(scene, operation=points, effects={"load_distribution": "on"})).torque.total
        np.testing.assert_allclose(series[index], alone[0], rtol=0.3)  # the tolerance


WITHOUT = {"lubricant": None, "surface": None, "friction_coefficient": 0.07}


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"effects": {"hysteresis": "on"}, "hysteresis_loss": None}, "hysteresis.*hysteresis_loss is not given.*0.004"),
        ({"effects": {"rolling": "on"}, **WITHOUT}, r"rolling.*add a table \[lubricant\]"),
        ({"effects": {"inlet_heating": "on"}, **WITHOUT}, r"inlet_heating.*no lubricant"),
        ({"effects": {"starvation": "on"}, **WITHOUT}, r"starvation.*no lubricant"),
        ({"effects": {"shoulder": "on"}}, 'shoulder = "on" cannot be had: not modelled; give "auto" or "off"'),
        ({"effects": {"spinning": "on"}}, "effects.spinning is not an effect to choose; known: .*spin, "),
    ],
)
def test_an_effect_that_cannot_be_had_is_refused_in_one_line(scene: Scene, change: Any, words: str) -> None:
    refused(replace(scene, **change), words)


def refused(scene: Scene, words: str) -> None:
    with pytest.raises(InputError, match=words) as caught:
        friction_torque(scene)
    assert "\n" not in str(caught.value)


def test_starvation_needs_the_rings(scene: Scene) -> None:
    unknown = replace(scene.bearing, outside_diameter=None)
    refused(replace(scene, bearing=unknown, effects={"starvation": "on"}), "outside_diameter are not given")


@pytest.mark.parametrize("name", ["load_distribution", "centrifugal", "gyroscopic"])
def test_a_held_angle_takes_no_ring(scene: Scene, name: str) -> None:
    held = replace(scene, contact_angle=ContactAngle(rule="given", value=0.2))
    refused(replace(held, effects={name: "on"}), f'{name} = "on" cannot be had: .*use "solved"')


def test_a_radial_load_at_a_held_angle_is_refused_where_it_matters(scene: Scene) -> None:
    held = replace(loaded_aside(scene, 50.0), contact_angle=ContactAngle(rule="given", value=0.3), tolerance=0.05)
    refused(held, r'radial_load and .* are up to 0\.344 of what thrust does.*use "solved"')  # 50 tan(0.3)/45
    friction_torque(loaded_aside(held, 0.5))
    pure = replace(
        held, operation=replace(held.operation, axial_load=np.zeros(2)), effects={"load_distribution": "off"}
    )
    refused(replace(pure, contact_angle=ContactAngle(rule="solved")), "leave effects.load_distribution on auto")


def test_balls_that_skid_are_refused_with_their_speed(scene: Scene) -> None:
    light = Operation(axial_load=np.array([900.0, 0.001]), inner_speed=np.array([100.0, 2000.0]))
    refused(
        replace(scene, operation=light),
        r"inner_speed = 2000 rad/s: the centrifugal force .* times its load under 0\.001 N .* above 1000.*raise",
    )


@pytest.mark.parametrize(
    ("share", "words"),
    [(0.31, "could be 0.31 of the torque"), (17.2, "could exceed the torque"), (np.inf, "nothing bounds it")],
)
def test_a_bound_beyond_the_torque_is_told_in_words(scene: Scene, share: float, words: str) -> None:
    """Where it calls for the effect, and in the warning where the scene leaves the effect out all the same."""
    ledger = Ledger(replace(scene, effects={"spin": "off"}), 2)
    ledger.decide("centrifugal", bound=np.array([share, 0.02]))
    ledger.decide("spin", bound=np.array([share, 0.02]))
    called, left = ledger.made["centrifugal"], ledger.made["spin"]
    assert called.reason == (f"{words}, more than 0.15 leaves" if share < 1 else words)  # half of the tolerance
    assert (left.decision, left.share, left.reason) == ("off", share, "the scene says off")
    told = torque_warnings(ledger, limits=[], oiled=None, shared=None, resistance=None)
    beyond = ", more than the tolerance" if share < 1 else ""
    assert f"spin is left out and {words}{beyond}: the scene says off" in told


def test_a_contact_beyond_its_shoulder_is_told_with_what_moved_it(scene: Scene) -> None:
    """At 300 000 rpm centrifugal force parts the contact angles; under a heavy load they move together."""
    fast = Operation(axial_load=np.array([300.0, 1000.0]), inner_speed=np.array([50.0, 31416.0]))
    wide = replace(scene, contact_angle=ContactAngle(rule="solved", free=0.3))
    refused(replace(wide, operation=fast, effects={"centrifugal": "on"}), "1000 N: .* lower the speed of 31416 rad/s")
    heavy = Operation(axial_load=np.array([1e7]), inner_speed=np.array([50.0]))
    for how in ("on", "off"):
        asked = replace(wide, operation=heavy, effects=dict.fromkeys(("centrifugal", "gyroscopic"), how))
        refused(asked, "inner race's shoulder: lower the load")
