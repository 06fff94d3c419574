"""Every public name says what it is, in sections that numpydoc renders, with shapes, units, errors and source.

Public is what `analytic` and `fembearing` export, every class of data that these functions take or return, or that such
a class holds, and the public methods and properties of all of them. Compiled and internal functions are not public,
also where a page names them.
"""

import ast
import dataclasses
import inspect
import re
import textwrap
from collections.abc import Iterator
from types import FunctionType

import pytest
from docutils.core import publish_doctree
from docutils.nodes import system_message
from numpydoc.docscrape import NumpyDocString
from numpydoc.docscrape_sphinx import SphinxDocString
from numpydoc.validate import validate

import analytic
from analytic import errors
from docs.extensions.public import classes_in, exported, hints, public_classes
from docs.extensions.source import field_comments

STRUCTURE = {  # of numpydoc: what it finds wrong with a docstring
    "GL06": "unknown section",
    "GL07": "sections in another order",
    "GL08": "no docstring",
    "SS01": "no summary",
    "PR01": "a parameter is missing",
    "PR02": "a parameter is unknown",
    "PR03": "parameters in another order",
    "PR07": "a parameter without description",
    "PR10": "no space before a colon",
    "RT01": "no section Returns",
    "RT03": "what is returned has no description",
}
NEVER_RAISES = {"physical_checks"}  # of the exported functions
NO_PHYSICS = {"bearing", "load_scene", "material", "operation", "physical_checks", "run_sweep", "surfaces"}
NUMBERS = re.compile(r"\b(?:float|int|ndarray|Array|ArrayLike|_Buffer|Quantity)\b")
UNITS = (
    r"kg m\^2|1/m|1/Pa|1/K|N/m\^1\.5|N/m\^n|N/m|N m s|N m|N|m/s\^2|m/s|m\^2|m|kg/m\^3|kg|Pa s|Pa|rad/s|rad|K|s|"
    r"W/\(m K\)|W|J"
)
BEFORE = r"(?:^|[,;:()] |[ (](?:and|or|[Ii]n|both|its|as|of) |\(|= )"
AFTER = (
    r"(?=[,.;:)]|$| (?:and|or|by|of|at|for|in|under|on|per|if|where|each|over|as|along|across|about|from|through)\b| >)"
)
UNIT = re.compile(rf"{BEFORE}(?:{UNITS}){AFTER}")
WITHOUT = re.compile(
    r"dimensionless|relative|shares?\b|ratio|number|count|factor|fraction|coefficient|\bSI\b|per cent|index|indices|"
    r"exponent|order|units?\b|bytes|seed|how many|times|less one|semi-axes|seconds",
    re.IGNORECASE,
)


def functions() -> Iterator[tuple[str, FunctionType]]:
    """Exported functions, and public methods that take something."""
    for one in exported():
        if isinstance(one, FunctionType):
            yield f"{one.__module__}.{one.__qualname__}", one
    for kind in public_classes():
        for name, member in vars(kind).items():
            method = member.__func__ if isinstance(member, classmethod | staticmethod) else member
            takes = isinstance(method, FunctionType) and set(inspect.signature(method).parameters) - {"self", "cls"}
            if takes and (not name.startswith("_") or name == "__call__"):
                yield f"{kind.__module__}.{kind.__qualname__}.{name}", method


def plain_members() -> Iterator[tuple[str, FunctionType]]:
    """Properties, and public methods that take nothing."""
    for kind in public_classes():
        for name, member in vars(kind).items():
            getter = getattr(member, "fget", None) or getattr(member, "func", None) or member
            takes = isinstance(getter, FunctionType) and set(inspect.signature(getter).parameters) - {"self"}
            if not name.startswith("_") and isinstance(getter, FunctionType) and not takes:
                yield f"{kind.__module__}.{kind.__qualname__}.{name}", getter


def is_number(annotation: object) -> bool:
    return bool(NUMBERS.search(str(annotation))) and "bool" not in str(annotation)


def words(name: str) -> str:
    return name.replace("_", " ")


def has_unit(text: str) -> bool:
    return bool(UNIT.search(text) or WITHOUT.search(text))


FUNCTIONS = dict(functions())
MEMBERS = dict(plain_members())
CLASSES = {f"{kind.__module__}.{kind.__qualname__}": kind for kind in public_classes()}


@pytest.mark.parametrize(
    "text", ["load, Q, N, >= 0", "speed, rad/s", "share, 0 to 1", "width, (n,) m", "float: In K, or a text"]
)
def test_a_unit_is_seen(text: str) -> None:
    assert has_unit(text)


@pytest.mark.parametrize("text", ["load, of the ball", "speed, of m balls", "width, N-th of all", "mass, see K"])
def test_a_missing_unit_is_seen(text: str) -> None:
    assert not has_unit(text)


def test_what_is_public() -> None:
    assert {analytic.Scene, analytic.Cage} < set(public_classes())
    assert {"FrictionTorque", "RingState", "Interval", "Estimate", "InputError"} < {
        one.__name__ for one in public_classes()
    }
    assert len(FUNCTIONS) > 40
    assert len(MEMBERS) > 80
    assert len(CLASSES) > 70


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_function_has_all_sections(name: str) -> None:
    found = {code: words for code, words in validate(name)["errors"] if code in STRUCTURE}
    assert found == {}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_number_that_a_function_takes_has_a_unit(name: str) -> None:
    function = FUNCTIONS[name]
    said = {
        part.strip(" *"): f"{entry.type}: {' '.join(entry.desc)}"
        for entry in NumpyDocString(inspect.getdoc(function) or "")["Parameters"]
        for part in entry.name.split(",")
    }
    signature = inspect.signature(function)
    for key, parameter in signature.parameters.items():
        if key not in ("self", "cls") and is_number(parameter.annotation):
            assert has_unit(f"{key} {said[key]}"), f"{name}: {key} has no unit: {said[key]}"
            if re.search(r"ndarray|ArrayLike|_Buffer", str(parameter.annotation)):
                assert re.search(r"shape|\(n|array_like|broadcast", said[key]), f"{name}: {key} has no shape"
    returned = NumpyDocString(inspect.getdoc(function) or "")["Returns"]
    if is_number(signature.return_annotation):
        assert has_unit(" ".join(f"{entry.type}: {' '.join(entry.desc)}" for entry in returned)), (
            f"{name}: what is returned"
        )


@pytest.mark.parametrize("name", [name for name in FUNCTIONS if FUNCTIONS[name] in set(exported())])
def test_an_exported_function_names_its_errors_and_its_source(name: str) -> None:
    text, short = inspect.getdoc(FUNCTIONS[name]) or "", name.rpartition(".")[2]
    raised = [entry.type for entry in NumpyDocString(text)["Raises"]]
    assert raised or short in NEVER_RAISES
    assert all(hasattr(errors, error) for error in raised)
    assert short in NO_PHYSICS or re.search(r"[Ss]ources?: |derived here", text), "no source"


@pytest.mark.parametrize("name", FUNCTIONS | MEMBERS)
def test_what_raises_says_so(name: str) -> None:
    function = (FUNCTIONS | MEMBERS)[name]
    tree = ast.parse(textwrap.dedent(inspect.getsource(function)))
    own = {getattr(getattr(node.exc, "func", None), "id", "") for node in ast.walk(tree) if isinstance(node, ast.Raise)}
    assert [error for error in own if hasattr(errors, error) and error not in (inspect.getdoc(function) or "")] == []


@pytest.mark.parametrize("name", MEMBERS)
def test_a_property_says_what_it_is_and_in_which_unit(name: str) -> None:
    text = inspect.getdoc(MEMBERS[name]) or ""
    assert text
    if is_number(inspect.signature(MEMBERS[name]).return_annotation):
        assert has_unit(text), f"{name}: no unit: {text}"


@pytest.mark.parametrize("name", CLASSES)
def test_a_class_says_what_it_is_and_its_fields_have_units(name: str) -> None:
    kind = CLASSES[name]
    text = " ".join((kind.__doc__ or "").split())
    assert text
    assert not text.startswith(f"{kind.__name__}("), f"{name}: what dataclass writes is no docstring"
    if not dataclasses.is_dataclass(kind):
        return
    silent = []
    for field, comment in field_comments(kind).items():
        if is_number(kind.__annotations__[field]):
            says = has_unit(f"{words(field)}, {comment}") or UNIT.search(text)
        else:  # the class of a field has a docstring of its own
            says = comment or f"`{field}`" in text or any(classes_in(hints(kind)[field]))
        if not says and not field.startswith("_"):
            silent.append(f"{field}  # {comment}")
    assert silent == [], f"{name}: no unit or no meaning"


@pytest.mark.parametrize("name", FUNCTIONS)
def test_sections_are_markup_without_errors(name: str) -> None:
    """As Sphinx reads them: a star or a bar of a formula is no markup, and blocks are indented."""
    text = str(SphinxDocString(inspect.getdoc(FUNCTIONS[name]) or "", config={}))
    tree = publish_doctree(
        text, settings_overrides={"report_level": 5, "halt_level": 5, "file_insertion_enabled": False}
    )
    assert [node.astext() for node in tree.findall(system_message)] == []
