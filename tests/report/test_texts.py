"""What people read has the units of engineers: no Pa beside GPa, no bare metres, no thousandths that mean percents."""

import re
from collections.abc import Iterator
from dataclasses import replace
from io import StringIO

import numpy as np
import pytest
from rich.console import Console

from analytic.errors import FembearingError
from analytic.result import FrictionTorque
from analytic.scene import ContactAngle, Operation
from analytic.scene_torque import SceneTorque, torque_of_scene
from analytic.torque import friction_torque
from fembearing.report.sections.torque import torque_sections
from fembearing.report.terminal import print_sections
from tests.analytic.cage.specimens import CAGED, with_cage
from tests.analytic.scenefile.scene_texts import OILED, SPEEDS, changed, scene

FORBIDDEN = {
    "pascals": r"\de[+-]?\d+ Pa\b|\d{4,} Pa\b",
    "metres": r"\d m\b(?!m)|\de-\d+ m\b",
    "radians a second": r"rad/s",
    "radians alone": r"\d rad\b(?!\))",  # those beside degrees stand in brackets
    "newton metres": r"\d N m\b",
    "kelvins of a temperature": r"\b[23]\d\d(\.\d+)? K\b",
    "shares of the torque": r"\b0?\.\d+ (of the torque|leaves|of a contact|of the static)",
    "a tolerance": r"tolerance(,| of)? 0?\.\d",
}
SCENES = {
    "oiled": OILED,
    "series": changed(SPEEDS, '["100 rpm", "900 rpm", "9000 rpm"]', OILED),
    "heavy": changed('"700 N"', '"16000 N"', OILED),
    "radial and moment": changed('"700 N"', '"500 N"\nradial_load = "900 N"\nmoment = "2 N m"', OILED),
    "light and fast": changed(SPEEDS, '"15000 rpm"', changed('"700 N"', '"30 N"', OILED)),
}


@pytest.mark.parametrize(
    "text",
    [
        "peak pressure 2.325e+09 Pa",
        "semi-axis 0.000957 m of",
        "at 3.1 rad/s",
        "beyond 0.83 rad",
        "moment 2.5 N m",
        "oil at 313.1 K",
        "at most 0.52 of the torque",
        "more than 0.025 leaves",
        "tolerance 0.05",
        "a tolerance of 0.05",
    ],
)
def test_every_form_is_seen(text: str) -> None:
    assert any(re.search(form, text) for form in FORBIDDEN.values())


def texts_of(found: FrictionTorque) -> Iterator[str]:
    yield from found.warnings
    yield from (effect.reason for effect in found.effects)
    yield from map(str, found.provenance.values())


@pytest.mark.parametrize("name", SCENES)
def test_texts_of_a_torque_have_no_forbidden_form(name: str) -> None:
    check(torque_of_scene(scene(SCENES[name])))


def test_texts_of_a_cage_have_none() -> None:
    operation = Operation(axial_load=np.array([1000.0]), radial_load=500.0, inner_speed=np.array([52.36]))
    scene = replace(CAGED, contact_angle=ContactAngle(rule="solved", free=0.18), operation=operation, effects={})
    check(torque_of_scene(with_cage(scene, pocket_diameter=8.14e-3)))


def check(result: SceneTorque) -> None:
    out = StringIO()
    print_sections(Console(file=out, width=200), torque_sections(result))
    for text in (*texts_of(result.friction), *result.notes, *out.getvalue().splitlines()):
        for what, form in FORBIDDEN.items():
            assert not re.search(form, text), f"{what}: {text}"


@pytest.mark.parametrize(
    "text",
    [
        changed('"700 N"', '"400000 N"', OILED),
        changed(SPEEDS, '"500000 rpm"', changed('"700 N"', '"1 N"', OILED)),
        changed('"700 N"', '"0 N"\nradial_load = "9e6 N"', OILED),
    ],
)
def test_refusals_have_none_either(text: str) -> None:
    with pytest.raises(FembearingError) as caught:
        friction_torque(scene(text))
    for what, form in FORBIDDEN.items():
        assert not re.search(form, str(caught.value)), f"{what}: {caught.value}"
