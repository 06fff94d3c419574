"""Scene files of thrust bearings: what they take, and what they refuse in one line."""

import re

import numpy as np
import pytest

from tests.analytic.scenefile.scene_texts import changed, refusal, scene

THRUST = """\
name = "thrust"
tolerance = "4 %"
[bearing]
kind = "thrust"
ball_count = 13
ball_diameter = "7.1 mm"
pitch_diameter = "39 mm"
conformity = 0.53
[operation]
axial_load = "700 N"
inner_speed = "90 rpm"
[friction]
coefficient = 0.1
"""


def test_the_circle_of_the_balls_is_that_of_both_grooves() -> None:
    read = scene(THRUST)
    bearing = read.bearing
    assert (bearing.kind, bearing.inner, bearing.pitch_diameter) == ("thrust", bearing.outer, 39e-3)
    assert bearing.inner.bottom_radius == 19.5e-3
    np.testing.assert_allclose(bearing.inner.groove_radius, 0.53 * 7.1e-3, rtol=1e-15)  # one rounding
    assert (read.contact_angle.rule, read.contact_angle.value) == ("given", np.pi / 2)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('pitch_diameter = "39 mm"', "", "bearing.pitch_diameter is missing"),
        ('"39 mm"', '"7 mm"', "bearing.pitch_diameter.*must exceed ball_diameter 7.1 mm"),
        ("conformity = 0.53", "", "groove_radius is missing"),
        ("conformity = 0.53", 'conformity = 0.53\nclearance = "5 um"', 'bearing.clearance.*kind = "radial"'),
        ("conformity = 0.53", 'conformity = 0.53\ncontact_angle = { nominal = "60 deg" }',
            'bearing.contact_angle.*kind = "radial"'),
        ("conformity = 0.53", 'conformity = 0.53\nouter = { bottom_radius = "19 mm" }',
            'bearing.outer.bottom_radius.*kind = "radial"'),
        ("conformity = 0.53", "inner = { conformity = 0.53 }\nouter = { conformity = 0.54 }",
            "bearing.outer.groove_radius.*two equal grooves"),
        ("conformity = 0.53",
            'conformity = 0.53\ninner = { shoulder_height = "3.6 mm" }\nouter = { shoulder_height = "3.6 mm" }',
            "washers touch"),
        ("conformity = 0.53", 'conformity = 0.53\nbore_diameter = "40 mm"', "bearing.bore_diameter.*below"),
        ("conformity = 0.53", 'conformity = 0.53\noutside_diameter = "38 mm"', "bearing.outside_diameter.*exceed"),
        ('"90 rpm"', '"90 rpm"\nradial_load = "2 N"', "operation.radial_load.*axial_load alone"),
        ('"90 rpm"', '"90 rpm"\nmoment = "-2 N m"', "operation.moment.*axial_load alone"),
        ('"90 rpm"', '"90 rpm"\ntilt = "1 mrad"', "operation.tilt.*washers are parallel"),
        ("[friction]", '[mounting]\nshaft_interference = "5 um"\n[friction]', "mounting.*not modelled for a thrust"),
        ("[friction]", '[arrangement]\nkind = "O"\npreload = "5 N"\n[friction]', "arrangement.*not modelled for a"),
        ('kind = "thrust"', 'kind = "axial"', "bearing.kind"),
    ],
)  # fmt: skip
def test_what_does_not_go_with_washers_is_refused_in_one_line(old: str, new: str, words: str) -> None:
    said = refusal(changed(old, new, THRUST))
    assert re.search(words, said), said
    assert "\n" not in said


CAGE = """\
[cage]
pocket_clearance = "0.2 mm"
wall_thickness = "0.6 mm"
mass = "3 g"
material = "peek"
"""


@pytest.mark.parametrize("key", ['start = "rest"', 'land = { ring = "outer", clearance = "0.3 mm", width = "5 mm" }'])
def test_a_cage_rests_on_its_balls(key: str) -> None:
    assert scene(THRUST + CAGE).cage is not None
    said = refusal(THRUST + CAGE + key)
    assert re.search(f"cage.{key.split()[0]}.*not modelled in a thrust bearing", said), said
