"""The record of a torque: what belongs to its points, and what it takes from a result."""

from dataclasses import replace
from types import MappingProxyType, SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.verdicts import PhysicalCheck
from fembearing.report import torque as module
from fembearing.report.torque import Band, cage_motion
from fembearing.verify.torque.left_out import Places
from fembearing.verify.torque.verdicts import Verdicts
from tests.report.prediction_rows import content, prediction_of
from tests.report.torque_rows import lost, point, record

TWO = record(point(0), point(1))
ON_THE_SECOND = PhysicalCheck(
    name="peak_pressure", where="ball", point=1, value=1.7e9, limit=4.2e9, unit="Pa", verdict="pass", note=""
)


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"catalogue_band": Band(low=(0.01, 0.02), high=None, values={}, note="")}, "half a catalogue_band"),
        ({"catalogue_band": Band(low=None, high=(0.01, 0.02), values={}, note="")}, "half a catalogue_band"),
        (
            {"catalogue_band": Band(low=(0.01,), high=(0.01, 0.02), values={}, note="")},
            "1 values of catalogue_band at 2",
        ),
        (
            {"catalogue_band": Band(low=(0.01, 0.02), high=(0.01,), values={}, note="")},
            "1 values of catalogue_band at 2",
        ),
        ({"interval": (None,)}, "1 intervals, or values of a maker, at 2"),
        ({"catalogue_band": Band(low=None, high=None, values={"SKF": (0.01,)}, note="")}, "1 intervals, or values"),
        (
            {"verdicts": Verdicts(numerical=None, physical=(replace(ON_THE_SECOND, point=2),))},
            "a verdict on point 2, and 2 points",
        ),
        ({"points": (point(0),), "interval": (None,), "prediction": prediction_of(content())}, "of 2 points, and 1"),
    ],
)
def test_what_belongs_to_other_points_is_refused(changed: dict[str, Any], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        replace(TWO, **changed)


def test_what_belongs_to_its_points_is_taken() -> None:
    whole = replace(
        TWO,
        catalogue_band=Band(low=(0.01, 0.02), high=(0.03, 0.04), values={"SKF": (0.01, None)}, note=""),
        verdicts=Verdicts(numerical=None, physical=(ON_THE_SECOND,)),
        prediction=prediction_of(content()),
        interval=(None, (0.01, 0.02)),
    )
    assert whole.computed == [0, 1]
    assert replace(whole, left_out=(lost(0),)).computed == [1]


def result_of(**changed: Any) -> Any:
    """What is read of a result at the first and the third of three points."""
    band = SimpleNamespace(
        low=np.array([0.01, 0.03]),
        high=np.array([0.04, 0.07]),
        values=MappingProxyType({"SKF": np.array([0.01, np.nan])}),
    )
    given: dict[str, Any] = {
        "catalogue": SimpleNamespace(band=band, note="a band"),
        "places": Places(size=3, left_out=(lost(1),)),
        "other_candidate": SimpleNamespace(torque=SimpleNamespace(total=np.array([0.05, 0.08]))),
        "scene": SimpleNamespace(
            bearing=SimpleNamespace(other_candidate=SimpleNamespace(ball_count=8, ball_diameter=12e-3))
        ),
        "interval": None,
        "friction": SimpleNamespace(inner_speed=np.array([10.0, 30.0])),
    }
    return SimpleNamespace(**(given | changed))


def test_a_band_has_its_ends_where_there_is_a_torque() -> None:
    band = module._band(result_of())
    np.testing.assert_array_equal(np.array(band.low, dtype=float), [0.01, np.nan, 0.03])
    np.testing.assert_array_equal(np.array(band.high, dtype=float), [0.04, np.nan, 0.07])
    assert band.values["SKF"][::2] == (0.01, None)  # where the model does not hold
    none = module._band(result_of(catalogue=SimpleNamespace(band=None, note="no band")))
    assert none == Band(low=None, high=None, values={}, note="no band")


def test_other_balls_are_told_where_they_are_known_and_have_a_torque() -> None:
    other = module._other(result_of())
    assert other is not None
    assert (other.ball_count, other.ball_diameter) == (8, 12e-3)
    np.testing.assert_array_equal(np.array(other.total, dtype=float), [0.05, np.nan, 0.08])
    assert module._other(result_of(other_candidate=None)) is None
    assert module._other(result_of(scene=SimpleNamespace(bearing=SimpleNamespace(other_candidate=None)))) is None


def test_an_interval_has_both_ends_at_each_point_or_is_not_known() -> None:
    assert module._interval(result_of()) == [None, None]
    ends = np.array([[0.01, 0.02], [0.03, 0.05]])
    assert module._interval(result_of(interval=ends)) == [(0.01, 0.03), (0.02, 0.05)]


def test_a_cage_that_moved_somewhere_has_an_entry_at_every_point() -> None:
    def friction(part: Any) -> Any:
        return SimpleNamespace(friction=SimpleNamespace(cage=part, inner_speed=np.array([10.0, 30.0])))

    motion = SimpleNamespace(torque=2e-3, start="rest", block=0.01, other=None)
    row = point().cage
    moved = SimpleNamespace(motion=[None, motion], row=lambda _: row)
    found = cage_motion(friction(moved))
    assert found is not None
    assert [each.inner_speed for each in found] == [10.0, 30.0]
    assert [each.torque for each in found] == [None, 2e-3]
    assert [each.start for each in found] == [None, "rest"]
    assert cage_motion(friction(SimpleNamespace(motion=[None, None]))) is None
    assert cage_motion(friction(None)) is None
