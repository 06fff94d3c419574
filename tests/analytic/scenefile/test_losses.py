"""The table [losses] of a scene."""

import pytest

from analytic import catalog
from analytic.errors import InputError
from analytic.scene import Losses, Scene, ShearedLand, ShearedPockets
from analytic.scenefile.read import parse_scene

PLAIN = catalog.path("scenes", "6205-dry").read_text("utf-8")
SEALED = """
name = "sealed"
tolerance = "5 %"
[bearing]
catalog = "6205-2RS1"
inner.shoulder_diameter = "34 mm"
[operation]
axial_load = "200 N"
inner_speed = "300 rpm"
[friction]
coefficient = 0.1
[losses]
seals = "estimate"
"""


def read(text: str) -> Scene:
    return parse_scene(text, origin="here")


def test_a_scene_file_declares_losses() -> None:
    found = read(PLAIN + '\n[losses]\nseals = "5 N mm"\ndrag = "0.3 N cm"\n')
    assert found.losses == Losses(seals=5e-3, drag=3e-3)
    assert read(PLAIN).losses == Losses()
    for line, words in (
        ('seals = "-5 N mm"', r"losses\.seals = '-5 N mm' is out of range"),
        ("seals = 5", r"losses\.seals = 5 has no unit"),
        ('seal = "5 N mm"', r"losses\.seal = '5 N mm' is an unknown key; did you mean seals"),
        ('drag = "5 N"', r"losses\.drag = '5 N' is not in a unit like N m"),
    ):
        with pytest.raises(InputError, match=words):
            read(f"{PLAIN}\n[losses]\n{line}\n")


def test_the_oil_outside_the_contacts_is_read() -> None:
    found = read(
        PLAIN + '\n[losses]\noil_share = "3 %"\noil_flow = "0.6 l/min"\n'
        'land = { ring = "outer", diameter = "45 mm", clearance = "0.3 mm", width = "4 mm" }\n'
        'pockets = { clearance = "0.2 mm", thickness = "1.7 mm" }\n'
    ).losses
    land = ShearedLand(ring="outer", diameter=45e-3, clearance=0.3e-3, width=4e-3)
    assert (found.land, found.pockets) == (land, ShearedPockets(clearance=0.2e-3, thickness=1.7e-3))
    assert (found.oil_share, found.oil_flow) == (0.03, pytest.approx(1e-5, rel=1e-14))  # one rounding


def test_estimated_seals_touch_the_inner_shoulder() -> None:
    """0.023 d^2.25 + 2 N mm of RS1 seals [SKF2018], d of 34 mm: given, or by the chord of the groove there."""
    found = read(SEALED)
    expected = 1e-3 * (0.023 * 34**2.25 + 2)
    assert found.losses.seals == pytest.approx(expected, rel=1e-10)  # the shoulder passes through its half-width
    origin = found.losses.origins["seals"]
    assert origin.status == "assumed"
    assert origin.source == "SKF's formula for RS1 seals [SKFSeals], on a diameter of 34 mm"
