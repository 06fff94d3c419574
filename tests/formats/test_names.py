"""Names of files that mean something else to the program that reads them, and the name that is proposed instead."""

import re
from pathlib import Path

import pytest

from fembearing.formats.choice import FormatName, export
from tests.refusals import message_of

OVER = {"speed": "300 rpm to 900 rpm in 2", "radial_load": "700 N"}
BALANCED = {"friction.spin_rule": "balanced"}
WRONG: dict[FormatName, str] = {
    "ross": "ross.py class.py numpy.py test.py json.py 6206.py bearing-2.py",
    "modelica": "end.mo package.mo model.mo Real.mo der.mo Modelica.mo 6206.mo bearing-2.mo gr\xf6.mo",
    "simscape": "end.m 6206.m bearing-2.m friction.m _.m " + 64 * "a" + ".m",
}


@pytest.mark.parametrize("to", WRONG)
def test_a_name_that_cannot_be_read_is_refused_with_one_that_can(to: FormatName, tmp_path: Path) -> None:
    message = ""
    for name in WRONG[to].split():
        message = message_of(lambda name=name: export("6206", to=to, out=tmp_path / name, over=OVER))
        assert name in message
        assert list(tmp_path.iterdir()) == []
    proposed = re.search(r"give for example '(.+)'", message)
    assert proposed
    assert export("6206", to=to, out=proposed[1], over=OVER, settings=BALANCED).file.parent == tmp_path


def test_other_formats_have_any_name(tmp_path: Path) -> None:
    assert export("6206", to="csv", out=tmp_path / "class-2.csv", over=OVER, settings=BALANCED).file.exists()
