"""A half space as a block with a flat surface."""

from typing import Literal

import numpy as np

from fembearing.mesh.bodies import Block, BodyMesh, body_mesh
from fembearing.mesh.footprint import Footprint
from fembearing.mesh.patch import contact_zone, patch_mesh


def flat_block(block: Block, footprint: Footprint, *, side: Literal[1, -1]) -> BodyMesh:
    """A half space on the grid of `block`.

    side : 1 for the upper body, which lies at z > 0; -1 for the lower one
    """
    patch = patch_mesh(block.cells, ends=footprint.ends, half=footprint.half)
    plane = block.plane(patch, contact_zone(patch, shape=block.recipe.patch, footprint=footprint))
    return body_mesh("half space", patch, block.stack(patch, plane, np.zeros_like(plane[0]), side=side))
