"""The grid of a block: cells that its far boundary asks for, depths of layers; and the groove of a washer."""

from dataclasses import replace

import numpy as np
import pytest

from fembearing.mesh.bodies import Block
from fembearing.mesh.patch import depth_lines
from fembearing.mesh.race import race_height
from fembearing.mesh.recipe import Depth, load_recipe
from tests.contacts import INNER

SMALL, LARGE = 0.13e-3, 0.91e-3  # m, of an ellipse


def block(reach: float, scale: float = 1.0) -> Block:
    axes = (scale * SMALL, scale * LARGE)
    return Block(recipe=load_recipe("race"), level=2, semi_axes=axes, reach=scale * reach)


def test_a_block_has_as_many_cells_at_any_scale() -> None:
    reach = 0.7  # m, far beyond what the recipe's own cells reach
    assert block(reach).whole == block(reach, scale=37.0).whole
    assert block(reach).growth == pytest.approx(block(reach, scale=37.0).growth, rel=1e-12)


def test_a_farther_boundary_has_a_cell_more_for_each_factor_of_the_recipe() -> None:
    growth = load_recipe("race").domain.growth
    near, far = (block(0.7 * growth**steps).whole for steps in (0, 3))
    assert far.outside - near.outside == 2 * 3  # on level 2
    assert far.depth - near.depth == 2 * 3
    assert (far.core, far.inside, far.margin) == (near.core, near.inside, near.margin)


def test_a_body_that_even_layers_go_through_has_even_layers_alone() -> None:
    """Half of the layers down to 3 minor semi-axes of 0.2 mm: they would end at 1.2 mm, below a wall of 0.7 mm."""
    lines = depth_lines(3, depth=Depth(layer=3.0, share=0.5), minor=0.2e-3, extent=0.7e-3)
    np.testing.assert_allclose(lines, 0.7e-3 * np.arange(7) / 6, rtol=1e-12, atol=1e-18)  # round-off


def test_layers_are_even_down_to_their_depth_and_end_at_the_far_boundary() -> None:
    """Half of eight layers go to 2.5 minor semi-axes of 0.2 mm, 0.125 mm each; the others grow to 7 mm."""
    corners = depth_lines(8, depth=Depth(layer=2.5, share=0.5), minor=0.2e-3, extent=7e-3)[::2]
    thickness = np.diff(corners)
    np.testing.assert_allclose(thickness[:4], 0.125e-3, rtol=1e-12)  # round-off
    assert np.all(np.diff(thickness[3:]) > 0)
    np.testing.assert_allclose((corners[0], corners[-1]), (0.0, 7e-3), rtol=1e-10)  # tolerance of the growth's root


WASHER = replace(
    INNER, rolling_radius=np.inf, contact_angle=np.pi / 2, shoulder=1.7e-3, far_shoulder=1.4e-3, groove_radius=4.2e-3
)


def test_a_washer_is_the_limit_of_ever_larger_rings() -> None:
    x, y = np.meshgrid(np.linspace(-2e-3, 2e-3, 5), np.linspace(-2.2e-3, 2.2e-3, 9))
    height = race_height(WASHER, x, y)
    for side in (1, -1):
        ring = race_height(replace(WASHER, rolling_radius=side * 1e3, contact_angle=0.0), x, y)
        np.testing.assert_allclose(height, ring, atol=1e-8)  # x^2/2R is 2e-9 m, rise^2/2R less
    profile = 4.2e-3 - np.sqrt(4.2e-3**2 - np.clip(y, -1.4e-3, 1.7e-3) ** 2)
    np.testing.assert_allclose(height, profile, rtol=1e-9, atol=1e-15)  # round-off of a small difference
