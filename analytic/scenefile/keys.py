"""The keys of a scene file, as `analytic.scene` declares them, and those that a file may give in place of a field.

A key is named by its path, `operation.axial_load`. `read_document` reads the keys of a document into SI; every message
is one line with the key, the value and what is accepted.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, replace
from difflib import get_close_matches
from functools import cache
from typing import Annotated, Any, ClassVar, Literal, get_args

from analytic import catalog
from analytic.catalog.bearing_rows import find_bearing
from analytic.declared import REQUIRED, AnyText, Hint, Key, Table, Text, Word, declarations, declared_of, declared_table
from analytic.errors import InputError
from analytic.mounting.clearance import Mounting
from analytic.quantity import Dimension, QuantityOrWord, Series
from analytic.scene import (
    Angle,
    ClearanceGroup,
    Decision,
    DynamicViscosity,
    EffectName,
    Force,
    Gap,
    Length,
    Material,
    Origin,
    Reaching,
    Roughness,
    Scene,
    Thermal,
    Width,
)
from analytic.scenefile.law_packages import BUILT_IN, GROUP, installed_laws
from analytic.scenefile.material import material_entry
from analytic.scenefile.viscosity import Viscosity
from analytic.words import plain, shown

CATALOG = "bearing.catalog"
RINGS = ("inner", "outer")
SAME_AS: dict[str, tuple[str, ...]] = {  # other words for keys and tables, as people write them
    **dict.fromkeys(("designation", "catalogue", "bearing_type", "type"), (CATALOG,)),
    **dict.fromkeys(("oil", "lubricant_name", "grease", "vg", "iso_vg"), ("lubricant.name",)),
    **dict.fromkeys(("balls", "number_of_balls", "ball_number", "z"), ("bearing.ball_count",)),
    **dict.fromkeys(("ball_radius", "ball_size", "dw"), ("bearing.ball_diameter",)),
    **dict.fromkeys(("pcd", "pitch", "pitch_circle", "pitch_radius", "dpw"), ("bearing.pitch_diameter",)),
    **dict.fromkeys(("oils", "lubrication", "lube"), ("lubricant",)),
    **dict.fromkeys(("speed", "rpm", "n", "rotational_speed", "shaft_speed"), ("operation.inner_speed",)),
    **dict.fromkeys(("load", "loads", "force"), ("operation.radial_load", "operation.axial_load")),
    **dict.fromkeys(("radial", "fr", "radial_force"), ("operation.radial_load",)),
    **dict.fromkeys(("axial", "fa", "thrust", "thrust_load", "axial_force"), ("operation.axial_load",)),
    **dict.fromkeys(("temperature", "oil_temperature", "temp"), ("lubricant.temperature",)),
    **dict.fromkeys(("operating", "operating_point", "conditions"), ("operation",)),
    **dict.fromkeys(("friction_coefficient", "mu"), ("friction.coefficient",)),
    "roughness": ("surface.Ra",),
    **dict.fromkeys(("rq", "sq", "rms"), ("surface.rms_roughness",)),
    "shaft_fit": ("mounting.shaft_interference",),
    "housing_fit": ("mounting.housing_interference",),
}
OF_CATALOG = ("bearing", "cage")  # tables that the catalog fills
BESIDE = ("uncertainty.", "assumed.")  # tables with the keys of the others
MOST_NAMES = 5  # in one message
EXTENT = Dimension(unit="m", low=1e-7, high=1.0, example='"3 mm"')


@dataclass(frozen=True)
class Designation:
    """A bearing of the catalogue."""

    accepted: str = 'give a designation, for example "6206"'
    is_text: ClassVar = True

    def read(self, given: object) -> Any:
        """The designation. Raises ValueError for one that the catalogue does not have."""
        if not isinstance(given, str):
            raise ValueError('is no designation; give it in quotes, for example "6206"')
        if given not in catalog.names("bearings"):
            try:
                find_bearing(given)
            except InputError as problem:
                raise ValueError(str(problem).removeprefix(f"bearing {shown(given)} ")) from None
        return given


@dataclass(frozen=True)
class RowOf:
    """The name of a row of a table of the catalog."""

    table: Literal["base_oils", "finishes"]
    thing: str
    is_text: ClassVar = True

    @property
    def words(self) -> tuple[str, ...]:
        """The names."""
        return tuple(catalog.rows(self.table))

    @property
    def accepted(self) -> str:
        """The end of a message."""
        return f"give one of {', '.join(self.words)}"

    def read(self, given: object) -> Any:
        """The name. Raises ValueError for another one."""
        if given not in self.words:
            raise ValueError(f"is not a {self.thing}; {self.accepted}")
        return given


@dataclass(frozen=True)
class Law:
    """The name of a law of traction, built in or installed; the package is not imported yet."""

    accepted: str = 'give "eyring_sinh", "eyring_constant" or the name of an installed law'
    is_text: ClassVar = True

    def read(self, given: object) -> Any:
        """The name. Raises ValueError for another one."""
        known = (*BUILT_IN, *installed_laws())
        if given not in known:
            remedy = f"give one of {', '.join(known)}, or install a package that has it as {GROUP}"
            raise ValueError(f"is not a law of traction; {remedy}")
        return given


@dataclass(frozen=True)
class Solid:
    """A material: a name of the catalog, or a table."""

    inside: Table
    accepted: str = 'give a material, for example "steel"'
    is_text: ClassVar = True

    def read(self, given: object) -> Any:
        """The name. Raises ValueError for what is none."""
        material_entry(given)
        return given


@dataclass(frozen=True)
class Direction:
    """Where gravity points."""

    accepted: str = "give three numbers, for example [1, 0, 0]"

    def read(self, given: object) -> Any:
        """The unit vector. Raises ValueError for what has no direction."""
        given = [*given] if isinstance(given, tuple) else given
        numbers = isinstance(given, list) and all(isinstance(each, int | float) for each in given)
        length = math.hypot(*given) if isinstance(given, list) and numbers and len(given) == 3 else 0.0
        if not isinstance(given, list) or not 0 < length < math.inf:
            raise ValueError(
                "is no direction; give where gravity points as [x, y, z] of any length, with x towards the radial load "
                "and z along the thrust, for example [1, 0, 0]"
            )
        return tuple(float(each) / length for each in given)


@dataclass(frozen=True)
class GivenLength:
    """A length that is given where a share may stand too."""

    metres: float


@dataclass(frozen=True, kw_only=True)
class Extent(Dimension):
    """A share of the ball's radius, or a length."""

    @property
    def accepted(self) -> str:
        """The end of every message."""
        return f"{super().accepted} of the ball's radius, or a length, {EXTENT.example}"

    def read(self, given: object) -> Any:
        """The share, or the length. Raises ValueError as `Dimension.read`."""
        if isinstance(given, str) and not given.rstrip().endswith("%"):
            return GivenLength(EXTENT.read(given))
        return super().read(given)


@dataclass(frozen=True, kw_only=True)
class GivenSpread:
    """A standard deviation as a scene gives it."""

    value: float
    is_share: bool  # of the input's value; else in its unit, SI


@dataclass(frozen=True, kw_only=True)
class Spread:
    """What a standard deviation accepts; `of` accepts only one in the unit of the input, as a sweep steps through."""

    of: Dimension
    takes_share: bool

    @property
    def accepted(self) -> str:
        """The end of every message."""
        return f'{self.of.accepted}, or "5 %"' if self.takes_share and self.of.unit else self.of.accepted

    def read(self, given: object) -> GivenSpread:
        """The deviation, or the share of the value. Raises ValueError that says what is wrong and what is accepted."""
        if isinstance(given, str) and given.rstrip().endswith("%"):
            if not self.takes_share:
                raise ValueError(f"is a share, but this input needs the standard deviation itself; {self.accepted}")
            return GivenSpread(value=SHARE.read(given), is_share=True)
        return GivenSpread(value=self.of.read(given), is_share=False)


LARGEST_SHARE = 3.0  # of a value: a standard deviation beyond it says that the value is not known
TIGHTEST_GROOVE = 0.5  # conformity of a groove that fits the ball
SHARE = Dimension(unit="", low=0, high=LARGEST_SHARE, example='"10 %"')
FACTOR, NORMAL = 0.0, None
# The inputs that a prediction varies, each with its floor: what lies above it is lognormal, and its median is the
# value; None: the value itself is normal. `Scene.uncertainty` has standard deviations, SI, in place of the defaults.
# Those of `model` are factors on formulas; those of `gap` and `elastic_rolling` are steps to the other law, that of
# `starvation` is one from the running bearing to a flooded one.
UNCERTAIN: Mapping[str, float | None] = {
    **dict.fromkeys(("bearing.ball_diameter", "bearing.pitch_diameter"), FACTOR),
    "bearing.clearance": NORMAL,
    **dict.fromkeys(("bearing.inner.conformity", "bearing.outer.conformity"), TIGHTEST_GROOVE),
    **dict.fromkeys(("bearing.contact_angle.free", "bearing.contact_angle.value"), NORMAL),
    **dict.fromkeys(("arrangement.preload", "arrangement.offset"), FACTOR),
    **dict.fromkeys(("operation.axial_load", "operation.radial_load", "operation.moment"), FACTOR),
    "lubricant.viscosity": FACTOR,
    "lubricant.temperature": NORMAL,
    **dict.fromkeys(("lubricant.pressure_viscosity", "lubricant.eyring_stress", "lubricant.limiting_shear"), FACTOR),
    **dict.fromkeys(("lubricant.surface_tension", "lubricant.reach.ahead"), FACTOR),
    **dict.fromkeys(("surface.rms_roughness", "surface.autocorrelation.length"), FACTOR),
    **dict.fromkeys(("surface.boundary_friction", "surface.hardness"), FACTOR),
    **dict.fromkeys(("friction.coefficient", "friction.hysteresis_loss"), FACTOR),
    **dict.fromkeys(("losses.seals", "losses.drag", "losses.oil_flow", "losses.oil_share"), FACTOR),
    "cage.friction_coefficient": FACTOR,
    **dict.fromkeys(("model.film", "model.traction"), FACTOR),
    "model.gap": NORMAL,
    **dict.fromkeys(("model.surfaces", "model.rolling", "model.heating"), FACTOR),
    **dict.fromkeys(("model.starvation", "model.elastic_rolling"), NORMAL),
    **dict.fromkeys(("model.grease_film", "model.unloaded_balls", "model.oil_losses"), FACTOR),
}
# By the keys of [assumed].
ASSUMABLE = (
    *(key for key in UNCERTAIN if not key.startswith("model.")),
    *("cage.pocket_clearance", "cage.wall_thickness", "cage.material", "cage.start"),
)
# Largest standard deviation and an example, by the unit. That it is at most 300 % of the value is checked too.
DEVIATIONS: Mapping[str, tuple[float, str]] = {
    "": (3.0, "0.01"),
    "m": (0.01, '"2 um"'),
    "rad": (1.0, '"1.5 deg"'),
    "N": (1e6, '"10 N"'),
    "N m": (1e4, '"1 N mm"'),
    "N/m": (0.1, '"0.003 N/m"'),
    "K": (100.0, '"2 K"'),
    "Pa": (1e10, '"0.4 GPa"'),
    "1/Pa": (1e-7, '"2e-9 1/Pa"'),
    "Pa s": (10.0, '"0.004 Pa s"'),
    "m^3/s": (1.0, '"0.05 l/min"'),
}
CLEARANCE = QuantityOrWord(
    unit="m", low=-1, high=1, example='"10 um"', words=get_args(ClearanceGroup), meaning="a group"
)
SEALS = QuantityOrWord(
    unit="N m", low=0, high=1e6, example='"5 N mm"', words=("estimate", "off"), meaning="SKF's formula or no drag"
)
Conformity = Annotated[float, Dimension(unit="", low=0.5, high=5, example="0.52")]
# What a file may give in place of a field, or beside the fields; a default is None unless it is said below.
IN_PLACE: dict[str, Any] = {
    CATALOG: Annotated[str, Designation(), "a bearing whose dimensions apply where no other is given"],
    "bearing.name": Annotated[Text, "shown with results; that of the catalogue without"],
    "bearing.ball_mass": None,
    "bearing.pitch_diameter": Annotated[Length, "of the circle of the ball centres"],
    "bearing.conformity": Annotated[Conformity, "of both rings: groove radius over ball diameter"],
    "bearing.clearance": Annotated[float, CLEARANCE, "unmounted, on the diameter; negative is preload"],
    "bearing.contact_angle.nominal": Annotated[Angle, "unloaded; the clearance follows from it"],
    **{
        f"bearing.{ring}.{key}": hint
        for ring in RINGS
        for key, hint in {
            "bottom_radius": None,
            "groove_radius": None,
            "conformity": Annotated[Conformity, "groove radius over ball diameter"],
            "shoulder_half_width": None,
            "shoulder_height": Annotated[Length, "of the near shoulder over the bottom of the groove"],
            "shoulder_diameter": Annotated[Length, "of the near shoulder"],
            "far_shoulder_height": Annotated[Width, "of the far shoulder, if it differs"],
            "far_shoulder_diameter": Annotated[Length, "of the far shoulder, if it differs"],
        }.items()
    },
    "operation.down": Annotated[
        tuple, Direction(), "where gravity points: x along the radial load, z along the thrust"
    ],
    "cage.variant": Annotated[Text, "of the cage in the catalog"],
    "cage.pocket_diameter": None,
    "cage.pocket_clearance": Annotated[Gap, "pocket diameter minus ball diameter"],
    "cage.pocket_depth": None,
    "cage.pocket_approach.load": Annotated[Force, "of a test or finite elements"],
    "cage.pocket_approach.approach": Annotated[Gap, "under this load, in place of Hertz's"],
    "lubricant.name": Annotated[Text, "of an oil or grease of the catalog"],
    "lubricant.base_oil": Annotated[str, RowOf("base_oils", "base oil"), "where the oil has no name of the catalog"],
    "lubricant.viscosity": Annotated[
        float, Viscosity(get_args(DynamicViscosity)[1]), "one, or two at two temperatures"
    ],
    "lubricant.traction": Annotated[str, Law(), "law of the shear stress"],
    **dict.fromkeys(
        f"lubricant.{key}"
        for key in (
            *("pressure_viscosity", "viscosity_temperature", "reference_temperature", "temperature"),
            *("thermal_conductivity", "density", "limiting_shear", "surface_tension"),
        )
    ),
    "lubricant.reach.ahead": Annotated[Reaching, Extent(unit="", low=0.05, high=1, example="0.9"), "in the inlet"],
    "lubricant.reach.behind": Annotated[Reaching, Extent(unit="", low=0.05, high=1, example="0.9"), "in the outlet"],
    "surface.Ra": Annotated[Roughness, "of each surface"],
    "surface.finish": Annotated[str, RowOf("finishes", "finish"), "of the race, in place of a roughness"],
    "surface.height_map.spacing": None,
    "surface.asperities": None,
    "losses.seals": Annotated[float, SEALS, "of both seals together"],
    "mounting.inner_temperature": None,
    "mounting.outer_temperature": None,
    "measured.file": Annotated[
        Text, Hint("give the path of a CSV file of measured torques, from the scene file's folder")
    ],
    **{f"effects.{name}": Annotated[Decision, "auto: where its input is there"] for name in get_args(EffectName)},
    **{f"assumed.{key}": Annotated[str, AnyText("give the source of the value in words")] for key in ASSUMABLE},
}
SOLIDS = ("bearing.ball_material", "bearing.inner.material", "bearing.outer.material", "cage.material")
SOLIDS += ("mounting.shaft_material", "mounting.housing_material")
DEFAULTS: dict[str, Any] = {
    **dict.fromkeys(("name", "tolerance", "measured.file"), REQUIRED),
    **dict.fromkeys(("cage.pocket_approach.load", "cage.pocket_approach.approach"), REQUIRED),
    "bearing.contact_angle.rule": "solved",
    "lubricant.traction": "eyring_sinh",
    **{f"operation.{name}": [0.0] for name in ("axial_load", "radial_load", "moment")},
    **{f"effects.{name}": "auto" for name in get_args(EffectName)},
}
HINTS = {
    "cage.pocket_approach": 'give the approach by a test or finite elements, { load = "28 N", approach = "0.883 um" }',
    "cage.start": 'give "rest", "ramp", "sudden" or "whirl"',
    "effects": 'give a table [effects] of "auto", "on", "off"',
    "measured": 'give a table [measured] of file = "data.csv"',
    "friction": "give a table [friction], with coefficient where no lubricant is given",
    "uncertainty": 'give a table [uncertainty] of lubricant.viscosity = "6 %" and others',
    "assumed": 'give a table [assumed] of lubricant.viscosity = "the source" and others',
}


@cache
def scene_table() -> Table:
    """The whole file of a scene."""
    root = declared_table(Scene)
    root.add(declared_table(Mounting, "mounting"))
    root.add(declared_table(Thermal, "thermal"))
    for path, hint in IN_PLACE.items():
        said = root.find(path)
        if hint is None:
            root.add(replace(said, default=None))  # pyright: ignore[reportArgumentType, reportCallIssue]
        else:
            told, own = declared_of(hint), getattr(said, "default", REQUIRED)
            assert told.kind is not None, path
            default = None if own in (REQUIRED, "") else own
            root.add(Key(path=path, kind=told.kind, default=default, meaning=told.meaning, hint=told.hint))
    for key, floor in UNCERTAIN.items():
        root.add(Key(path=f"uncertainty.{key}", kind=_spread(key, floor, root), default=None))
    for path in SOLIDS:
        table = root.find(path)
        assert isinstance(table, Table), path
        for name, default in {"name": "unnamed", "source": "the scene file"}.items():
            table.add(replace(table.keys[name], default=default))  # pyright: ignore[reportArgumentType, reportCallIssue]
        root.add(Key(path=path, kind=Solid(table), default=REQUIRED if path == "cage.material" else "steel"))
    for path, default in DEFAULTS.items():
        root.add(replace(root.find(path), default=default))  # pyright: ignore[reportArgumentType, reportCallIssue]
    for path, words in HINTS.items():
        root.add(replace(root.find(path), hint=words))  # pyright: ignore[reportArgumentType, reportCallIssue]
    for path in ("bearing", "operation"):
        root.add(replace(root.find(path), is_required=True))  # pyright: ignore[reportArgumentType, reportCallIssue]
    root.add(replace(root.find("cage"), word="none"))  # pyright: ignore[reportArgumentType, reportCallIssue]
    return root


def _spread(key: str, floor: float | None, root: Table) -> Spread:
    """What the standard deviation of an input accepts."""
    entry = root.find(key)  # None: a factor on a formula
    dimension = entry.dimension if isinstance(entry, Key) else None
    unit = "" if dimension is None else dimension.unit
    high, example = DEVIATIONS[unit]
    return Spread(of=Dimension(unit=unit, low=0.0, high=high, example=example), takes_share=floor == FACTOR)


class Values(dict[str, Any]):
    """Values of a scene by key, SI; of a key that is not there its default, None without one."""

    def __init__(self) -> None:
        super().__init__()
        self.said: set[str] = set()  # keys and tables of the document
        self.faults: list[tuple[str, Any, str]] = []  # (path, value, problem)
        self.unknown: list[tuple[Table, str, Any]] = []  # (table, name, value) of keys that there are not
        self.origins: dict[str, Origin] = {}  # of what rules gave

    def __missing__(self, path: str) -> Any:
        key = scene_table().find(path)
        if not isinstance(key, Key):  # a rule gives it
            return None
        if isinstance(key.kind, Solid) and key.default is not REQUIRED:
            return catalog_solid(key.default)
        return None if key.default is REQUIRED else key.default

    def at(self, temperature: float) -> "Values":
        """The same with the oil at a temperature, K."""
        warm = copy(self)
        warm["lubricant.temperature"] = temperature
        return warm

    def fields(self, noun: type, path: str, **others: Any) -> dict[str, Any]:
        """The fields of a noun whose keys are below a path; others : of the noun, in place of those"""
        names = [name for name, said in declarations(noun).items() if said.kind is not None and not said.is_derived]
        return {name: self[f"{path}.{name}"] for name in names if name not in others} | others

    def noun(self, noun: type, path: str) -> Any:
        """The noun whose table is at a path; None: the document has none."""
        return noun(**self.fields(noun, path)) if path in self.said else None


def read_document(document: Mapping[str, Any], table: Table) -> Values:
    """The values of a document, with its faults."""
    values = Values()
    _read(table, document, values)
    return values


def _read(table: Table, given: Mapping[str, Any], values: Values) -> None:
    values.unknown += [(table, name, value) for name, value in given.items() if name not in table.keys]
    for name in (name for name in table.keys if name in given):
        entry, value = table.keys[name], given[name]
        values.said.add(entry.path)
        if isinstance(entry, Key):
            _read_key(entry, value, values)
        elif isinstance(value, Mapping):
            _read(entry, value, values)
        elif entry.word is None or not isinstance(value, str):
            values.faults.append((entry.path, value, f"is not a table; {entry.hint}"))
        elif value == entry.word:
            values.said.remove(entry.path)
            values.said.add(f"{entry.path} = {value}")
        else:
            values.faults.append((entry.path, value, f"is no {entry.path}; {entry.hint}"))


def _read_key(key: Key, given: Any, values: Values) -> None:
    try:
        if isinstance(key.kind, Solid):
            solid = material_entry(given)
            inside = read_document(solid, key.kind.inside)
            failed = {path for path, _, _ in inside.faults}
            lacking = [each for each in missing_keys(key.kind.inside, inside) if each[0] not in failed]
            values.faults += [*inside.faults, *lacking]
            values.unknown += inside.unknown
            if not (inside.faults or lacking or inside.unknown):
                values[key.path] = Material(**inside.fields(Material, key.path))
        elif isinstance(key.kind, Series) and isinstance(given, list) and given:
            values[key.path] = [_element(key, number, each, values) for number, each in enumerate(given)]
        else:
            values[key.path] = key.kind.read(given)
    except ValueError as problem:
        values.faults.append((key.path, given, _problem(key, problem)))


def _element(key: Key, number: int, given: Any, values: Values) -> Any:
    try:
        return key.read(given)
    except ValueError as problem:
        values.faults.append((f"{key.path}[{number}]", given, str(problem)))
        return 0.0


def _problem(key: Key, problem: ValueError) -> str:
    """What is wrong with the value; the hint of the key says what to give where there is one."""
    words = str(problem)
    return words.replace(key.kind.accepted, key.accepted) if key.hint else words


@cache
def catalog_solid(name: str) -> Material:
    """The material of the catalog with that name."""
    table = declared_table(Material, "material")
    values = read_document(material_entry(name), table)
    return Material(**{key.partition(".")[2]: value for key, value in values.items()})


def missing_keys(table: Table, values: Values) -> Iterator[tuple[str, Any, str]]:
    """The faults of keys that a table, or a table inside it that is there, lacks."""
    for entry in table.keys.values():
        if isinstance(entry, Table):
            if entry.path in values.said:
                yield from missing_keys(entry, values)
            elif entry.is_required:
                yield entry.path, None, f"is missing; {entry.hint}"
        elif entry.default is REQUIRED and entry.path not in values:
            yield entry.path, None, f"is missing; {entry.accepted}"


def faults_of(table: Table, values: Values) -> list[str]:
    """All faults of a document in words: unknown keys first, without the missing keys that they explain."""
    explained = {path for inside, name, _ in values.unknown for path in _explained(inside, name)}
    failed = {path.partition("[")[0] for path, _, _ in values.faults}
    lacking = [
        (path, given, problem)
        for path, given, problem in missing_keys(table, values)
        if path not in explained | failed
        and not (CATALOG in explained | failed and path.partition(".")[0] in OF_CATALOG)
    ]
    unknown = [
        f"{plain(f'{inside.path}.{name}'.lstrip('.'))} = {shown(given)} is an unknown key; "
        + _instead(table, inside, name, given)
        for inside, name, given in values.unknown
    ]
    return unknown + [_in_words(*fault) for fault in (*values.faults, *lacking)]


def _in_words(path: str, given: Any, problem: str) -> str:
    return f"{path} {problem}" if given is None else f"{path} = {shown(given)} {problem}"


def _explained(table: Table, name: str) -> Iterator[str]:
    """The keys that are not missing but written in another way."""
    yield from SAME_AS.get(name.casefold(), ())
    yield from (f"{table.path}.{meant}".lstrip(".") for meant in _meant(table, name))


def _meant(table: Table, name: str) -> list[str]:
    """The keys of the same table for which an unknown one is another word, or the one that it is like."""
    same = [path.rpartition(".") for path in SAME_AS.get(name.casefold(), ())]
    return [last for owner, _, last in same if owner == table.path] or get_close_matches(name, [*table.keys], n=1)


def _instead(root: Table, table: Table, name: str, given: object) -> str:
    """What to write for an unknown key: the key meant, the same key of another table, or the most similar ones."""
    same = SAME_AS.get(name.casefold(), ())
    if isinstance(given, dict):
        same = tuple(dict.fromkeys(path.partition(".")[0] for path in same))
    known = [*root.paths(), *root.tables()]
    elsewhere = [path for path in known if path.rpartition(".")[2] == name and not path.startswith(BESIDE)]
    meant = _meant(table, name)
    meant = (meant or same or elsewhere[:2]) if table.path else (same or meant or elsewhere[:2])
    if not meant:
        return f"known: {_some(get_close_matches(name, [*table.keys], n=len(table.keys), cutoff=0.0))}"
    return f"did you mean {' or '.join(meant)}?"


def _some(names: Sequence[str]) -> str:
    """The first of the names, and how many there are more."""
    more = len(names) - MOST_NAMES
    return ", ".join(names[:MOST_NAMES]) + (f" and {more} more, see docs/scenes.md" if more > 0 else "")


def scene_key(path: str, *, root: Table | None = None) -> Key:
    """The key with that path; root : of another file. Raises InputError for an unknown key and for that of a table."""
    table = scene_table() if root is None else root
    found = table.find(path) if all(path.split(".")) else None
    if found is None:
        raise InputError(f"{plain(path)} is no key of a scene file{_hint(table, path)}")
    if isinstance(found, Table) and found.word is not None:
        return Key(path=path, kind=Word((found.word,)), hint=found.hint)
    if isinstance(found, Table):
        inside = [f"{path}.{name}" for name in found.keys]
        raise InputError(f"{path} is a table of a scene file; give one of its keys: {_some(inside)}")
    return found


def _hint(table: Table, path: str) -> str:
    known = list(table.paths())
    last = path.rpartition(".")[2]
    same = [name for name in known if name.rpartition(".")[2] == last and not name.startswith(BESIDE)]
    near = SAME_AS.get(last.casefold()) or sorted(same, key=lambda name: name.count("."))
    near = near or get_close_matches(path, known, n=2)
    near = near or [name for name in known if name.rpartition(".")[2].endswith(last)]
    return f"; did you mean {' or '.join(near[:4])}?" if near else "; give its whole path, as operation.axial_load"


def with_key(document: Mapping[str, Any], path: str, value: object) -> dict[str, Any]:
    """A copy of the document with that key set. Raises InputError if a part of the path holds a value, not a table."""
    first, _, rest = path.partition(".")
    if not rest:
        return {**document, first: value}
    inside = document.get(first, {})
    if not isinstance(inside, dict):
        raise InputError(
            f"{first} = {shown(inside)} is no table in the scene, so {rest} in it cannot be set; write it out"
        )
    return {**document, first: with_key(inside, rest, value)}


def without_key(document: Mapping[str, Any], path: str) -> dict[str, Any]:
    """A copy of the document without that key."""
    first, _, rest = path.partition(".")
    inside = document.get(first)
    if rest and isinstance(inside, Mapping):
        return {**document, first: without_key(inside, rest)}
    return {key: value for key, value in document.items() if rest or key != first}


def fault_at(document: Mapping[str, Any], path: str, problem: str) -> str:
    """The key, its value in the document, and the problem, in one line; path : empty of several."""
    value: Any = document
    for part in path.split("."):
        value = value.get(part) if isinstance(value, Mapping) else None
    return f"{path} {problem}".lstrip() if value is None or not path else f"{path} = {shown(value)} {problem}"
