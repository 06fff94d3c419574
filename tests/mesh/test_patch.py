"""Depths of the layers under a contact."""

import numpy as np

from fembearing.mesh.patch import depth_lines
from fembearing.mesh.recipe import Depth


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
