"""One line of a noun or of a series, tables of a notebook, and rows of a result."""

from dataclasses import dataclass

import numpy as np
import pytest

from analytic.brief import Brief, points_of, span
from analytic.declared import Noun
from analytic.labelled import Column, Labelled, dataset_of, frame_of, html_table
from analytic.rows import require_one_length, row_of
from analytic.scene import Length
from tests.refusals import refused


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ([3.0, 1.25, 2.0], "1.25 to 3"),
        ([7, 7], "7"),
        ([1.00001, 1.00002], "1"),  # alike in four digits
        (np.array([True, False]), "2 values"),
        (["a", "b", "c"], "3 values"),
        (np.array([]), "0 values"),
    ],
)
def test_numbers_span_from_the_least_to_the_largest(values: object, words: str) -> None:
    assert span(values) == words


def test_a_span_has_its_factor() -> None:
    assert span([2 * np.pi * 25, 4 * np.pi * 25], 30 / np.pi) == "1500 to 3000"


def test_a_series_is_told_by_its_speeds_and_by_loads_that_are_not_0() -> None:
    speed = np.array([np.pi, 2 * np.pi])  # half a turn and one turn a second
    loads = {"axial_load": np.array([310.0, 470.0]), "radial_load": 0.0, "moment": np.array([0.0, -0.4])}
    assert points_of({"inner_speed": speed, **loads}) == "2 points, 30 to 60 rpm, 310 to 470 N axial, -0.4 to 0 N m"
    one = {"inner_speed": np.array([np.pi]), "axial_load": 0.0, "radial_load": 17.0, "moment": 0.0}
    assert points_of(one) == "1 point, 30 rpm, 17 N radial"


@dataclass(frozen=True, kw_only=True, eq=False)
class Shaft(Noun):
    name: str
    length: Length = 2.0
    holes: int = 3
    is_hollow: bool = False
    heights: np.ndarray | None = None


def test_a_noun_shows_what_is_not_usual() -> None:
    assert repr(Shaft(name="long", length=1.2345678)) == "Shaft(name=long, length=1.2346)"
    assert repr(Shaft(name="bored", holes=4, is_hollow=True, heights=np.array([2.0, 5.0]))) == (
        "Shaft(name=bored, holes=4, is_hollow=True, heights=2 to 5)"
    )


@pytest.mark.parametrize(("length", "is_cut"), [(88, False), (89, True)])
def test_a_line_has_a_hundred_characters_at_most(length: int, is_cut: bool) -> None:
    line = repr(Shaft(name="x" * length))
    assert len(line) == 100
    assert line.endswith("...)") == is_cut
    assert isinstance(Shaft(name="a"), Brief)


def test_a_number_with_a_unit_of_its_own_is_no_number_of_a_noun() -> None:
    class Quantity:
        magnitude, units = 3.0, "mm"

        def __str__(self) -> str:
            return "3.0 mm"

    refused(lambda: Shaft(name="a", length=Quantity()), "Shaft.length = 3.0 mm has a unit", "number in m")  # pyright: ignore[reportArgumentType]
    refused(lambda: Shaft(name="a", heights=[1.0, Quantity()]), "Shaft.heights")  # pyright: ignore[reportArgumentType]


@dataclass(frozen=True, kw_only=True)
class Numbers:
    load: object
    film: object


def test_a_row_has_the_numbers_of_one_point() -> None:
    series = Numbers(load=np.array([3.0, 5.0, 7.0]), film=None)
    assert row_of(series, 1) == Numbers(load=5.0, film=None)


def test_lists_that_belong_together_have_one_length() -> None:
    require_one_length()
    require_one_length([1, 2], "ab", (3, 4))
    with pytest.raises(ValueError, match="lists of 2 and 3 values"):
        require_one_length([1, 2], "abc", (3, 4))


def test_a_table_has_its_cells_as_text() -> None:
    assert html_table(["load, N", "a<b"], [["3", "5"], ["7", "&"]], "of <all>") == (
        "<table><caption>of &lt;all&gt;</caption><thead><tr><th>load, N</th><th>a&lt;b</th></tr></thead>"
        "<tbody><tr><td>3</td><td>5</td></tr><tr><td>7</td><td>&amp;</td></tr></tbody></table>"
    )


def test_a_dataset_lacks_what_holds_nothing_and_a_frame_what_is_not_of_its_rows() -> None:
    xarray = pytest.importorskip("xarray")
    newton = Column("N", "load")
    speed = {"speed": Labelled(("point",), [1.5, 2.5], Column("rad/s", "speed"))}
    columns = {
        "load": Labelled(("point",), [3.0, np.nan], newton),
        "none": Labelled(("point",), [np.nan, np.nan], newton),
        "empty": Labelled(("other",), np.zeros(0), newton),
        "name": Labelled(("point",), ["a", "b"], Column("", "name")),
        "table": Labelled(("point", "ball"), np.ones((2, 3)), newton),
    }
    found = dataset_of(columns, coordinates=speed, attributes={"by": "test"})
    assert isinstance(found, xarray.Dataset)
    assert set(found.data_vars) == {"load", "empty", "name", "table"}
    assert (found["load"].attrs, found.attrs) == ({"units": "N", "long_name": "load"}, {"by": "test"})
    frame = frame_of(speed | columns, "point")
    assert list(frame.columns) == ["speed", "load", "name"]
    assert frame.index.name == "point"
    assert frame.attrs["units"] == {"speed": "rad/s", "load": "N", "name": ""}
    own = frame_of(columns, "other")
    assert own.empty
    assert frame_of({"point": speed["speed"]} | columns, "point").index.tolist() == [1.5, 2.5]
