"""Units as people write them, against their definitions; and ranges in the units of the examples."""

import math
import re
import subprocess
import sys
from dataclasses import replace

import pytest

from analytic import catalog
from analytic.quantity import COMMON, looked_up
from analytic.scenefile.keys import scene_key, scene_table

MINUTE, INCH, POUND = 2 * math.pi / 60, 0.0254, 0.45359237 * 9.80665  # rad/s, m, N: by definition
KEYS = {
    "speed": scene_key("operation.inner_speed"),
    "length": scene_key("bearing.ball_diameter"),
    "force": scene_key("operation.axial_load"),
    "moment": scene_key("operation.moment"),
    "pressure": scene_key("surface.hardness"),
    "temperature": scene_key("lubricant.temperature"),
}


@pytest.mark.parametrize(
    "unit",
    ["rpm", "RPM", "r/min", "1/min", "1 / min", "/min", "min-1", "min^-1", "min**-1", "min⁻¹", "U/min", "tr/min"],
)
def test_revolutions_per_minute(unit: str) -> None:
    assert KEYS["speed"].read(f"1251 {unit}") == pytest.approx(1251 * MINUTE, rel=1e-15)  # one rounding


def test_a_number_is_read_to_its_end() -> None:
    assert KEYS["speed"].read("12511/min") == pytest.approx(12511 * MINUTE, rel=1e-15)  # not 1251 and 1/min


@pytest.mark.parametrize(
    ("key", "written", "expected"),
    [
        ("length", "0.3 in", 0.3 * INCH),
        ("length", "0.3 inch", 0.3 * INCH),
        ("length", '0.3"', 0.3 * INCH),
        ("length", "70 um", 70e-6),
        ("length", "70 µm", 70e-6),  # the micro sign
        ("length", "70 \N{GREEK SMALL LETTER MU}m", 70e-6),
        ("length", "70 micron", 70e-6),
        ("force", "1.7 kN", 1700.0),
        ("force", "17 lbf", 17 * POUND),
        ("moment", "17 lbf in", 17 * POUND * INCH),
        ("moment", "17 N mm", 0.017),
        ("moment", "17 N·mm", 0.017),
        ("pressure", "17 psi", 17 * POUND / INCH**2),
        ("pressure", "17 ksi", 17e3 * POUND / INCH**2),
        ("pressure", "1700 N/mm2", 1.7e9),
        ("pressure", "1700 N/mm²", 1.7e9),
        ("temperature", "70 degC", 343.15),
        ("temperature", "70 °C", 343.15),
        ("temperature", "158 degF", 343.15),  # 158 = 70 * 9/5 + 32
    ],
)
def test_units_of_engineers(key: str, written: str, expected: float) -> None:
    assert KEYS[key].read(written) == pytest.approx(expected, rel=1e-15)  # one rounding


@pytest.mark.parametrize("name", COMMON)
def test_the_units_that_scenes_use_are_those_of_pint(name: str) -> None:
    ours, theirs = COMMON[name], looked_up("percent" if name == "%" else name)
    assert theirs is not None
    assert (ours.powers, ours.zero) == (theirs.powers, theirs.zero)
    assert float(ours.factor / theirs.factor - 1) == pytest.approx(0, abs=1e-27)  # of 28 digits


def test_scenes_that_ship_need_no_pint() -> None:
    names = [*catalog.names("scenes"), "6205", "7208B"]
    show = (
        "import sys, analytic\n"
        f"for name in {names!r}: analytic.load_scene(name)\n"
        "assert 'pint' not in sys.modules\n"
        "analytic.operation(axial_load='1 short_ton_force', inner_speed='1 turn/minute'); assert 'pint' in sys.modules"
    )
    subprocess.run([sys.executable, "-c", show], check=True)


def test_scales_that_are_not_even_have_no_units() -> None:
    for key in (*KEYS.values(), scene_key("friction.coefficient")):
        with pytest.raises(ValueError, match="unknown unit 'dB'"):
            key.read("7 dB")
    with pytest.raises(ValueError, match="is not in a unit like"):
        scene_key("lubricant.viscosity_temperature").read("0.04 1/degC")  # a scale with a zero of its own


@pytest.mark.parametrize(
    "written", ["7 Pa-s2", "7 mm22", "7 mm2^2", "7 N2^3", "7 /", "7 1/", '7 ""', '7 " s', "7 min--1"]
)
def test_the_grammar_stays_narrow(written: str) -> None:
    for key in KEYS.values():
        with pytest.raises(ValueError, match=r"is not a number and a unit|is not in a unit like"):
            key.read(written)


def test_every_example_is_within_its_range_and_names_the_unit_of_the_range() -> None:
    dimensions = [key.dimension for key in map(scene_key, scene_table().paths()) if key.dimension is not None]
    assert len(dimensions) > 40
    for dimension in dimensions:
        quoted = re.match('"([^"]*)"', dimension.example)
        value = dimension.read(quoted[1] if quoted else float(dimension.example))
        assert dimension.low <= value <= dimension.high
        unbounded, unit = replace(dimension, low=-math.inf, high=math.inf), dimension.shown_unit
        ends = re.match(r"(\S+) to (\S+) ?", dimension.span)
        assert ends, dimension.span
        told = [unbounded.read(f"{end} {unit}" if unit else float(end.rstrip(","))) for end in ends.groups()]
        assert told == pytest.approx([dimension.low, dimension.high], rel=1e-5)  # messages show six digits
