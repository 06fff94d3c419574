"""Declared inputs: dataclasses whose annotations say what each field takes, and how keys follow from them.

    ball_diameter: Annotated[Length, "D"]

`Length` is `Annotated[float, Dimension(...)]`, with unit, range and example; the text is the meaning. From such fields
follow the keys of files, which `analytic.scenefile.keys` reads.
"""

import copyreg
from collections.abc import Iterator, Mapping
from dataclasses import MISSING, dataclass, field, fields, is_dataclass, replace
from functools import cache
from types import MappingProxyType, NoneType, UnionType
from typing import Annotated, Any, ClassVar, Literal, NamedTuple, Protocol, Union, get_args, get_origin, get_type_hints

import numpy as np

from analytic.brief import Brief, html_table
from analytic.errors import InputError
from analytic.given import has_unit, why_no_unit
from analytic.quantity import Dimension, Series, word_like
from analytic.words import shown


class Kind(Protocol):
    """What a key takes."""

    @property
    def accepted(self) -> str:
        """The end of a message: what to give."""
        ...

    def read(self, given: object) -> Any:
        """The value, a quantity in SI. Raises ValueError that says what is wrong and what is accepted."""
        ...


@dataclass(frozen=True)
class Word:
    """One of a few words."""

    words: tuple[str, ...]

    @property
    def accepted(self) -> str:
        """The end of a message."""
        *others, last = (f'"{word}"' for word in self.words)
        return f"give {', '.join(others)} or {last}" if others else f"give {last}"

    def read(self, given: object) -> Any:
        """The word. Raises ValueError for another one."""
        word = word_like(given, self.words)
        if word is None:
            raise ValueError(f"is not a word known here; {self.accepted}")
        return word


@dataclass(frozen=True)
class AnyText:
    """Printable text."""

    accepted: str = "give a name"
    is_text: ClassVar = True

    def read(self, given: object) -> Any:
        """The text. Raises ValueError for another value."""
        if not isinstance(given, str) or not given.strip() or len(given) > 200 or not given.isprintable():
            raise ValueError("is no name or text; give printable text of 1 to 200 characters")
        return given


@dataclass(frozen=True, kw_only=True)
class Whole:
    """A whole number of these things, from low to high."""

    things: str
    low: int
    high: int
    example: int

    @property
    def accepted(self) -> str:
        """The end of a message."""
        return f"give a whole number from {self.low} to {self.high}, for example {self.example}"

    def read(self, given: object) -> Any:
        """The number. Raises ValueError for another value."""
        if isinstance(given, bool) or not isinstance(given, int) or not self.low <= given <= self.high:
            raise ValueError(f"is not a number of {self.things}; {self.accepted}")
        return given


@dataclass(frozen=True)
class Switch:
    """True or false."""

    accepted: str = "give true or false"

    def read(self, given: object) -> Any:
        """The switch. Raises ValueError for another value."""
        if not isinstance(given, bool):
            raise ValueError("is neither true nor false; give one of them, without quotes")
        return given


NUMBERS = (int, float, np.ndarray)  # of one operating point, or of each
REQUIRED: Any = ...  # in place of a default
AS_IN_PYTHON: Any = object()  # likewise


class InFile(NamedTuple):
    """What a file says of a field in another way than Python."""

    default: Any = AS_IN_PYTHON  # of a material its name; None: a rule, the catalogue or another key gives the value
    hint: str = ""  # what to give, in place of the words of its kind
    at: str = ""  # path of the key, or of its table with a point, where it is not that of its owner
    word: str | None = None  # that may stand in place of the table


class Derived(NamedTuple):
    """A field that follows from other keys, and is none."""


DERIVED = Derived()
FILLED = InFile(default=None)
Text = Annotated[str, AnyText()]


def read_only(mapping: Mapping) -> MappingProxyType:
    return MappingProxyType(mapping)


# Scenes and results are sent between processes, and read-only mappings cannot be pickled without this.
copyreg.pickle(MappingProxyType, lambda mapping: (read_only, (dict(mapping),)))


def nothing() -> Mapping:
    """An empty mapping, for a field's default."""
    return read_only({})


class Declared(NamedTuple):
    """What the annotation of a field says."""

    kind: Kind | None
    noun: "type[Noun] | None"  # of the field's value
    meaning: str
    in_file: InFile
    is_derived: bool
    is_mapping: bool  # of names to values of the kind
    others: tuple[type, ...]  # classes whose objects it takes beside a word

    def place(self, name: str, owner: str) -> str:
        """The path of the key of a field of this name; owner : path of the table of its dataclass."""
        at = self.in_file.at or (f"{owner}." if owner else "")
        return at if at and not at.endswith(".") else f"{at}{name}"


@cache
def declarations(noun: type) -> Mapping[str, Declared]:
    """What each field of a dataclass declares, by name."""
    hints = get_type_hints(noun, include_extras=True)
    return {each.name: declared_of(hints[each.name]) for each in fields(noun)}


def declared_of(hint: Any) -> Declared:
    """What one annotation says."""
    is_mapping = get_origin(hint) is Mapping
    notes = [*_notes(get_args(hint)[1] if is_mapping else hint)]
    words = tuple(word for note in notes if get_origin(note) is Literal for word in get_args(note))
    kinds = [note for note in notes if hasattr(note, "read") and not isinstance(note, type)]
    classes = [note for note in notes if isinstance(note, type)]
    return Declared(
        kind=kinds[0] if kinds else Word(words) if words else None,
        noun=next((each for each in classes if issubclass(each, Noun)), None),
        meaning=next((note for note in notes if isinstance(note, str)), ""),
        in_file=next((note for note in notes if isinstance(note, InFile)), InFile()),
        is_derived=any(isinstance(note, Derived) for note in notes),
        is_mapping=is_mapping,
        others=tuple(classes),
    )


def _notes(hint: Any) -> Iterator[Any]:
    """Everything that an annotation consists of, the outer first."""
    if get_origin(hint) is Annotated:
        yield from reversed(hint.__metadata__)
        yield from _notes(hint.__origin__)
    elif get_origin(hint) in (Union, UnionType):
        for part in get_args(hint):
            yield from _notes(part)
    else:
        yield hint


class Noun(Brief):
    """A base of frozen dataclasses. Raises InputError for a number with a unit of its own, and for unknown words."""

    HINT: ClassVar[str] = ""  # what to give for it in a file

    def __post_init__(self) -> None:
        values = vars(self)
        for name, value in values.items():
            if type(value) is not float and value is not None and has_unit(value):
                kind = declarations(type(self))[name].kind
                unit = getattr(getattr(kind, "of", kind), "unit", None)
                raise InputError(why_no_unit(f"{type(self).__name__}.{name}", value, unit))
        for name, words in _worded(type(self)).items():
            value = values[name]
            # The usual word is known at once.
            if words.is_mapping or type(value) is not str or value not in words.kind.words:  # pyright: ignore
                _require_words(f"{type(self).__name__}.{name}", words, value)

    def _rows(self, owner: str = "") -> Iterator[list[str]]:
        """Path, value and meaning of each field that is given, with those of the nouns in it."""
        for name, said in declarations(type(self)).items():
            value, path = getattr(self, name), f"{owner}{name}"
            if isinstance(value, Noun):
                yield from value._rows(f"{path}.")
            elif isinstance(kind := getattr(said.kind, "of", said.kind), Dimension) and isinstance(value, NUMBERS):
                ends = dict.fromkeys((float(np.min(value)), float(np.max(value))))
                yield [path, f"{' to '.join(map(kind.written, ends))} {kind.shown_unit}".rstrip(), said.meaning]
            elif isinstance(value, str | int) and value != "":
                yield [path, str(value), said.meaning]

    def _repr_html_(self) -> str:
        """A table for a notebook: a row for each input."""
        return html_table(["input", "value", "meaning"], [*self._rows()], type(self).__name__)


@cache
def _worded(noun: type) -> Mapping[str, Declared]:
    """The fields of a noun that take words, by name."""
    return {name: each for name, each in declarations(noun).items() if isinstance(each.kind, Word)}


def _require_words(name: str, words: Declared, given: Any) -> None:
    """Raise InputError for an unknown word, or unknown words of a mapping."""
    assert isinstance(words.kind, Word)
    names = ["None" if kind is NoneType else kind.__name__ for kind in words.others]
    *others, last = *(f'"{word}"' for word in words.kind.words), *names
    choice = f"{', '.join(others)} or {last}" if others else last
    if words.is_mapping and not isinstance(given, Mapping):
        raise InputError(f"{name} must be a mapping of names to {choice}, got {shown(given)}")
    for key, value in (
        {f"{name}.{key}": each for key, each in given.items()}.items() if words.is_mapping else [(name, given)]
    ):
        if not (isinstance(value, str) and value in words.kind.words) and not isinstance(value, words.others):
            raise InputError(f"{key} must be {choice}, got {shown(value)}")


@dataclass(frozen=True, kw_only=True, eq=False)
class Key:
    """A key of a file that takes one value."""

    path: str
    kind: Kind
    default: Any = REQUIRED
    meaning: str = ""
    hint: str = ""

    @property
    def accepted(self) -> str:
        """The end of a message: what to give."""
        return self.hint or self.kind.accepted

    @property
    def dimension(self) -> Dimension | None:
        """Of a quantity or a pure number; None: a whole number or a word."""
        kind = getattr(self.kind, "of", self.kind)
        return kind if isinstance(kind, Dimension) else None

    @property
    def takes_text(self) -> bool:
        """Whether a text that looks like a number is one: a name, a date."""
        return getattr(self.kind, "is_text", False)

    @property
    def in_series(self) -> bool:
        """Whether a list of values makes a series."""
        return isinstance(self.kind, Series)

    def read(self, given: object) -> Any:
        """One value, a quantity in SI. Raises ValueError that says what is wrong and what is accepted."""
        return getattr(self.kind, "of", self.kind).read(given)

    def read_as(self, name: str, given: object) -> Any:
        """The same. Raises InputError, which begins with this name and the value."""
        try:
            return self.read(given)
        except ValueError as problem:
            raise InputError(f"{name} = {shown(given)} {problem}") from None


@dataclass(frozen=True, kw_only=True, eq=False)
class Table:
    """A table of a file."""

    path: str  # empty: the file
    hint: str
    default: Any = None  # REQUIRED: the file needs it; of a material its name
    word: str | None = None  # that may stand in its place
    noun: type | None = None  # that declares it
    keys: dict[str, "Key | Table"] = field(default_factory=dict)

    def add(self, entry: "Key | Table") -> None:
        """Put a key or a table at its path, in place of the one that is there."""
        within = entry.path[len(self.path) :].lstrip(".")
        first, _, rest = within.partition(".")
        if not rest:
            self.keys[first] = entry
            return
        inside = self.keys.get(first)
        if not isinstance(inside, Table):
            path = f"{self.path}.{first}".lstrip(".")
            inside = self.keys[first] = Table(path=path, hint=f"give a table [{path}]")
        inside.add(entry)

    def find(self, path: str) -> "Key | Table | None":
        """The key or the table with this path below this one; None: there is none."""
        first, _, rest = path.partition(".")
        inside = self.keys.get(first)
        if not rest or inside is None:
            return inside
        within = inside if isinstance(inside, Table) else getattr(inside.kind, "inside", None)
        return None if within is None else within.find(rest)

    def tables(self) -> Iterator["Table"]:
        """All tables inside."""
        for entry in self.keys.values():
            if isinstance(entry, Table):
                yield entry
                yield from entry.tables()

    def paths(self) -> Iterator[str]:
        """Of all keys."""
        for entry in self.keys.values():
            inside = entry if isinstance(entry, Table) else getattr(entry.kind, "inside", None)
            if isinstance(entry, Key) or entry.word is not None:
                yield entry.path
            if inside is not None:
                yield from inside.paths()


def declared_table(noun: type, path: str = "") -> Table:
    """The table of the keys that a dataclass declares."""
    table = Table(path=path, hint=getattr(noun, "HINT", ""), noun=noun)
    for each in fields(noun):
        said = declarations(noun)[each.name]
        of_file, place = said.in_file, said.place(each.name, path)
        if said.is_derived or said.is_mapping:
            continue
        if said.noun is not None and is_dataclass(said.noun):
            default = None if of_file.default is AS_IN_PYTHON else of_file.default
            table.add(replace(declared_table(said.noun, place), default=default, word=of_file.word))
        elif said.kind is not None:
            own = REQUIRED if each.default is MISSING else each.default
            default = own if of_file.default is AS_IN_PYTHON else of_file.default
            table.add(Key(path=place, kind=said.kind, default=default, meaning=said.meaning, hint=of_file.hint))
    return table
