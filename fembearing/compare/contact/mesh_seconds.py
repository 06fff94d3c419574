"""How long a mesh will take, told before it is solved, from one that this machine has solved.

Seconds grow with the unknowns N as 0.1 s + 14 us N + 0.77 ns N^2: set-up, cells, and the factorisation with its many
right-hand sides. The shape of that was fitted to 24 solves of six random contacts on one machine; the machine's own
speed comes from the mesh at hand. A tensor grid refined in all directions has unknowns as the cube of its level.
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:  # the solver takes a second to import, and nothing else here asks for it
    from fembearing.fem.solution import MeshSolution

FIXED, EACH, EACH_SQUARED = 0.1, 14e-6, 7.7e-10  # s, of which only the ratios count


def predicted_seconds(level: int, *, known: "MeshSolution") -> float:
    """Of meshing and solving one level of a recipe, s.

    known : the largest mesh solved so far, of the same contact and recipe
    """
    unknowns = known.unknowns * (level / known.level) ** 3
    return known.seconds * _work(unknowns) / _work(known.unknowns)


def about(seconds: float) -> str:
    """As a person says it: one digit, in seconds or minutes."""
    if seconds >= 90:
        return f"about {round(seconds / 60):d} min"
    return f"about {float(f'{seconds:.1g}'):g} s"


def _work(unknowns: float) -> float:
    return FIXED + EACH * unknowns + EACH_SQUARED * unknowns**2
