"""Peer: NGSolve, quadratic hexahedra pressed on a rigid paraboloid. Refinement: level of our mesh recipe.

By symmetry each of two equal half spaces sees a rigid paraboloid of half the gap. The pressure is a penalty times the
penetration; the active set is renewed at the quadrature points until it carries the load.
"""

from typing import Any

from idealised import quarter
from peer import Solve, peak_pressure, semi_axis, serve

PENALTY = 1e5  # times E over the minor semi-axis: gives under the pressure by 1e-5 of the approach
MOST_ROUNDS = 40
BALANCED = 1e-9  # of the load
FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))


def load() -> Solve:
    import netgen.meshing as nm
    import ngsolve as ng
    import numpy as np
    from ngsolve import dx, x, y

    ng.ngsglobals.msg_level = 0

    def solve(case, level):
        import time
        T0=time.perf_counter()
        block = quarter(case, level)
        mesh, = make_mesh(block),
        a, b = case["semi_axes"]
        T1=time.perf_counter()
        E, nu = case["youngs_modulus"], case["poisson_ratio"]
        lam, mu = E*nu/((1+nu)*(1-2*nu)), E/2/(1+nu)
        quarter_load = case["load"]/4
        V = ng.VectorH1(mesh, order=2, dirichletx="x|far", dirichlety="y|far", dirichletz="far")
        u, v = V.TnT()
        gap = (case["curvature_x"]*x**2+case["curvature_y"]*y**2)/4
        gamma = PENALTY*E/min(a, b)
        surface = ng.ds("contact", bonus_intorder=2)
        state = ng.GridFunction(V)
        far(state, mesh, case)
        bc = state.vec.CreateVector(); bc.data = state.vec
        active = ng.IfPos(1-(x/a)**2-(y/b)**2, 1, 0)
        eps = lambda w: ng.Sym(ng.Grad(w))
        with ng.TaskManager():
          for its in range(MOST_ROUNDS):
            t0=time.perf_counter()
            K = ng.BilinearForm(V, symmetric=True, condense=True)
            K += (2*mu*ng.InnerProduct(eps(u), eps(v))+lam*ng.div(u)*ng.div(v))*dx
            K += gamma*active*u[2]*v[2]*surface
            K.Assemble()
            f = ng.LinearForm(gamma*active*gap*v[2]*surface).Assemble()
            c = ng.LinearForm(-gamma*active*v[2]*surface).Assemble()
            c0 = ng.Integrate(gamma*active*surface, mesh); g0 = ng.Integrate(gamma*active*gap*surface, mesh)
            t1=time.perf_counter()
            inv = K.mat.Inverse(V.FreeDofs(True), inverse=INV)
            t2=time.perf_counter()
            r = f.vec.CreateVector(); w1=f.vec.CreateVector(); w2=f.vec.CreateVector()
            r.data = f.vec - K.mat*bc
            w1.data = bc + inv*r
            w2.data = inv*c.vec
            d = (quarter_load+g0+ng.InnerProduct(c.vec, w1))/(c0-ng.InnerProduct(c.vec, w2))
            new = ng.GridFunction(V); new.vec.data = w1+d*w2
            pen = d-gap+new[2]
            p = ng.IfPos(pen, gamma*pen, 0)
            F = ng.Integrate(p*surface, mesh)
            import sys
            print(its, d, F/quarter_load-1, 'asm',round(t1-t0,3),'inv',round(t2-t1,3), file=sys.stderr)
            active = ng.IfPos(pen, 1, 0)
            if abs(F/quarter_load-1) < BALANCED: break
        T2=time.perf_counter()
        I = lambda q: ng.Integrate(q*surface, mesh)
        ax = (5*I(p*x**2)/F)**.5, (5*I(p*y**2)/F)**.5
        ir = ng.IntegrationRule(ng.QUAD, 4)
        pts = mesh.MapToAllElements(ir, mesh.Boundaries("contact"))
        px, py, pp = (np.ravel(q(pts)) for q in (x, y, p))
        w = np.tile([i.weight for i in ir], px.size//len(ir))
        jac = np.ravel(ng.specialcf.JacobianMatrix(3,2)(pts)) if 0 else 1
        pk = peak_pressure(px, py, pp, w*jac, semi_axes=ax)
        print('mesh',T1-T0,'newton',T2-T1,'post',time.perf_counter()-T2, file=sys.stderr)
        return {"semi_axis_x": ax[0], "semi_axis_y": ax[1], "peak_pressure": pk, "approach": 2*d, "unknowns": V.ndof}

    def make_mesh(block):
        m = nm.Mesh(dim=3)
        corners = block.cells[:, :8]
        used, cells = np.unique(corners, return_inverse=True); cells = cells.reshape(corners.shape)
        pos = block.position[used]
        ids = [m.Add(nm.MeshPoint(nm.Pnt(*p))) for p in pos.tolist()]
        names = ["x", "y", "far", "contact", "free"]
        for k, n in enumerate(names):
            m.Add(nm.FaceDescriptor(surfnr=k+1, domin=1, bc=k+1)); m.SetBCName(k, n)
        faces = cells[:, FACES].reshape(-1, 4)
        key = np.sort(faces, axis=1)
        _, first, count = np.unique(key, axis=0, return_index=True, return_counts=True)
        outer = faces[first[count == 1]]
        size = pos.max()
        flags = [pos[:, 0] < 1e-9*size, pos[:, 1] < 1e-9*size, block.far[used], None, None]
        top = block.top[used]; t = block.touching[used]
        for face in outer:
            if top[face].all(): k = 3 if t[face].any() else 4
            else: k = next(i for i in range(3) if flags[i][face].all())
            m.Add(nm.Element2D(k+1, [ids[i] for i in face]))
        for cell in cells: m.Add(nm.Element3D(1, [ids[i] for i in cell]))
        return ng.Mesh(m)

    def far(state, mesh, case):
        E, nu = case["youngs_modulus"], case["poisson_ratio"]
        scale = (1+nu)/(2*np.pi*E)
        parts = []
        a, b = case["semi_axes"]
        t = [0, 0, 0]
        for sx in (-1, 1):
          for sy in (-1, 1):
            X, Y, Z = x-sx*a/5**.5, y-sy*b/5**.5, -ng.z
            r = ng.sqrt(X**2+Y**2+Z**2)
            s = scale*(Z/r**3-(1-2*nu)/(r*(r+Z)))*case["load"]/4
            for i, q in enumerate((s*X, s*Y, -scale*(Z**2/r**3+2*(1-nu)/r)*case["load"]/4)): t[i] = t[i]+q
        state.Set(ng.CF(tuple(t)), definedon=mesh.Boundaries("far"))

    return solve

import os
INV=os.environ.get("INV","sparsecholesky"); PENALTY=float(os.environ.get("PEN","1e5"))
if __name__ == "__main__":
    serve(load)
