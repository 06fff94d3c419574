"""What the commands take: their arguments and options, each described once, and how a text with a unit is read."""

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from analytic.errors import InputError
from analytic.scenefile.quantity import Dimension

TOLERANCE = Dimension(unit="", low=1e-6, high=1.0, example='"1 %" or 0.01')
LOAD = Dimension(unit="N", low=1e-12, high=1e7, example='"620 N"')


class PairName(StrEnum):
    inner = "inner"
    outer = "outer"
    pocket = "pocket"


class GeometryName(StrEnum):
    real = "real"
    hertzian = "hertzian"
    wall = "wall"
    ring = "ring"


ScenePath = Annotated[
    Path | None, typer.Argument(metavar="[SCENE]", help="Scene file, TOML; the built-in 6205 without it.")
]
Tolerance = Annotated[str | None, typer.Option(help='Asked accuracy, for example "1 %"; the scene\'s without it.')]
Accuracy = Annotated[
    str | None,
    typer.Option(
        "--tolerance",
        help='Accuracy asked of the finite elements, for example "0.1 %"; the scene\'s tolerance without it. Verdicts '
        "on Hertz are by the scene's either way.",
    ),
]
Folder = Annotated[
    Path | None, typer.Option("--out", help="New folder for page or pictures, tables, series in time and JSON.")
]
AsJson = Annotated[bool, typer.Option("--json", help="Machine-readable result on standard output, nothing else there.")]
Load = Annotated[str | None, typer.Option(help='Load of the ball, for example "620 N"; from the scene without it.')]
Loads = Annotated[
    list[str] | None,
    typer.Option(
        "--load", help='Load of the ball, for example "620 N"; from the scene without it. Several: the stiffness law.'
    ),
]
Geometry = Annotated[
    GeometryName,
    typer.Option(
        help="True shapes; the idealisation whose exact answer is Hertz; the sheet of a pocket on its support; or true "
        "shapes and, apart from the contact, the ring on a rigid seat."
    ),
]


def read_option(option: str, dimension: Dimension, given: str) -> float:
    """The value of an option in SI. Raises InputError for what is none."""
    try:
        number: object = float(given)  # an option is text, a pure number too
    except ValueError:
        number = given
    try:
        return dimension.read(number)
    except ValueError as problem:
        raise InputError(f"{option} {given!r} {problem}") from None
