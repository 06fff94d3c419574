"""Numbers in sentences, against the definitions of their units."""

import numpy as np
import pytest

from analytic.words import angle_of, length_of, percent_of, pressure_of, speed_of, torque_of


@pytest.mark.parametrize(
    ("written", "words"),
    [
        (pressure_of(2.325e9), "2.325 GPa"),
        (pressure_of(4.2e9), "4.2 GPa"),
        (length_of(0.957e-3), "0.957 mm"),
        (length_of(117e-6), "0.117 mm"),
        (length_of(-14e-6), "-14 um"),
        (length_of(0.3e-9), "0.0003 um"),
        (length_of(0.0), "0 mm"),
        (torque_of(0.0123), "12.3 N mm"),
        (speed_of(2 * np.pi * 25), "1500 rpm"),  # 25 turns a second
        (speed_of(-np.pi / 3), "-10 rpm"),
        (speed_of(1e4 * np.pi), "300000 rpm"),
        (angle_of(np.pi / 6), "30 deg (0.5236 rad)"),
        (angle_of(-3.77e-18), "0 deg (0 rad)"),  # rounding of an equilibrium
        (percent_of(0.553), "55.3 %"),
        (percent_of(0.0257, 2), "2.6 %"),
        (percent_of(47.5), "4750 %"),  # no power of ten
    ],
)
def test_a_number_has_the_unit_of_engineers(written: str, words: str) -> None:
    assert written == words
