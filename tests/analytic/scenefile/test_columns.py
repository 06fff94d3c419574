"""Files of rows: columns with units, what is refused, operating points, and the oil at each measured temperature."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import analytic
from analytic.errors import InputError
from analytic.scene import Arrangement, Operation, Scene
from analytic.scenefile.columns import operating_points, read_measured, require_loads
from analytic.scenefile.read import load_scene
from fembearing.provenance import provenance_of
from tests.analytic.scenefile.scene_texts import MINE
from tests.analytic.specimens import BEARING_6205, dry
from tests.refusals import refused

OILED = """\
name = "oiled"
tolerance = "5 %"
[bearing]
catalog = "6206"
[operation]
axial_load = "700 N"
inner_speed = "900 rpm"
[lubricant]
name = "ISO VG 46"
temperature = "55 degC"
[surface]
finish = "ground and honed"
[friction]
spin_rule = "balanced"
"""
HEAD = "inner_speed [rpm],torque [N mm]"


def data(folder: Path, text: str) -> Path:
    file = folder / "data.csv"
    file.write_text(text, "utf-8")
    return file


def test_columns_are_read_in_si_in_any_order_and_unit(tmp_path: Path) -> None:
    text = (
        '\ufeff# rig 2\n\n torque [N m] ,temperature [°C],"inner_speed [1/min]",uncertainty [%],axial_load [kgf]\n'
        "# first run\n0.0351,62.5,300,2,50\n 0.04 ,  65 ,-600, 3 ,70\n"
    )
    found = read_measured(data(tmp_path, text))
    np.testing.assert_allclose(found.torque, [0.0351, 0.04], rtol=1e-15)
    assert found.uncertainty is not None
    np.testing.assert_allclose(found.uncertainty, [0.02 * 0.0351, 0.03 * 0.04], rtol=1e-15)  # shares of the torque
    np.testing.assert_allclose(found.inner_speed, [10 * np.pi, -20 * np.pi], rtol=1e-15)  # type: ignore[arg-type]
    np.testing.assert_allclose(found.axial_load, [50 * 9.80665, 70 * 9.80665], rtol=1e-15)  # type: ignore[arg-type]
    np.testing.assert_allclose(found.temperature, [335.65, 338.15], rtol=1e-15)  # type: ignore[arg-type]
    assert found.radial_load is None


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("sped [rpm],torque [N mm]\n60,5", ("'sped [rpm]' is not known", "did you mean inner_speed [rpm]?")),
        ("innerspeed,radial_load [N],torque [N mm]\n60,3,5", ("'innerspeed' is not known", "did you mean inner_speed")),
        ("speed,T,torque\n[rpm],[C],[N mm]\n60,70,5", ("'T' is not known, and its unit fits temperature [degC]",)),
        ("speed [rpm],Moment [N mm]\n60,5", ("'Moment [N mm]' is not known, and its unit fits torque [N mm]",)),
        (f"{HEAD},temp\n60,5,70", ("'temp' is not known", "did you mean temperature [degC]?", "leave the column out")),
        (
            f"{HEAD},Fr [kN]\n60,5,70",
            ("'Fr [kN]' is not known, and its unit fits axial_load [kN] or radial_load [kN]",),
        ),
        (f"{HEAD},moment [N mm]\n60,5,7", ("'moment [N mm]' is not known", "operation.moment in the scene")),
        (f"{HEAD},run\n60,5,2", ("row 1 (line 2): torque = 5,2 may be one number", "write 5.0", "the column run out")),
        (f"{HEAD},run\n60,5,2,", ("row 1 (line 2) has 4 values", "3 columns", "decimal points")),
        ("duration [s],inner_speed [rpm]\n4,60", ("a column duration and no column torque", "fembearing duty")),
        ("inner_speed,torque [N mm]\n60,5", ("inner_speed has no unit", "inner_speed [rpm]")),
        ("inner_speed [\ufeffrpm],torque [N mm]\n60,5", ("'\\ufeffrpm'] has the unknown unit", "inner_speed [rpm]")),
        ("inner_speed [rmp],torque [N mm]\n60,5", ("inner_speed [rmp]", "unknown unit 'rmp'", "inner_speed [rpm]")),
        (f"{HEAD}\n60,{'9' * 2000}", ("torque = '999", "...999", '"35.1 N mm"')),
        ("inner_speed [N],torque [N mm]\n60,5", ("inner_speed [N] is not in a unit like rpm",)),
        (f"{HEAD},uncertainty [rpm]\n60,5,2", ("uncertainty [rpm]", "uncertainty [N mm] or [%]")),
        (f"{HEAD},torque [N m]\n60,5,5", ("2 columns torque", "keep one")),
        ("inner_speed [rpm]\n60", ("no column torque", "torque [N mm]")),
        ("torque [N mm]\n5", ("does not say where", "inner_speed [rpm], axial_load [kN]")),
        (HEAD, ("no row below it",)),
        ("inner_speed;torque\n[rpm];[rpm]\n60;5", ("column inner_speed has no unit", "inner_speed [rpm]")),
        (f"{HEAD}\n60,5,2", ("row 1 (line 2) has 3 values", "2 columns", "decimal points")),
        (f"{HEAD}\n\n60", ("row 1 (line 3) has 1 value,", "give one for each")),
        (f"# rig\n{HEAD}\n60,5\n90,abc", ("row 2 (line 4): torque = 'abc' is no number", "N mm")),
        (f"{HEAD}\nnan,5", ("row 1 (line 2): inner_speed = 'nan' is no number",)),
        (f"{HEAD}\n60,", ("torque is empty",)),
        (f"{HEAD}\n0,5", ("inner_speed = 0: nothing turns",)),
        (f"{HEAD}\n60,-5", ("torque = -5 N mm is below 0", "magnitude")),
        ("axial_load [N],torque [N mm]\n-3,5", ("axial_load = -3 N must be at least 0 kN")),
        (f"{HEAD},uncertainty [N m]\n60,5,5", ("uncertainty = 5000 N mm is larger than the torque, 5 N mm", "k = 1")),
    ],
)
def test_a_mistake_names_place_value_and_remedy_in_one_line(tmp_path: Path, text: str, words: tuple[str, ...]) -> None:
    file = data(tmp_path, text)
    refused(lambda: read_measured(file), f"{file}: ", *words)
    with pytest.raises(InputError) as found:
        read_measured(file)
    assert len(str(found.value)) < 200 + len(str(file))  # readable, whatever stands in a cell


def test_a_file_that_cannot_be_read_is_named(tmp_path: Path) -> None:
    refused(lambda: read_measured(tmp_path / "gone.csv"), "gone.csv", "No such file", "give the path of a CSV or")
    file = data(tmp_path, f"{HEAD}\n" + "60,5\n" * 20_001)
    refused(lambda: read_measured(file), "data.csv: has more than 20000 rows")


def test_a_scene_names_its_file_from_its_folder_and_a_given_one_comes_first(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    inside = tmp_path / "rig"
    inside.mkdir()
    data(inside, f"{HEAD}\n60,5\n")
    (tmp_path / "other.csv").write_text(f"{HEAD}\n90,7\n")
    (inside / "scene.toml").write_text(MINE + '[measured]\nfile = "data.csv"\n')
    own, given = load_scene("rig/scene.toml"), load_scene("rig/scene.toml", measured="other.csv")
    assert own.measured is not None
    assert given.measured is not None
    assert (own.measured.file, given.measured.file) == (str(Path("rig/data.csv")), "other.csv")
    assert given.measured.torque.tolist() == [0.007]
    plain = load_scene_text(tmp_path, MINE)
    measured, bare = (analytic.friction_torque(scene).torque.total for scene in (own, plain))
    np.testing.assert_array_equal(measured, bare)
    # They change no torque, so they change no hash.
    assert provenance_of(own).scene_sha256 == provenance_of(plain).scene_sha256


def load_scene_text(folder: Path, text: str) -> analytic.Scene:
    (folder / "plain.toml").write_text(text)
    return load_scene(folder / "plain.toml")


def test_each_temperature_has_the_oil_that_the_scene_has_there(tmp_path: Path) -> None:
    file = data(tmp_path, "temperature [degC],torque [N mm]\n70,5\n55,6\n70,7\n")
    (tmp_path / "scene.toml").write_text(OILED)
    found = load_scene(tmp_path / "scene.toml", measured=file)
    assert found.measured is not None
    (tmp_path / "warm.toml").write_text(OILED.replace("55 degC", "70 degC"))
    warm = load_scene(tmp_path / "warm.toml")
    assert found.measured.oils == {328.15: found.lubricant, 343.15: warm.lubricant}


def test_temperatures_need_an_oil_that_is_known_there(tmp_path: Path) -> None:
    file = data(tmp_path, "temperature [degC],torque [N mm]\n70,5\n190,6\n")
    (tmp_path / "dry.toml").write_text(MINE)
    refused(lambda: load_scene(tmp_path / "dry.toml", measured=file), "data.csv", "no [lubricant]", "leave the column")
    (tmp_path / "oiled.toml").write_text(OILED)
    with pytest.raises(InputError, match=r"data\.csv: row 2: temperature = 190 degC: .* -40 to 140 degC"):
        load_scene(tmp_path / "oiled.toml", measured=file)


@pytest.fixture
def scene() -> Scene:
    operation = Operation(
        axial_load=np.full(2, 300.0), inner_speed=np.array([10.0, 20.0]), radial_load=np.full(2, 40.0)
    )
    return replace(dry(BEARING_6205), operation=operation)


def test_a_column_takes_the_place_of_the_scenes_values(scene: Scene) -> None:
    columns = {"inner_speed": np.array([7.0, 8.0, 9.0]), "radial_load": None}
    found = operating_points(scene, "a.csv", columns, 3)
    np.testing.assert_array_equal(found["inner_speed"], [7.0, 8.0, 9.0])
    for name, value in (("axial_load", 300.0), ("radial_load", 40.0), ("moment", 0.0)):
        np.testing.assert_array_equal(found[name], [value] * 3)


def test_what_the_file_lacks_must_have_one_value(scene: Scene) -> None:
    words = (
        "a.csv has no column inner_speed, and the scene has 2 values of it; add the column, or give one in operation."
    )
    refused(lambda: operating_points(scene, "a.csv", {}, 3), words)
    tilted = replace(scene, operation=replace(scene.operation, inner_speed=np.ones(2), moment=np.array([1.0, 3.0])))
    refused(lambda: operating_points(tilted, "a.csv", {}, 3), "2 values of it; give one in operation.moment")


def test_each_row_needs_a_load_unless_a_pair_has_its_preload(scene: Scene) -> None:
    loads = {"axial_load": [3.0, 0.0, 0.0, 0.0], "radial_load": [0.0, -2.0, 0.0, 0.0], "moment": [0.0, 0.0, 0.5, 0.0]}
    points = {name: np.array(values) for name, values in loads.items()}
    require_loads(scene, "a.csv", {name: values[:3] for name, values in points.items()})
    tandem = Arrangement(kind="tandem")
    for given in (scene, replace(scene, arrangement=tandem)):
        refused(lambda: require_loads(given, "a.csv", points), "a.csv: row 4 has no load")  # noqa: B023
    require_loads(replace(scene, arrangement=Arrangement(kind="O", preload=9.0)), "a.csv", points)
