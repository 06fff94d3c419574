"""Which effects act: those left out change nothing, and what is impossible is refused."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.contact.geometry import RACES, race_contact
from analytic.contact.hertz import contact_modulus, hertz_contact, relative_curvatures
from analytic.effects.ledger import Ledger
from analytic.errors import InputError
from analytic.result import FrictionTorque
from analytic.scene import Bearing, ContactAngle, Operation, Scene
from analytic.torque import friction_torque
from tests.analytic.specimens import idling, present


@pytest.fixture(scope="module")
def scene(bearing_6205: Bearing) -> Scene:
    return idling(bearing_6205)


SLIDES = {"conformity": "on"}  # without it auto lets nothing slide here


def few(scene: Scene) -> Operation:
    """Its first two points."""
    return replace(
        scene.operation, axial_load=scene.operation.axial_load[:2], inner_speed=scene.operation.inner_speed[:2]
    )


def loaded_aside(scene: Scene, radial_load: float) -> Scene:
    return replace(scene, operation=replace(scene.operation, radial_load=radial_load))


def same(found: FrictionTorque, other: FrictionTorque) -> None:
    """Bit for bit, in every number of the heaviest ball and of the torque."""
    ours, theirs = found.columns(), other.columns()
    # The first counts the bounds of what is left out; the others are of loads that balls do not feel.
    for name in ours.keys() - {"uncertainty_numerical", "tilt", "holding_moment"}:
        np.testing.assert_array_equal(ours[name], theirs[name], err_msg=name)


@pytest.mark.parametrize("how", ["auto", "off"])
def test_balls_that_are_alike_take_no_ring(scene: Scene, how: str) -> None:
    """Radial load, inertia and gyroscopic moment change nothing until they are asked for, each by itself."""
    names = "load_distribution", "centrifugal", "gyroscopic"
    asked = replace(loaded_aside(scene, 0.3), effects=dict.fromkeys(names, how))
    found = friction_torque(asked)
    assert [found.effects.decisions[name] for name in names] == ["off"] * 3
    same(found, friction_torque(replace(asked, operation=replace(asked.operation, radial_load=0.0))))
    np.testing.assert_array_equal(found.inner.load, found.outer.load)
    off = dict.fromkeys((*names, "finite_geometry"), "off")
    alone = {name: friction_torque(replace(asked, effects={**off, name: "on"})) for name in names}
    assert np.all(alone["load_distribution"].ball_load > 1.001 * found.ball_load)
    assert np.all(alone["centrifugal"].outer.load > alone["centrifugal"].inner.load + 1e-5)  # N: m R omega^2, 2e-5
    for name in ("load_distribution", "gyroscopic"):
        np.testing.assert_allclose(alone[name].outer.load, alone[name].inner.load, rtol=1e-12)  # round-off
    assert np.all(alone["gyroscopic"].contact_angle < found.contact_angle - 1e-9)  # rad; the root is exact to 1e-12


@pytest.mark.parametrize("how", ["auto", "off"])
def test_balls_without_inertia_carry_the_same_load_on_both_races_of_the_ring(scene: Scene, how: str) -> None:
    effects = {"load_distribution": "on", "centrifugal": how, "gyroscopic": how}
    asked = replace(loaded_aside(scene, 3.0), effects=effects)
    found = friction_torque(asked)
    assert [found.effects.decisions[name] for name in ("centrifugal", "gyroscopic")] == ["off"] * 2
    np.testing.assert_allclose(found.outer.load, found.inner.load, rtol=1e-12)  # round-off
    thrown = friction_torque(replace(asked, effects=effects | {"centrifugal": "on"}))
    assert np.all(thrown.outer.load > thrown.inner.load + 1e-5)  # N, as above
    turned = friction_torque(replace(asked, effects=effects | {"gyroscopic": "on"}))
    assert np.all(turned.contact_angle < found.contact_angle - 1e-9)


@pytest.mark.parametrize("how", ["auto", "off"])
def test_contacts_of_half_spaces_are_those_of_hertz(scene: Scene, how: str) -> None:
    found = friction_torque(replace(scene, effects={"finite_geometry": how}))
    assert found.effects.decisions["finite_geometry"] == "off"
    true = friction_torque(replace(scene, effects={"finite_geometry": "on"}))
    for race in RACES:
        ellipse = getattr(found, race)
        for point in (0, -1):
            angle, load = float(found.contact_angle[point]), float(ellipse.load[point])
            contact = race_contact(scene.bearing, race, contact_angle=angle, ball_load=load)
            curvature_x, curvature_y = relative_curvatures(contact)
            modulus = contact_modulus(contact.ball_material, contact.race_material)
            exact = hertz_contact(curvature_x=curvature_x, curvature_y=curvature_y, load=load, modulus=modulus)
            np.testing.assert_allclose(ellipse.semi_axis_transverse[point], exact.semi_axis_y, rtol=1e-9)  # round-off
        assert np.all(getattr(true, race).semi_axis_transverse < 0.999 * ellipse.semi_axis_transverse)


@pytest.mark.parametrize("how", ["auto", "off"])
def test_asperities_left_out_share_no_load(scene: Scene, how: str) -> None:
    found = friction_torque(replace(scene, effects={"asperities": how, **SLIDES}))
    assert found.effects.decisions["asperities"] == "off"
    coarse = replace(present(scene.surface), rms_roughness=0.5e-6)
    shared = friction_torque(replace(scene, surface=coarse, effects={"asperities": "on", **SLIDES}))
    for race in RACES:
        assert np.all(getattr(found.asperity_share, race) == 0)
        assert np.all(getattr(shared.asperity_share, race) > 0)


@pytest.mark.parametrize("how", ["auto", "off"])
def test_heating_left_out_thins_no_film(scene: Scene, how: str) -> None:
    """As an oil that conducts all heat away; what heats the inlets of rolling does not depend on that."""
    found = friction_torque(replace(scene, effects={"inlet_heating": how, **SLIDES}))
    assert found.effects.decisions["inlet_heating"] == "off"
    on = replace(scene, effects={"inlet_heating": "on", **SLIDES})
    cold = friction_torque(replace(on, lubricant=replace(present(scene.lubricant), thermal_conductivity=1e20)))
    hot = friction_torque(on)
    for race in RACES:
        film = getattr(found.film, race)
        np.testing.assert_allclose(film, getattr(cold.film, race), rtol=1e-12)  # round-off
        assert np.all(getattr(hot.film, race) < (1 - 1e-5) * film)
    assert np.all(np.asarray(hot.torque.rolling) < np.asarray(found.torque.rolling))


@pytest.mark.parametrize("how", ["auto", "off"])
def test_starvation_left_out_takes_nothing_from_rolling(scene: Scene, how: str) -> None:
    """As without the bore, where there is no formula to ask."""
    effects = {"inlet_heating": "off", "starvation": how}
    found = friction_torque(replace(scene, effects=effects))
    assert found.effects.decisions["starvation"] == "off"
    unknown = replace(scene.bearing, bore_diameter=None)
    flooded = friction_torque(replace(scene, bearing=unknown, effects={"inlet_heating": "off"}))
    np.testing.assert_array_equal(found.torque.rolling, flooded.torque.rolling)
    starved = friction_torque(replace(scene, effects=effects | {"starvation": "on"}))
    assert np.all(np.asarray(starved.torque.rolling) < np.asarray(flooded.torque.rolling))


@pytest.mark.parametrize("how", ["auto", "off"])
def test_balls_that_do_not_spin_have_no_spin_torque(scene: Scene, how: str) -> None:
    effects = {"finite_geometry": "off", "load_distribution": "off", "centrifugal": "off", "gyroscopic": "off"}
    flat = replace(scene, contact_angle=ContactAngle(rule="given", value=1e-3), sliding="single_coefficient")
    found = friction_torque(replace(flat, effects=effects | {"spin": how}))
    assert found.effects.decisions["spin"] == "off"
    assert found.torque.spin is None
    spinning = friction_torque(replace(flat, effects=effects | {"spin": "on"}))
    assert np.all(present(spinning.torque.spin) > 0)


def test_what_is_a_part_of_the_torque_and_left_out_is_absent(scene: Scene) -> None:
    def parts(**changes: Any) -> tuple[bool, bool, bool, bool]:
        found = friction_torque(replace(scene, **changes))
        torque = found.torque
        given = (torque.hysteresis, torque.rolling, found.film.inner, torque.conformity)
        return tuple(part is not None for part in given)  # pyright: ignore[reportReturnType]

    assert parts(effects={"rolling": "off"}, operation=few(scene)) == (True, False, True, True)
    # auto: there is no oil
    assert parts(lubricant=None, surface=None, friction_coefficient=0.06) == (True, False, False, True)
    assert parts(effects={"spin": "off", "conformity": "off", "hysteresis": "off"}) == (False, True, False, False)
    assert parts(operation=few(scene)) == (True, True, True, True)


def test_auto_spends_its_half_of_the_tolerance_on_all_effects_together(scene: Scene) -> None:
    ledger = Ledger(replace(scene, tolerance=0.1), 2)
    assert not ledger.decide("centrifugal", bound=np.array([0.03, 0.001]))
    assert not ledger.decide("gyroscopic", bound=np.array([0.001, 0.04]))  # at no point more than 0.05
    assert ledger.decide("finite_geometry", bound=np.array([0.03, 0.0]))
    assert not ledger.decide("spin", bound=np.array([0.015, 0.005]))
    compound = [1.03 * 1.001 * 1.015 - 1, 1.001 * 1.04 * 1.005 - 1]  # one effect changes what the next acts on
    np.testing.assert_allclose(ledger.left_out, compound, rtol=1e-12)  # round-off
    assert ledger.decide("hysteresis", bound=np.array([np.inf, 0.0]))
    # At the first point 1.05/(1.03 x 1.001) - 1 is left.
    words = "up to 3 % of the torque, exceeds the remaining budget of 1.84 %"
    assert ledger.made["finite_geometry"].reason == words
    assert ledger.made["hysteresis"].reason == "no bound known"
    assert not ledger.decide("conformity", bound=np.zeros(2))
    assert ledger.made["conformity"].reason == "no effect here"


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


STILL = {"spin": "off", "conformity": "off"}
WITHOUT = {"lubricant": None, "surface": None, "friction_coefficient": 0.07}


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"effects": {"rolling": "on"}, **WITHOUT}, r"rolling.*add a table \[lubricant\]"),
        ({"effects": {"inlet_heating": "on"}, **WITHOUT}, r"inlet_heating.*no lubricant"),
        ({"effects": {"starvation": "on"}, **WITHOUT}, r"starvation.*no lubricant"),
        ({"effects": {"shoulder": "on"}}, 'shoulder = "on" is refused: not modelled; give "auto" or "off"'),
        ({"effects": {"spinning": "on"}}, "effects.spinning is not an effect to choose; known: .*spin, "),
        ({"effects": STILL | {"asperities": "on"}}, "asperities.*no sliding without spin and conformity"),
        (
            {"effects": STILL | {"inlet_heating": "on", "rolling": "off"}},
            "inlet_heating.*nothing slides or rolls in oil",
        ),
        ({"effects": STILL | {"starvation": "on", "rolling": "off"}}, "starvation.*nothing slides or rolls in oil"),
        (
            {
                "effects": {"conformity": "off", "spin": "on", "asperities": "on"},
                "friction_coefficient": 0.07,
                "surface": None,
            },
            "asperities.*coefficient is given",
        ),
        ({"effects": {"cage": "on"}}, "cage.*no cage is given"),
    ],
)
def test_an_impossible_effect_is_refused_in_one_line(scene: Scene, change: Any, words: str) -> None:
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
    refused(replace(held, effects={name: "on"}), f'{name} = "on" is refused: .*use "solved"')


def test_a_radial_load_at_a_held_angle_is_refused_where_it_matters(scene: Scene) -> None:
    held = replace(loaded_aside(scene, 50.0), contact_angle=ContactAngle(rule="given", value=0.3), tolerance=0.05)
    refused(held, r'radial_load and .* are up to 34\.4 % of the thrust.*use "solved"')  # 50 tan(0.3)/45
    friction_torque(loaded_aside(held, 0.5))
    pure = replace(
        held,
        operation=replace(held.operation, axial_load=0 * held.operation.axial_load),
        effects={"load_distribution": "off"},
    )
    refused(replace(pure, contact_angle=ContactAngle(rule="solved")), "set effects.load_distribution to auto")


def test_balls_that_skid_are_refused_with_their_speed(scene: Scene) -> None:
    light = Operation(axial_load=np.array([900.0, 0.001]), inner_speed=np.array([100.0, 2000.0]))
    refused(
        replace(scene, operation=light),
        r"inner_speed = 19099 rpm: the centrifugal force .* times its load under 0\.001 N .* above 1000.*raise",
    )


def test_a_contact_beyond_its_shoulder_is_told_with_what_moved_it(scene: Scene) -> None:
    """At 300 000 rpm centrifugal force parts the contact angles; under a heavy load they move together."""
    fast = Operation(axial_load=np.array([300.0, 1000.0]), inner_speed=np.array([50.0, 31416.0]))
    wide = replace(scene, contact_angle=ContactAngle(rule="solved", free=0.3))
    refused(replace(wide, operation=fast, effects={"centrifugal": "on"}), "1000 N: .* lower the speed of 300001 rpm")
    heavy = Operation(axial_load=np.array([1e7]), inner_speed=np.array([50.0]))
    for how in ("on", "off"):
        asked = replace(wide, operation=heavy, effects=dict.fromkeys(("centrifugal", "gyroscopic"), how))
        refused(asked, "inner race's shoulder: lower the load")
