"""The bearing element of ROSS: its coefficients are the ring's stiffness, and a rotor runs on it."""

import runpy
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic import friction_torque
from analytic.scene import Arrangement, Operation, Scene
from analytic.scenefile.read import load_by_temperature, load_scene
from fembearing.formats.axes import axes_of
from fembearing.formats.choice import export
from fembearing.formats.ross import stiffness_at
from tests.refusals import refused

OVER = {"speed": "0 rpm to 9000 rpm in 6", "axial_load": "700 N", "radial_load": "300 N"}


@pytest.fixture(scope="module")
def scene() -> Scene:
    return load_scene("7206B", axial_load="700 N", radial_load="300 N", speed="3000 rpm")


ELEMENTS: dict[int, Callable[..., dict[str, Any]]] = {  # of ROSS 2 and 3: the speed of the shaft by its argument
    2: lambda frequency=None, **given: {**given, "of_shaft": frequency},
    3: lambda speed=None, frequency=None, **given: {**given, "of_shaft": speed, "of_whirl": frequency},
}


@pytest.mark.parametrize("version", ELEMENTS)
def test_the_stiffness_is_the_slope_of_the_load(
    version: int, scene: Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Against differences of the ring's place, at 3600 rpm, along the axis and along the radial load."""
    file = export(scene, to="ross", out=tmp_path / "bearing.py", over=OVER).file
    monkeypatch.setitem(sys.modules, "ross", SimpleNamespace(BearingElement=ELEMENTS[version]))
    element = runpy.run_path(str(file))["bearing"](n=3)
    assert (element["n"], element["cxx"]) == (3, 0.0)
    np.testing.assert_allclose(element["of_shaft"], np.linspace(0, 9000, 6) * np.pi / 30)
    axial, radial = np.array([693.0, 707.0, 700.0, 700.0]), np.array([300.0, 300.0, 293.0, 307.0])
    points = Operation(inner_speed=np.full(4, 3600 * np.pi / 30), axial_load=axial, radial_load=radial)
    ring = friction_torque(replace(scene, operation=points)).ring
    assert ring is not None
    place, whole = ring.displacement, ring.stiffness.mean(axis=0)
    assert place is not None
    moved = np.stack([place[1] - place[0], place[3] - place[2]], axis=1)  # by 14 N along z, and along x
    # The stiffness holds each contact's K and the balls' own forces, which follow the load: 2.5 %, and 4.6 % across.
    np.testing.assert_allclose((whole @ moved)[[0, 1]] / 14.0, np.eye(2), atol=0.06)
    # y of ROSS is x of the ring, x of ROSS is -y
    for name, right in {"kxx": whole[2, 2], "kyy": whole[1, 1], "kzz": whole[0, 0], "kxy": -whole[2, 1]}.items():
        np.testing.assert_allclose(element[name][2], right, rtol=1e-3, atol=1e-6 * whole[1, 1])
    assert abs(element["kyy"][2] / element["kxx"][2] - 1) > 0.02  # else exchanged axes would not show
    assert element["kyx"] == element["kxy"]


def test_a_rotor_of_ross_runs_on_it(scene: Scene, tmp_path: Path) -> None:
    ross = pytest.importorskip("ross", reason="an optional tool, which is large")
    file = export(scene, to="ross", out=tmp_path / "bearing.py", over=OVER).file
    module = runpy.run_path(str(file))
    bearing = module["bearing"]
    first, last = bearing(n=0), bearing(n=6, cxx=150.0)
    shaft = [ross.ShaftElement(L=0.05, idl=0.0, odl=0.03, material=ross.steel) for _ in range(6)]
    disk = ross.DiskElement.from_geometry(n=3, material=ross.steel, width=0.03, i_d=0.03, o_d=0.16)
    rotor = ross.Rotor(shaft, [disk], [first, last])
    speed = 5000 * np.pi / 30
    found = rotor.run_modal(speed=speed)
    assert (found.wn[:4] > 0).all()
    whirl = {"frequency": 0.3 * speed, "speed": speed} if module["AXIS"] == "speed" else {"frequency": speed}
    found = load_by_temperature(scene)
    right = stiffness_at(found, axes_of(found, OVER | {"speed": [speed]}, whole=False))[0]
    # ROSS draws cubic curves through the six speeds, up to 0.3 % from the stiffness here
    np.testing.assert_allclose(np.diag(first.K(**whirl)), np.diag(right)[[2, 1, 0]], rtol=0.01)


def test_the_name_of_a_bearing_is_never_code(scene: Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    named = replace(scene, bearing=replace(scene.bearing, name="""a'''; 1 / 0; "\""; 1 / 0; \\N"""))
    file = export(named, to="ross", out=tmp_path / "bearing.py", over=OVER).file
    monkeypatch.setitem(sys.modules, "ross", SimpleNamespace(BearingElement=ELEMENTS[3]))
    assert len(runpy.run_path(str(file))["SPEED"]) == 6


def test_what_has_no_stiffness_is_refused(scene: Scene, tmp_path: Path) -> None:
    file = tmp_path / "bearing.py"
    pair = replace(scene, arrangement=Arrangement(kind="X", preload=130.0, distance=0.03))
    refused(lambda: export(pair, to="ross", out=file, over=OVER), "pair of bearings")
    refused(lambda: export(scene, to="ross", out=file, over=OVER | {"speed": "300 rpm"}), "give speed as a range")
    assert list(tmp_path.iterdir()) == []


def test_the_verdict_on_a_stiffness_is_on_the_physical_limits_alone(scene: Scene, tmp_path: Path) -> None:
    """Not on what the torque neglects, or on its solver error."""
    made = export(scene, to="ross", out=tmp_path / "bearing.py", over=OVER)
    assert made.standing.word == "check"
    over = {"speed": "0 rpm to 900 rpm in 2", "radial_load": "40 kN"}
    broken = export("6206", to="ross", out=tmp_path / "broken.py", over=over)
    assert (broken.standing.word, broken.standing.points, broken.standing.size) == ("fail", 2, 2)
