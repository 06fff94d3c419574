"""The ring's part of the approach from its meshes, and the message where there is none."""

from types import SimpleNamespace
from typing import Any

import pytest

from analytic.errors import InputError
from analytic.scenefile.read import load_scene, parse_scene
from fembearing.check.contact import meshed_region as module
from fembearing.check.contact.meshed_region import structure_of_ring
from fembearing.check.contact.solution import solve_contact
from fembearing.grid_convergence import Estimate
from fembearing.mesh.recipe import load_recipe
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


def test_the_infinite_half_space_takes_the_place_of_the_block(monkeypatch: pytest.MonkeyPatch) -> None:
    """By hand: ring less block -0.25 um; an infinite region softens the contact by 2 % of 5 um more, -0.35 um."""
    rings = {("free", 1): 1.7e-6, ("held", 1): 1.69e-6, ("free", 2): 1.75e-6}
    blocks = {1: 1.92e-6, 2: 2e-6}

    def ring(mesh: Any, *, end: str = "free", **_: object) -> float:
        return rings[end, mesh.level]

    monkeypatch.setattr(module, "ring_compression", ring)
    monkeypatch.setattr(module, "block_compression", lambda mesh: blocks[mesh.level])
    meshes: Any = [SimpleNamespace(level=level) for level in (1, 2, 3)]
    approach = Estimate(values=(4e-6, 4.9e-6, 5.1e-6), order=3.0, richardson=5e-6, mesh=0.1, beyond=0.02, domain=0.01)
    structure = structure_of_ring(meshes, approach, recipe=load_recipe("race"))
    assert structure.approach == pytest.approx(-0.35e-6, rel=1e-9)  # round-off of differences
    assert structure.share == pytest.approx(-0.35 / 5.1, rel=1e-9)
    assert structure.mesh == pytest.approx(0.01e-6, rel=1e-9)  # a third of -0.25 less -0.22
    assert structure.domain == pytest.approx(0.051e-6, rel=1e-9)  # 1 % of 5.1
    assert structure.reach == pytest.approx(0.01e-6, rel=1e-9)
    assert structure.uncertainty == pytest.approx(0.071e-6, rel=1e-9)


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
