"""The tables [mounting] and [arrangement] of a scene file."""

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.mounting.clearance import Mounting, mounted
from analytic.scene import Arrangement, Scene
from analytic.scenefile.parts import material
from analytic.scenefile.read import parse_scene

SCENE = """\
name = "installed"
tolerance = "5 %"
[bearing]
catalog = "6205"
{bearing}
[operation]
axial_load = "{load} N"
inner_speed = "1000 rpm"
[friction]
coefficient = 0.1
"""
SEATS = '[mounting]\nshaft_interference = "12 um"\nhousing_interference = "-5 um"\n'
WARM = 'inner_temperature = "75 degC"\nouter_temperature = "65 degC"\n'


def scene(more: str, *, bearing: str = "", load: float = 500) -> Scene:
    return parse_scene(SCENE.format(bearing=bearing, load=load) + more, origin="here")


def test_a_scene_holds_the_bearing_in_operation_and_its_clearances() -> None:
    plain, found = scene("").bearing, scene(SEATS + WARM + 'shaft_bore = "8 mm"\nmounting_temperature = "22 degC"\n')
    steel = material("steel")
    mounting = Mounting(
        shaft_material=steel,
        housing_material=steel,
        shaft_interference=12e-6,
        housing_interference=-5e-6,
        shaft_bore=8e-3,
        inner_temperature=348.15,
        outer_temperature=338.15,
        mounting_temperature=295.15,
    )
    warm, clearances = mounted(plain, mounting)
    assert found.clearances == clearances
    assert found.bearing == warm
    assert found.bearing.diametral_clearance == clearances.operating < clearances.mounted < clearances.unmounted
    assert clearances.unmounted == plain.diametral_clearance
    assert scene("").clearances is None


def test_the_pocket_keeps_its_size() -> None:
    cage = '[cage]\npocket_clearance = "0.2 mm"\nwall_thickness = "0.9 mm"\nmass = "6 g"\nmaterial = "peek"\n'
    cold, warm = (scene(more + cage).cage for more in ("", SEATS + WARM))
    assert cold == warm


def test_a_nominal_angle_gives_the_clearance_that_the_seats_change() -> None:
    found = scene(SEATS, bearing='contact_angle = { nominal = "15 deg" }')
    assert found.clearances is not None
    distance = scene("").bearing.groove_centre_distance
    np.testing.assert_allclose(found.clearances.unmounted, 2 * distance * (1 - np.cos(np.radians(15))), rtol=1e-9)


def test_an_arrangement_is_read() -> None:
    found = scene('[arrangement]\nkind = "X"\noffset = "8 um"\ndistance = "40 mm"\n')
    assert found.arrangement == Arrangement(kind="X", offset=8e-6, distance=40e-3)
    assert scene('[arrangement]\nkind = "O"\npreload = "100 N"\n', load=0).operation.axial_load[0] == 0


@pytest.mark.parametrize(
    ("more", "bearing", "words"),
    [
        (SEATS, 'contact_angle = { free = "12 deg" }', r"bearing\.contact_angle\.free = '12 deg' leaves the clearance"),
        (SEATS, 'contact_angle = { rule = "given", value = "12 deg" }', r"fixes the contact angle, which \[mounting\]"),
        (SEATS + 'inner_temperature = "75 degC"\n', "", r"mounting\.outer_temperature is missing"),
        (SEATS + 'ball_temperature = "75 degC"\n', "", r"mounting\.ball_temperature = '75 degC' goes with"),
        (SEATS + 'shaft_bore = "30 mm"\n', "", r"mounting\.shaft_bore = '30 mm' must be below bearing.bore_diameter"),
        ('[mounting]\nshaft_interference = "12"\n', "", r"mounting\.shaft_interference = '12' .*12 um"),
        (SEATS + WARM + 'shaft_material = "peek"\n', "",
            r"mounting\.shaft_material = 'peek' 'peek' of the shaft has no"),
        ('[mounting]\nshaft_fit = "k5"\n', "",
            r"mounting\.shaft_fit = 'k5' is an unknown key; did you mean shaft_interference\?"),
        ('[mounting]\nhousing_fit = "H7"\n', "", r"did you mean housing_interference\?"),
        ('[arrangement]\nkind = "O"\n', "", r"arrangement = .* needs one of preload and offset"),
        ('[arrangement]\nkind = "tandem"\npreload = "9 N"\n', "", r"arrangement\.preload = '9 N' does not go"),
        ('[arrangement]\nkind = "O"\npreload = "9 N"\noffset = "3 um"\n', "",
            r"arrangement\.offset = '3 um' and preload both give the clamping of the pair; leave one of them out"),
        ('[arrangement]\nkind = "DB"\npreload = "9 N"\n', "", r"arrangement\.kind = 'DB' is .*; give \"O\" \(.*, DB\)"),
        ('[arrangement]\nkind = "DT"\npreload = "9 N"\n', "", r"arrangement\.kind = 'DT' is .* \"tandem\" \(DT\)"),
        ('[arrangement]\nkind = "O"\npreload = "9 N"\ndistance = "9 mm"\n', "",
            r"arrangement\.distance = '9 mm' must be at least bearing.width 15 mm"),
        ('[arrangement]\nkind = "O"\noffset = "3 mm"\n', "", r"arrangement\.offset = '3 mm' must be at most 685\.7 um"),
        ('[arrangement]\nkind = "X"\noffset = "0.5 mm"\n', 'inner = { shoulder_half_width = "2 mm" }',
            r"arrangement\.offset = '0.5 mm' must be at most .* um: there the balls reach a shoulder"),
        ('[arrangement]\nkind = "O"\npreload = "9 N"\n', 'contact_angle = { rule = "given", value = "12 deg" }',
            r"bearing\.contact_angle\.rule = 'given' fixes the contact angle, which the loads of a pair change"),
    ],
)  # fmt: skip
def test_a_mistake_is_one_line(more: str, bearing: str, words: str) -> None:
    with pytest.raises(InputError, match=words) as problem:
        scene(more, bearing=bearing)
    assert "\n" not in str(problem.value)


def test_the_largest_offset_is_that_of_the_shoulder() -> None:
    """The line between the groove centres is then at asin(w/r_g); |axial| = (A0 - P_d/2) tan of it, less the play."""
    found = scene("", bearing='inner = { shoulder_half_width = "2 mm" }').bearing
    distance, play = found.groove_centre_distance, found.diametral_clearance / 2
    steep, loose = np.arcsin(2e-3 / found.inner.groove_radius), np.arccos(1 - play / distance)
    most = 2 * (distance - play) * (np.tan(steep) - np.tan(loose)) * 1e6
    for offset, is_refused in ((most * 1.001, True), (most * 0.999, False)):
        more = f'[arrangement]\nkind = "O"\noffset = "{offset:.6f} um"\n'
        if is_refused:
            with pytest.raises(InputError, match=f"at most {most:.4g} um"):
                scene(more, bearing='inner = { shoulder_half_width = "2 mm" }')
        else:
            scene(more, bearing='inner = { shoulder_half_width = "2 mm" }')
