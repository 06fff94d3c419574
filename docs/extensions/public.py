"""What is public: what the packages export, the classes of data that it takes or returns, and what these hold."""

import dataclasses
import inspect
import typing
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any

from matplotlib.figure import Figure

import analytic
import analytic.scene_torque as scene_torque
import fembearing
from analytic import errors
from analytic.prediction.prediction import Prediction

PACKAGES = (analytic, fembearing)


def is_ours(one: object) -> bool:
    return inspect.isclass(one) and one.__module__.partition(".")[0] in ("analytic", "fembearing")


def classes_in(annotation: object) -> Iterator[type]:
    named = typing.get_origin(annotation) or annotation
    if is_ours(named):
        yield named  # type: ignore[misc]
    for part in typing.get_args(annotation):
        if part is not Ellipsis:
            yield from classes_in(part)


@cache
def hints(of: Callable[..., Any]) -> dict[str, Any]:
    late = {scene_torque.SceneTorque: {"Prediction": Prediction}, fembearing.draw_bearing: {"Figure": Figure}}
    return typing.get_type_hints(of, localns=late.get(of))  # imported for a type alone


def exported() -> Iterator[Callable[..., Any]]:
    for package in PACKAGES:
        yield from (getattr(package, name) for name in package.__all__)


@cache
def public_classes() -> tuple[type, ...]:
    found: dict[type, None] = {}
    waiting: list[Callable[..., Any]] = list(exported())
    while waiting:
        one = waiting.pop()
        if inspect.isclass(one):
            if one in found or not dataclasses.is_dataclass(one):
                continue
            found[one] = None
        for name, annotation in hints(one).items():
            if not name.startswith("_"):
                waiting += classes_in(annotation)
    raised = (one for one in vars(errors).values() if is_ours(one) and one.__module__ == errors.__name__)
    return *found, *raised
