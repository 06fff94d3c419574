"""A loaded contact: its derived quantities, the radius of its surface, and what it refuses."""

import numpy as np
import pytest

from analytic.contact.hertz import hertz_contact
from analytic.contact.rolling_contact import deformed_radius, elliptic_contact
from analytic.errors import InputError
from tests.analytic.specimens import rolling_contact

HERTZ = {"curvature_rolling": 310.0, "curvature_transverse": 14.7, "load": 613.0, "modulus": 1.13e11}


def test_the_contact_surface_lies_halfway_between_ball_and_groove() -> None:
    found = deformed_radius(groove_radius=[4.13e-3, 4.21e-3], ball_diameter=7.94e-3)
    halfway = [(1 / 3.97e-3 + 1 / groove) / 2 for groove in (4.13e-3, 4.21e-3)]
    np.testing.assert_allclose(found, 1 / np.array(halfway), rtol=1e-14)  # round-off


def test_the_elliptic_contact_is_that_of_hertz() -> None:
    found = elliptic_contact(**HERTZ)
    hertz = hertz_contact(curvature_x=310.0, curvature_y=14.7, load=613.0, modulus=1.13e11)
    assert (found.semi_axis_rolling, found.semi_axis_transverse) == (hertz.semi_axis_x, hertz.semi_axis_y)
    assert found.semi_axis_rolling < found.semi_axis_transverse
    np.testing.assert_allclose(found.area, np.pi * hertz.semi_axis_x * hertz.semi_axis_y, rtol=1e-14)  # round-off
    np.testing.assert_allclose(found.mean_pressure, 2 / 3 * hertz.peak_pressure, rtol=1e-14)


def test_a_contact_without_load_is_a_point_without_pressure() -> None:
    found = elliptic_contact(**HERTZ | {"load": np.array([0.0, 613.0])})
    assert found.area[0] == found.mean_pressure[0] == 0
    assert found.mean_pressure[1] > 1e8


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"load": float("nan")}, "load must be at least 0"),
        ({"semi_axis_rolling": -1e-5}, "semi_axis_rolling must be at least 0"),
        ({"curvature_transverse": 0.0}, "curvature_transverse must be positive"),
        ({"modulus": np.inf}, "modulus must be positive and finite"),
        ({"deformed_radius": 0.0}, "deformed_radius must be positive"),
        ({"rolling_rate": -2.0}, "rolling_rate must be at least 0"),
        ({"load": np.ones(3), "rolling_rate": np.ones(2)}, r"shapes \(3,\).*give equal lengths"),
    ],
)
def test_a_bad_contact_is_refused(change: dict[str, object], words: str) -> None:
    with pytest.raises(InputError, match=words):
        rolling_contact(**change)


@pytest.mark.parametrize("name", HERTZ)
def test_a_bad_argument_is_named(name: str) -> None:
    with pytest.raises(InputError, match=f"{name} must be"):
        elliptic_contact(**HERTZ | {name: -1.0})
