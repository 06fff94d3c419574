"""Predicted time to mesh and solve a level, from a mesh that this machine has solved.

The time grows with the unknowns N as 0.1 s + 14 us N + 0.77 ns N^2: set-up, cells, and the factorisation with its many
right-hand sides. The ratios were fitted to 24 solves of six random contacts on one machine; the machine's own speed
comes from the solved mesh. The unknowns of a tensor grid refined in all directions grow as the cube of its level.
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:  # the solver takes a second to import, and nothing else here needs it
    from fembearing.fem.solution import MeshSolution

FIXED, EACH, EACH_SQUARED = 0.1, 14e-6, 7.7e-10  # s; only their ratios matter


def predicted_seconds(level: int, *, known: "MeshSolution") -> float:
    """Seconds to mesh and solve one level of a recipe.

    known : the largest mesh solved so far of the same contact and recipe
    """
    unknowns = known.unknowns * (level / known.level) ** 3
    return known.seconds * _work(unknowns) / _work(known.unknowns)


def about(seconds: float) -> str:
    """A duration in words: one digit, in seconds or minutes."""
    if seconds >= 90:
        return f"about {round(seconds / 60):d} min"
    return f"about {float(f'{seconds:.1g}'):g} s"


def _work(unknowns: float) -> float:
    return FIXED + EACH * unknowns + EACH_SQUARED * unknowns**2
