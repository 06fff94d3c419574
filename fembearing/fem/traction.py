"""What pressure and tractions on a contact do to one body, sampled under a few of them.

A load is sqrt(1 - x^2/a^2 - y^2/b^2) times a power of x/a and of y/b, along rolling, across it, or along the normal. A
quarter of a body bears each of them with the conditions of its parity: where the mirror image of a load at x = 0 is the
load itself, that plane keeps its normal displacement at 0, and where the image is the opposite load, the other two.

The far boundary of a block, a race or half a space, has the exact displacement of a half space under the same forces:
Boussinesq's and Cerruti's. A tangential load of the ball is reacted at its middle plane, which is clamped; under a load
that is its own image at both planes the middle plane only stays plane, as between two races. So a displacement is one
against the ball's middle plane and the race's far field. Rigid shifts in it have no part in friction, whose creepages
are given.
"""

from dataclasses import dataclass, replace
from itertools import product
from typing import Literal

import numpy as np

from analytic.scene import Array, Material
from fembearing.fem.condensation import HeldBody, nodal_forces
from fembearing.fem.elasticity import cell_stiffness
from fembearing.fem.farfield import loaded_surface
from fembearing.fem.topology import topology_of
from fembearing.mesh.bodies import BodyMesh

Axis = Literal[0, 1, 2]
ALONG: Axis = 0
ACROSS: Axis = 1
NORMAL: Axis = 2
Parity = tuple[bool, bool]  # whether a load is its own mirror image at x = 0, and at y = 0
PARITIES: tuple[Parity, ...] = ((True, True), (True, False), (False, True), (False, False))


@dataclass(frozen=True)
class Term:
    """A polynomial load or displacement: a component, and powers of places in semi-axes."""

    axis: Axis  # along rolling, across, or along the normal
    of_x: int
    of_y: int

    @property
    def parity(self) -> Parity:
        """Whether it is its own mirror image at x = 0, and at y = 0."""
        return (self.of_x + (self.axis == ALONG)) % 2 == 0, (self.of_y + (self.axis == ACROSS)) % 2 == 0


def worked(
    body: BodyMesh, *, material: Material, directions: Array, terms: tuple[Term, ...], force: Array, depth: int = 1
) -> Array:
    """Work of each load on the displacement by each other one, on a quarter of a body.

    body : a quarter of a ball, of the block of a race, or of a half space
    directions : (3, 3, m) unit vectors along which loads of each axis push the touching nodes
    force : (m, terms) on the touching nodes, N;  depth : 1 or -1, sign of z inside the body
    The work, (terms, terms), N m, is 0 between loads of unlike parity, and symmetric as far as the far boundary fits
    the mesh.
    """
    entries, work = cell_stiffness(body.mesh, material), np.zeros((len(terms), len(terms)))
    for parity in PARITIES:
        own = [number for number, term in enumerate(terms) if term.parity == parity]
        pushed = np.stack([directions[terms[number].axis] * force[:, number] for number in own], axis=-1)
        far = _far_displacement(body, pushed, parity, material=material, depth=depth)
        moved = _displacement(body, entries, pushed, parity, far)
        work[np.ix_(own, own)] = np.einsum("amk,aml->kl", pushed, moved)
    return work


def _far_displacement(body: BodyMesh, pushed: Array, parity: Parity, *, material: Material, depth: int) -> Array:
    """Displacement (3, far, k) of a half space at the far nodes of a block under the forces and their images."""
    upright = np.array([1, 1, depth])[:, None]
    place, loaded = upright * body.mesh.doflocs[:, body.far], body.mesh.doflocs[:2, body.touching]
    inwards, total = upright[..., None] * pushed, np.zeros((3, body.far.size, pushed.shape[2]))
    for side in product((1, -1), repeat=2):
        sign = np.prod([1 if own or each > 0 else -1 for own, each in zip(parity, side, strict=True)])
        image = sign * np.array([*side, 1])[:, None, None] * inwards
        total += loaded_surface(place, np.array(side)[:, None] * loaded, image, material=material)
    return upright[..., None] * total


def _displacement(body: BodyMesh, entries: Array, pushed: Array, parity: Parity, far: Array) -> Array:
    """Displacement (3, m, k), m, of the touching nodes.

    entries : `cell_stiffness`;  pushed : (3, m, k), N;  far : (3, far, k), m
    """
    cells, count = body.mesh.dofs.element_dofs, body.mesh.doflocs.shape[1]
    is_held = np.zeros((3, count), dtype=bool)
    for axis, own in enumerate(parity):
        still = [axis] if own else [other for other in range(3) if other != axis]
        for component in still:
            is_held[component, body.planes[axis]] = True
    is_held[slice(2 if all(parity) else 0, 3), body.planes[2]] = True
    is_held[:, body.far] = True
    topology = topology_of(cells, is_held)
    none = np.zeros((3, count))
    system = HeldBody(
        name=body.name, topology=topology, upper=topology.assembled(entries), far_force=none.ravel(), held=none
    )
    moved = np.empty_like(pushed)
    for number in range(pushed.shape[2]):
        held, push = none.copy(), none.copy()
        held[:, body.far], push[:, body.touching] = far[..., number], pushed[..., number]
        far_force = -nodal_forces(held, cells, entries)[topology.free]
        loaded = replace(system, far_force=far_force, held=held)
        moved[..., number] = loaded.displacement(push.ravel()[topology.free], load=1.0)[:, body.touching]
    return moved
