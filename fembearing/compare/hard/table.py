"""The table of hard cases, where such programs go wrong: each with its problem, and its right answer and why.

An expected number is exact, a limit, or 40-digit arithmetic on the inputs written in the table, never our own output.
Where no number is right, the right answer is an error that says so; any other answer, also infinity, is wrong.
"""

from fembearing.compare.hard.cage import CAGE_CASES
from fembearing.compare.hard.case import HardCase, HardOutcome, outcome_of
from fembearing.compare.hard.contacts import CONTACT_CASES
from fembearing.compare.hard.free_balls import FREE_BALL_CASES
from fembearing.compare.hard.friction import FRICTION_CASES
from fembearing.compare.hard.lubrication import LUBRICATION_CASES
from fembearing.compare.hard.meshes import MESH_CASES
from fembearing.compare.hard.roughness import ROUGHNESS_CASES
from fembearing.progress import Progress, silent

__all__ = ["HARD_CASES", "HardCase", "HardOutcome", "outcome_of", "run_hard_cases"]

HARD_CASES: tuple[HardCase, ...] = (
    CONTACT_CASES + MESH_CASES + FRICTION_CASES + FREE_BALL_CASES + LUBRICATION_CASES + ROUGHNESS_CASES + CAGE_CASES
)


def run_hard_cases(
    *, cases: tuple[HardCase, ...] | None = None, progress: Progress = silent
) -> tuple[HardOutcome, ...]:
    """Evaluate every case of the table.

    cases : to evaluate in place of the table
    progress : called with the share done, 0 to 1, and the current case
    Any other exception is recorded as wrong, with its type: one case does not stop the others.
    """
    cases = HARD_CASES if cases is None else cases
    outcomes = []
    for number, case in enumerate(cases):
        progress(number / len(cases), case.name)
        outcomes.append(outcome_of(case))
    return tuple(outcomes)
