"""Stresses under the centre of a computed contact, and their maxima: where rolling-contact fatigue begins.

Depth runs from the contact's centre along the load into the body; a stress is positive in tension. The axis is where
the two planes of symmetry meet, so along rolling (x), across it (y) and along the load (z) are principal directions.
"""

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import make_lsq_spline
from scipy.optimize import minimize_scalar
from skfem import Basis, ElementHex2

from analytic.errors import InputError
from analytic.scene import Material
from fembearing.fem.condensation import held_stiffness, middle_plane
from fembearing.fem.elasticity import lame_parameters
from fembearing.fem.solution import MeshSolution
from fembearing.mesh.bodies import BodyMesh

Array = NDArray[np.float64]
Side = Literal["upper", "lower"]
DEEPEST = 3.0  # minor semi-axes that a curve covers; both maxima lie within 0.8
POINTS = 301  # of a curve
# A quadratic cell's stress is an order more accurate at these points than elsewhere (Barlow, 1976, not seen); 2 each
# way, which are also the points where the change of volume of a nearly incompressible body is integrated.
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
    The body is solved once more under the contact's forces. In each layer under the centre, stresses at the cell's
    Gauss points are brought to the axis by a fit even in x and y; a cubic spline with one knot a layer, half as many
    as there are points, smooths what still alternates within a cell.
    Raises InputError for half a contact: its axis lies in one plane of symmetry only, so that x, y and z are not the
    directions of principal stress there.
    Off the axis, at the edge of the contact, other stresses may be larger; they are not looked at.
    """
    if solution.pair.footprint.half:
        raise InputError(
            f"{solution.contact.pair}: no stress below the contact, which is cut off at one shoulder and has no axis "
            "of symmetry to find the greatest on; lower the load or the contact angle"
        )
    body, material = _body(solution, side)
    displacement = body_displacement(solution, side=side)
    place, sampled = _stress_at_axis(body, displacement, material)
    minor = min(solution.pair.semi_axes)  # the mesh's: those measured are 0 where a single node touches
    lines = _layers(body)

    def even(depth: Any) -> Any:
        return np.arcsinh(depth / minor)  # layers are even near the surface and grow below: here they are even again

    knots = even(lines)
    spline = make_lsq_spline(even(place), sampled, np.concatenate([[knots[0]] * 3, knots, [knots[-1]] * 3]), k=3)
    depth = np.linspace(0.0, min(DEEPEST * minor, lines[-1]), POINTS)
    stress = spline(even(depth)).T
    shear, mises = _max_shear(stress), _von_mises(stress)
    greatest_shear, shear_depth = _greatest(depth, shear, lambda at: float(_max_shear(spline(even(at)))))
    greatest_mises, mises_depth = _greatest(depth, mises, lambda at: float(_von_mises(spline(even(at)))))
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

    As `condense` tells it: half a ball moves as seen from its middle plane, which holds it across.
    """
    pair = solution.pair
    body, material = _body(solution, side)
    system = held_stiffness(body, material=material, semi_axes=pair.semi_axes, room=pair.footprint.room)
    towards = -pair.normal if side == "upper" else pair.normal
    push = system.forces(body.touching, towards) @ solution.force
    plane = middle_plane(system, body) if body.pinned else 0 * push
    across = float(towards[1] @ solution.force)
    # The forces are those on the meshed part of the body, the far field is that of the whole load.
    moved = system.displacement(push - across * plane, load=solution.contact.load)
    moved[1] -= plane @ moved.ravel()[system.free]
    return moved


def _body(solution: MeshSolution, side: Side) -> tuple[BodyMesh, Material]:
    if side == "upper":
        return solution.pair.upper, solution.contact.ball_material
    return solution.pair.lower, solution.contact.race_material


def _stress_at_axis(body: BodyMesh, displacement: Array, material: Material) -> tuple[Array, Array]:
    """Depths (p,), m, increasing, two a layer, and the stresses (p, 3) along x, y and z there, Pa."""
    axis = _axis(body)
    cells = np.flatnonzero(np.isin(body.mesh.t[:2], axis).all(axis=0))  # a cell's first edge runs along depth
    points = np.array(np.meshgrid(GAUSS, GAUSS, GAUSS, indexing="ij")).reshape(3, -1)
    basis = Basis(body.mesh, ElementHex2(), elements=cells, quadrature=(points, np.ones(points.shape[1])))
    strain = [basis.interpolate(part).grad[i] for i, part in enumerate(displacement)]  # along x, y, z alone
    lam, mu = lame_parameters(material)
    stress = lam * sum(strain) + 2 * mu * np.array(strain)

    x, y, z = np.asarray(basis.global_coordinates())
    known = np.array([np.abs(z), *stress]).reshape(4, cells.size, 4, 2)  # four points across, two along depth
    square = np.array([np.ones_like(x), (x / x.max()) ** 2, (y / y.max()) ** 2]).reshape(3, cells.size, 4, 2)
    to_axis = np.linalg.pinv(square.transpose(1, 3, 2, 0))[:, :, 0]  # (cells, 2, 4): the even fit's value at x = y = 0
    depth, *parts = np.einsum("clp,qcpl->qcl", to_axis, known).reshape(4, -1)
    order = np.argsort(depth)
    return depth[order], np.array(parts).T[order]


def _axis(body: BodyMesh) -> NDArray[np.intp]:
    """The nodes on both planes of symmetry."""
    return np.intersect1d(body.planes[0], body.planes[1])


def _layers(body: BodyMesh) -> Array:
    """Depths of the layers' faces on the axis, m, from the surface's 0; middle nodes left out."""
    return np.sort(np.abs(body.mesh.doflocs[2, _axis(body)]))[::2]


def _max_shear(stress: Array) -> Array:
    """(sigma_1 - sigma_3)/2 of principal stresses (3, ...)."""
    return (stress.max(axis=0) - stress.min(axis=0)) / 2


def _von_mises(stress: Array) -> Array:
    """Of principal stresses (3, ...)."""
    x, y, z = stress
    return np.sqrt(((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) / 2)


def _greatest(depth: Array, values: Array, measure: Any) -> tuple[float, float]:
    """The largest value of a curve, refined between its points, and its depth."""
    top = int(np.argmax(values))
    low, high = depth[max(top - 1, 0)], depth[min(top + 1, depth.size - 1)]
    sharp = 1e-6 * (high - low)  # m; SciPy's own, 1e-5, is no length of a contact
    found: Any = minimize_scalar(
        lambda at: -measure(at), bounds=(low, high), method="bounded", options={"xatol": sharp}
    )
    if -found.fun > values[top]:
        return float(-found.fun), float(found.x)
    return float(values[top]), float(depth[top])  # on the surface, where a search would only come near it
