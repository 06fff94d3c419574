"""Numbers that a formula refuses: one by one, a few, or the ends of many; and what the refusals say."""

import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from analytic import errors
from analytic.errors import (
    MissingPackageError,
    real_numbers,
    require_finite,
    require_non_negative,
    require_packages,
    require_positive,
)
from tests.refusals import refused

Requirement = Callable[..., None]
LIMITS: dict[Requirement, tuple[str, tuple[float, ...]]] = {  # the words of a limit, and what it refuses
    require_finite: ("finite", (np.nan, np.inf, -np.inf)),
    require_positive: ("positive and finite", (0.0, -0.3, np.nan, np.inf, -np.inf)),
    require_non_negative: ("at least 0 and finite", (-0.3, np.nan, np.inf, -np.inf)),
}
TAKEN: dict[Requirement, tuple[float, ...]] = {
    require_finite: (-3.7, 0.0, 2.3),
    require_positive: (5e-324, 2.3),
    require_non_negative: (0.0, 2.3),
}
EVERY = [*LIMITS]


@pytest.mark.parametrize("require", EVERY)
def test_numbers_within_the_limit_are_taken_in_any_form(require: Requirement) -> None:
    for value in TAKEN[require]:
        for form in (value, np.float64(value), np.array(value), [value], np.full(3, value), np.full((2, 5), value)):
            require(load=form)
    require(load=7, speed=np.array([3, 4, 5, 6, 7]), other=True)


@pytest.mark.parametrize("require", EVERY)
def test_a_number_beyond_the_limit_is_refused_by_its_name_and_place(require: Requirement) -> None:
    """Few numbers are compared one by one, of many the ends."""
    words, wrong = LIMITS[require]
    for value in wrong:
        refused(lambda: require(load=value), f"load must be {words}, got {value!r};")  # noqa: B023 - called at once
        for count in (1, 4, 5, 9):
            for place in {0, count // 2, count - 1}:
                many = np.full(count, 2.3)
                many[place] = value
                refused(lambda: require(other=1.7, load=many), f"got {value!r} at index [{place}];")  # noqa: B023


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ("5", "must be a number or an array of numbers in SI units, got '5'"),
        (3 + 4j, "must be a real number"),
        (10**400, "must be a number"),
        ([[1.0], [2.0, 3.0]], "must be a number"),
        ([3 + 4j, 2.0], "must be a real number"),
    ],
)
def test_what_is_no_real_number_is_refused(wrong: Any, words: str) -> None:
    refused(lambda: real_numbers("operation.axial_load", wrong), "operation.axial_load", words)


def test_a_number_with_a_unit_is_refused_with_the_one_that_is_read() -> None:
    class Quantity:
        magnitude, units = 3.0, "kN"

        def __str__(self) -> str:
            return "3.0 kN"

    given: Any = Quantity()
    refused(lambda: real_numbers("operation.axial_load", given), "= 3.0 kN has a unit", "give its number in SI")
    refused(lambda: real_numbers("anything", given), "give its number in SI")


def test_a_missing_package_is_named_with_what_brings_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(errors, "find_spec", lambda module: None if module in ("xarray", "skfem") else object())
    require_packages("a figure", "matplotlib", "jinja2")
    for purpose, modules, package, extra in (
        ("a dataset", ("matplotlib", "xarray"), "xarray", "sweep"),
        ("a mesh", ("skfem",), "scikit-fem", "check"),
    ):
        words = f'{purpose} needs {package}: pip install ".[{extra}]" in the folder of fembearing'
        with pytest.raises(MissingPackageError, match=f"^{re.escape(words)}$"):
            require_packages(purpose, *modules)
