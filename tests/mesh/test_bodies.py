"""The grid of a block: how many cells its far boundary asks for."""

import pytest

from fembearing.mesh.bodies import Block
from fembearing.mesh.recipe import load_recipe

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
