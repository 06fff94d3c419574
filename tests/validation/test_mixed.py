"""The share of the load on asperities: the laws of the study, and the interval that has to reach measured ones."""

import numpy as np
import pytest

from validation.mixed import run as mixed

LAWS = {law.short: law for law in mixed.laws()}


@pytest.mark.parametrize(
    ("law", "shares"),
    [("Clarke", (0.066, 0.18)), ("Z&H", (0.072, 0.13)), ("T&S", (0.29, 0.42)), ("T&S Gauss", (0.36, 0.50))],
)
def test_the_laws_have_their_known_shares(law: str, shares: tuple[float, float]) -> None:
    """At lambda 1.3 and 0.95, to two digits, the second one of which is 4 % of the smallest."""
    np.testing.assert_allclose(LAWS[law].share(np.array([1.3, 0.95])), shares, rtol=0.04)


def test_a_law_has_no_share_outside_its_range() -> None:
    assert np.isnan(LAWS["C&S"].share(np.array([2.2, 0.7]))).tolist() == [True, False]


@pytest.mark.parametrize("finish", mixed.FINISHES)
@pytest.mark.parametrize(
    ("law", "first", "last"),  # of lambda, where the interval contains the law
    [("Clarke", 0.1, 3.0), ("T&S", 0.4, 1.7), ("Z&H", 0.3, 3.0), ("BGT", 0.2, 3.0), ("O&S", 0.2, 2.3)],
)
def test_the_interval_contains_the_measured_laws(finish: str, law: str, first: float, last: float) -> None:
    contact, film_ratio = mixed.rough_contact(finish), np.linspace(first, last, 40)
    share = LAWS[law].share(film_ratio)
    assert np.all(contact.share(film_ratio, -mixed.END) < share)
    assert np.all(share < contact.share(film_ratio, mixed.END))


@pytest.mark.parametrize("finish", mixed.FINISHES)
def test_the_upper_end_all_but_reaches_the_law_of_gaussian_heights(finish: str) -> None:
    """The end is at 0.98 of the way: 0.02 of a ratio of 100 at most is missing, exp(-0.02 ln 100) = 0.91."""
    contact, film_ratio = mixed.rough_contact(finish), np.linspace(0.5, 2.3, 40)
    reached = contact.share(film_ratio, mixed.END) / LAWS["T&S Gauss"].share(film_ratio)
    assert np.all((reached > 0.9) & (reached < 1))
