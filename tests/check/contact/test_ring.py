"""The ring's part of the approach from its meshes, and the message where there is none."""

import pytest

from analytic.errors import InputError
from analytic.scenefile.read import load_scene, parse_scene
from fembearing.check.contact.solution import solve_contact
from tests.analytic.specimens import present

UNSEATED = """
name = "no seats"
tolerance = 0.9
[bearing]
name = "hybrid"
ball_count = 9
ball_diameter = "7.94 mm"
ball_mass = "2.04 g"
ball_material = "steel"
contact_angle = { rule = "given", value = "0.3 rad" }
inner = { bottom_radius = "15.53 mm", groove_radius = "4.13 mm", shoulder_half_width = "3.1 mm", material = "steel" }
outer = { bottom_radius = "23.48 mm", groove_radius = "4.21 mm", shoulder_half_width = "3.1 mm", material = "steel" }
[operation]
axial_load = "900 N"
inner_speed = "100 rpm"
"""


@pytest.mark.slow
def test_the_ring_does_not_change_the_contact() -> None:
    scene = load_scene("6205-dry")
    plain, ringed = (solve_contact(scene, pair="inner", tolerance=0.9, geometry=shape) for shape in ("real", "ring"))
    ring = present(ringed.numbers.ring)
    # A second method, for the size alone: a bonded layer of the ring's thickness under a point load, whose integral of
    # 1 - L(k) over k is 1.377 at nu = 0.3: 0.23 um. The ellipse is as wide as the ring is thick, the shoulders carry.
    layer = 1.377 * 372.2 * (1 - 0.3**2) / (3.1416 * 206e9 * 3.03e-3)
    assert -1.1 * layer < ring.approach < -0.6 * layer
    assert ring.uncertainty < 0.1 * abs(ring.approach)
    assert (ringed.numbers.geometry, plain.numbers.ring) == ("ring", None)
    assert ringed.numbers.quantities == plain.numbers.quantities


def test_without_seats_the_error_names_the_missing_keys() -> None:
    scene = parse_scene(UNSEATED, origin="case.toml")
    with pytest.raises(InputError, match=r"inner: .* bearing\.bore_diameter and bearing\.width"):
        solve_contact(scene, pair="inner", geometry="ring")
