"""The table of hard cases: every case, every literal by 40 digits, and wrong answers judged as wrong."""

import json
import math

import mpmath
import pytest
from mpmath import mpf

from analytic.errors import InputError
from analytic.torque import MODEL_VERSION
from fembearing.check.hard_record import RECORD, last_run
from tests.validation.hard.cage_exact import CAGE
from tests.validation.hard.contact_exact import CONTACT
from tests.validation.hard.lubrication_exact import LUBRICATION
from tests.validation.hard.torque_exact import TORQUE
from validation.hard.run import EVALUATIONS, HARD_CASES, HardCase, outcome_of

TABLE = {case.name: case for case in HARD_CASES}
EXACT = CONTACT | LUBRICATION | CAGE | TORQUE
NUMBERS = {case.name: case.expected for case in HARD_CASES if case.expected not in (None, -1, 0, 1)}


SLOW = {  # fine meshes of the true groove and fine grids
    f"contact: {name}"
    for name in (
        "true groove at 1e-6 N",
        "incompressible race",
        "closest groove",
        "steel on ceramic",
        "steel on bronze",
    )
} | {
    "contact: steel on PEEK",
    "numerical film: 1e-6 N",
    "numerical film: reversed",
    "numerical film: clearance 1e-12 m",
    "numerical friction: conformity 0.5005",
    "numerical friction: 1e-4 N on a free ring",
}


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[pytest.mark.slow] if name in SLOW else []) for name in TABLE]
)
def test_every_case_is_right(name: str) -> None:
    found = outcome_of(TABLE[name])
    assert found.outcome == ("refused" if TABLE[name].refusal else "right"), found.detail


INTEGRATED = "mixed: 1e-9 m/s", "mixed: very rough"  # roots of integrals: five seconds each


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[pytest.mark.nightly] if name in INTEGRATED else []) for name in NUMBERS]
)
def test_every_literal_is_exact(name: str) -> None:
    with mpmath.workdps(40):
        off = float(abs(mpf(NUMBERS[name]) / EXACT[name]() - 1))
    near = 1e-11 if name == "Hertz: nearly a circle" else 3e-16  # a first-order limit; a double's own rounding
    assert off < near, off


def test_the_table_is_sound() -> None:
    assert len(TABLE) == len(HARD_CASES) >= 60
    refused = [case for case in HARD_CASES if case.refusal]
    assert 0 < 3 * len(refused) <= len(HARD_CASES)  # a table of refusals would show nothing
    assert EVALUATIONS.keys() == TABLE.keys()
    assert NUMBERS.keys() == EXACT.keys()
    assert len(EXACT) == len(CONTACT) + len(LUBRICATION) + len(CAGE) + len(TORQUE)


def number(evaluate: object, expected: float = 2.5) -> HardCase:
    tolerance = (1e-3, "a test's")
    return HardCase(name="n", problem="p", answer="a", evaluate=evaluate, expected=expected, tolerance=tolerance)  # pyright: ignore[reportArgumentType]


def refusal(evaluate: object) -> HardCase:
    return HardCase(name="n", problem="p", answer="a", evaluate=evaluate, refusal="too steep")  # pyright: ignore[reportArgumentType]


def refuse(words: str) -> float:
    raise InputError(f"it is {words}: mind the step")


@pytest.mark.parametrize(
    ("case", "outcome", "words"),
    [
        (number(lambda: 2.5 * (1 + 0.9e-3)), "right", "off by 9.0e-04"),
        (number(lambda: 2.5 * (1 - 1.1e-3)), "wrong", "off by -1.1e-03"),
        (number(lambda: math.nan), "wrong", "nan"),
        (number(lambda: math.inf, expected=math.inf), "wrong", "inf"),
        (number(lambda: -1.1e-3, expected=0.0), "wrong", "off by -1.1e-03"),
        (number(lambda: refuse("too steep")), "wrong", "refused: it is too steep"),
        (number(lambda: 1 / 0), "wrong", "ZeroDivisionError"),
        (refusal(lambda: refuse("too steep")), "refused", "too steep"),
        (refusal(lambda: refuse("too flat")), "wrong", "too flat"),
        (refusal(lambda: 2.5), "wrong", "2.5 instead of a refusal"),
    ],
)
def test_a_wrong_answer_is_judged_as_wrong(case: HardCase, outcome: str, words: str) -> None:
    found = outcome_of(case)
    assert found.outcome == outcome
    assert words in found.detail


def test_the_record_is_of_this_table() -> None:
    """Whoever adds a case runs the table again, with --write."""
    content = json.loads(RECORD.read_text("utf-8"))
    assert [each["case"] for each in content["outcomes"]] == [case.name for case in HARD_CASES]
    found = last_run()
    assert (found.wrong, found.refused) == (0, sum(case.refusal is not None for case in HARD_CASES))
    assert found.right + found.refused == len(HARD_CASES)
    assert found.model_version in (MODEL_VERSION - 1, MODEL_VERSION)  # each case runs with the tests of this version
