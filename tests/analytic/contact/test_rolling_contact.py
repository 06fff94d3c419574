"""A loaded contact: Hertz's semi-axes, and the radius of its surface."""

import numpy as np

from analytic.contact.hertz import hertz_contact
from analytic.contact.rolling_contact import deformed_radius, elliptic_contact

HERTZ = {"curvature_rolling": 310.0, "curvature_transverse": 14.7, "load": 613.0, "modulus": 1.13e11}


def test_the_contact_surface_lies_halfway_between_ball_and_groove() -> None:
    found = deformed_radius(groove_radius=[4.13e-3, 4.21e-3], ball_diameter=7.94e-3)
    halfway = [(1 / 3.97e-3 + 1 / groove) / 2 for groove in (4.13e-3, 4.21e-3)]
    np.testing.assert_allclose(found, 1 / np.array(halfway), rtol=1e-14)  # round-off


def test_the_elliptic_contact_is_that_of_hertz_and_a_point_without_load() -> None:
    found = elliptic_contact(**HERTZ | {"load": np.array([0.0, 613.0])})
    hertz = hertz_contact(curvature_x=310.0, curvature_y=14.7, load=613.0, modulus=1.13e11)
    np.testing.assert_array_equal(found.semi_axis_rolling, [0.0, hertz.semi_axis_x])
    np.testing.assert_array_equal(found.semi_axis_transverse, [0.0, hertz.semi_axis_y])
