"""Scenes whose every value is admitted, and some of whose values are extreme.

Each begins as a scene that ships, a bearing of the catalogue, or one of validation/promises. Then a few keys get
values from the whole range that the reader admits, its ends among them, or a thousandth to a thousand times what they
had. The reader refuses some of these scenes, because their values do not fit together. How long a cage is to be
followed is left alone: that computing is what the user orders.
"""

import tomllib
from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np

from analytic import catalog, friction_torque
from analytic.catalog.bearing_rows import bearing_names
from analytic.declared import Key, Switch, Word
from analytic.errors import InputError
from analytic.scenefile.keys import scene_key, scene_table, with_key
from analytic.scenefile.read import parse_scene
from analytic.scenefile.template import scene_text as template
from fembearing.plain_types import plain
from validation.promises.drawn import RADIAL_INPUTS, radial_scene, toml
from validation.stress.watched import Input, SilentError
from validation.study import SCENES

SHIPPED = tuple(catalog.path("scenes", name) for name in catalog.names("scenes")) + tuple(sorted(SCENES.glob("*.toml")))
LEFT_ALONE = ("cage.start", "cage.seeds", "cage.duration", "cage.steps_per_contact", "tolerance", "bearing.kind")
WITHOUT_MEANING = ("assumed.", "uncertainty.", "report.")  # for the torque
MOST_CHANGES = 4
DECADES = 3.0  # of a factor on what is there
TOLERANCE = 0.03
SMALLEST = 1e-12  # of the largest value, beside 0


def scene_input(seed: int) -> Input:
    """A scene, and its torque."""
    text = extreme_scene(np.random.default_rng(seed))
    return Input("scene", text.encode(), lambda: require_finite(friction_torque(parse_scene(text, origin="")).rows))


def require_finite(result: object) -> None:
    """Raise SilentError for a number that is not finite anywhere in a result."""
    for place, number in numbers(plain(result)):
        if not np.isfinite(number):
            raise SilentError(f"{place} = {number}")


def numbers(node: object, place: str = "") -> Iterator[tuple[str, float]]:
    """All floats in lists and dicts, with their places."""
    match node:
        case dict():
            for name, inside in node.items():
                yield from numbers(inside, f"{place}.{name}")
        case list() | tuple():
            for index, inside in enumerate(node):
                yield from numbers(inside, f"{place}[{index}]")
        case float():
            yield place, node


def extreme_scene(rng: np.random.Generator) -> str:
    """The text of a scene file."""
    document = base(rng)
    here = [key for key in keys() if at(document, key.path) is not None]
    tables = [key for key in keys() if isinstance(at(document, key.path.rpartition(".")[0]), dict)]
    for _ in range(min(int(rng.geometric(0.5)), MOST_CHANGES)):
        place = rng.random()
        choices = here if place < 0.6 else tables if place < 0.9 else keys()
        key = choices[rng.integers(len(choices))]
        try:
            document = with_key(document, key.path, value_of(key, at(document, key.path), rng))
        except InputError:  # a material that stands there by its name
            continue
    return toml(document)


def base(rng: np.random.Generator) -> dict[str, Any]:
    kind = rng.integers(3)
    if kind == 0:
        return radial_scene(rng.random(RADIAL_INPUTS).tolist(), tolerance=TOLERANCE)
    if kind == 1:
        names = bearing_names()
        return tomllib.loads(template(names[rng.integers(len(names))]))
    document = tomllib.loads(SHIPPED[rng.integers(len(SHIPPED))].read_text("utf-8"))
    if "cage" in document:
        document["cage"].pop("start", None)  # its motion takes as long as the user likes
    return document


@cache
def keys() -> list[Key]:
    """The keys that take a quantity, a number or one of some words."""
    known = [
        scene_key(path)
        for path in sorted(scene_table().paths())  # not in the order of declarations, which may change
        if path not in LEFT_ALONE and not path.startswith(WITHOUT_MEANING)
    ]
    return [key for key in known if key.dimension is not None or words_of(key) or key.path == "bearing.ball_count"]


def words_of(key: Key) -> list[object]:
    """The words that a key takes."""
    if isinstance(key.kind, Switch):
        return [True, False]
    return [*key.kind.words] if isinstance(key.kind, Word) else []


def value_of(key: Key, given: object, rng: np.random.Generator) -> object:
    """A value that the reader admits for this key."""
    if key.dimension is None:
        words = words_of(key)
        return words[rng.integers(len(words))] if words else int(rng.choice([1, 2, 3, 5, 40, 1000]))
    low, high = float(key.dimension.low), float(key.dimension.high)
    try:
        known = key.read(given[0] if isinstance(given, list) else given)
    except (ValueError, InputError):
        known = None
    if isinstance(known, float) and known != 0 and rng.random() < 0.6:
        number = float(np.clip(known * 10 ** rng.uniform(-DECADES, DECADES), low, high))
    elif rng.random() < 0.3:
        number = float(rng.choice([low, high]))
    else:
        most = max(abs(low), high)
        least = low if low > 0 else SMALLEST * most
        number = float(np.exp(rng.uniform(np.log(least), np.log(most))))
        number *= -1 if high <= 0 or (low < 0 and rng.random() < 0.5) else 1
        number = float(np.clip(number, low, high))
    unit = key.dimension.unit
    return f"{number!r} {unit}" if unit else number


def at(document: dict[str, Any], path: str) -> Any:
    """What stands at a path; None: nothing."""
    node: Any = document
    for part in path.split(".") if path else ():
        node = node.get(part) if isinstance(node, dict) else None
    return node
