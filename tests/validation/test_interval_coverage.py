"""Measured films and torques in the stated intervals."""

import numpy as np
import pytest

from validation.intervals import run as intervals
from validation.intervals import run as program


def test_measured_films_lie_in_the_stated_interval() -> None:
    found = {(each.what, each.interval): each for each in intervals.films()}
    fast = found["films from 0.02 m/s", "film formula"]
    assert fast.points == 20
    assert fast.covered >= 19
    slow = found["slower films", "film formula, scatter"]
    assert slow.covered + slow.below + slow.above == slow.points == 11
    assert slow.covered > found["slower films", "film formula"].covered


@pytest.mark.nightly
def test_measured_torques_are_counted_against_an_interval_that_is_not_moved() -> None:
    found = list(program.torques())
    assert {each.points for each in found} == {6}
    for each in found:
        assert each.covered + each.below + each.above == 6
    # The interval is about the model's own torque, which is below the measured one up to 150 rpm, four speeds of six.
    rig = program.measured.compare(3.0)
    interval = program.predict(rig.scene, samples=128, workers=1).total
    assert np.all((interval.low < rig.computed) & (rig.computed < interval.high))
    assert np.flatnonzero(rig.computed < rig.measured).tolist() == [0, 1, 2, 3]
