"""Peer: NGSolve, quadratic hexahedra pressed on a rigid paraboloid. The refinement is the level of our mesh recipe.

By symmetry, each of two equal half spaces is pressed against a rigid paraboloid with half the gap. The pressure is a
penalty times the penetration; the set of penetrating points is updated until it carries the load. `sparsecholesky` was
the fastest direct solver of NGSolve: UMFPACK took five times as long with 20 000 unknowns.
"""

from typing import Any

import netgen.meshing as netgen  # pyright: ignore[reportMissingImports]
import ngsolve as ng  # pyright: ignore[reportMissingImports]
import numpy as np

from validation.peers.ours import quarter
from validation.peers.peer import peak_pressure

PENALTY = 1e5  # times E over the minor semi-axis: the paraboloid sinks in by 1e-5 of the approach
MOST_ROUNDS = 40
BALANCED = 1e-9  # of the load
NAMES = ("x", "y", "far", "contact", "free")  # of the outer faces
FACES = ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))  # by corners
ng.ngsglobals.msg_level = 0


def solve(case: dict[str, Any], level: int) -> dict[str, Any]:
    mesh = meshed(case, level)
    modulus, ratio = case["youngs_modulus"], case["poisson_ratio"]
    lam, mu = modulus * ratio / ((1 + ratio) * (1 - 2 * ratio)), modulus / (2 * (1 + ratio))
    a, b = case["semi_axes"]
    space = ng.VectorH1(mesh, order=2, dirichletx="x|far", dirichlety="y|far", dirichletz="far")
    u, v = space.TnT()
    strain_u, strain_v = ng.Sym(ng.Grad(u)), ng.Sym(ng.Grad(v))
    elastic = (2 * mu * ng.InnerProduct(strain_u, strain_v) + lam * ng.div(u) * ng.div(v)) * ng.dx
    gap = (case["curvature_x"] * ng.x**2 + case["curvature_y"] * ng.y**2) / 4
    penalty = PENALTY * modulus / min(a, b)
    surface = ng.ds("contact", bonus_intorder=2)
    field = ng.GridFunction(space)
    field.Set(far_field(case), definedon=mesh.Boundaries("far"))
    held, load_on, closed, freed = (field.vec.CreateVector() for _ in range(4))
    held.data = field.vec
    touches = ng.IfPos(1 - (ng.x / a) ** 2 - (ng.y / b) ** 2, 1, 0)
    with ng.TaskManager():
        for _ in range(MOST_ROUNDS):
            spring = penalty * touches
            matrix = ng.BilinearForm(space, symmetric=True, condense=True)
            matrix += elastic + spring * u[2] * v[2] * surface
            matrix.Assemble()
            by_gap = ng.LinearForm(spring * gap * v[2] * surface).Assemble().vec
            by_approach = ng.LinearForm(-spring * v[2] * surface).Assemble().vec
            inverse = matrix.mat.Inverse(space.FreeDofs(True), inverse="sparsecholesky")
            # The displacement is linear in the approach, which follows from the load.
            load_on.data = by_gap - matrix.mat * held
            closed.data = held + inverse * load_on
            freed.data = inverse * by_approach
            fixed = ng.Integrate(spring * gap * surface, mesh) + ng.InnerProduct(by_approach, closed)
            stiffness = ng.Integrate(spring * surface, mesh) - ng.InnerProduct(by_approach, freed)
            approach = (case["load"] / 4 + fixed) / stiffness
            field = ng.GridFunction(space)  # a new one, as the set of touching points depends on the old one
            field.vec.data = closed + approach * freed
            penetration = approach - gap + field[2]
            touches = ng.IfPos(penetration, 1, 0)
            pressure = touches * penalty * penetration
            if abs(ng.Integrate(pressure * surface, mesh) / (case["load"] / 4) - 1) < BALANCED:
                break
        else:
            raise RuntimeError(f"the contact did not converge in {MOST_ROUNDS} rounds")
    axes = tuple(
        float(5 * ng.Integrate(pressure * position**2 * surface, mesh) / (case["load"] / 4)) ** 0.5
        for position in (ng.x, ng.y)
    )
    rule = ng.IntegrationRule(ng.ET.QUAD, 4)
    points = mesh.MapToAllElements(rule, mesh.Boundaries("contact"))
    x, y, values, size = (np.ravel(part(points)) for part in (ng.x, ng.y, pressure, ng.specialcf.mesh_size))
    area = size**2 * np.tile([point.weight for point in rule], x.size // len(rule))
    return {
        "semi_axis_x": axes[0],
        "semi_axis_y": axes[1],
        "peak_pressure": peak_pressure(x, y, values, area, semi_axes=axes),
        "approach": 2 * approach,
        "unknowns": sum(space.FreeDofs()),
    }


def meshed(case: dict[str, Any], level: int) -> ng.Mesh:
    """The cells of our quarter with straight edges and named outer faces."""
    block = quarter(case, level)
    used, cells = np.unique(block.cells[:, :8], return_inverse=True)
    cells, position = cells.reshape(-1, 8), block.position[used]
    top, touching, far = block.top[used], block.touching[used], block.far[used]
    mesh = netgen.Mesh(dim=3)
    points = [mesh.Add(netgen.MeshPoint(netgen.Pnt(*place))) for place in position.tolist()]
    for number, name in enumerate(NAMES):
        mesh.Add(netgen.FaceDescriptor(surfnr=number + 1, domin=1, bc=number + 1))
        mesh.SetBCName(number, name)
    faces = cells[:, FACES].reshape(-1, 4)
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    planes = (position[:, 0] < 1e-9 * position.max(), position[:, 1] < 1e-9 * position.max(), far)
    for face in faces[first[count == 1]]:
        if top[face].all():
            name = "contact" if touching[face].any() else "free"
        else:
            name = NAMES[next(number for number, plane in enumerate(planes) if plane[face].all())]
        mesh.Add(netgen.Element2D(NAMES.index(name) + 1, [points[node] for node in face]))
    for cell in cells:
        mesh.Add(netgen.Element3D(1, [points[node] for node in cell]))
    return ng.Mesh(mesh)


def far_field(case: dict[str, Any]) -> ng.CoefficientFunction:
    """Boussinesq's displacement, m, of four point loads with the second moments of the pressure."""
    ratio = case["poisson_ratio"]
    scale = case["load"] / 4 * (1 + ratio) / (2 * np.pi * case["youngs_modulus"])
    shifts = [axis / 5**0.5 for axis in case["semi_axes"]]
    total = ng.CF((0, 0, 0))
    for x in (ng.x - shifts[0], ng.x + shifts[0]):
        for y in (ng.y - shifts[1], ng.y + shifts[1]):
            distance = ng.sqrt(x**2 + y**2 + ng.z**2)
            sideways = -ng.z / distance**3 - (1 - 2 * ratio) / (distance * (distance - ng.z))
            inwards = ng.z**2 / distance**3 + 2 * (1 - ratio) / distance
            total = total + scale * ng.CF((sideways * x, sideways * y, -inwards))
    return total
