"""Numbers in sentences, against the definitions of their units."""

import numpy as np
import pytest

from analytic.words import (
    NEWTON,
    RPM,
    Unit,
    angle_of,
    length_of,
    percent_of,
    plain,
    pressure_of,
    shown,
    speed_of,
    torque_of,
)


@pytest.mark.parametrize(
    ("written", "words"),
    [
        (pressure_of(2.325e9), "2.325 GPa"),
        (length_of(0.957e-3), "0.957 mm"),
        (length_of(-14e-6), "-14 um"),
        (length_of(0.0), "0 mm"),
        (torque_of(0.0123), "12.3 N mm"),
        (speed_of(2 * np.pi * 25), "1500 rpm"),  # 25 turns a second
        (speed_of(-np.pi / 3), "-10 rpm"),
        (angle_of(np.pi / 6), "30 deg (0.5236 rad)"),
        (angle_of(-3.77e-18), "0 deg (0 rad)"),  # rounding of an equilibrium
        (percent_of(0.553), "55.3 %"),
        (percent_of(47.5), "4750 %"),  # no power of ten
        # A unit changes at its limit.
        (length_of(0.89e-4), "89 um"),
        (length_of(0.91e-4), "0.091 mm"),
        (angle_of(0.9e-9), "0 deg (0 rad)"),
        (angle_of(-1.1e-9), "-6.303e-08 deg (-1.1e-09 rad)"),
        (speed_of(0.99999e5 * np.pi / 30), "99999 rpm"),
        (speed_of(-1.234567e5 * np.pi / 30), "-123457 rpm"),
        (percent_of(9.994), "999 %"),
        (RPM.written(2 * np.pi, ".3g"), "60 rpm"),
        (NEWTON.written(3.25, "g"), "3.25 N"),
        (Unit("degC", 1.0, -273.15).written(300.0, ".5g"), "26.85 degC"),
        (Unit("", 2.0).written(1.5, "g"), "3"),
    ],
)
def test_a_number_has_the_unit_of_engineers(written: str, words: str) -> None:
    assert written == words


def test_what_a_user_gave_is_shown_in_one_short_line() -> None:
    assert shown("a" * 58) == repr("a" * 58)
    assert len(shown("a" * 500)) == 60
    assert shown([1, 2, 3, 4]) == "[1, 2, 3, ...]"
    assert shown({1: 2, 3: 4, 5: 6, 7: 8}).count(":") == 3
    assert shown([[[5]]]) == shown([[[[5]]]]) == "[[[...]]]"
    assert shown([[5]]) == "[[5]]"
    assert "\n" not in shown(np.eye(2))
    assert shown(12345) == "12345"
    assert len(shown(10**100)) == 40
    assert shown(2**2000) == "a number of some 602 digits"  # 2000 log10(2) = 602.06
    assert shown(-(2**1999)).startswith("-")


@pytest.mark.parametrize(("length", "is_quoted"), [(200, False), (201, True)])
def test_a_long_or_unprintable_text_is_quoted(length: int, is_quoted: bool) -> None:
    assert (plain("b" * length) != "b" * length) == is_quoted
    assert plain("line\nline") == repr("line\nline")
