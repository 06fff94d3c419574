"""Peer in its ordinary workflow: NGSolve as its tutorial "Contact Problems" teaches.

The block is meshed by Netgen, finely where it may touch, with curved tetrahedra of order 2; it is fixed below, free
aside, and held by symmetry. The contact is an energy of the penetration, quadratic with a penalty, and is minimised by
Newton's method. The block has the size of the tutorial's in radii of its contact, 180 by 90. The tutorial's penalty
lets the bodies overlap by more than they approach; here it is stiff. By symmetry, one of two equal bodies is pressed
against a rigid paraboloid with half the gap; the approach is found from the load. The refinement is the number of
elements along the minor semi-axis.
"""

from typing import Any

from validation.peers.peer import Solve, peak_pressure, semi_axis, serve

WIDTH, DEPTH = 180, 90  # of the block, in minor semi-axes
COARSE = 30  # largest size of a tetrahedron, in minor semi-axes
PATCH = 1.5  # semi-axes of the finely meshed part of the surface, in those of the contact
PENALTY = 1e3  # times E over the minor semi-axis: the paraboloid sinks in by 0.04 % of the approach
ORDER = 2
MM = 1e3  # in a metre: the geometry has an absolute tolerance of 1e-7
MOST_ROUNDS = 10
BALANCED = 1e-4  # of the load


def load() -> Solve:
    import netgen.occ as occ  # pyright: ignore[reportMissingImports]
    import ngsolve as ng  # pyright: ignore[reportMissingImports]
    import numpy as np
    from ngsolve.solvers import NewtonMinimization  # pyright: ignore[reportMissingImports]

    ng.ngsglobals.msg_level = 0

    def solve(case: dict[str, Any], elements: int) -> dict[str, Any]:
        a, b = (MM * axis for axis in case["semi_axes"])
        mesh = meshed(a, b, size=a / elements)
        modulus, ratio = case["youngs_modulus"] / MM**2, case["poisson_ratio"]
        lam, mu = modulus * ratio / ((1 + ratio) * (1 - 2 * ratio)), modulus / (2 * (1 + ratio))
        space = ng.VectorH1(mesh, order=ORDER, dirichletx="x|fix", dirichlety="y|fix", dirichletz="fix")
        u = space.TrialFunction()
        strain = ng.Sym(ng.Grad(u))
        gap = (case["curvature_x"] * ng.x**2 + case["curvature_y"] * ng.y**2) / (4 * MM)
        penalty, approach = PENALTY * modulus / a, ng.Parameter(0.0)
        surface = ng.ds("contact", bonus_intorder=2)
        overlap = approach - gap + u[2]
        form = ng.BilinearForm(space, symmetric=True)
        energy = mu * ng.InnerProduct(strain, strain) + lam / 2 * ng.Trace(strain) ** 2
        form += ng.Variation(energy.Compile() * ng.dx)
        form += ng.Variation(ng.IfPos(overlap, penalty / 2 * overlap**2, 0) * surface)
        field = ng.GridFunction(space)

        def pressure() -> Any:
            overlap = approach - gap + field[2]
            return ng.IfPos(overlap, penalty * overlap, 0)

        def force(value: float) -> float:
            approach.Set(value)
            NewtonMinimization(a=form, u=field, printing=False, inverse="sparsecholesky")
            return ng.Integrate(pressure() * surface, mesh)

        wanted = case["load"] / 4
        # The load of a contact grows with the power 1.5 of the approach.
        value = 0.5 * case["load"] * (1 - ratio**2) / (modulus * (a * b) ** 0.5)
        with ng.TaskManager():
            for _ in range(MOST_ROUNDS):
                found = force(value)
                if abs(found / wanted - 1) < BALANCED:
                    break
                value *= (wanted / found) ** (2 / 3)
            else:
                raise RuntimeError(f"the approach did not converge in {MOST_ROUNDS} rounds")
        rule = ng.IntegrationRule(ng.ET.TRIG, 4)
        points = mesh.MapToAllElements(rule, mesh.Boundaries("contact"))
        x, y, values, size = (np.ravel(part(points)) for part in (ng.x, ng.y, pressure(), ng.specialcf.mesh_size))
        area = size**2 * np.tile([point.weight for point in rule], x.size // len(rule))
        axes = semi_axis(x, values * area), semi_axis(y, values * area)
        return {
            "semi_axis_x": axes[0] / MM,
            "semi_axis_y": axes[1] / MM,
            "peak_pressure": peak_pressure(x, y, values, area, semi_axes=axes) * MM**2,
            "approach": 2 * value / MM,
            "unknowns": sum(space.FreeDofs()),
        }

    def meshed(a: float, b: float, *, size: float) -> ng.Mesh:
        """A quarter of the block, the contact in the corner on top."""
        width, depth = WIDTH * a + b, DEPTH * a
        block = occ.Box(occ.Pnt(0, 0, -depth), occ.Pnt(width, width, 0))
        block.faces.Min(occ.X).name, block.faces.Min(occ.Y).name = "x", "y"
        block.faces.Min(occ.Z).name = "fix"
        patch = occ.WorkPlane().Rectangle(PATCH * a, PATCH * b).Face()
        patch.name, patch.maxh = "contact", size
        return ng.Mesh(occ.OCCGeometry(occ.Glue([block, patch])).GenerateMesh(maxh=COARSE * a)).Curve(ORDER)

    return solve


if __name__ == "__main__":
    serve(load)
