"""The steady temperature of the oil: the balance of heat, its limits, and what is refused."""

import math
from pathlib import Path

import pytest

import analytic
from analytic.errors import ConvergenceError
from analytic.prediction.steady import steady_temperature
from analytic.scene import Thermal
from tests.refusals import refused

RUN = {"radial_load": 2500.0, "speed": 250.0, "oil": "ISO VG 68"}  # N, rad/s
AMBIENT = 294.0  # K


def heated(resistance: float, ambient: float = AMBIENT) -> analytic.Scene:
    settings = {"thermal.resistance": resistance, "thermal.ambient": ambient, "friction.spin_rule": "balanced"}
    return analytic.steady_scene("6308", settings=settings, **RUN)


def temperature(scene: analytic.Scene) -> float:
    assert scene.lubricant is not None
    return scene.lubricant.temperature


def test_friction_and_resistance_give_the_temperature() -> None:
    """The definition, with the torque of a scene that is read at that temperature."""
    scene = heated(0.7)
    same = analytic.load_scene(
        "6308", temperature=temperature(scene), settings={"friction.spin_rule": "balanced"}, **RUN
    )
    power = analytic.friction_torque(same).torque.total[0] * 250.0
    assert temperature(scene) > AMBIENT + 5  # else the balance says nothing
    assert temperature(scene) == pytest.approx(AMBIENT + 0.7 * power, abs=1e-3)  # of a search to 1e-4 K
    assert analytic.friction_torque(scene).torque.total[0] * 250.0 == pytest.approx(power, rel=1e-12)
    assert scene.lubricant is not None
    assert "0.7 K/W" in scene.lubricant.origins["temperature"].source


def test_a_temperature_beside_a_resistance_is_refused() -> None:
    heat = {"thermal.resistance": 0.7, "thermal.ambient": AMBIENT}
    words = "lubricant.temperature = 333.0 K and [thermal] both determine the oil temperature: leave one of them out"
    refused(lambda: analytic.steady_scene("6308", settings=heat, temperature=333.0), f"of 6308: {words}")
    both = {**heat, "lubricant.temperature": 333.0}
    refused(lambda: analytic.steady_scene("6308", settings=both), words)


@pytest.mark.parametrize(("decay", "resistance"), [(0.03, 0.4), (0.0, 2.5)])
def test_a_power_of_known_form_has_its_known_temperature(decay: float, resistance: float) -> None:
    """P = P0 exp(-k (T - Ta)): the rise is W(k R P0)/k by Lambert's function, and R P0 where k is 0."""
    from scipy.special import lambertw

    initial = 37.0
    thermal = Thermal(resistance=resistance, ambient=AMBIENT)
    found = steady_temperature(lambda t: initial * math.exp(-decay * (t - AMBIENT)), thermal, tolerance=0.01)
    heat = resistance * initial
    rise = heat if decay == 0 else float(lambertw(decay * heat).real) / decay
    assert found.temperature - AMBIENT == pytest.approx(rise, abs=2e-4)


def test_of_several_temperatures_the_lowest_is_found() -> None:
    """Power that grows: R P = 0.4 + (T - Ta)^2/50 meets T - Ta at 0.403... and again at 49.6."""
    thermal = Thermal(resistance=2.0, ambient=AMBIENT)
    found = steady_temperature(lambda t: 0.2 + (t - AMBIENT) ** 2 / 100, thermal, tolerance=0.01)
    assert found.temperature - AMBIENT == pytest.approx(25 - math.sqrt(625 - 20), abs=2e-4)


def test_a_thermal_runaway_and_the_end_of_the_data_are_said_in_one_line() -> None:
    with pytest.raises(ConvergenceError) as problem:
        heated(90.0)
    message = str(problem.value)
    assert "\n" not in message
    assert "no steady temperature within its data" in message
    assert "thermal.resistance = 90 K/W" in message
    assert "140" in message  # degC, where the oil's data end


def test_a_jump_that_exceeds_the_tolerance_is_no_balance() -> None:
    thermal = Thermal(resistance=2.0, ambient=AMBIENT)
    with pytest.raises(ConvergenceError, match="jumps by"):
        steady_temperature(lambda t: 9.0 if t < AMBIENT + 13 else 3.0, thermal, tolerance=0.05)
    found = steady_temperature(lambda t: 9.0 if t < AMBIENT + 17.9 else 8.8, thermal, tolerance=0.05)
    assert found.temperature == pytest.approx(AMBIENT + 17.9, abs=1e-3)


OILED = """\
name = "warm"
tolerance = "5 %"
[bearing]
catalog = "6206"
[operation]
axial_load = "700 N"
inner_speed = "900 rpm"
[surface]
finish = "ground and honed"
[thermal]
resistance = "0.4 K/W"
ambient = "25 degC"
[lubricant]
"""


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (("[lubricant]\n", ""), ("thermal", "no [lubricant]")),
        (
            ("[lubricant]", '[lubricant]\nviscosity = "60 mPa s"\npressure_viscosity = "2e-8 1/Pa"\n'),
            ("lubricant.viscosity", "one temperature alone", "46 cSt at 40 degC"),
        ),
        (('"900 rpm"', '["900 rpm", "500 rpm"]'), ("2 operating points", "fembearing duty")),
    ],
)
def test_what_does_not_fit_is_refused_in_one_line(tmp_path: Path, change: tuple[str, str], words: tuple[str]) -> None:
    text = OILED + ("" if "[lubricant]" in change[0] else 'name = "ISO VG 46"\n')
    file = tmp_path / "warm.toml"
    assert change[0] in text
    file.write_text(text.replace(*change))
    refused(lambda: analytic.steady_scene(file), *words)
