"""Approach over load: the power law of Hertz, and the correction inside and outside its range."""

from dataclasses import replace

import numpy as np

from analytic.scene import Contact
from fembearing.check.contact.hertz import approach_over_load, corrected_hertz, hertz_quantities
from fembearing.plain_types import plain
from tests.analytic.specimens import present


def test_the_curve_of_hertz_agrees_with_hertz_at_every_load(contacts: dict[str, Contact]) -> None:
    contact = contacts["inner"]
    curve = approach_over_load(contact, hertz=hertz_quantities(contact), correctable=False)
    solved = [hertz_quantities(replace(contact, load=float(load))).approach for load in curve.load]
    np.testing.assert_allclose(curve.hertz, solved, rtol=1e-12)
    np.testing.assert_allclose(curve.load[:: len(curve.load) - 1], (0.05 * 372, 1.5 * 372), rtol=1e-12)
    assert plain(curve)["corrected"] == [None] * len(curve.load)


def test_the_curve_of_the_correction_agrees_with_single_contacts(contacts: dict[str, Contact]) -> None:
    contact = contacts["outer"]
    curve = approach_over_load(contact, hertz=hertz_quantities(contact), correctable=True)
    for point in (3, 20):
        single = replace(contact, load=float(curve.load[point]))
        single_corrected, _ = corrected_hertz(single, hertz=hertz_quantities(single))
        assert single_corrected is not None
        np.testing.assert_allclose(present(curve.corrected[point]), single_corrected.quantities.approach, rtol=1e-12)
        np.testing.assert_allclose(
            present(curve.uncertainty[point]), single_corrected.uncertainty["approach"], rtol=1e-12
        )
    factor = np.array(curve.corrected) / np.array(curve.hertz) - 1
    assert np.all(np.diff(factor) < 0)  # the larger the contact, the stiffer it is compared with Hertz
    assert np.all(factor < 0)


def test_the_curve_of_the_correction_ends_with_the_range_of_the_fit(contacts: dict[str, Contact]) -> None:
    # A semi-axis of 1.9 mm leaves less than 15 % of it
    narrow = replace(contacts["inner"], shoulder=1.7e-3, load=3000.0)
    curve = approach_over_load(narrow, hertz=hertz_quantities(narrow), correctable=True)
    semi_axis = hertz_quantities(narrow).semi_axis_transverse * (np.array(curve.load) / 3000) ** (1 / 3)
    is_known = [value is not None for value in curve.corrected]
    np.testing.assert_array_equal(is_known, 1.15 * semi_axis <= 1.7e-3)
    assert 0 < sum(is_known) < len(curve.load)
