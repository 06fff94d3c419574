"""Arguments and options that several commands take, each described once, and how their texts are read."""

import sys
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from fembearing.cli.status import print_warnings

if TYPE_CHECKING:
    from analytic.scene import Scene
    from analytic.scenefile.by_temperature import SceneByTemperature

BUILTIN = "paper_6205"
STANDARD_INPUT = "-"  # as the name of a scene
NOTHING_SET: Mapping[str, str] = MappingProxyType({})
OF_FILES = (".csv", ".html", ".json", ".nc", ".pdf", ".png", ".svg", ".toml", ".vtu")  # endings
PairName = Literal["inner", "outer", "pocket"]
GeometryName = Literal["real", "hertzian", "wall", "ring"]


def bearing_names_like(incomplete: str) -> list[str]:
    """Designations of the catalogue that begin so, for the completion of a shell."""
    from analytic.catalog.bearing_rows import bearing_names

    return [name for name in bearing_names() if name.casefold().startswith(incomplete.casefold())]


def scene_names_like(incomplete: str) -> list[str]:
    """Scene files, folders, built-in scenes and bearings that begin so, for the completion of a shell."""
    from analytic import catalog

    found = [path for path in sorted(Path().glob(f"{incomplete}*")) if path.is_dir() or path.suffix == ".toml"]
    files = [f"{path}/" if path.is_dir() else str(path) for path in found]
    builtin = [name for name in catalog.names("scenes") if name.startswith(incomplete)]
    return [*files, *builtin, *bearing_names_like(incomplete)]


SceneName = Annotated[
    str | None,
    typer.Argument(
        metavar="SCENE",
        help="Scene file (TOML), - for standard input, or a bearing of the catalog, for example 6206 (default: the "
        "built-in paper_6205).",
        autocompletion=scene_names_like,
    ),
]
SceneNames = Annotated[
    list[str] | None,
    typer.Argument(
        metavar="SCENE",
        help="Scene file (TOML), - for standard input, or a bearing of the catalog, for example 6206 (default: the "
        "built-in paper_6205). Several are compared.",
        autocompletion=scene_names_like,
    ),
]
Tolerance = Annotated[str | None, typer.Option(help='Required accuracy, for example "1 %" (default: from the scene).')]
Accuracy = Annotated[
    str | None,
    typer.Option(
        "--tolerance",
        help='Required accuracy of the finite elements, for example "0.1 %" (default: from the scene). The limit for '
        "Hertz is always the tolerance of the scene.",
    ),
]
Folder = Annotated[
    Path | None, typer.Option("--out", "-o", help="New folder for page or pictures, tables, time series and JSON.")
]
Target = Annotated[
    Path | None,
    typer.Option(
        "--out",
        "-o",
        help="New folder for torque.json, torque.csv, torque.png and time series; or one file: .csv, .json, .png, "
        ".svg, .pdf, .html.",
    ),
]
WithInterval = Annotated[
    bool,
    typer.Option("--interval", help="Compute the 95 % interval of the torque from 512 or more samples, on all cores."),
]
Samples = Annotated[
    int | None,
    typer.Option(help="Number of samples of the interval (default: 512, or more until its ends converge)."),
]
AsJson = Annotated[bool, typer.Option("--json", help="Print the result as JSON only.")]
Load = Annotated[str | None, typer.Option(help='Load of the ball, for example "620 N" (default: from the scene).')]
Loads = Annotated[
    list[str] | None,
    typer.Option(
        "--load",
        help='Load of the ball, for example "620 N" (default: from the scene). Several give the stiffness law.',
    ),
]
Geometry = Annotated[
    GeometryName,
    typer.Option(
        help="Meshed shape. real: true shapes; hertzian: half spaces, with Hertz as exact solution; wall: sheet of a "
        "pocket on its rim; ring: true shapes, and the ring on a rigid seat as a separate part."
    ),
]

Bodies = Annotated[
    Literal["half-space", "meshed"],
    typer.Option(
        "--compliance",
        help="Elastic bodies of the numerical solution. half-space: two half spaces; meshed: ball and race of true "
        "shape by finite elements.",
    ),
]


def read_scene(
    name: str | None, *, settings: Mapping[str, str] = NOTHING_SET, options: Mapping[str, str] = NOTHING_SET
) -> "Scene":
    """The scene of that name, "-" that of standard input, None the built-in one; the others as for `load_scene`.

    Friction settles the temperature of its oil where it has [thermal].
    """
    found = read_by_temperature(name, settings=settings, options=options)
    if found.thermal is None:
        return found.scene
    from analytic.prediction.steady import at_steady_temperature  # with the production model: few scenes need it

    return at_steady_temperature(found)


def read_by_temperature(
    name: str | None,
    *,
    settings: Mapping[str, str] = NOTHING_SET,
    options: Mapping[str, str] = NOTHING_SET,
    columns: Mapping[str, Any] = NOTHING_SET,
) -> "SceneByTemperature":
    """The same scene at any temperature of its oil; columns : as for `load_by_temperature`."""
    from analytic.scenefile.read import load_by_temperature, parse_by_temperature, refuse_options

    if name != STANDARD_INPUT:
        found = load_by_temperature(BUILTIN if name is None else name, settings=settings, columns=columns, **options)
    else:
        refuse_options(options, "standard input")
        found = parse_by_temperature(_standard_input(), origin="standard input", settings=settings)
    return replace(found, scene=with_details(found.scene))


def with_details(scene: "Scene") -> "Scene":
    """The scene with the details of the report that options give, or the user's settings where it says none."""
    from analytic.report_details import ReportDetails
    from fembearing.cli.config import own_details
    from fembearing.cli.report_options import given_details

    usual = vars(ReportDetails())
    own = {name: value for name, value in own_details().items() if getattr(scene.report, name) == usual[name]}
    return replace(scene, report=replace(scene.report, **{**own, **given_details()}))


def _standard_input() -> str:
    """Raises InputError for more than a scene file may have, and for what is not UTF-8."""
    from analytic.errors import InputError
    from analytic.scenefile.text import LARGEST_FILE

    content = sys.stdin.buffer.read(LARGEST_FILE + 1)
    if len(content) > LARGEST_FILE:
        raise InputError(f"standard input: has more than {LARGEST_FILE} bytes; give a scene")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        raise InputError(f"standard input: byte {problem.start} is not UTF-8; give the scene as UTF-8") from problem


def require_folder_name(folder: Path | None) -> None:
    """Raises InputError for a folder whose name would be one of a file."""
    if folder is not None and folder.suffix.casefold() in OF_FILES:
        from analytic.errors import InputError

        raise InputError(
            f"--out {str(folder)!r} ends with {folder.suffix!r}, and this command writes a folder; give a name without "
            "it"
        )


def read_tolerance(given: str | None, scene: "Scene") -> float:
    """The tolerance of an option, or the scene's."""
    return scene.tolerance if given is None else _read_option("--tolerance", given, "tolerance")


def read_load(given: str) -> float:
    """The load of an option in N."""
    return _read_option("--load", given, "ball_load")


def read_speed(given: str) -> float:
    """The speed of an option in rad/s."""
    return _read_option("--speed", given, "operation.inner_speed")


def read_friction(given: str) -> float:
    """The friction coefficient of an option."""
    return _read_option("--friction", given, "friction.coefficient")


def read_samples(given: int | None, *, with_interval: bool) -> int | Literal["enough"] | None:
    """The samples of an interval; None: no interval. Raises InputError for samples without an interval."""
    if given is not None and not with_interval:
        from analytic.errors import InputError

        raise InputError(f"--samples {given} goes with --interval; give both, or leave it out")
    return "enough" if with_interval and given is None else given


def _read_option(option: str, given: str, key: str) -> float:
    """The value of an option in SI. Raises InputError for a text that this key of a scene or a grid does not take."""
    from analytic.errors import InputError
    from analytic.scenefile.keys import scene_key
    from analytic.scenefile.setting import read_setting
    from analytic.scenefile.tables import SceneTable
    from fembearing.sweep.grid import OF_AXES, GridTable

    root = GridTable if key in OF_AXES else SceneTable
    value, notes = read_setting(key, given, root=root)
    dimension = scene_key(key, root=root).dimension
    assert dimension is not None, key
    try:
        number = dimension.read(value)
    except ValueError as problem:
        raise InputError(f"{option} {given!r} {problem}") from None
    print_warnings(notes, read=notes)
    return number
