"""The keys of a scene file: what a key takes, a document that has it, and messages about its value.

A key is named by its path, `operation.axial_load`.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from types import UnionType
from typing import Annotated, Any, Union, get_args, get_origin

from pydantic import TypeAdapter, ValidationError
from pydantic.fields import FieldInfo

from analytic.errors import InputError
from analytic.scenefile.bearing import catalog_row
from analytic.scenefile.quantity import Dimension
from analytic.scenefile.table import Table, table_of
from analytic.scenefile.tables import SceneTable
from analytic.words import plain, shown

Value = float | int | str | bool
CATALOG = "bearing.catalog"
NOTHING = "leave it out"  # where a key is not known
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


@dataclass(frozen=True, kw_only=True)
class SceneKey:
    """A key that takes one value: a quantity, a number or a word."""

    path: str
    dimension: Dimension | None  # of a quantity; None: a whole number or a word
    in_series: bool  # whether a list of values makes a series
    field: FieldInfo

    @property
    def takes_text(self) -> bool:
        """Whether any text is a value, also one that looks like a number: a name, a date."""
        kinds = (self.field.annotation, *get_args(self.field.annotation))
        return any(kind is str or (get_origin(kind) is Annotated and get_args(kind)[0] is str) for kind in kinds)

    def read(self, given: object) -> Value:
        """The value, a quantity in SI. Raises ValueError that says what is wrong and what is accepted."""
        if self.dimension is not None:
            return self.dimension.read(given)
        if not isinstance(given, Value):
            raise ValueError("is not a number or a word")
        if self.path == CATALOG:
            try:
                catalog_row({"catalog": given})
            except InputError as problem:
                raise ValueError(f"is no bearing: {problem}") from None
        try:
            TypeAdapter(self.field.rebuild_annotation()).validate_python(given)
        except ValidationError as problem:
            raise ValueError(_problem(problem.errors(include_url=False)[0], self.field)) from None
        return given

    def read_as(self, name: str, given: object) -> Value:
        """The same. Raises InputError, which begins with this name and the value."""
        try:
            return self.read(given)
        except ValueError as problem:
            raise InputError(f"{name} = {shown(given)} {problem}") from None


@dataclass(frozen=True, kw_only=True)
class Place:
    """A place in a document."""

    path: str
    name: str  # the last part of the path
    table: type[Table]  # that holds it
    field: FieldInfo | None  # None: an unknown key


def scene_key(path: str, *, root: type[Table] = SceneTable) -> SceneKey:
    """The key with that path in the root. Raises InputError for an unknown key and for one that takes a table."""
    table: type[Table] | None = root
    field: FieldInfo | None = None
    for part in path.split("."):
        field = None if table is None else table.model_fields.get(part)
        if field is None:
            raise InputError(f"{plain(path)} is no key of a scene file{_hint(path)}")
        table = table_of(field)
    assert field is not None
    if table is not None and not field.metadata:  # a material may be a table or a name, so it has a validator
        inside = [f"{path}.{name}" for name in table.model_fields]
        raise InputError(f"{path} is a table of a scene file; give one of its keys: {_some(inside)}")
    return SceneKey(
        path=path,
        dimension=next(_dimensions(field.rebuild_annotation()), None),
        in_series=get_origin(field.annotation) is list,
        field=field,
    )


def with_key(document: dict[str, Any], path: str, value: object) -> dict[str, Any]:
    """A copy of the document with that key set. Raises InputError if a part of the path holds a value, not a table."""
    first, _, rest = path.partition(".")
    if not rest:
        return document | {first: value}
    inside = document.get(first, {})
    if not isinstance(inside, dict):
        raise InputError(f"{first} = {shown(inside)} is no table in the scene, so {rest} cannot be set; write it out")
    return document | {first: with_key(inside, rest, value)}


def fault_at(document: dict[str, Any], path: str, problem: str) -> str:
    """The key, its value in the scene file or the catalog, and the problem, in one line; path : empty of several."""
    value: Any = document
    for part in path.split("."):
        value = value.get(part) if isinstance(value, dict) else None
    return f"{path} {problem}".lstrip() if value is None or not path else f"{path} = {shown(value)} {problem}"


def faults_of(
    document: dict[str, Any], errors: Sequence[Mapping[str, Any]], *, root: type[Table] = SceneTable
) -> list[str]:
    """The same for all errors that pydantic reports: unknown keys first, without the missing keys that they explain.

    root : of which the document is
    """
    unknown = [error for error in errors if error["type"] == "extra_forbidden"]
    explained = {place for error in unknown for place in _explained(_place(document, error["loc"], root))}
    without_catalog = tuple(CATALOG.split(".")) in explained

    def follows(error: Mapping[str, Any]) -> bool:
        place = error["loc"]
        return error["type"] == "missing" and (place in explained or (without_catalog and place[0] in OF_CATALOG))

    others = [error for error in errors if error["type"] != "extra_forbidden" and not follows(error)]
    return [_fault_of(_place(document, error["loc"], root), error) for error in (*unknown, *others)]


def _explained(place: Place) -> Iterator[tuple[str, ...]]:
    """The keys that are not missing but written in another way."""
    yield from (tuple(path.split(".")) for path in SAME_AS.get(place.name.casefold(), ()))
    yield from ((*place.path.split(".")[:-1], meant) for meant in _meant(place))


def _meant(place: Place) -> list[str]:
    """The keys of the same table for which an unknown one is another word, or the one that it is like."""
    table = place.path.rpartition(".")[0]
    same = [path.rpartition(".") for path in SAME_AS.get(place.name.casefold(), ())]
    return [name for owner, _, name in same if owner == table] or get_close_matches(
        place.name, list(place.table.model_fields), n=1
    )


def _fault_of(place: Place, error: Mapping[str, Any]) -> str:
    if error["type"] in ("missing", "too_short"):  # an empty table
        return f"{place.path} is missing; {accepted(place.field) or NOTHING}"
    if error["type"] == "extra_forbidden":
        problem = f"is an unknown key; {_instead(place, error['input'])}"
    elif error["type"] in ("value_error", "literal_error"):
        problem = _problem(error, place.field)
    else:  # the tables allow only one other error: not a table
        problem = f"is not a table; {accepted(place.field) or NOTHING}"
    return f"{place.path} = {shown(error['input'])} {problem}"


def _instead(place: Place, given: object) -> str:
    """What to write for an unknown key: the key meant, the same key of another table, or the most similar ones."""
    names, same = list(place.table.model_fields), SAME_AS.get(place.name.casefold(), ())
    if isinstance(given, dict):
        same = tuple(dict.fromkeys(path.partition(".")[0] for path in same))
    elsewhere = [path for path in paths() if path.rpartition(".")[2] == place.name and not path.startswith(BESIDE)]
    meant = same if "." not in place.path else _meant(place)
    meant = meant or _meant(place) or same or elsewhere[:2]
    if not meant:
        return f"known: {_some(get_close_matches(place.name, names, n=len(names), cutoff=0.0))}"
    return f"did you mean {' or '.join(meant)}?"


def _some(names: Sequence[str]) -> str:
    """The first of the names, and how many there are more."""
    more = len(names) - MOST_NAMES
    return ", ".join(names[:MOST_NAMES]) + (f" and {more} more, see docs/scenes.md" if more > 0 else "")


def _problem(error: Mapping[str, Any], field: FieldInfo | None) -> str:
    """What is wrong with a value, by pydantic's error."""
    context = error["ctx"]
    if "error" in context:
        return str(context["error"])
    return f"is not a word known here; {accepted(field) or 'give ' + context['expected']}"


def _place(document: dict[str, Any], location: tuple[str | int, ...], root: type[Table]) -> Place:
    path, node, inside, table, field = "", document, root, root, None
    for part in location:
        if isinstance(part, int):
            if isinstance(node, list):  # pydantic always sees a list; the scene file may have a single quantity
                path, node = f"{path}[{part}]", node[part]
            continue
        table, field = inside, inside.model_fields.get(part)
        path = f"{path}.{plain(part)}" if path else plain(part)
        node = node.get(part) if isinstance(node, dict) else None
        inside = (table_of(field) if field else None) or inside
    return Place(path=path, name=str(location[-1]), table=table, field=field)


def accepted(field: FieldInfo | None) -> str | None:
    """What the field takes, in words; None: anything of its kind."""
    if field is None:
        return None
    table, dimension = table_of(field), next(_dimensions(field.rebuild_annotation()), None)
    return field.description or (table.HINT if table else None) or (dimension and dimension.accepted)


def _hint(path: str) -> str:
    known = list(paths())
    last = path.rpartition(".")[2]
    near = SAME_AS.get(last.casefold()) or [
        name for name in known if name.rpartition(".")[2] == last and not name.startswith(BESIDE)
    ]
    near = near or get_close_matches(path, known, n=2)
    near = near or [name for name in known if name.rpartition(".")[2].endswith(last)]
    return f"; did you mean {' or '.join(near[:4])}?" if near else "; give its whole path, as operation.axial_load"


def paths(table: type[Table] = SceneTable, before: str = "") -> Iterator[str]:
    """The paths of all keys that take a value."""
    for name, field in table.model_fields.items():
        inside = table_of(field)
        if inside is None or field.metadata:
            yield before + name
        if inside is not None:
            yield from paths(inside, f"{before}{name}.")


def _dimensions(kind: Any) -> Iterator[Dimension]:
    """The dimensions in an annotation: a quantity, an optional quantity, or a list of quantities."""
    if get_origin(kind) is Annotated:
        yield from (note for note in kind.__metadata__ if isinstance(note, Dimension))
        yield from _dimensions(kind.__origin__)
    elif get_origin(kind) in (Union, UnionType, list):
        for part in get_args(kind):
            yield from _dimensions(part)
