"""The comparison error E against u_val."""

import pytest

from fembearing.check.contact.comparison_error import compared, comparison_of
from fembearing.grid_convergence import Estimate
from fembearing.plain_types import plain


@pytest.mark.parametrize(("error", "resolved"), [(-6.9, False), (7.0, False), (-7.1, True), (12.5, True)])
def test_an_error_is_resolved_beyond_the_root_of_the_sum_of_squares(error: float, resolved: bool) -> None:
    comparison = compared(error, numerical=2.0, given=3.0, reference=6.0)  # 4 + 9 + 36 = 49
    assert comparison.total == 7.0
    document = plain(comparison)
    assert [document[name] for name in ("error", "numerical", "input", "reference")] == [error, 2.0, 3.0, 6.0]
    assert (document["total"], document["resolved"]) == (7.0, resolved)


def test_the_uncertainty_of_the_datum_is_that_of_meshes_and_far_boundary() -> None:
    part = Estimate(values=(7e-6, 6.5e-6), order=None, richardson=6.4e-6, mesh=0.008, beyond=0.25, domain=0.015)
    comparison = comparison_of(7.5e-6, part)  # the value is 6.4 um and a quarter more
    assert comparison.error == pytest.approx(-0.5e-6, rel=1e-9)  # a difference of near values
    assert comparison.total == comparison.reference == pytest.approx(0.017 * 8e-6, rel=1e-12)  # round-off
    assert (comparison.numerical, comparison.input) == (0.0, 0.0)
