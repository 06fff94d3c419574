"""The table of hard cases: every row, every literal of it by 40 digits, and that a wrong answer is called wrong."""

import json
import math

import mpmath
import pytest
from mpmath import mpf

from analytic.errors import ConvergenceError, InputError
from fembearing.compare.hard import contacts as hard_contacts
from fembearing.compare.hard import meshes as hard_meshes
from fembearing.compare.hard import table as hard_cases
from fembearing.compare.hard.cage import CAGE_CASES
from fembearing.compare.hard.contacts import CONTACT_CASES
from fembearing.compare.hard.friction import FRICTION_CASES
from fembearing.compare.hard.lubrication import LUBRICATION_CASES
from fembearing.compare.hard.meshes import MESH_CASES
from fembearing.compare.hard.roughness import ROUGHNESS_CASES
from fembearing.compare.hard.table import HARD_CASES, HardCase, outcome_of, run_hard_cases
from tests.compare.hard.many_digits import exact, off_by

TABLE = {case.name: case for case in HARD_CASES}
NUMBERS = {case.name: case for case in CONTACT_CASES + MESH_CASES + FRICTION_CASES if case.expected is not None}
STEEL, PEEK, INCOMPRESSIBLE = ("206e9", "0.3"), ("3.6e9", "0.38"), ("206e9", "0.4999")  # Pa and Poisson ratio


def plain(quantity: str, curvature_x: str = "310", curvature_y: str = "9.7", load: str = "613") -> mpf:
    return exact(mpf(curvature_x), mpf(curvature_y), mpf(load), mpf("1.13e11"))[quantity]


def on_race(
    quantity: str,
    *,
    load: str = "620",
    ball: tuple[str, str] = STEEL,
    race: tuple[str, str] = STEEL,
    groove: str = "4.13e-3",
) -> mpf:
    """The ball on the inner race of the 6205 at 0.18 rad, from the dimensions of its table typed in again."""
    radius, pitch, cosine = mpf("3.97e-3"), mpf("15.53e-3") + mpf("23.48e-3"), mpmath.cos(mpf("0.18"))
    along = 1 / radius + cosine / (pitch / 2 - radius * cosine)
    softness = sum((1 - mpf(ratio) ** 2) / mpf(modulus) for modulus, ratio in (ball, race))
    return exact(along, 1 / radius - 1 / mpf(groove), mpf(load), 1 / softness)[quantity]


def still_line() -> mpf:
    """g of the pure-rolling lines without spin, the root of g^3 - 3 g + 1 between 0 and 1."""
    return mpmath.findroot(lambda g: g**3 - 3 * g + 1, mpf("0.35"))


def rolling_without_spin() -> mpf:
    """The moment of |v(y)| mu q(y) about the rolling axis, its slip as y^2 - g^2: by quadrature."""
    g = still_line()

    def weighted(y: mpf) -> mpf:
        return mpf(3) / 4 * (1 - y**2) * mpmath.sign(y**2 - g**2) * y**2 / 2

    return 2 * (mpmath.quad(weighted, [0, g]) + mpmath.quad(weighted, [g, 1]))


def spinning_in_full(rate: str) -> mpf:
    """3/8 mu Q b times the rate, N m."""
    return mpf(3) / 8 * mpf("0.07") * 530 * mpf("0.9e-3") * mpf(rate)


def shared_spin() -> mpf:
    """Torque of two alike contacts that take half of the spin each, times its rate."""
    eps = mpf("0.69") / 2 * mpf("3.7e-3") / (mpf("2.9") * mpf("0.9e-3"))
    d = mpmath.findroot(lambda d: d**3 - 3 * (1 - eps**2) * d + 1, mpf("0.49"))
    return 8 * eps * d * (1 - eps**2 - d**2) * spinning_in_full("0.69")


def mises_on_the_surface() -> mpf:
    """Of -p0 b/(a + b), -p0 a/(a + b) and -p0, in the middle of the ellipse of a body of Poisson ratio 0."""
    a, b = mpf("0.12"), mpf("1.1")
    along, across = b / (a + b), a / (a + b)
    return mpf("2.1e9") * mpmath.sqrt(((along - across) ** 2 + (across - 1) ** 2 + (1 - along) ** 2) / 2)


CERAMIC, BRONZE = ("310e9", "0.27"), ("110e9", "0.34")

REFERENCES = {
    "Hertz: circle": lambda: plain("approach", curvature_y="310"),
    "Hertz: nearly a circle": lambda: plain("log_k", "310", str(310 * (1 - mpf("1e-12")))) * mpf("1e12"),
    "Hertz: ratio 1e6": lambda: plain("minor", "9.7e6"),
    "Hertz: ratio 1e-6": lambda: plain("minor", "9.7", "9.7e6"),
    "Hertz: 1e-12 N": lambda: plain("approach", load="1e-12"),
    "Hertz: no load": lambda: plain("stiffness"),
    "Hertz: plastic overload": lambda: plain("pressure", load="1e7") / plain("pressure", load="10"),
    "Hertz: incompressible": lambda: mpf("206e9") / (2 * (1 - mpf("0.4999") ** 2)),
    "Hertz: steel on PEEK": lambda: on_race("approach", race=PEEK),
    "stress: Poisson ratio 0": mises_on_the_surface,
    "stress: depth at Poisson ratio 0": lambda: mpf(1),
    "contact angle: vanishing load": lambda: mpf("0.18"),
    "contact angle: from zero": lambda: mpf(1) / 4,
    "contact angle: preload": lambda: mpf("14e-6") / 2,
    "contact angle: huge load": lambda: mpf(1),
    "contact: 1e-6 N": lambda: on_race("approach", load="1e-6"),
    "contact: load to the two thirds": lambda: mpf(2) / 3,
    "contact: incompressible": lambda: on_race("pressure", ball=INCOMPRESSIBLE, race=INCOMPRESSIBLE),
    "contact: close groove": lambda: on_race("major", groove=str(mpf("0.505") * mpf("7.94e-3"))),
    "contact: mesh ten times too small": lambda: on_race("minor"),
    "contact: mesh ten times too large": lambda: on_race("approach"),
    "contact: grazing its shoulder": lambda: on_race("approach"),
    "contact: a single node": lambda: on_race("pressure"),
    "contact: mesh ten times too wide along rolling": lambda: on_race("approach"),
    "contact: mesh ten times too short across": lambda: on_race("major"),
    "contact: one node thought to touch": lambda: on_race("approach"),
    "contact: static limit": lambda: mpf("4.2e9"),
    "contact: true groove at 1e-6 N": lambda: on_race("approach", load="1e-6"),
    "contact: loads in any order": lambda: mpf(1),
    "contact: closest groove": lambda: on_race("approach", groove=str(mpf("0.5025") * mpf("7.94e-3"))),
    "contact: open groove": lambda: on_race("pressure", groove=str(mpf("0.6") * mpf("7.94e-3"))),
    "contact: steel on ceramic": lambda: on_race("approach", race=CERAMIC),
    "contact: steel on bronze": lambda: on_race("minor", race=BRONZE),
    "contact: steel on PEEK": lambda: on_race("approach", race=PEEK),
    "contact: bodies exchanged": lambda: mpf(1),
    "contact: incompressible race": lambda: on_race("pressure", load="1e-3", race=INCOMPRESSIBLE),
    "contact: other units": lambda: mpf(1000),
    "micro-slip: no spin": rolling_without_spin,
    "micro-slip: all but no spin": lambda: 3 * still_line() * (1 - still_line() ** 2),
    "micro-slip: spin in full": lambda: 2 * mpmath.quad(lambda y: mpf(3) / 4 * (1 - y**2) * y, [0, 1]),
    "micro-slip: far beyond full spin": lambda: mpf(3) / 8,
    "micro-slip: the end of rolling": lambda: mpf(3) / 4,
    "micro-slip: the other sense": lambda: mpf(-1),
    "micro-slip: across full spin": lambda: mpf(1),
    "micro-slip: across full spin in the other sense": lambda: mpf(1),
    "spin balance: races all but alike": shared_spin,
    "spin balance: both races in full spin": lambda: spinning_in_full("0.83"),
    "load: radial, at no angle": lambda: 9 / sum(max(mpmath.cospi(mpf(2 * i) / 9), 0) ** mpf("2.5") for i in range(9)),
    "load: radial, on very many balls": lambda: (
        2 * mpmath.pi / mpmath.quad(lambda psi: mpmath.cos(psi) ** mpf("2.5"), [-mpmath.pi / 2, 0, mpmath.pi / 2])
    ),
    "torque: radial load at no angle": lambda: mpf(1),
    "torque: spin at vanishing load": lambda: mpf(4) / 3,
    "torque: conformity at vanishing load": lambda: mpf(5) / 3,
    "torque: hysteresis at vanishing load": lambda: mpf(4) / 3,
    "torque: spin from an angle of zero": lambda: mpf(5) / 4,
    "torque: conformity from an angle of zero": lambda: mpf(5) / 4,
    "torque: hysteresis from an angle of zero": lambda: mpf(1),
    "torque: preload without thrust": lambda: mpf(1),
    "torque: the other way round": lambda: mpf(1),
    "torque: at standstill": lambda: mpf(1),
    "torque: no friction": lambda: mpf(1),
}


SLOW = {  # fine meshes of the true groove
    f"contact: {name}"
    for name in (
        "true groove at 1e-6 N",
        "incompressible race",
        "closest groove",
        "steel on ceramic",
        "steel on bronze",
    )
} | {"contact: steel on PEEK"}


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[pytest.mark.slow] if name in SLOW else []) for name in TABLE]
)
def test_every_case_is_right(name: str) -> None:
    found = outcome_of(TABLE[name])
    assert found.outcome == ("refused" if TABLE[name].refusal else "right"), found.detail


AS_USERS_GET_IT = (
    *("1e-6 N", "incompressible", "close groove", "far over its shoulder", "past the ball", "static limit"),
    *("true groove at 1e-6 N", "closest groove", "open groove", "steel on ceramic", "steel on bronze", "steel on PEEK"),
    *("PEEK out of its groove", "incompressible race", "Poisson ratio 0.5", "no modulus", "no load"),
)


@pytest.mark.parametrize("name", AS_USERS_GET_IT)
def test_a_contact_goes_the_way_that_users_take(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Through the reference, with its meshes and its accuracy; only what is about a mesh itself goes past it."""

    def turned_away(*_: object, **__: object) -> None:
        raise ConvergenceError(iterations=3, residual=0.5, tolerance=0.1, problem="the way through the reference")

    monkeypatch.setattr(hard_contacts, "solve_reference", turned_away)
    assert "the way through the reference" in outcome_of(TABLE[f"contact: {name}"]).detail


@pytest.mark.parametrize("name", NUMBERS)
def test_every_literal_is_that_of_many_digits(name: str) -> None:
    with mpmath.workdps(100):  # the circle's form loses half of them at a ratio of 1 + 1e-12
        off = off_by(NUMBERS[name], REFERENCES[name]())
    near = 1e-11 if name == "Hertz: nearly a circle" else 3e-16  # a first-order limit; a double's own rounding
    assert off < near, off


def test_the_table_is_sound() -> None:
    assert len(TABLE) == len(HARD_CASES)
    assert len(TABLE) >= 60
    refused = [case for case in HARD_CASES if case.refusal]
    assert 0 < 3 * len(refused) <= len(HARD_CASES)  # a table of refusals would show nothing
    # The references of these are in test_hard_lubrication and test_hard_cage.
    others = LUBRICATION_CASES + ROUGHNESS_CASES + CAGE_CASES
    assert CONTACT_CASES + MESH_CASES + FRICTION_CASES + others == HARD_CASES
    assert NUMBERS.keys() == REFERENCES.keys()


def test_a_sound_mesh_file_is_read() -> None:
    """What the row on a broken one breaks is its node alone."""
    assert hard_meshes.nodes_read(26) == 27


def number(evaluate: object, expected: float = 2.5) -> HardCase:
    tolerance = (1e-3, "a test's")
    return HardCase(name="n", asked="a", right="r", evaluate=evaluate, expected=expected, tolerance=tolerance)  # pyright: ignore[reportArgumentType]


def refusal(evaluate: object) -> HardCase:
    return HardCase(name="n", asked="a", right="r", evaluate=evaluate, refusal="too steep")  # pyright: ignore[reportArgumentType]


def refuse(words: str) -> float:
    raise InputError(f"it is {words}: mind the step")


def stop() -> float:
    raise ConvergenceError(iterations=3, residual=0.5, tolerance=0.1, problem="too steep")


@pytest.mark.parametrize(
    ("case", "outcome", "words"),
    [
        (number(lambda: 2.5 * (1 + 0.9e-3)), "right", "2.50225, expected 2.5: off by 9.0e-04, allowed 1.0e-03"),
        (number(lambda: 2.5 * (1 + 1.1e-3)), "wrong", "off by 1.1e-03"),
        (number(lambda: 2.5 * (1 - 1.1e-3)), "wrong", "off by -1.1e-03"),
        (number(lambda: -2.5), "wrong", "-2.5"),
        (number(lambda: math.nan), "wrong", "nan"),
        (number(lambda: math.inf), "wrong", "inf"),
        (number(lambda: math.inf, expected=math.inf), "wrong", "inf"),
        (number(lambda: refuse("too steep")), "wrong", "refused: it is too steep"),
        (number(lambda: 1 / 0), "wrong", "bug, ZeroDivisionError: division by zero"),
        (refusal(lambda: refuse("too steep")), "refused", "it is too steep: mind the step"),
        (refusal(stop), "refused", "too steep did not settle in 3 iterations"),
        (refusal(lambda: refuse("too flat")), "wrong", "it is too flat"),
        (refusal(lambda: 2.5), "wrong", "2.5 instead of a refusal"),
        (refusal(lambda: math.nan), "wrong", "nan instead of a refusal"),
        (refusal(lambda: 1 / 0), "wrong", "bug, ZeroDivisionError"),
    ],
)
def test_a_wrong_answer_is_called_wrong(case: HardCase, outcome: str, words: str) -> None:
    found = outcome_of(case)
    assert found.outcome == outcome
    assert words in found.detail


def test_the_table_is_what_runs_unless_told_otherwise(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(hard_cases, "HARD_CASES", (number(lambda: 7.0),))
    assert [each.outcome for each in run_hard_cases()] == ["wrong"]


def test_one_bug_does_not_stop_the_table() -> None:
    shares: list[float] = []
    cases = (number(lambda: 1 / 0), number(lambda: 2.5))
    found = run_hard_cases(cases=cases, progress=lambda share, _: shares.append(share))
    assert [each.outcome for each in found] == ["wrong", "right"]
    assert shares == [0, 0.5]
    told = json.loads(json.dumps([each.to_json() for each in found]))
    assert told[1].keys() == {"case", "outcome", "detail"}


@pytest.mark.parametrize(
    "answer",
    [
        {},
        {"expected": 2.5},
        {"expected": 2.5, "tolerance": (0.1, "why"), "refusal": "no"},
        {"tolerance": (0.1, "why"), "refusal": "no"},
        {"expected": 0.0, "tolerance": (0.1, "why")},
    ],
)
def test_a_case_has_one_right_answer(answer: dict) -> None:
    with pytest.raises(InputError, match="hard case 'n'"):
        HardCase(name="n", asked="a", right="r", evaluate=lambda: 1.5, **answer)


@pytest.mark.parametrize("name", ["mesh file: a node that does not exist", "surface: heights near the largest double"])
def test_a_refused_file_is_told_the_same_way_every_time(name: str) -> None:
    first, second = (outcome_of(TABLE[name]).detail for _ in range(2))
    assert first == second
