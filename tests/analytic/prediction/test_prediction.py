"""The interval of real scenes: closed forms where the torque is linear, workers, spreads and messages."""

from dataclasses import replace

import numpy as np
import pytest

import analytic
from analytic.errors import InputError
from analytic.oil.variation import Variation
from analytic.prediction.prediction import SAMPLES, Prediction, predict, require_samples
from analytic.prediction.spreads import uncertain_inputs
from analytic.prediction.variants import varied_scene
from analytic.scene import Arrangement, ContactAngle, Losses, Scene
from analytic.scenefile.inputs import uncertain_value
from analytic.scenefile.keys import UNCERTAIN
from analytic.scenefile.read import load_scene, parse_scene
from analytic.torque import friction_torque
from tests.analytic.scenefile.scene_texts import OILED
from tests.analytic.specimens import present

GROOVES = ("bearing.inner.conformity", "bearing.outer.conformity")
SPREADS = {"friction.coefficient": 0.02, "friction.hysteresis_loss": 0.002, "losses.seals": 1.5e-3}


def dry(**spreads: float) -> Scene:
    """Race torque proportional to the coefficient, hysteresis to its loss, and seals: the total is linear in them."""
    scene = analytic.load_scene("6205-dry")
    off = dict.fromkeys(("creep", "cage", "finite_geometry"), "off")
    nothing = {each.key: 0.0 for each in uncertain_inputs(scene)}
    return replace(
        scene,
        contact_angle=replace(scene.contact_angle, rule="given", value=0.31, free=None),
        operation=analytic.operation(axial_load=[800.0], inner_speed=[30.0]),
        losses=Losses(seals=4e-3),
        spin_rule="inner_control",
        effects={**scene.effects, **off},
        tolerance=1.0,
        uncertainty={k: v for k, v in nothing.items() if "free" not in k}
        | {"bearing.contact_angle.value": 0.0}
        | spreads,
    )


@pytest.fixture(scope="module")
def predicted() -> Prediction:
    return predict(dry(**SPREADS), samples=256, seed=5, workers=1)


def test_a_torque_that_is_linear_in_its_inputs_has_its_closed_interval_and_indices(predicted: Prediction) -> None:
    """Sliding goes with the coefficient, hysteresis with its loss; the numerical uncertainty is a factor."""
    torque = predicted.nominal.torque
    assert torque.spin is not None
    assert torque.conformity is not None
    assert torque.hysteresis is not None
    sizes = {
        "friction.coefficient": (float(torque.spin[0] + torque.conformity[0]), 0.02 / 0.1),
        "friction.hysteresis_loss": (float(torque.hysteresis[0]), 0.002 / 0.007),
        "losses.seals": (4e-3, 1.5 / 4),
    }
    normal = np.random.default_rng(11).standard_normal((1_000_000, 4))
    parts = [size * np.exp(spread * z) for (size, spread), z in zip(sizes.values(), normal.T, strict=False)]
    numerical = [each.deviation for each in predicted.inputs if each.key == "numerical"]
    total = sum(parts) * np.exp(sum(numerical) * normal[:, 3])
    low, high = np.quantile(total, (0.025, 0.975))
    assert predicted.total.low[0] == pytest.approx(low, abs=3 * predicted.total.low_error[0])
    assert predicted.total.high[0] == pytest.approx(high, abs=3 * predicted.total.high_error[0])
    assert predicted.total.low_error[0] < 0.03 * low
    assert predicted.explained[0] > 0.98
    variances = {key: size**2 * np.exp(s**2) * (np.exp(s**2) - 1) for key, (size, s) in sizes.items()}
    # The variance by the numerical factor is that of the whole torque.
    whole = float(np.var(total))
    for place, each in enumerate(predicted.inputs):
        if each.key in variances:
            share = variances[each.key] / whole
            assert predicted.indices.first[place, 0] == pytest.approx(share, abs=0.03), each.key
            assert predicted.indices.total[place, 0] == pytest.approx(share, abs=0.03), each.key


def test_alone_the_parts_of_the_interval_are_those_of_their_inputs(predicted: Prediction) -> None:
    nominal = predicted.nominal.torque.total[0]
    low, high = predicted.made_of["numerical"][:, 0]
    u = predicted.nominal.numerical_uncertainty[0]
    ends = nominal * np.exp(np.array([-1, 1]) * 1.959963984540054 * u / 2)
    np.testing.assert_allclose([low, high], ends, rtol=1e-12)  # rounding: it does not depend on the samples
    assert "model" not in predicted.made_of  # no oil: no formula varies
    assert predicted.made_of["input"][0, 0] < low < nominal < high < predicted.made_of["input"][1, 0]


def test_the_number_of_threads_does_not_change_a_number() -> None:
    scene = dry(**SPREADS)
    alone, together = (predict(scene, samples=60, seed=9, workers=workers) for workers in (1, 2))
    for one, other in ((alone.columns(), together.columns()), (vars(alone.indices), vars(together.indices))):
        for name, values in one.items():
            np.testing.assert_array_equal(values, other[name])


@pytest.mark.parametrize("angle", [ContactAngle(rule="given", value=0.02), ContactAngle(rule="solved", free=0.0)])
def test_an_angle_near_0_has_its_default_spread_to_both_sides(angle: ContactAngle) -> None:
    """The standard deviation is 0.03 rad, so that many of the angles are below 0: they count by their size."""
    key = f"bearing.contact_angle.{'value' if angle.rule == 'given' else 'free'}"
    known = dict.fromkeys(SPREADS, 0.0)
    off = {key: value for key, value in dry(**known).uncertainty.items() if "contact_angle" not in key}
    scene = replace(dry(), contact_angle=angle, uncertainty=off)
    assert [each.key for each in uncertain_inputs(scene)] == [key]
    found = predict(scene, samples=64, workers=1)
    assert found.failed == 0
    mirrored = [varied_scene(scene, {key: value})[0].contact_angle for value in (-0.04, 0.04)]
    assert mirrored[0] == mirrored[1]


@pytest.mark.parametrize("samples", [1_000_001, 10**20, 10**400])
def test_too_many_samples_are_refused_before_any_is_drawn(samples: int) -> None:
    with pytest.raises(InputError, match=rf"samples = \d+.*: at most 1000000; {SAMPLES} are usual"):
        require_samples(samples, uncertain_inputs(load_scene("6205-dry")))


def test_too_few_samples_are_refused_with_the_least_number() -> None:
    with pytest.raises(InputError, match=rf"samples = 39: .* needs at least 40; {SAMPLES} are usual"):
        predict(dry(**SPREADS), samples=39, workers=1)
    with pytest.raises(InputError, match="workers = 0: give a whole number from 1"):
        predict(dry(**SPREADS), workers=0)


def test_a_hundredth_of_the_samples_may_have_no_torque() -> None:
    """Of contact angles with a deviation of 0.6 rad many lie beyond a shoulder."""
    wild = replace(analytic.load_scene("6205-dry"), uncertainty={"bearing.contact_angle.free": 0.6})
    with pytest.raises(InputError, match=r"of 64 samples have no torque, limit 1 %"):
        predict(wild, samples=64, workers=1)


def test_the_scene_with_the_values_that_it_has_is_the_same() -> None:
    scene = parse_scene(OILED, origin="here")
    values = {each.key: each.value for each in uncertain_inputs(scene)}
    same, variation = varied_scene(scene, values)
    assert variation == Variation()
    for key in values:
        assert uncertain_value(same, key) == pytest.approx(uncertain_value(scene, key), rel=1e-12)
    before, after = (friction_torque(each).torque.total for each in (scene, same))
    np.testing.assert_allclose(after, before, rtol=1e-9)  # rounding of the dimensions


@pytest.mark.parametrize("key", [key for key in UNCERTAIN if not key.startswith(("model", "arrangement", "cage"))])
def test_an_input_takes_the_value_that_it_is_given(key: str) -> None:
    scene = dry() if key.startswith(("friction.coefficient", "losses", "bearing.contact")) else None
    scene = scene or parse_scene(OILED, origin="here")
    if key == "bearing.contact_angle.free":
        scene = analytic.load_scene("6205-dry")
    if key.startswith(("losses", "operation")):
        loads = {"axial_load": 300.0, "radial_load": -200.0, "moment": 0.7, "inner_speed": 20.0}
        losses = Losses(seals=3e-3, drag=2e-3, oil_flow=4e-6, oil_share=0.03)
        scene = replace(scene, losses=losses, operation=analytic.operation(**loads))
    if key.startswith("surface.hardness") and scene.surface is not None:
        scene = replace(scene, surface=replace(scene.surface, hardness=7e9))
    if key == "lubricant.surface_tension":
        scene = replace(scene, lubricant=replace(present(scene.lubricant), supply="grease"))
    if key == "friction.hysteresis_loss":
        scene = replace(scene, hysteresis_loss=0.006)
    if key == "bearing.contact_angle.value":
        scene = replace(scene, contact_angle=ContactAngle(rule="given", value=0.2))
    value = uncertain_value(scene, key)
    assert value is not None
    other, _ = varied_scene(scene, {key: 1.0625 * value})
    assert uncertain_value(other, key) == pytest.approx(1.0625 * value, rel=1e-9)
    moved = {each for each in UNCERTAIN if _differs(uncertain_value(scene, each), uncertain_value(other, each))}
    # A clearance that closes at a nominal angle follows the size of balls and grooves, so that the angle stays.
    closes = scene.bearing.origins["clearance"].status == "derived" if "clearance" in scene.bearing.origins else False
    follows = {"bearing.clearance"} if closes and key in ("bearing.ball_diameter", *GROOVES) else set()
    assert moved == {key} | follows
    if follows:
        assert _free_angle(other) == pytest.approx(_free_angle(scene), rel=1e-9)


def test_the_formulas_take_their_factors() -> None:
    scene = parse_scene(OILED, origin="here")
    factors = {"model.film": 1.1, "model.rolling": 1.3, "model.gap": 0.7, "model.surfaces": 1.6, "model.heating": 0.8}
    _, variation = varied_scene(scene, factors | {"model.elastic_rolling": -0.4, "model.starvation": 0.9})
    assert variation == Variation(
        film=1.1,
        rolling_error=1.3,
        heating=0.8,
        asperity_pressure=1.6,
        asperity_share=0.7,
        elastic_rolling=-0.4,
        starvation=0.9,
    )


def test_a_cage_and_a_pair_take_their_values() -> None:
    cage = analytic.load_scene("6205-dry")
    assert cage.cage is not None
    cage = replace(cage, cage=replace(cage.cage, friction_coefficient=0.07))
    pair = replace(cage, arrangement=Arrangement(kind="O", preload=150.0))
    for scene, key, value in ((cage, "cage.friction_coefficient", 0.09), (pair, "arrangement.preload", 170.0)):
        other, _ = varied_scene(scene, {key: value})
        assert uncertain_value(other, key) == value


def test_only_a_clearance_that_closes_at_an_angle_follows_the_grooves() -> None:
    """One that a scene gives stays as it is, and so does one that nobody says where it is from."""
    text = OILED.replace('catalog = "paper_6205"', 'catalog = "6205"\nclearance = "13 um"')
    scene = parse_scene(text, origin="here")
    bare = replace(scene, bearing=replace(scene.bearing, origins={}))
    assert scene.bearing.origins["clearance"].status == "given"
    for given in (scene, bare):
        for key, factor in (("bearing.ball_diameter", 1.003), ("bearing.outer.conformity", 1.02)):
            other, _ = varied_scene(given, {key: factor * (uncertain_value(given, key) or np.nan)})
            assert other.bearing.groove_centre_distance != given.bearing.groove_centre_distance
            grown = factor if key == "bearing.ball_diameter" else 1.0
            assert other.bearing.ball_mass == pytest.approx(grown**3 * given.bearing.ball_mass, rel=1e-12)
            # 1e-9: a difference of radii a thousand times as large
            assert other.bearing.diametral_clearance == pytest.approx(13e-6, rel=1e-9)


def _free_angle(scene: Scene) -> float:
    """At which balls touch both races without load, by the triangle of the groove centres."""
    bearing = scene.bearing
    return float(np.arccos(1 - bearing.diametral_clearance / (2 * bearing.groove_centre_distance)))


def _differs(one: float | None, other: float | None) -> bool:
    return one is not None and other is not None and abs(other - one) > 1e-9 * abs(one)


def test_dataset_data_frame_and_columns_have_the_same_numbers(predicted: Prediction) -> None:
    columns, dataset, frame = predicted.columns(), predicted.to_dataset(), predicted.to_dataframe()
    assert dataset["index_total"].dims == ("input", "point")
    assert dataset["input"].values.tolist() == [each.key for each in predicted.inputs]
    np.testing.assert_array_equal(dataset["index_total"], predicted.indices.total)
    for name in ("total_low", "total_high_error", "race_high"):
        np.testing.assert_array_equal(frame[f"torque_{name}"], columns[name])
    for cause in predicted.made_of:
        np.testing.assert_array_equal(dataset.sel(cause=cause)["made_of_high"], columns[f"by_{cause}_high"])
    assert frame["axial_load"].tolist() == [800.0] * len(frame)
    assert frame.attrs["units"]["torque_total_low"] == "N m"


def test_a_notebook_shows_the_interval_and_what_makes_it(predicted: Prediction) -> None:
    text = predicted._repr_html_()
    for value in (predicted.nominal.torque.total, predicted.total.low, predicted.total.high):
        assert f"<td>{value[0] * 1e3:.4g}</td>" in text
    assert f"<p>Most by {predicted.inputs[predicted.ranked[0]].key}" in text
