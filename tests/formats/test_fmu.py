"""The unit in FMPy: valid, with the torque within its stated error; it keeps its state, and holds what is outside."""

import re
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from scipy.interpolate import RegularGridInterpolator

from analytic.scene import Array
from analytic.scenefile.read import load_by_temperature
from fembearing.formats import fmu
from fembearing.formats.axes import axes_of
from fembearing.formats.choice import export_of
from fembearing.formats.torque_map import TorqueMap, from_standstill, mapped_torque
from tests.refusals import refused

fmpy = pytest.importorskip("fmpy", reason="an optional tool, which reads the unit")
fmi2 = pytest.importorskip("fmpy.fmi2")

OVER = {
    "speed": "0 rpm to 3000 rpm in 5",
    "axial_load": "150 N to 900 N in 3",
    "radial_load": "400 N",
    "temperature": "50 degC to 75 degC in 2",
}
SMALL = {"speed": "700 rpm to 900 rpm in 2", "axial_load": "500 N", "radial_load": "400 N", "temperature": "60 degC"}
OK, WARNING = 0, 1  # statuses of FMI
INPUTS, OUTPUTS = ("speed", "axial_load", "temperature"), ("low", "torque", "high", "power")


class Made(NamedTuple):
    file: Path
    table: TorqueMap
    description: Any  # of FMPy


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Made:
    found = load_by_temperature(
        "6206", speed="1500 rpm", radial_load="400 N", settings={"friction.spin_rule": "balanced"}
    )
    file = tmp_path_factory.mktemp("unit") / "bearing.fmu"
    export_of(found, to="fmu", out=file, over=OVER)
    table = mapped_torque(found, from_standstill(axes_of(found, OVER, whole=True)))
    return Made(file, table, fmpy.read_model_description(str(file), validate=True))


class Unit:
    """An instance of the unit in its simulation."""

    def __init__(self, made: Made, folder: str, name: str) -> None:
        self.places = {each.name: each.valueReference for each in made.description.modelVariables}
        self.slave = fmi2.FMU2Slave(
            guid=made.description.guid,
            unzipDirectory=folder,
            modelIdentifier=made.description.coSimulation.modelIdentifier,
            instanceName=name,
        )
        self.slave.instantiate()
        self.slave.setupExperiment(startTime=0.0)
        self.slave.enterInitializationMode()
        self.slave.exitInitializationMode()

    def give(self, **values: float) -> None:
        self.slave.setReal([self.places[name] for name in values], list(values.values()))

    def take(self, *names: str) -> list[float]:
        return self.slave.getReal([self.places[name] for name in names])

    @property
    def outside(self) -> int:
        """Number of the input that is beyond the table; 0: none."""
        return self.slave.getInteger([self.places["outside"]])[0]

    def status_of(self, name: str, value: float) -> int:
        """What the unit answers to an input."""
        place, number = (fmi2.fmi2ValueReference * 1)(self.places[name]), (fmi2.fmi2Real * 1)(value)
        return self.slave.dll.fmi2SetReal(self.slave.component, place, 1, number)


@pytest.fixture
def units(made: Made) -> Iterator[tuple[Unit, Unit]]:
    folder = fmpy.extract(str(made.file))
    both = Unit(made, folder, "first"), Unit(made, folder, "second")
    yield both
    for unit in both:
        unit.slave.terminate()
        unit.slave.freeInstance()


def way(table: TorqueMap, count: int) -> dict[str, Array]:
    """Inputs that wander through the table, the speed to both sides and at last at rest."""
    rng = np.random.default_rng(11)
    found = {}
    for name in INPUTS:
        low, high = table.axes[name][[0, -1]]
        walk = np.cumsum(rng.normal(size=count))
        found[name] = low + (high - low) * (walk - walk.min()) / np.ptp(walk)
    middle = np.median(found["speed"])
    found["speed"] = np.where(np.arange(count) % 2, -1.0, 1.0) * np.abs(found["speed"] - middle)
    found["speed"][-1] = 0.0
    low, high = table.axes["temperature"][[0, -1]]
    found["temperature"] = np.linspace(low, high, 3)[rng.integers(3, size=count)]  # each takes a function of its own
    return found


def stated_error(made: Made) -> float:
    found = re.search(r"by up to ([\d.e-]+) %", made.description.description)
    assert found
    return float(found[1]) / 100


def test_a_thousand_steps_have_the_torque_within_the_stated_error(made: Made, units: tuple[Unit, Unit]) -> None:
    inputs, unit = way(made.table, 1000), units[0]
    found = np.empty((1000, len(OUTPUTS)))
    for step in range(1000):
        unit.give(**{name: float(values[step]) for name, values in inputs.items()})
        unit.slave.doStep(currentCommunicationPoint=0.01 * step, communicationStepSize=0.01)
        found[step] = unit.take(*OUTPUTS)
    low, torque, high, power = found.T
    points = {"speed": np.abs(inputs["speed"]), "axial_load": inputs["axial_load"], "radial_load": np.full(1000, 400.0)}
    points["temperature"] = inputs["temperature"]
    right = made.table.law.at(points)
    # 5 %: the error is measured in the middle of cells, is largest near it, and is printed with two digits
    np.testing.assert_array_less(np.abs(torque / right - 1), 1.05 * stated_error(made))
    assert (low < torque).all()
    assert (torque < high).all()
    np.testing.assert_allclose(power, torque * np.abs(inputs["speed"]), rtol=1e-14)
    # the same straight lines a second time, by SciPy
    for part, values in zip(made.table.torque, (low, torque, high), strict=True):
        again = RegularGridInterpolator([*made.table.axes.values()], part)(np.stack([*points.values()], axis=1))
        np.testing.assert_allclose(values, again, rtol=1e-12)


def test_the_state_comes_back_and_reset_begins_again(units: tuple[Unit, Unit]) -> None:
    unit = units[0]
    begun = unit.take(*INPUTS, *OUTPUTS)
    unit.give(speed=31.0, axial_load=333.0)
    kept, state = unit.take(*INPUTS, *OUTPUTS), unit.slave.getFMUstate()
    text = unit.slave.serializeFMUstate(state)
    unit.give(speed=250.0, temperature=325.0)
    assert unit.take("torque") != kept[4:5]
    unit.slave.setFMUstate(state)
    assert unit.take(*INPUTS, *OUTPUTS) == kept
    unit.give(speed=77.0)
    again = fmi2.fmi2FMUstate()
    unit.slave.deSerializeFMUstate(text, again)
    unit.slave.setFMUstate(again)
    assert unit.take(*INPUTS, *OUTPUTS) == kept
    for each in (state, again):
        unit.slave.freeFMUstate(each)
    unit.slave.reset()
    assert unit.take(*INPUTS, *OUTPUTS) == begun


def test_two_instances_do_not_mix(units: tuple[Unit, Unit]) -> None:
    first, second = units
    first.give(speed=17.0)
    second.give(speed=170.0)
    alone = first.take(*OUTPUTS)
    second.give(axial_load=880.0)
    second.slave.doStep(currentCommunicationPoint=0.0, communicationStepSize=0.1)
    assert first.take(*OUTPUTS) == alone
    assert first.take("speed") == [17.0]
    assert second.take("speed", "axial_load") == [170.0, 880.0]


@pytest.mark.parametrize(
    ("name", "beyond", "number"),
    [
        ("speed", 315.0, 1),
        ("speed", -400.0, 1),
        ("axial_load", 20.0, 2),
        ("axial_load", 1e4, 2),
        ("temperature", 350.0, 4),
    ],
)
def test_beyond_the_table_its_last_torque_holds_with_a_flag_and_one_warning(
    made: Made, units: tuple[Unit, Unit], name: str, beyond: float, number: int
) -> None:
    unit, place = units[0], units[0].places[name]
    (inside,) = unit.take(name)
    low, high = made.table.axes[name][[0, -1]].tolist()
    assert unit.outside == 0
    unit.give(**{name: low if beyond == 20.0 else high})
    (torque,) = unit.take("torque")
    assert unit.outside == 0
    assert unit.status_of(name, beyond) == WARNING
    assert unit.status_of(name, 1.001 * beyond) == OK  # it has left the table before
    assert unit.take("torque", name) == [torque, 1.001 * beyond]
    assert unit.take("power")[0] == pytest.approx(torque * abs(unit.take("speed")[0]), rel=1e-14)
    assert unit.outside == number
    assert f"{number}: {name} is outside its table, " in made.description.modelVariables[-1].description
    unit.give(**{name: inside})
    assert unit.outside == 0
    assert unit.status_of(name, beyond) == WARNING
    with pytest.raises(Exception, match="status 3"):
        unit.slave.setReal([place], [np.nan])
    assert unit.take(name) == [beyond]


def test_a_run_beyond_the_table_goes_on(made: Made, capsys: pytest.CaptureFixture[str]) -> None:
    """From 0 to 400 rad/s in 2 s; the table ends at 314 rad/s."""
    time = np.linspace(0.0, 2.0, 41)
    given = np.array([*zip(time, 200.0 * time, strict=True)], dtype=[("time", float), ("speed", float)])
    found = fmpy.simulate_fmu(
        str(made.file),
        stop_time=2.0,
        output_interval=0.05,
        input=given,
        output=["torque", "outside", "speed"],
    )
    beyond = found["speed"] > made.table.axes["speed"][-1]
    assert found["time"][-1] == pytest.approx(2.0)
    np.testing.assert_array_equal(found["outside"] == 1, beyond)
    assert np.ptp(found["torque"][beyond]) == 0
    logged = [line for line in capsys.readouterr().out.splitlines() if line.startswith("[")]  # FMPy prints it
    assert [line.partition(" to ")[0] for line in logged] == ["[WARNING] speed is outside its table, 0 rpm"]


def test_a_constant_and_an_output_cannot_be_set(units: tuple[Unit, Unit]) -> None:
    assert units[0].take("radial_load") == [400.0]
    for name in ("radial_load", "torque"):
        with pytest.raises(Exception, match="status 3"):
            units[0].give(**{name: 5.0})


def test_the_file_is_small_and_the_same_each_time(made: Made, tmp_path: Path) -> None:
    assert made.file.stat().st_size < 1e6
    with zipfile.ZipFile(made.file) as unit:
        assert {"modelDescription.xml", "sources/fmu.c", "sources/table.h"} < set(unit.namelist())
        assert b"python" not in next(unit.read(name) for name in unit.namelist() if "binaries" in name).lower()
    files = [tmp_path / "one.fmu", tmp_path / "other.fmu"]
    for file in files:
        export_of(made.table.law.found, to="fmu", out=file, over=SMALL)
    with zipfile.ZipFile(files[0]) as one, zipfile.ZipFile(files[1]) as other:
        for name in ("modelDescription.xml", "sources/table.h"):
            assert one.read(name) == other.read(name)


def test_no_compiler_and_a_broken_one_are_refused(made: Made, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "bearing.fmu"
    monkeypatch.setattr(fmu.shutil, "which", lambda _: None)
    refused(lambda: export_of(made.table.law.found, to="fmu", out=file, over=SMALL), "C compiler", "install one")
    monkeypatch.setattr(fmu.shutil, "which", lambda _: "/bin/false")
    refused(lambda: export_of(made.table.law.found, to="fmu", out=file, over=SMALL), "'/bin/false' fails", "status 1")
    many = OVER | {"speed": "0 rpm to 3000 rpm in 2000"}
    refused(lambda: export_of(made.table.law.found, to="fmu", out=file, over=many), " x 3 x 1 x 2 = ", "fewer")
    assert list(tmp_path.iterdir()) == []
