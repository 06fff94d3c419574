"""The fitted formulas against the exact contact: their errors are those of the docstring."""

import numpy as np
import pytest

from analytic.contact.hertz import hertz_contact
from analytic.contact.hertz_fitted import fitted_error, hertz_contact_fitted

LOAD, MODULUS, SMALL = 613.0, 1.13e11, 9.7  # N, Pa, 1/m
RATIOS = np.geomspace(1, 100, 801)
# Least and largest relative error by the docstring; x is the minor axis here.
STATED = {
    "semi_axis_x": (-0.011, 0.012),
    "semi_axis_y": (-0.027, 0.021),
    "peak_pressure": (-0.011, 0.017),
    "approach": (-0.042, 0.027),
    "stiffness": (-0.040, 0.065),
}


def both(curvature_x: object, curvature_y: object, load: object = LOAD) -> tuple:
    arguments = {"curvature_x": curvature_x, "curvature_y": curvature_y, "load": load, "modulus": MODULUS}
    return hertz_contact_fitted(**arguments), hertz_contact(**arguments)  # pyright: ignore[reportArgumentType]


@pytest.mark.parametrize("field", STATED)
def test_the_stated_error_holds_and_is_reached(field: str) -> None:
    fitted, exact = both(SMALL * RATIOS, SMALL)
    errors = getattr(fitted, field) / getattr(exact, field) - 1
    least, largest = STATED[field]
    assert least <= errors.min() < 0.9 * least  # the docstring does not overstate it
    assert 0.9 * largest < errors.max() <= largest


def test_the_circle_is_exact() -> None:
    fitted, exact = both(SMALL, SMALL)
    for field in STATED:
        np.testing.assert_allclose(getattr(fitted, field), getattr(exact, field), rtol=1e-13)  # round-off


def test_pressure_carries_the_load_and_stiffness_fits_the_approach() -> None:
    """Load of a semi-ellipsoid, 2/3 pi a b p0; shapes broadcast, and either semi-axis may be the longer."""
    fitted, _ = both(np.array([[310.0], [3.1]]), SMALL, load=np.array([3.0, 41.0]))
    carried = 2 / 3 * np.pi * fitted.semi_axis_x * fitted.semi_axis_y * fitted.peak_pressure
    np.testing.assert_allclose(carried, [[3.0, 41.0]] * 2, rtol=1e-13)  # round-off
    np.testing.assert_allclose(fitted.stiffness * fitted.approach**1.5, [[3.0, 41.0]] * 2, rtol=1e-13)
    assert np.all((fitted.semi_axis_x < fitted.semi_axis_y) == [[True], [False]])


def test_the_bound_covers_the_error_and_is_at_most_half_larger() -> None:
    """At any ratio of the curvatures, in both orders and at any size; beyond the last knot it is infinite."""
    ratios = np.geomspace(1.05, 9e4, 4001)
    for curvatures in ((SMALL * ratios, SMALL), (0.3, 0.3 * ratios)):
        fitted, exact = both(*curvatures)
        names = ("semi_axis_x", "semi_axis_y", "peak_pressure", "approach")
        error = np.max([np.abs(getattr(fitted, name) / getattr(exact, name) - 1) for name in names], axis=0)
        bound = fitted_error(curvature_x=curvatures[0], curvature_y=curvatures[1])
        assert np.all(error < bound)
        assert np.all(bound < 1.5 * error)
    assert fitted_error(curvature_x=SMALL, curvature_y=SMALL) == 0
    assert fitted_error(curvature_x=2e5 * SMALL, curvature_y=SMALL) == np.inf
