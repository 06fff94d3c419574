"""The table of hard cases, where such programs go wrong: each with its problem, and its right answer and why.

An expected number is exact, a limit, or 40-digit arithmetic on the inputs written in the case, never our own output.
Where no number is right, the right answer is an error that says so; any other answer, also infinity, is wrong.
cases.csv has problems and answers; a tolerance is relative, absolute for an expected 0.
"""

from fractions import Fraction
from pathlib import Path

from validation.hard.cage import CAGE_CASES
from validation.hard.case import ROUND_OFF, HardCase
from validation.hard.contacts import CONTACT_CASES
from validation.hard.free_balls import FREE_BALL_CASES
from validation.hard.friction import FRICTION_CASES
from validation.hard.lubrication import LUBRICATION_CASES
from validation.hard.meshes import MESH_CASES
from validation.hard.numerical_film import NUMERICAL_FILM_CASES
from validation.hard.numerical_friction import NUMERICAL_FRICTION_CASES
from validation.hard.roughness import ROUGHNESS_CASES
from validation.study import Row, read

EVALUATIONS = (
    CONTACT_CASES
    | MESH_CASES
    | FRICTION_CASES
    | FREE_BALL_CASES
    | NUMERICAL_FRICTION_CASES
    | LUBRICATION_CASES
    | NUMERICAL_FILM_CASES
    | ROUGHNESS_CASES
    | CAGE_CASES
)


def _case(row: Row) -> HardCase:
    return HardCase(
        name=row["name"],
        problem=row["problem"],
        answer=row["answer"],
        evaluate=EVALUATIONS[row["name"]],
        expected=float(Fraction(row["expected"])) if row["expected"] else None,
        tolerance=(float(row["tolerance"]), row["why"]) if row["tolerance"] else ROUND_OFF,
        refusal=row["refusal"] or None,
    )


HARD_CASES = tuple(map(_case, read(Path(__file__).with_name("cases.csv"))))
