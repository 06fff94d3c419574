"""The twin of a contact against the exact half spaces, against scale, and against finer meshes."""

from dataclasses import asdict, replace

import numpy as np
import pytest

from analytic.scene import Contact, Material
from fembearing.check.contact.refinement import COMPARED
from fembearing.fem import twin
from fembearing.fem.compliance import sampled_pair
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.half_space import contact_modulus, hertz_ellipse
from fembearing.fem.pixel_contact import press_pair
from fembearing.fem.solution import pressed
from fembearing.fem.twin import shared_axes
from fembearing.mesh.recipe import load_recipe
from tests.contacts import CONTACTS, INNER, OUTER, PEEK

RECIPE = load_recipe("race")


def scaled(contact: Contact, *, length: float, modulus: float) -> Contact:
    """The same shape in another size and another stiffness: pressures as `modulus`."""

    def stiffer(material: Material) -> Material:
        return replace(material, youngs_modulus=modulus * material.youngs_modulus)

    lengths = ("ball_radius", "groove_radius", "rolling_radius", "shoulder", "far_shoulder")
    return replace(
        contact,
        **{name: length * getattr(contact, name) for name in lengths},
        load=modulus * length**2 * contact.load,
        ball_material=stiffer(contact.ball_material),
        race_material=stiffer(contact.race_material),
    )


def axes_of(contact: Contact) -> tuple[float, float]:
    return shared_axes(expected_semi_axes(contact, geometry="real"))


def test_a_nearly_flat_contact_needs_no_more_than_its_twin() -> None:
    """At 1e-3 N the bodies are half spaces: the pair adds nothing to them, where a mesh alone is off by 0.3 %."""
    contact = replace(OUTER, load=1e-3, groove_radius=4.9e-3)
    modulus = contact_modulus(contact)
    curvatures = 1 / contact.ball_radius + 1 / contact.rolling_radius, 1 / contact.ball_radius - 1 / 4.9e-3
    a, b = hertz_ellipse(curvatures, load=1e-3, modulus=modulus)
    _, pair = sampled_pair(contact, recipe=RECIPE, level=2, semi_axes=axes_of(contact))
    found = press_pair(pair, load=contact.load)
    exact = {"semi_axis_rolling": a, "semi_axis_transverse": b, "peak_pressure": 3e-3 / (2 * np.pi * a * b)}
    for name, value in exact.items():
        # 0.01 %: a hundredth of the error of this level. On the cells of a block the twin of the ball leaves 0.07 %.
        assert getattr(found.quantities, name) == pytest.approx(value, rel=1e-4), name


def test_the_twin_does_not_depend_on_size_and_stiffness() -> None:
    """A contact 3 times as large and 0.7 times as stiff meets the same half spaces, solved once."""
    contact = INNER
    other = scaled(contact, length=3.1, modulus=0.7)
    twin._condensed.cache_clear()
    first, second = (
        sampled_pair(each, recipe=RECIPE, level=1, semi_axes=axes_of(each))[1] for each in (contact, other)
    )
    assert twin._condensed.cache_info().misses == 2  # the ball's and the race's half space
    # Round-off of the difference between bodies and twin, which is a tenth of both
    np.testing.assert_allclose(3.1 * 0.7 * second.added, first.added, rtol=1e-7, atol=1e-9 * np.abs(first.added).max())


def test_a_mesh_with_a_twin_has_one_of_few_axis_ratios() -> None:
    for semi_axes in ((0.11e-3, 0.93e-3), (0.31e-3, 0.31e-3), (0.9e-3, 0.2e-3)):
        rolling, transverse = shared_axes(semi_axes)
        steps = np.log(transverse / rolling) / twin.STEP
        assert steps == pytest.approx(round(steps), abs=1e-9)
        assert rolling * transverse == pytest.approx(semi_axes[0] * semi_axes[1], rel=1e-12)
        np.testing.assert_allclose((rolling, transverse), semi_axes, rtol=twin.STEP / 4 * 1.01)


@pytest.mark.parametrize("pair", ["inner", "outer"])
def test_two_levels_of_the_compliance_agree_far_better_than_two_plain_ones(pair: str) -> None:
    contact = replace(CONTACTS[pair], race_material=PEEK, load=20.0)
    plain, pixels = [], []
    for level in (1, 2):
        bodies, compliance = sampled_pair(contact, recipe=RECIPE, level=level, semi_axes=axes_of(contact))
        plain.append(asdict(pressed(bodies, load=contact.load, expected=bodies.pair.semi_axes).quantities))
        pixels.append(asdict(press_pair(compliance, load=contact.load).quantities))
    changes = [max(abs(coarse[name] / fine[name] - 1) for name in COMPARED) for coarse, fine in (plain, pixels)]
    assert changes[1] < changes[0] / 8  # ten and more on the calibration contacts


def test_a_twin_follows_an_extended_block() -> None:
    """Added cells change the error of the mesh: without their own twin they would seem to change a tiny contact."""
    contact = replace(INNER, load=1e-3)
    plain, pixels = [], []
    for far in (False, True):
        bodies, compliance = sampled_pair(contact, recipe=RECIPE, level=1, semi_axes=axes_of(contact), extended=far)
        plain.append(pressed(bodies, load=contact.load, expected=bodies.pair.semi_axes).quantities.approach)
        pixels.append(press_pair(compliance, load=contact.load).quantities.approach)
    assert abs(plain[1] / plain[0] - 1) > 2e-4
    assert abs(pixels[1] / pixels[0] - 1) < abs(plain[1] / plain[0] - 1) / 3  # half spaces have no far boundary
