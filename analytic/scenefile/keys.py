"""The keys of a scene file, as `analytic.scene` declares them, and those that a file may give in place of a field.

A key is named by its path, `operation.axial_load`. `read_document` reads the keys of a document into SI; every message
is one line with the key, the value and what is accepted.
"""

from collections.abc import Iterator, Mapping, Sequence
from copy import copy
from dataclasses import fields, replace
from difflib import get_close_matches
from functools import cache
from typing import Annotated, Any, get_args

from analytic.catalog.bearing_rows import CatalogBearing
from analytic.declared import (
    AS_IN_PYTHON,
    FILLED,
    REQUIRED,
    AnyText,
    InFile,
    Key,
    Table,
    Text,
    Word,
    declarations,
    declared_of,
    declared_table,
)
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
    Roughness,
    Scene,
    Thermal,
    Width,
)
from analytic.scenefile.kinds import (
    Designation,
    Direction,
    Extent,
    Law,
    RowOf,
    Solid,
    Spread,
    Viscosity,
    material_entry,
)
from analytic.words import plain, shown

CATALOG = "bearing.catalog"
RINGS = ("inner", "outer")
GIVEN = Origin(status="given", uncertainty=None, source="the scene")
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
MOST_UNKNOWN = 20  # keys for which similar ones are looked for: more of them take long, and no message tells so many
MOST_NAMES = 5  # in one message
TIGHTEST_GROOVE = 0.5  # conformity of a groove that fits the ball
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
# What a file may give in place of a field, or beside the fields, and what to give for tables of such keys.
IN_PLACE: dict[str, Any] = {
    CATALOG: Annotated[str, Designation(), FILLED, "a bearing whose dimensions apply where no other is given"],
    "bearing.pitch_diameter": Annotated[Length, FILLED, "of the circle of the ball centres"],
    "bearing.conformity": Annotated[Conformity, FILLED, "of both rings: groove radius over ball diameter"],
    "bearing.clearance": Annotated[float, CLEARANCE, FILLED, "unmounted, on the diameter; negative is preload"],
    "bearing.contact_angle.nominal": Annotated[Angle, FILLED, "unloaded; the clearance follows from it"],
    **{
        f"bearing.{ring}.{key}": Annotated[length, FILLED, meaning]
        for ring in RINGS
        for key, length, meaning in (
            ("conformity", Conformity, "groove radius over ball diameter"),
            ("shoulder_height", Length, "of the near shoulder over the bottom of the groove"),
            ("shoulder_diameter", Length, "of the near shoulder"),
            ("far_shoulder_height", Width, "of the far shoulder, if it differs"),
            ("far_shoulder_diameter", Length, "of the far shoulder, if it differs"),
        )
    },
    "operation.down": Annotated[
        tuple, Direction(), FILLED, "where gravity points: x along the radial load, z along the thrust"
    ],
    "cage.variant": Annotated[Text, FILLED, "of the cage in the catalog"],
    "cage.pocket_clearance": Annotated[Gap, FILLED, "pocket diameter minus ball diameter"],
    "cage.pocket_approach": 'give the approach by a test or finite elements, { load = "28 N", approach = "0.883 um" }',
    "cage.pocket_approach.load": Annotated[Force, "of a test or finite elements"],
    "cage.pocket_approach.approach": Annotated[Gap, "under this load, in place of Hertz's"],
    "lubricant.name": Annotated[Text, FILLED, "of an oil or grease of the catalog"],
    "lubricant.base_oil": Annotated[
        str, RowOf("base_oils", "base oil"), FILLED, "where the oil has no name of the catalog"
    ],
    "lubricant.viscosity": Annotated[
        float, Viscosity(get_args(DynamicViscosity)[1]), FILLED, "one, or two at two temperatures"
    ],
    "lubricant.traction": Annotated[str, Law(), InFile("eyring_sinh"), "law of the shear stress"],
    **{
        f"lubricant.reach.{way}": Annotated[float, Extent(unit="", low=0.05, high=1, example="0.9"), f"in the {let}"]
        for way, let in (("ahead", "inlet"), ("behind", "outlet"))
    },
    "surface.Ra": Annotated[Roughness, FILLED, "of each surface"],
    "surface.finish": Annotated[str, RowOf("finishes", "finish"), FILLED, "of the race, in place of a roughness"],
    "losses.seals": Annotated[float, SEALS, FILLED, "of both seals together"],
    "friction": "give a table [friction], with coefficient where no lubricant is given",
    "measured": 'give a table [measured] of file = "data.csv"',
    "measured.file": Annotated[
        Text, InFile(hint="give the path of a CSV file of measured torques, from the scene file's folder")
    ],
    "effects": 'give a table [effects] of "auto", "on", "off"',
    **{
        f"effects.{name}": Annotated[Decision, InFile("auto"), "auto: where its input is there"]
        for name in get_args(EffectName)
    },
    "assumed": 'give a table [assumed] of lubricant.viscosity = "the source" and others',
    **{f"assumed.{key}": Annotated[str, AnyText("give the source of the value in words"), FILLED] for key in ASSUMABLE},
    "uncertainty": 'give a table [uncertainty] of lubricant.viscosity = "6 %" and others',
}


@cache
def scene_table() -> Table:
    """The whole file of a scene."""
    root = declared_table(Scene)
    root.add(declared_table(Mounting, "mounting"))
    root.add(declared_table(Thermal, "thermal"))
    for path, hint in IN_PLACE.items():
        if isinstance(hint, str):
            there = root.find(path)
            root.add(replace(there, hint=hint) if isinstance(there, Table) else Table(path=path, hint=hint))
            continue
        said = declared_of(hint)
        assert said.kind is not None, path
        default = said.in_file.default
        if default is AS_IN_PYTHON:
            default = getattr(root.find(path), "default", REQUIRED)
        root.add(Key(path=path, kind=said.kind, default=default, meaning=said.meaning, hint=said.in_file.hint))
    for key, floor in UNCERTAIN.items():
        root.add(Key(path=f"uncertainty.{key}", kind=_spread(key, floor, root), default=None))
    for table in [table for table in root.tables() if table.noun is Material]:
        root.add(Key(path=table.path, kind=Solid(table), default=table.default))
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

    def __init__(self, document: Mapping[str, Any]) -> None:
        super().__init__()
        self.document = document
        self.said: set[str] = set()  # keys and tables of the document
        self.faults: list[tuple[str, Any, str]] = []  # (path, value, problem)
        self.unknown: list[tuple[Table, str, Any]] = []  # (table, name, value) of keys that there are not
        self.misfits: list[tuple[str, str]] = []  # (path, problem) of values that do not fit together
        self.origins: dict[str, Origin] = {}  # of what rules gave
        self.row: CatalogBearing | None = None  # of the catalogue, whose bearing it is

    def __missing__(self, path: str) -> Any:
        key = scene_table().find(path)
        if not isinstance(key, Key):  # a rule gives it
            return None
        if key.default is REQUIRED:
            return None
        return catalog_solid(key.default) if isinstance(key.kind, Solid) else key.default

    def at(self, temperature: float) -> "Values":
        """The same with the oil at a temperature, K."""
        warm = copy(self)
        warm["lubricant.temperature"] = temperature
        return warm

    def noun(self, noun: type, path: str) -> Any:
        """The noun whose table is at a path; None: the document has none."""
        return noun(**self.fields(noun, path)) if path in self.said else None

    def fields(self, noun: type, path: str, **others: Any) -> dict[str, Any]:
        """The fields of a noun whose keys are below a path; others : of the noun, in place of those"""
        found = dict(others)
        for each in fields(noun):
            said = declarations(noun)[each.name]
            place = said.place(each.name, path)
            if each.name in others or said.is_derived or said.is_mapping:
                continue
            if said.noun not in (None, Material):
                is_optional = each.default is None
                found[each.name] = (
                    self.noun(said.noun, place) if is_optional else said.noun(**self.fields(said.noun, place))
                )
            elif said.kind is not None or said.noun is Material:
                found[each.name] = self[place]
        return found


def read_document(document: Mapping[str, Any], table: Table) -> Values:
    """The values of a document, with its faults."""
    values = Values(document)
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
            elif entry.default is REQUIRED:
                yield entry.path, None, f"is missing; {entry.hint}"
        elif entry.default is REQUIRED and entry.path not in values:
            yield entry.path, None, f"is missing; {entry.accepted}"


def faults_of(table: Table, values: Values) -> list[str]:
    """All faults of a document in words: unknown keys first, without the missing keys that they explain."""
    told, more = values.unknown[:MOST_UNKNOWN], values.unknown[MOST_UNKNOWN:]
    explained = {path for inside, name, _ in told for path in _explained(inside, name)}
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
        for inside, name, given in told
    ]
    unknown += [f"{name} is an unknown key" for _, name, _ in more]
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
    known = [*root.paths(), *(inside.path for inside in root.tables())]
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
