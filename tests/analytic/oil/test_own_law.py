"""A user's law of traction: its table against the function, its inverse against a search, and what is refused."""

import math
import pickle
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import brentq

from analytic.oil.law_table import flow_of, kept_table, law_address, rate_of
from analytic.oil.own_law import ACCURACY, own_traction
from analytic.oil.traction import oil_shear_stress
from analytic.oil.viscosity import oil_numbers
from tests.analytic.specimens import OIL
from tests.refusals import refused

Law = Callable[[float], float]
LAWS: dict[str, Law] = {
    "eyring": math.asinh,
    "carreau": lambda x: x * (1 + x * x) ** ((0.46 - 1) / 2),
    "exponential": lambda x: -math.expm1(-x),  # of Bair and Winer: it tends to a limit of its own
    "newton": lambda x: x,
    "kinked": lambda x: min(x, 7.3),
    "thickening": lambda x: x * (1 + x * x) ** 0.2,
}
each_law = pytest.mark.parametrize("name", LAWS)


@each_law
def test_the_table_follows_the_function_and_its_slope(name: str) -> None:
    law, function = law_address(own_traction(name, LAWS[name])), LAWS[name]
    rates = 10 ** np.random.default_rng(3).uniform(-9, 29, 500)
    found, slopes = flow_of(law, rates)
    expected = np.array([function(rate) for rate in rates])
    # Below the table the law is proportional: the exponential one has bent by 5e-7 at its first rate.
    np.testing.assert_allclose(found, expected, rtol=ACCURACY)
    step = 1e-4
    above, below = (flow_of(law, rates * factor)[0] for factor in (1 + step, 1 - step))
    # Of a difference whose ends lie in two pieces: the curvature jumps between them.
    assert np.all(np.abs(slopes * rates - (above - below) / (2 * step)) <= 1e-3 * expected)


@each_law
def test_the_rate_of_a_stress_is_that_of_a_search(name: str) -> None:
    law, random = law_address(own_traction(name, LAWS[name])), np.random.default_rng(4)
    for _ in range(200):
        softness, asked = 10 ** random.uniform(-9, 9), 10 ** random.uniform(-9, 15)

        def left(log_rate: float, softness: float = softness, asked: float = asked) -> float:
            rate = math.exp(log_rate)
            return math.log((rate + softness * flow_of(law, rate)[0]) / asked)

        low = min(0.0, math.log(asked)) - 50
        rate = math.exp(brentq(left, low, math.log(asked) + 1e-9, xtol=1e-14, rtol=1e-14))
        assert rate_of(law, 1.0, softness, asked) == pytest.approx(rate, rel=1e-10)  # of the search, in its logarithm
    assert rate_of(law, 1.0, 0.3, 0.0) == 0.0
    assert rate_of(law, 0.0, 3.1, 3.1 * flow_of(law, 2.7)[0]) == pytest.approx(2.7, rel=1e-9)


def test_a_stress_that_the_law_never_reaches_has_no_rate() -> None:
    law = law_address(own_traction("exponential", LAWS["exponential"]))
    assert rate_of(law, 0.0, 2.0, 2.1) == np.inf
    assert rate_of(law, 1.0, 2.0, 2.1) == pytest.approx(brentq(lambda x: x - 2 * math.expm1(-x) - 2.1, 0, 2), rel=1e-5)


def test_eyrings_law_as_a_users_law_is_the_built_in_one() -> None:
    own = replace(OIL, traction=own_traction("eyring", math.asinh))
    pressure, speed = np.array([[2e7], [0.3e9], [1.1e9]]), np.array([0.0, 1e-9, 3e-6, 0.02, 1.7])
    given = {"pressure": pressure, "speed": speed, "film_thickness": 0.21e-6}
    np.testing.assert_allclose(
        oil_shear_stress(oil_numbers(own), **given), oil_shear_stress(oil_numbers(OIL), **given), rtol=ACCURACY
    )
    dry = {"pressure": 1.3e9, "speed": [0.0, 0.2], "film_thickness": [0.0, -3e-7]}
    np.testing.assert_array_equal(oil_shear_stress(oil_numbers(own), **dry), oil_shear_stress(oil_numbers(OIL), **dry))


def test_oil_without_a_film_shears_at_the_most_that_its_law_gives() -> None:
    oil = replace(OIL, traction=own_traction("exponential", LAWS["exponential"]))
    found = oil_shear_stress(oil_numbers(oil), pressure=[1.3e9, 2e7], speed=0.2, film_thickness=0.0)
    np.testing.assert_allclose(found, [4.7e6, 0.06 * 2e7], rtol=ACCURACY)


MISTAKES: dict[str, tuple[Law, tuple[str, ...]]] = {
    "falls": (lambda x: x / (1 + x * x), ("falls from", "never falls")),
    "nan": (lambda x: x if x < 1e3 else math.nan, ("= nan", "finite")),
    "infinite": (lambda x: x if x < 1e3 else math.inf, ("= inf", "finite")),
    "fails": (lambda x: math.sinh(x), ("OverflowError", "from 0 to 1e+30")),
    "words": (lambda x: f"{x} Pa", ("ValueError", "function of one float")),  # pyright: ignore[reportAssignmentType]
    "at rest": (lambda x: x + 0.5, ("f(0) = 0.5", "f(0) = 0")),
    "steep": (lambda x: 1.7 * x, ("f(x)/x = 1.7", "slope 1")),
    "power": (lambda x: x**0.5, ("f(x)/x = 1000", "slope 1")),
    "negative": (lambda x: x if x < 1 else -x, ("= -", "positive")),
    "jumps": (lambda x: x if x < 21 else x + 5, ("without jumps", "near x = 21")),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_a_function_that_is_no_law_is_refused_in_one_line(name: str) -> None:
    function, words = MISTAKES[name]
    refused(lambda: own_traction(name, function), f"law of traction {name}: ", *words)


def test_laws_are_equal_where_their_numbers_are() -> None:
    first, same = own_traction("a", LAWS["carreau"]), own_traction("a", lambda x: LAWS["carreau"](x))
    other = own_traction("a", lambda x: x * (1 + x * x) ** ((0.4601 - 1) / 2))
    assert first == same
    assert hash(first) == hash(same)
    assert first != other
    assert kept_table(first) is kept_table(same)
    assert oil_numbers(replace(OIL, traction=first)).own == oil_numbers(replace(OIL, traction=same)).own
    assert oil_numbers(replace(OIL, traction=first)).own != oil_numbers(replace(OIL, traction=other)).own
    assert oil_numbers(OIL).own == 0.0
    sent = pickle.loads(pickle.dumps(replace(OIL, traction=first)))
    assert sent.traction == first
    np.testing.assert_array_equal(sent.traction.table, first.table)
    assert repr(first) == f"OwnTraction(name=a, sha256={first.sha256})"
