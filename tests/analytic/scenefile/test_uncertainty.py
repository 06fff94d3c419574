"""The table [uncertainty] of a scene: shares and standard deviations, and what is refused."""

import re

import pytest

from analytic.errors import InputError
from analytic.prediction.spreads import uncertain_inputs
from analytic.scenefile.read import parse_scene
from tests.analytic.scenefile.scene_texts import OILED


def test_a_spread_is_a_share_of_the_value_or_its_standard_deviation() -> None:
    lines = 'lubricant.viscosity = "6 %"\nlubricant.temperature = "3 K"\nbearing.clearance = "4 um"\n'
    scene = parse_scene(f"{OILED}[uncertainty]\n{lines}", origin="here")
    found = {each.key: each for each in uncertain_inputs(scene)}
    viscosity = found["lubricant.viscosity"]
    assert viscosity.deviation == pytest.approx(0.06 * viscosity.value, rel=1e-12)
    assert found["lubricant.temperature"].deviation == 3
    assert found["bearing.clearance"].deviation == pytest.approx(4e-6, rel=1e-12)


@pytest.mark.parametrize(
    ("lines", "complaint"),
    [
        ('lubricant.viscosity = "-6 %"', r"uncertainty.lubricant.viscosity = '-6 %' is out of range, 0 to 300 %; give"),
        ('lubricant.viscosity = "301 %"', r"is out of range, 0 to 300 %; give"),
        ('lubricant.viscosity = "9 Pa s"', r"is more than 300 % of the value, 0.\d+ Pa s"),
        ("lubricant.viscosity = 0.1", r"has no unit; give for example"),
        ('lubricant.viscocity = "6 %"', r"lubricant.viscocity = '6 %' is an unknown key; did you mean visc"),
        ('lubricant.temperature = "2 degC"', r"is out of range, 0 to 100 K; give for example \"2 K\""),
        ('bearing.clearance = "3 %"', r"is a share, but this input needs the standard deviation itself"),
        ('friction.coefficient = "3 %"', r"is of an input that this scene lacks"),
        # The 6205 has inner grooves of 0.519 times its balls, 0.019 above the tightest groove.
        ("bearing.inner.conformity = 0.07", r"= 0.07 is more than 300 % of the value above 0.5, 0.0\d+; an input that"),
    ],
)
def test_a_wrong_spread_gives_one_line(lines: str, complaint: str) -> None:
    with pytest.raises(InputError) as caught:
        parse_scene(f"{OILED}[uncertainty]\n{lines}\n", origin="here")
    assert re.search(complaint, str(caught.value)), caught.value
    assert "\n" not in str(caught.value)
    assert str(caught.value).count("uncertainty.") == 1
