"""Modelica and Simscape: the tables read back, with standstill, both directions and the error of straight lines."""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from analytic.scene import Scene
from analytic.scenefile.read import load_by_temperature, load_scene
from fembearing.formats.axes import axes_of
from fembearing.formats.choice import FormatName, export
from fembearing.formats.torque_map import TorqueMap, from_standstill, mapped_torque
from tests.refusals import refused

OVER = {"speed": "0 rpm to 2700 rpm in 7"}
NUMBER = r"[-+\d.e]+"
LIBRARY = """
package Modelica
  package Mechanics
    package Rotational
      package Components
        model BearingFriction
          parameter Real tau_pos[:, 2] = [0, 1];
          parameter Real peak(final min=1) = 1;
          Real breakaway = peak*tau_pos[1, 2];
          Real torques = sum(tau_pos[:, 2]);
          Real speeds = sum(tau_pos[:, 1]);
        end BearingFriction;
      end Components;
    end Rotational;
  end Mechanics;
end Modelica;
"""


@pytest.fixture(scope="module")
def scene() -> Scene:
    return load_scene("6206", speed="1500 rpm", radial_load="700 N", settings={"friction.spin_rule": "balanced"})


@pytest.fixture(scope="module")
def curve(scene: Scene) -> TorqueMap:
    found = load_by_temperature(scene)
    return mapped_torque(found, from_standstill(axes_of(found, OVER, whole=False)))


def tables_of(text: str) -> dict[str, np.ndarray]:
    """tau_pos of each model of a Modelica package."""
    found = re.findall(r"model (\w+) .*?tau_pos=\[(.*?)\],\s+final peak=1\);\s+end \1;", text, re.DOTALL)
    return {
        name: np.array([[float(each) for each in row.split(",")] for row in rows.split(";")]) for name, rows in found
    }


def test_a_modelica_package_has_the_table_of_bearing_friction(scene: Scene, curve: TorqueMap, tmp_path: Path) -> None:
    made = export(scene, to="modelica", out=tmp_path / "friction_6206.mo", over=OVER)
    text = made.file.read_text("utf-8")
    tables = tables_of(text)
    assert list(tables) == ["Low", "Friction", "High"]
    for table, torque in zip(tables.values(), curve.curve[1], strict=True):
        np.testing.assert_array_equal(table, np.stack([curve.axes["speed"], torque], axis=1))
        assert table[0, 0] == 0.0  # BearingFriction takes the torque at standstill from the first row
        assert (np.diff(table[:, 0]) > 0).all()
        assert (table[:, 1] > 0).all()
    assert text.startswith("package friction_6206 ")
    assert text.endswith("end friction_6206;\n")
    assert text.count("extends Modelica.Mechanics.Rotational.Components.BearingFriction(") == 3


def test_a_compiler_of_modelica_takes_the_package(scene: Scene, curve: TorqueMap, tmp_path: Path) -> None:
    """With a BearingFriction of the same parameters, which gives what it finds in the table."""
    rumoca = pytest.importorskip("rumoca", reason="an optional tool, with wheels for few systems")
    named = replace(scene, bearing=replace(scene.bearing, name='a "quoted" \\ name'))
    made = export(named, to="modelica", out=tmp_path / "friction_6206.mo", over=OVER)
    for model, torque in zip(("Low", "Friction", "High"), curve.curve[1], strict=True):
        compiled = rumoca.Session().loads(LIBRARY + made.file.read_text("utf-8"), model=f"friction_6206.{model}")
        found = compiled.simulate(0.1)
        read = [found[name][-1] for name in ("breakaway", "torques", "speeds")]
        # sums in another order
        np.testing.assert_allclose(read, [torque[0], torque.sum(), curve.axes["speed"].sum()], rtol=1e-13)


def test_a_script_of_matlab_has_both_directions_and_no_jump(scene: Scene, curve: TorqueMap, tmp_path: Path) -> None:
    made = export(scene, to="simscape", out=tmp_path / "bearing.m", over=OVER)
    text = made.file.read_text("utf-8")
    vectors = {
        name: np.array([float(each) for each in re.findall(NUMBER, values.replace("...", " "))])
        for name, values in re.findall(r"^friction\.(\w+) = \[(.*?)\];", text, re.MULTILINE | re.DOTALL)
    }
    speed = vectors.pop("speed")
    assert (np.diff(speed) > 0).all()  # as a lookup table needs
    assert list(vectors) == ["torque", "low", "high"]
    for values, torque in zip((vectors["low"], vectors["torque"], vectors["high"]), curve.curve[1], strict=True):
        np.testing.assert_array_equal(values, -values[::-1])
        np.testing.assert_array_equal(speed, -speed[::-1])
        np.testing.assert_array_equal(values[speed > 0], torque)
        np.testing.assert_array_equal(speed[speed > 0][1:], curve.axes["speed"][1:])
        assert np.interp(0.0, speed, values) == 0.0
        assert np.interp(1e-9 + 1e-3 * curve.axes["speed"][1], speed, values) == pytest.approx(torque[0], rel=1e-6)
    assert "the ends of the 95 % interval\n" in text
    breakaway = re.search(rf"^friction\.breakaway = ({NUMBER});", text, re.MULTILINE)
    assert breakaway
    assert float(breakaway[1]) == curve.nominal.ravel()[0]


def test_standstill_is_added_and_the_stated_error_holds(scene: Scene, tmp_path: Path) -> None:
    over = {"speed": "600 rpm to 2400 rpm in 4"}
    made = export(scene, to="simscape", out=tmp_path / "made.m", over=over)
    stated = re.search(r"by up to ([\d.]+) %", made.notes[0])
    assert stated
    text = made.file.read_text("utf-8")
    found = load_by_temperature(scene)
    table = mapped_torque(found, from_standstill(axes_of(found, over, whole=False)))
    speeds, torques = table.axes["speed"], table.nominal.ravel()
    assert repr(speeds[1].item()) in text
    assert 0 < speeds[1] < 1e-4 * speeds[-1]  # the torque falls by half before 600 rpm
    middles = np.linspace(0.0, speeds[-1], 500)
    points = {"axial_load": 0.0, "radial_load": 700.0, "temperature": table.axes["temperature"][0]}
    right = table.law.at({"speed": middles} | {name: np.full(500, value) for name, value in points.items()})
    error = 100 * np.abs(np.interp(middles, speeds, torques) / right - 1).max()
    assert error < 1.05 * float(stated[1])  # two digits are stated


def test_one_load_and_one_temperature(scene: Scene, tmp_path: Path) -> None:
    over = OVER | {"radial_load": "500 N to 900 N in 3"}
    files: tuple[tuple[FormatName, str], ...] = (("modelica", "a.mo"), ("simscape", "a.m"), ("ross", "a.py"))
    for to, name in files:
        refused(lambda to=to, name=name: export(scene, to=to, out=tmp_path / name, over=over), "radial_load has 3")
    assert list(tmp_path.iterdir()) == []
