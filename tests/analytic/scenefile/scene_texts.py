"""Short scene files, which the tests read, change or garble; and functions that read them."""

import pytest

from analytic.errors import InputError
from analytic.scene import Scene
from analytic.scenefile.read import parse_scene

PLAIN = """\
name = "a series"
tolerance = "2 %"
[bearing]
catalog = "paper_6205"
contact_angle = { rule = "solved" }
[operation]
axial_load = "700 N"
inner_speed = ["100 rpm", "30 deg/s"]
"""
MINE = """\
name = "mine"
tolerance = "4 %"
[bearing]
catalog = "paper_6205"
contact_angle = { rule = "given", value = "0.2 rad" }
[operation]
axial_load = "700 N"
inner_speed = "90 rpm"
[friction]
coefficient = 0.1
"""
INLINE = """\
name = "by hand"
tolerance = 0.03
[bearing]
name = "hybrid"
ball_count = 11
ball_diameter = "6 mm"
ball_mass = "0.36 g"
ball_material = { name = "ceramic", youngs_modulus = "310 GPa", poisson_ratio = 0.27, density = "3.2 g/cm^3" }
contact_angle = { rule = "given", value = "15 deg" }
[bearing.inner]
bottom_radius = "12 mm"
groove_radius = "3.1 mm"
shoulder_half_width = "2 mm"
material = "steel"
[bearing.outer]
bottom_radius = "18.01 mm"
groove_radius = "3.2 mm"
shoulder_half_width = "2.1 mm"
material = "peek"
[operation]
axial_load = ["12 kgf", "1e-12 N"]
inner_speed = ["-200 rpm", "0 rpm"]
[cage]
pocket_diameter = "6.3 mm"
pocket_depth = "3.1 mm"
wall_thickness = "0.7 mm"
mass = "3 g"
material = "peek"
[effects]
spin = "off"
"""
LUBRICANT = """\
[lubricant]
viscosity = "60 mPa s"
pressure_viscosity = "2e-8 1/Pa"
eyring_stress = "5 MPa"
traction = "eyring_sinh"
"""
SURFACE = """\
[surface]
rms_roughness = "0.1 um"
autocorrelation = { kind = "gaussian", length = "60 um", spacing = "2 um" }
"""
OIL, ROUGH = PLAIN + LUBRICANT, PLAIN + SURFACE
OILED = PLAIN + LUBRICANT + SURFACE
SPEEDS = '["100 rpm", "30 deg/s"]'  # of PLAIN


def scene(text: str) -> Scene:
    return parse_scene(text, origin="case.toml")


def refusal(text: str) -> str:
    """The message that refuses the text."""
    with pytest.raises(InputError) as problem:
        scene(text)
    return str(problem.value)


def changed(old: str, new: str, text: str = PLAIN) -> str:
    """The text with the first `old` replaced by `new`."""
    assert old in text, "nothing to replace: the test would test nothing"
    return text.replace(old, new, 1)


MOVING = (  # with a cage that moves
    changed("90 rpm", "500 rpm", MINE)
    + """\
[cage]
pocket_clearance = "0.2 mm"
start = "rest"
duration = "0.01 s"
seeds = 2
[effects]
cage_dynamics = "on"
"""
)
