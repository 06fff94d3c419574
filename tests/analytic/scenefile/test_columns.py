"""Operating points of a file's rows, with what the scene has for the others."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.scene import Arrangement, Operation, Scene
from analytic.scenefile.columns import operating_points, require_loads
from tests.analytic.specimens import BEARING_6205, dry
from tests.refusals import refused


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
