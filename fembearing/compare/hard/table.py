"""Cases where such programs go wrong: what is asked, what is right and why, as a table.

An expected number is exact, a limit, or 40-digit arithmetic on the inputs written in the table, never our own output.
Where no number is right, a refusal that says so is: any other answer, a silent infinity included, is wrong.
"""

from fembearing.compare.hard.cage import CAGE_CASES
from fembearing.compare.hard.case import HardCase, HardOutcome, outcome_of
from fembearing.compare.hard.contacts import CONTACT_CASES
from fembearing.compare.hard.friction import FRICTION_CASES
from fembearing.compare.hard.lubrication import LUBRICATION_CASES
from fembearing.compare.hard.meshes import MESH_CASES
from fembearing.compare.hard.roughness import ROUGHNESS_CASES
from fembearing.progress import Progress, silent

__all__ = ["HARD_CASES", "HardCase", "HardOutcome", "outcome_of", "run_hard_cases"]

HARD_CASES: tuple[HardCase, ...] = (
    CONTACT_CASES + MESH_CASES + FRICTION_CASES + LUBRICATION_CASES + ROUGHNESS_CASES + CAGE_CASES
)


def run_hard_cases(
    *, cases: tuple[HardCase, ...] | None = None, progress: Progress = silent
) -> tuple[HardOutcome, ...]:
    """Every case of the table.

    cases : others than those of the table
    progress : called with the share done, 0 to 1, and the case at hand
    An exception that is no refusal is recorded as wrong, with its type: one case does not stop the others.
    """
    asked = HARD_CASES if cases is None else cases
    outcomes = []
    for number, case in enumerate(asked):
        progress(number / len(asked), case.name)
        outcomes.append(outcome_of(case))
    return tuple(outcomes)
