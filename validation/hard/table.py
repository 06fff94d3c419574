"""The table of hard cases, where such programs go wrong: each with its problem, and its right answer and why.

An expected number is exact, a limit, or 40-digit arithmetic on the inputs written in the table, never our own output.
Where no number is right, the right answer is an error that says so; any other answer, also infinity, is wrong.
"""

from validation.hard.cage import CAGE_CASES
from validation.hard.case import HardCase
from validation.hard.contacts import CONTACT_CASES
from validation.hard.free_balls import FREE_BALL_CASES
from validation.hard.friction import FRICTION_CASES
from validation.hard.lubrication import LUBRICATION_CASES
from validation.hard.meshes import MESH_CASES
from validation.hard.numerical_film import NUMERICAL_FILM_CASES
from validation.hard.numerical_friction import NUMERICAL_FRICTION_CASES
from validation.hard.roughness import ROUGHNESS_CASES

HARD_CASES: tuple[HardCase, ...] = (
    CONTACT_CASES
    + MESH_CASES
    + FRICTION_CASES
    + FREE_BALL_CASES
    + NUMERICAL_FRICTION_CASES
    + LUBRICATION_CASES
    + NUMERICAL_FILM_CASES
    + ROUGHNESS_CASES
    + CAGE_CASES
)
