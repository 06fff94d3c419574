"""A scene at other temperatures of its oil, and scenes whose oil is not known there."""

import pytest

from analytic.scenefile.read import parse_by_temperature, parse_scene
from tests.analytic.scenefile.scene_texts import PLAIN, SURFACE, refusal
from tests.refusals import refused

OILED = f'{PLAIN}[lubricant]\nname = "ISO VG 46"\ntemperature = "55 degC"\n{SURFACE}'
THERMAL = '[thermal]\nresistance = "0.5 K/W"\nambient = "20 degC"\n'
PAIR = 'viscosity = ["46 cSt at 40 degC", "6.8 cSt at 100 degC"]\nbase_oil = "mineral"'


def test_the_oil_is_read_again_at_another_temperature() -> None:
    read = parse_by_temperature(OILED, origin="here")
    warm = parse_scene(OILED.replace("55 degC", "70 degC"), origin="here")
    assert read.at(343.15).lubricant == warm.lubricant
    assert read.fixed.lubricant == parse_scene(OILED, origin="here").lubricant != warm.lubricant
    refused(lambda: read.at(463.15), "here: oil at 190 degC: lubricant.temperature must be -40 to 140 degC")


def test_without_an_oil_there_is_no_other_temperature() -> None:
    refused(lambda: parse_by_temperature(PLAIN, origin="here").at(320.0), "here: the scene has no [lubricant]; give")


def test_friction_warms_an_oil_that_is_known_at_every_temperature() -> None:
    for lines in ('name = "ISO VG 46"', PAIR):
        read = parse_by_temperature(f"{PLAIN}[lubricant]\n{lines}\n{SURFACE}{THERMAL}", origin="here")
        assert read.thermal is not None
        refused(lambda: read.fixed, "here: the scene has [thermal]", "or run fembearing torque")  # noqa: B023


@pytest.mark.parametrize(
    ("lines", "words"),
    [
        (
            "",
            "thermal = {'ambient': '20 degC', 'resistance': '0.5 K/W'} warms the oil, and the scene has no [lubricant]",
        ),
        (
            '[lubricant]\nviscosity = "60 mPa s"\nbase_oil = "mineral"\n',
            "lubricant.viscosity = '60 mPa s' is known at one",
        ),
    ],
)
def test_friction_warms_no_other_oil(lines: str, words: str) -> None:
    assert words in refusal(PLAIN + lines + THERMAL)
