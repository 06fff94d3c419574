"""Stresses under the centre of a computed contact, and their maxima: where rolling-contact fatigue begins.

Depth runs from the centre of the contact along the load into the body; tensile stress is positive. On the axis, where
the two planes of symmetry meet, the rolling (x), the transverse (y) and the load direction (z) are principal.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from skfem import Basis, ElementHex2

from analytic.errors import InputError
from analytic.scene import Array, Material
from fembearing.fem.condensation import held_stiffness, middle_plane
from fembearing.fem.elasticity import lame_parameters
from fembearing.fem.solution import MeshSolution
from fembearing.mesh.bodies import BodyMesh

Side = Literal["upper", "lower"]
DEEPEST = 3.0  # end of a curve, in minor semi-axes; both maxima lie within 0.8
POINTS = 301  # in a curve
# Two points in each direction. There the stress in a quadratic cell is one order more accurate than elsewhere
# [Barlow1976], and there the change of volume of a nearly incompressible body is integrated too.
GAUSS = (1 + np.array([-1.0, 1.0]) / np.sqrt(3)) / 2


@dataclass(frozen=True, kw_only=True, eq=False)
class SubsurfaceStress:
    """Stresses of one body on the contact's axis."""

    depth: Array  # (n,) m, from 0, even steps
    stress: Array  # (3, n) along x, y and z, Pa
    max_shear: Array  # (n,) (sigma_1 - sigma_3)/2, Pa
    von_mises: Array  # (n,) Pa
    greatest_shear: float  # Pa
    greatest_shear_depth: float  # m
    greatest_von_mises: float  # Pa
    greatest_von_mises_depth: float  # m


def subsurface_stress(solution: MeshSolution, *, side: Side = "lower") -> SubsurfaceStress:
    """Stresses on the axis of a body of a solved contact, to 3 minor semi-axes or to its far side if that is nearer.

    side : "upper" is the ball, "lower" the race, seat or sheet
    The body is solved once more under the contact forces. In each layer under the centre, a fit even in x and y takes
    the stresses from the Gauss points of the cell to the axis. A cubic spline with one knot for each layer, half as
    many as there are points, smooths the remaining oscillation within a cell.
    Raises InputError for half a contact: its axis lies in one plane of symmetry only, so that x, y and z are not
    principal directions there.
    Larger stresses may occur off the axis, at the edge of the contact; they are not computed.
    """
    if solution.pair.footprint.half:
        raise InputError(
            f"{solution.contact.pair}: no stress below the contact, which is cut off at one shoulder and has no axis "
            "of symmetry to find the greatest on; lower the load or the contact angle"
        )
    body, material = body_of(solution, side)
    displacement = body_displacement(solution, side=side)
    place, stresses = _stress_at_axis(body, displacement, material)
    minor = min(solution.pair.semi_axes)  # of the mesh: the measured ones are 0 where a single node touches
    lines = _layers(body)
    degree = min(3, lines.size - 1)  # with fewer than three layers there are too few points for a cubic

    def powers(depth: Array) -> Array:
        """(n, k) all splines are sums of these columns, each a power that sets in at a knot."""
        # Layers are even near the surface and grow below it; in this coordinate all are about even.
        even, knots = np.arcsinh(depth / minor)[:, None], np.arcsinh(lines / minor)
        return np.hstack([even ** np.arange(float(degree)), np.maximum(even - knots[:-1], 0.0) ** degree])

    spline = np.linalg.lstsq(powers(place), stresses)[0]
    depth = np.linspace(0.0, min(DEEPEST * minor, lines[-1]), POINTS)
    stress = (powers(depth) @ spline).T
    shear, mises = _max_shear(stress), von_mises(stress)
    greatest_shear, shear_depth = _greatest(depth, shear, lambda at: _max_shear((powers(at) @ spline).T))
    greatest_mises, mises_depth = _greatest(depth, mises, lambda at: von_mises((powers(at) @ spline).T))
    return SubsurfaceStress(
        depth=depth,
        stress=stress,
        max_shear=shear,
        von_mises=mises,
        greatest_shear=greatest_shear,
        greatest_shear_depth=shear_depth,
        greatest_von_mises=greatest_mises,
        greatest_von_mises_depth=mises_depth,
    )


def body_displacement(solution: MeshSolution, *, side: Side) -> Array:
    """Displacement (3, nodes), m, of a body's mesh under the forces and the far field of a solved contact.

    As in `condense`, the displacement of half a ball is relative to its middle plane, which is held transversely.
    """
    pair = solution.pair
    body, material = body_of(solution, side)
    system = held_stiffness(body, material=material, semi_axes=pair.semi_axes, shoulders=pair.footprint.shoulders)
    direction = -pair.normal if side == "upper" else pair.normal
    push = system.forces(body.touching, direction) @ solution.force
    plane = middle_plane(system, body) if body.pinned else 0 * push
    transverse = float(direction[1] @ solution.force)
    # The forces act on the meshed part of the body; the far field is that of the whole load.
    moved = system.displacement(push - transverse * plane, load=solution.contact.load)
    moved[1] -= plane @ moved.ravel()[system.free]
    return moved


def body_of(solution: MeshSolution, side: Side) -> tuple[BodyMesh, Material]:
    """The mesh and the material of a body of a contact."""
    if side == "upper":
        return solution.pair.upper, solution.contact.ball_material
    return solution.pair.lower, solution.contact.race_material


def _stress_at_axis(body: BodyMesh, displacement: Array, material: Material) -> tuple[Array, Array]:
    """Depths (p,), m, increasing, two in each layer, and the stresses (p, 3) along x, y and z there, Pa."""
    axis = _axis(body)
    cells = np.flatnonzero(np.isin(body.mesh.t[:2], axis).all(axis=0))  # the first edge of a cell runs along depth
    points = np.array(np.meshgrid(GAUSS, GAUSS, GAUSS, indexing="ij")).reshape(3, -1)
    basis = Basis(body.mesh, ElementHex2(), elements=cells, quadrature=(points, np.ones(points.shape[1])))
    strain = [basis.interpolate(part).grad[i] for i, part in enumerate(displacement)]  # along x, y, z alone
    lam, mu = lame_parameters(material)
    stress = lam * sum(strain) + 2 * mu * np.array(strain)

    x, y, z = np.asarray(basis.global_coordinates())
    known = np.array([np.abs(z), *stress]).reshape(4, cells.size, 4, 2)  # four points in x and y, two along depth
    square = np.array([np.ones_like(x), (x / x.max()) ** 2, (y / y.max()) ** 2]).reshape(3, cells.size, 4, 2)
    to_axis = np.linalg.pinv(square.transpose(1, 3, 2, 0))[:, :, 0]  # (cells, 2, 4): value of the even fit at x = y = 0
    depth, *parts = np.einsum("clp,qcpl->qcl", to_axis, known).reshape(4, -1)
    order = np.argsort(depth)
    return depth[order], np.array(parts).T[order]


def _axis(body: BodyMesh) -> NDArray[np.intp]:
    """The nodes on both planes of symmetry."""
    return np.intersect1d(body.planes[0], body.planes[1])


def _layers(body: BodyMesh) -> Array:
    """Depths of the faces of the layers on the axis, m, beginning with 0; middle nodes are left out."""
    return np.sort(np.abs(body.mesh.doflocs[2, _axis(body)]))[::2]


def _max_shear(stress: Array) -> Array:
    """(sigma_1 - sigma_3)/2 of principal stresses (3, ...)."""
    return (stress.max(axis=0) - stress.min(axis=0)) / 2


def von_mises(stress: Array) -> Array:
    """Equivalent stress, Pa, of stresses xx, yy, zz, and xy, yz, xz unless the three are principal, (3 or 6, ...)."""
    xx, yy, zz, *shear = stress
    normal = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    return np.sqrt(normal / 2 + 3 * np.square(shear).sum(axis=0))


def _greatest(depth: Array, values: Array, measure: Callable[[Array], Array]) -> tuple[float, float]:
    """The largest value of a curve, refined between its points, and its depth, m."""
    top = int(np.argmax(values))
    between = np.linspace(depth[max(top - 1, 0)], depth[min(top + 1, depth.size - 1)], POINTS)
    refined = measure(between)
    top = int(np.argmax(refined))
    return float(refined[top]), float(between[top])
