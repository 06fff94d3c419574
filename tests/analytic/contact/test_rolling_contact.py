"""A loaded contact: its derived quantities, the radius of its surface, and what it refuses."""

import numpy as np

from analytic.contact.hertz import hertz_contact
from analytic.contact.rolling_contact import deformed_radius, elliptic_contact
from tests.analytic.specimens import rolling_contact
from tests.refusals import refused, refuses

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


def test_a_bad_contact_is_refused() -> None:
    refuses(rolling_contact, load=float("nan"), semi_axis_rolling=-1e-5, curvature_transverse=0.0, modulus=np.inf)
    refuses(rolling_contact, deformed_radius=0.0, rolling_rate=-2.0)
    refused(lambda: rolling_contact(load=np.ones(3), rolling_rate=np.ones(2)), "(3,)", "equal lengths")


def test_a_bad_argument_is_named() -> None:
    refuses(lambda **wrong: elliptic_contact(**HERTZ | wrong), **dict.fromkeys(HERTZ, -1.0))
