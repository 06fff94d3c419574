"""The twin of a contact: two half spaces on the same cells, whose exact answer shows the error of the mesh.

The pressure of a contact falls like a square root at its edge, where most of a mesh's error arises. Half spaces with
the same cells as the ball and the race share that error. They are pressed together over the paraboloid that, by the
exact solution for half spaces, touches in the ellipse of the contact. Exact over computed is the factor that corrects
each quantity of the contact.

Each half space has the columns and the layers of its body, with the surface in the plane tangent to it; its far
boundary is held by the exact displacement. What stays is the error that the shape of the bodies adds: about a tenth of
that of the mesh on the first level, and less on finer ones.
The twin counts lengths in rolling semi-axes of the mesh, and forces in E* times their square. Meshes of one axis ratio
and one reach share it.
"""

import math
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from scipy.sparse import csr_matrix

from analytic.scene import Array, Contact, Material
from fembearing.fem.condensation import CondensedBody, condense
from fembearing.fem.contact import press
from fembearing.fem.elasticity import surface_mass
from fembearing.fem.factor import solver_threads
from fembearing.fem.half_space import contact_modulus, curvatures_under, exact_quantities, plane_strain_modulus
from fembearing.fem.measure import Quantities, measured_quantities, nodal_pressure, product, ratio, within_ellipse
from fembearing.fem.solution import MeshSolution, solve_on_mesh
from fembearing.mesh.ball import block_of_ball, flat_ball
from fembearing.mesh.bodies import Block, BodyMesh
from fembearing.mesh.footprint import Footprint
from fembearing.mesh.half_space import flat_block
from fembearing.mesh.race import block_of_race
from fembearing.mesh.recipe import Recipe

GOOD = (0.1, 0.02)  # deviation of the corrected ellipse from that of its mesh, in semi-axes: first level, finer ones
FARTHEST = 0.3  # the same before the correction, beyond which an ellipse is not measured well enough to correct it
MOST_GUESSES = 3  # one is usual
STEP = 0.01  # of the logarithm of the axis ratio, by which the meshes of contacts with a twin differ
KEPT = 64  # half spaces of one process: 0.1 MB each on the second level, 2 MB on the fourth
ROUNDS = 3  # the twin's ellipse follows from its own factors; the third round changes them by less than 1e-6
QUARTERS = 4


@dataclass(frozen=True, kw_only=True, eq=False)
class TwinSolution:
    """A contact on one mesh, and what its twin says of that mesh."""

    mesh: MeshSolution  # its seconds with those of the twin
    factors: Quantities  # exact over computed of the twin

    @property
    def corrected(self) -> dict[str, float]:
        """Each quantity without the error that the twin shows."""
        return vars(product(self.mesh.quantities, self.factors))

    @property
    def ellipse(self) -> tuple[float, float]:
        """Corrected semi-axes, m."""
        return self.corrected["semi_axis_rolling"], self.corrected["semi_axis_transverse"]


def twin_on_level(contact: Contact, *, recipe: Recipe, level: int, start: tuple[float, float]) -> TwinSolution | None:
    """A contact of true shape on one level, on a mesh for its ellipse, with its twin.

    start : semi-axes of the first mesh, m
    None where a shoulder cuts the contact off, and where ellipse and mesh do not converge: a twin says nothing there.
    Raises InputError and ConvergenceError as `solve_on_mesh`.
    """
    semi_axes, good = shared_axes(start), GOOD[level > recipe.levels[0]]
    for _ in range(MOST_GUESSES):
        with ThreadPoolExecutor(1) as beside:
            if solver_threads() > 1:  # half spaces are condensed, and kept, while the contact is solved
                footprint = Footprint(semi_axes=semi_axes)
                beside.submit(twin_of, contact, recipe=recipe, level=level, footprint=footprint)
            mesh = solve_on_mesh(contact, recipe=recipe, level=level, semi_axes=semi_axes)
        begun = time.perf_counter()
        if mesh.pair.footprint.cut or _deviation(mesh.semi_axes, semi_axes) > FARTHEST:
            return None
        factors = twin_factors(mesh, recipe=recipe)
        mesh = replace(mesh, seconds=mesh.seconds + time.perf_counter() - begun)
        solution = TwinSolution(mesh=mesh, factors=factors)
        if _deviation(solution.ellipse, semi_axes) < good:
            return solution
        semi_axes = shared_axes(solution.ellipse)
    return None


def shared_axes(semi_axes: tuple[float, float]) -> tuple[float, float]:
    """Semi-axes, m, of nearly the same ellipse, with one of the axis ratios that meshes with a twin have."""
    rolling, transverse = semi_axes
    ratio = math.log(transverse / rolling)
    stretch = math.exp((STEP * round(ratio / STEP) - ratio) / 2)
    return rolling / stretch, transverse * stretch


def twin_factors(solution: MeshSolution, *, recipe: Recipe, extended: bool = False) -> Quantities:
    """Exact over computed of each quantity of the twin of a contact on a quarter that no shoulder cuts off.

    recipe : of the mesh of the contact
    extended : whether cells were added around its block
    """
    rolling, _ = solution.pair.semi_axes
    twin = twin_of(
        solution.contact, recipe=recipe, level=solution.level, footprint=solution.pair.footprint, extended=extended
    )
    measured = solution.quantities.semi_axis_rolling / rolling, solution.quantities.semi_axis_transverse / rolling
    factors = _factors(twin, measured)
    for _ in range(ROUNDS - 1):
        corrected = measured[0] * factors.semi_axis_rolling, measured[1] * factors.semi_axis_transverse
        factors = _factors(twin, corrected)
    return factors


@dataclass(frozen=True, kw_only=True, eq=False)
class Surface:
    """The surface of a meshed half space, on the m nodes that may touch."""

    x: Array  # (m,)
    y: Array  # (m,)
    mass: csr_matrix  # (m, m)
    area: Array  # (m,)


@dataclass(frozen=True, kw_only=True, eq=False)
class Twin:
    """Two half spaces in place of ball and race, reduced to the m nodes that may touch; in the twin's units."""

    surface: Surface
    compliance: Array  # (m, m)
    drift: Array  # (m,)


def twin_of(contact: Contact, *, recipe: Recipe, level: int, footprint: Footprint, extended: bool = False) -> Twin:
    """The twin on the cells of a contact; arguments as those of `solve_on_mesh`."""
    rolling, _ = footprint.semi_axes
    ball = _in_units(block_of_ball(contact, recipe, level, footprint), of=rolling)
    race = _in_units(block_of_race(contact, recipe, level, footprint, extended), of=rolling)
    above = _condensed(flat_ball, ball, contact.ball_material.poisson_ratio)
    below = _condensed(flat_race, race, contact.race_material.poisson_ratio)
    share = contact_modulus(contact) / plane_strain_modulus(contact.ball_material)
    return Twin(
        surface=_surface(race),
        compliance=share * above.compliance + (1 - share) * below.compliance,
        drift=share * above.drift + (1 - share) * below.drift,
    )


def _factors(twin: Twin, ellipse: tuple[float, float]) -> Quantities:
    """Exact over computed under a unit load whose exact semi-axes are `ellipse`."""
    x, y = twin.surface.x, twin.surface.y
    curvature_x, curvature_y = curvatures_under(ellipse, load=1.0, modulus=1.0)
    force, approach, _ = press(
        compliance=twin.compliance,
        drift=QUARTERS * twin.drift,
        gap=(curvature_x * x**2 + curvature_y * y**2) / 2,
        lever=np.ones_like(x),
        load=1 / QUARTERS,
        start=within_ellipse(x, y, ellipse),
    )
    pressure = nodal_pressure(force, twin.surface.mass)
    found = measured_quantities(x, y, force, pressure, twin.surface.area, load=1.0, approach=approach)
    return ratio(exact_quantities(ellipse, load=1.0, modulus=1.0), found)


def _deviation(ellipse: tuple[float, float], mesh: tuple[float, float]) -> float:
    """Of an ellipse from that of its mesh: the larger of |ratio of semi-axes - 1|."""
    return max(abs(part / whole - 1) for part, whole in zip(ellipse, mesh, strict=True))


def _in_units(block: Block, *, of: float) -> Block:
    """The block with lengths in units of a length, without round-off: equal blocks are the same key of a cache."""

    def share(length: float) -> float:
        return float(f"{length / of:.9g}")

    rolling, transverse = block.semi_axes
    return Block(
        recipe=block.recipe,
        level=block.level,
        semi_axes=(share(rolling), share(transverse)),
        reach=share(block.reach),
        further=None if block.further is None else share(block.further),
    )


@lru_cache(KEPT)
def _condensed(mesh: Callable[[Block], BodyMesh], block: Block, poisson_ratio: float) -> CondensedBody:
    """A half space with E/(1 - nu^2) = 1, on the cells that `mesh` makes of a block."""
    body = mesh(block)
    material = Material(
        name="half space",
        youngs_modulus=1 - poisson_ratio**2,
        poisson_ratio=poisson_ratio,
        density=1.0,
        source="unit of the twin",
    )
    inwards = np.tile([[0.0], [0.0], [1.0]], body.touching.size)
    return condense(body, material=material, force=inwards, semi_axes=block.semi_axes)


@lru_cache(KEPT)
def _surface(block: Block) -> Surface:
    body = flat_race(block)
    x, y, _ = body.mesh.doflocs[:, body.touching]
    mass = surface_mass(body.mesh, body.touching)
    return Surface(x=x, y=y, mass=mass, area=np.asarray(mass.sum(axis=1)).ravel())


def flat_race(block: Block) -> BodyMesh:
    """A half space on the grid of the block of a race."""
    return flat_block(block, Footprint(semi_axes=block.semi_axes))
