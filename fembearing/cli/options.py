"""Arguments and options that several commands take, each described once, and how their texts are read."""

import inspect
import sys
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager, nullcontext
from dataclasses import dataclass, fields, is_dataclass, make_dataclass, replace
from functools import wraps
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from analytic.given import USUAL_SPEED, USUAL_TEMPERATURE, UnitSystem
from fembearing.cli.status import print_warnings

if TYPE_CHECKING:
    from analytic.scene import Scene
    from analytic.scenefile.read import SceneByTemperature

BUILTIN = "paper_6205"
STANDARD_INPUT = "-"  # as the name of a scene
NO_COLUMNS: Mapping[str, Any] = MappingProxyType({})
OF_FILES = (".csv", ".html", ".json", ".nc", ".pdf", ".png", ".svg", ".toml", ".vtu")  # endings
PairName = Literal["inner", "outer", "pocket"]
GeometryName = Literal["real", "hertzian", "wall", "ring"]
Command = Callable[..., None]


def with_groups(command: Command) -> Command:
    """A command that has an option for each field of its dataclass parameters, in place of these."""
    own = inspect.signature(command, eval_str=True).parameters
    groups: dict[str, Any] = {name: each.annotation for name, each in own.items() if is_dataclass(each.annotation)}

    @wraps(command)
    def run(**arguments: Any) -> None:
        made = {
            name: group(**{field.name: arguments.pop(field.name) for field in fields(group)})
            for name, group in groups.items()
        }
        command(**arguments, **made)

    parameters = [each for name, each in own.items() if name not in groups]
    for group in groups.values():
        parameters += [
            inspect.Parameter(field.name, inspect.Parameter.KEYWORD_ONLY, default=field.default, annotation=field.type)
            for field in fields(group)
        ]
    vars(run)["__signature__"] = inspect.Signature(parameters)
    return run


@dataclass(frozen=True, kw_only=True)
class Talk:
    """What a command says on standard error beside errors."""

    quiet: Annotated[
        bool,
        typer.Option("--quiet", "-q", help="Print no progress, and no warnings but those of how the input was read."),
    ] = False
    verbose: Annotated[
        bool, typer.Option("--verbose", "-v", help="Print each step with its time on standard error.")
    ] = False

    def __post_init__(self) -> None:
        if self.quiet and self.verbose:
            from analytic.errors import InputError

            raise InputError("--quiet and --verbose exclude each other: leave one of them out")

    def warn(self, warnings: Iterable[str], *, read: Collection[str] = ()) -> None:
        """Say warnings; a quiet command only those that say how the input was `read`, as they change the number."""
        print_warnings(each for each in warnings if not self.quiet or each in read)

    def early(self, line: str) -> None:
        """Say a line of the result before the rest is known, where the progress is shown."""
        from fembearing.cli.console import err

        if self.verbose or (err.is_terminal and not self.quiet):
            err.tell(f"fembearing: {line}")

    def progress(self) -> AbstractContextManager[Callable[[float, str], None]]:
        """As `console.shown_progress`."""
        from fembearing.cli.console import shown_progress

        return shown_progress(quiet=self.quiet, verbose=self.verbose)


Force = Annotated[
    bool, typer.Option("--force", help="Replace an existing file, or a folder with files of fembearing only.")
]
Units = Annotated[
    UnitSystem | None, typer.Option(help="Units of page and tables (default: from the scene, or metric).")
]


@dataclass(frozen=True, kw_only=True)
class Output:
    """Where a command writes its files."""

    folder: Annotated[
        Path | None, typer.Option("--out", "-o", help="New folder for page or pictures, tables, time series and JSON.")
    ] = None
    force: Force = False

    def __post_init__(self) -> None:
        require_folder_name(self.folder, option="--out")

    @contextmanager
    def opened(self) -> Iterator[Path | None]:
        """A folder that takes its place when everything is in it; None: nothing is to be written."""
        from analytic.writing import new_folder

        with nullcontext() if self.folder is None else new_folder(self.folder, force=self.force) as place:
            yield place


USUAL = {  # what options say of the usual scene of a bearing, by the names of `analytic.given.KEYS`
    "axial_load": 'Axial load, for example "500 N", or a range "100 N to 1 kN in 5".',
    "radial_load": 'Radial load, for example "5 kN", or a range (default for a bearing without any load: a light one).',
    "speed": 'Speed of the inner ring, or a range "1 rpm to 8000 rpm in 15 log" '
    f"(default: from the scene, or {USUAL_SPEED}).",
    "oil": "Name of the oil, see `fembearing list oils` (default: from the scene, or by size, speed and temperature).",
    "temperature": f"Oil temperature (default: from the scene, or {USUAL_TEMPERATURE}).",
    "supply": "Oil supply: oil_bath, oil_jet, oil_spot or grease (default: from the scene, or by bearing and oil).",
}


def text_options(helps: Mapping[str, str]) -> type:
    """A dataclass of options that are texts, None where not given; helps : by name."""
    texts = [(name, Annotated[str | None, typer.Option(help=text)], None) for name, text in helps.items()]
    return make_dataclass("TextOptions", texts, frozen=True, kw_only=True)


class Usual(text_options(USUAL)):
    """What options say of the usual scene of a bearing."""

    @property
    def options(self) -> dict[str, Any]:
        """The texts of the options, by the names of `analytic.given.KEYS`."""
        return {name: text for name in USUAL if (text := getattr(self, name)) is not None}


@dataclass(frozen=True, kw_only=True)
class Given(Usual):
    """What options say of a scene, in place of what it says itself."""

    texts: Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            metavar="KEY=VALUE",
            help="Key of the scene with a new value, for example lubricant.supply=grease; one option for each key.",
        ),
    ] = None
    units: Units = None

    @property
    def settings(self) -> dict[str, str]:
        """The texts of --set by key. Raises InputError for one that is no "key=value"."""
        from analytic.scenefile.setting import typed_settings

        return typed_settings(self.texts or [])

    def scene(self, name: str | None, *, measured: str | None = None) -> "Scene":
        """The scene of that name, "-" that of standard input, None the built-in one; measured : as for `load_scene`.

        Friction settles the temperature of its oil where it has [thermal].
        """
        found = self.by_temperature(name, measured=measured)
        if found.thermal is None:
            return found.scene
        from analytic.prediction.steady import at_steady_temperature  # with the production model: few scenes need it

        return at_steady_temperature(found)

    def by_temperature(
        self, name: str | None, *, columns: Mapping[str, Any] = NO_COLUMNS, measured: str | None = None
    ) -> "SceneByTemperature":
        """The same scene at any temperature of its oil; columns : as for `load_by_temperature`."""
        from analytic.scenefile.read import load_by_temperature, parse_by_temperature

        given = self.options | {"settings": self.settings, "measured": measured}
        if name == STANDARD_INPUT:
            found = parse_by_temperature(_standard_input(), origin="standard input", **given)
        else:
            found = load_by_temperature(BUILTIN if name is None else name, columns=columns, **given)
        return replace(found, scene=self.shown(found.scene))

    def shown(self, scene: "Scene") -> "Scene":
        """The scene in the units of the option."""
        return scene if self.units is None else replace(scene, report=replace(scene.report, units=self.units))


Tolerance = Annotated[str | None, typer.Option(help='Required accuracy, for example "1 %" (default: from the scene).')]


@dataclass(frozen=True, kw_only=True)
class GivenAccurate(Given):
    """The same with the accuracy that is required."""

    tolerance: Tolerance = None

    def scene(self, name: str | None, *, measured: str | None = None) -> "Scene":
        """As `Given.scene`, with this tolerance in place of its own."""
        found = super().scene(name, measured=measured)
        return replace(found, tolerance=read_tolerance(self.tolerance, found))


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


OF_SCENE = "Scene file (TOML), - for standard input, or a bearing of the catalog, for example 6206"
Named = Annotated[str, typer.Argument(metavar="SCENE", help=f"{OF_SCENE}.", autocompletion=scene_names_like)]
SceneName = Annotated[
    str | None,
    typer.Argument(
        metavar="SCENE", help=f"{OF_SCENE} (default: the built-in paper_6205).", autocompletion=scene_names_like
    ),
]
SceneNames = Annotated[
    list[str] | None,
    typer.Argument(
        metavar="SCENE",
        help=f"{OF_SCENE}, or a list of bearings, .csv or .xlsx (default: the built-in paper_6205). Several are "
        "compared.",
        autocompletion=scene_names_like,
    ),
]
WithInterval = Annotated[
    bool,
    typer.Option("--interval", help="Compute the 95 % interval of the torque from 512 or more samples, on all cores."),
]
Samples = Annotated[
    int | None, typer.Option(help="Number of samples of the interval (default: 512, or more until its ends converge).")
]
AsJson = Annotated[bool, typer.Option("--json", help="Print the result as JSON only.")]
Load = Annotated[str | None, typer.Option(help='Load of the ball, for example "620 N" (default: from the scene).')]
Bodies = Annotated[
    Literal["half-space", "meshed"],
    typer.Option(
        "--compliance",
        help="Elastic bodies of the numerical solution. half-space: two half spaces; meshed: ball and race of true "
        "shape by finite elements.",
    ),
]


def _standard_input() -> str:
    """Raises InputError for more than a scene file may have, and for what is not UTF-8."""
    from analytic.errors import InputError
    from analytic.scenefile.find import LARGEST_FILE

    content = sys.stdin.buffer.read(LARGEST_FILE + 1)
    if len(content) > LARGEST_FILE:
        raise InputError(f"standard input: has more than {LARGEST_FILE} bytes; give a scene")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        raise InputError(f"standard input: byte {problem.start} is not UTF-8; give the scene as UTF-8") from problem


def require_folder_name(folder: Path | None, *, option: str) -> None:
    """Raises InputError for a folder whose name would be one of a file."""
    if folder is not None and folder.suffix.casefold() in OF_FILES:
        from analytic.errors import InputError

        raise InputError(
            f"{option} {str(folder)!r} ends with {folder.suffix!r}, and this command writes a folder; give a name "
            "without it"
        )


def read_tolerance(given: str | None, scene: "Scene") -> float:
    """The tolerance of an option, or the scene's."""
    return scene.tolerance if given is None else read_option("--tolerance", given, "tolerance")


def read_load(given: str | None) -> float | None:
    """The load of an option in N; None: not given."""
    return None if given is None else read_option("--load", given, "ball_load")


def read_samples(given: int | None, *, with_interval: bool) -> int | Literal["enough"] | None:
    """The samples of an interval; None: no interval. Raises InputError for samples without an interval."""
    if given is not None and not with_interval:
        from analytic.errors import InputError

        raise InputError(f"--samples {given} goes with --interval; give both, or leave it out")
    return "enough" if with_interval and given is None else given


def read_option(option: str, given: str, key: str) -> float:
    """The value of an option in SI. Raises InputError for a text that this key of a scene or a grid does not take."""
    from analytic.scenefile.keys import scene_key
    from analytic.scenefile.setting import read_setting
    from fembearing.sweep.grid import GRID, OF_AXES

    root = GRID if key in OF_AXES else None
    value, notes = read_setting(key, given, root=root)
    number = scene_key(key, root=root).read_as(option, value)
    print_warnings(notes)
    return number
