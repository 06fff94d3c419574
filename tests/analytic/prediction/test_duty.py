"""A duty cycle: sums of its steps, intervals of errors that all steps share, and what is refused."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import analytic
from analytic.prediction.duty import DutyCycle, duty_cycle
from analytic.prediction.first_order import first_order_ends
from analytic.scene import Operation
from analytic.scenefile.read import load_scene
from tests.refusals import refused

HEAD = "duration [s],inner_speed [rpm],axial_load [N]\n"
STEPS = HEAD + "20,600,900\n5,-2400,300\n7,0,0\n20,600,900\n"
SETTINGS = {"friction.spin_rule": "balanced"}
RUN = {"axial_load": 900.0, "speed": 60.0, "oil": "ISO VG 46"}
OILED = {**RUN, "temperature": 335.0}


def cycle_file(folder: Path, text: str = STEPS) -> Path:
    file = folder / "cycle.csv"
    file.write_text(text)
    return file


@pytest.fixture(scope="module")
def oiled(tmp_path_factory: pytest.TempPathFactory) -> DutyCycle:
    file = cycle_file(tmp_path_factory.mktemp("duty"))
    return duty_cycle("6206", file, settings=SETTINGS, **OILED)


@pytest.fixture(scope="module")
def nominal() -> analytic.FrictionTorque:
    """The torque at the two operating points of the cycle."""
    scene = load_scene("6206", settings=SETTINGS, **OILED)
    operation = Operation(axial_load=np.array([900.0, 300.0]), inner_speed=np.array([600.0, -2400.0]) * np.pi / 30)
    return analytic.friction_torque(replace(scene, operation=operation))


def test_energy_torque_and_power_are_those_of_the_steps(oiled: DutyCycle, nominal: analytic.FrictionTorque) -> None:
    slow, fast = nominal.torque.total
    angles = np.array([2 * 20 * 600, 5 * 2400]) * np.pi / 30
    energy = float(angles @ (slow, fast))
    assert oiled.energy.value == pytest.approx(energy, rel=1e-12)
    assert oiled.mean_torque.value == pytest.approx(energy / angles.sum(), rel=1e-12)
    assert oiled.mean_power.value == pytest.approx(energy / 52, rel=1e-12)  # with the pause of 7 s
    assert oiled.duration == pytest.approx(52)
    assert oiled.worst_torque.value == pytest.approx(max(slow, fast), rel=1e-12)
    assert oiled.steps[oiled.worst_step].torque.value == oiled.worst_torque.value
    assert [step.power > 0 for step in oiled.steps] == [True, True, False, True]
    assert sum(step.energy for step in oiled.steps) == pytest.approx(energy, rel=1e-12)


def test_the_interval_of_one_step_is_that_of_its_torque(tmp_path: Path) -> None:
    """Second way: `first_order_ends`, which the command torque shows."""
    scene = load_scene("6206", settings=SETTINGS, **OILED)
    found = duty_cycle(
        "6206", cycle_file(tmp_path, "duration [s],axial_load [N]\n13,900\n"), settings=SETTINGS, **OILED
    )
    ends = first_order_ends(scene, analytic.friction_torque(scene))
    assert ends is not None
    for estimate in (found.mean_torque, found.worst_torque, found.steps[0].torque):
        assert (estimate.low, estimate.high) == pytest.approx(tuple(ends[:, 0]), rel=1e-12)
    ratio = found.energy.value / found.mean_torque.value
    assert found.energy.high == pytest.approx(ratio * ends[1, 0], rel=1e-12)


def test_errors_that_all_steps_share_do_not_average_out(oiled: DutyCycle) -> None:
    """The energy is as uncertain as the steps are: within the spans of their relative ends."""
    ends = np.array([[s.torque.low, s.torque.high] for s in oiled.steps if s.power], float)
    values = np.array([[step.torque.value] for step in oiled.steps if step.power])
    assert oiled.energy.low is not None
    assert oiled.energy.high is not None
    low, high = (ends / values).T
    assert low.min() <= oiled.energy.low / oiled.energy.value <= low.max()
    assert high.min() <= oiled.energy.high / oiled.energy.value <= high.max()


def test_each_temperature_has_its_own_oil(tmp_path: Path) -> None:
    file = cycle_file(tmp_path, "duration [min],temperature [degC]\n2,40\n3,70\n")
    found = duty_cycle("6206", file, settings=SETTINGS, **OILED)
    for step, warmth in zip(found.steps, (313.15, 343.15), strict=True):
        warm: dict[str, Any] = {**OILED, "temperature": warmth}
        scene = load_scene("6206", settings=SETTINGS, **warm)
        assert step.torque.value == pytest.approx(analytic.friction_torque(scene).torque.total[0], rel=1e-12)
        assert step.temperature == pytest.approx(warmth)
    assert found.steps[0].duration == 120


def test_the_mean_power_warms_the_oil(tmp_path: Path) -> None:
    settings = {**SETTINGS, "thermal.resistance": 0.9, "thermal.ambient": 296.0}
    found = duty_cycle("6206", cycle_file(tmp_path), settings=settings, **RUN)
    assert found.steady is not None
    assert found.steady.temperature > 296.5
    # 1e-3 K: the search ends at 1e-4 K
    assert found.steady.temperature == pytest.approx(296.0 + 0.9 * found.mean_power.value, abs=1e-3)
    assert {step.temperature for step in found.steps} == {found.steady.temperature}


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("inner_speed [rpm]\n60\n", ("no column duration", "duration [s]")),
        ("duration [s]\n60\n", ("does not say what runs in its steps",)),
        (HEAD + "0,60,500\n", ("row 1 (line 2): duration = 0 s must be at least",)),
        (HEAD + "5,0,500\n", ("nothing turns in any step",)),
        (HEAD + "5,60,0\n", ("row 1 has no load",)),
        ("duration [s],inner_speed [rpm],temperature [degC]\n5,600,60\n", ("6205-dry", "no [lubricant]")),
    ],
)
def test_a_mistake_gives_one_line(tmp_path: Path, text: str, words: tuple[str, ...]) -> None:
    file = cycle_file(tmp_path, text)
    refused(lambda: duty_cycle("6205-dry", file), *words)


def test_no_usual_load_is_added_to_the_loads_of_the_steps(tmp_path: Path) -> None:
    """A 6206 has a usual radial load, which counts where no column is a load."""
    thrust = duty_cycle("6206", cycle_file(tmp_path, HEAD + "7,600,300\n3,0,0\n"), settings=SETTINGS)
    assert [step.radial_load for step in thrust.steps] == [0, 0]
    nothing = {**SETTINGS, "operation.radial_load": 0.0}
    assert duty_cycle("6206", cycle_file(tmp_path), settings=nothing).steps[1].axial_load == 300
    radial = duty_cycle("6206", cycle_file(tmp_path, "duration [s],radial_load [N]\n7,-900\n"), settings=SETTINGS)
    assert (radial.steps[0].radial_load, radial.steps[0].axial_load) == (-900, 0)
    bare = duty_cycle("6206", cycle_file(tmp_path, "duration [s],inner_speed [rpm]\n7,600\n"), settings=SETTINGS)
    assert bare.steps[0].radial_load == np.max(load_scene("6206").operation.radial_load) > 0
