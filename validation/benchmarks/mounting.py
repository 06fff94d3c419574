"""How far a ring's groove moves when the ring is fitted: python validation/benchmarks/mounting.py

The model takes a ring as thick as its wall below the groove (`analytic.mounting`). This program solves rings with their
true section, groove and shoulders, by finite elements of the section about the axis: the inner ring on a solid shaft
three times as wide, the outer ring in a housing of twice its diameter, without friction between them. It prints the
change of the groove's diameter over the interference, beside that of the model and of a ring with the same area of
section. Needs a few seconds.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import block_diag, coo_array
from scipy.sparse.linalg import spsolve
from skfem import Basis, BilinearForm, ElementQuad2, ElementVector, MeshQuad
from skfem.helpers import ddot, grad

from analytic.mounting.thick_ring import ThickRing, fit_pressure
from analytic.scene import Material
from validation.study import out, run, show

STEEL = Material(name="steel", youngs_modulus=206e9, poisson_ratio=0.3, density=7850.0, source="usual values")
WIDER = 3.0  # shaft and housing, in widths of the ring
HOUSING = 2.0  # outside diameter of the housing over that of the ring


@dataclass(frozen=True, kw_only=True)
class Section:
    """A ring's section, mm."""

    name: str
    seat: float  # radius of bore or outside diameter
    bottom: float  # radius of the groove's bottom
    groove: float  # radius of the groove's profile
    shoulder: float  # half-width of the groove
    far_shoulder: float  # 0: none on this side
    width: float

    @property
    def sign(self) -> int:
        """1 of an inner ring, -1 of an outer one."""
        return 1 if self.bottom > self.seat else -1

    def surface(self, y: NDArray[np.float64]) -> NDArray[np.float64]:
        """Radius of the surface that faces the balls at a distance y from the middle of the groove."""
        reach = np.clip(y, -self.far_shoulder, self.shoulder)
        return self.bottom + self.sign * (self.groove - np.sqrt(self.groove**2 - reach**2))

    @property
    def mean_radius(self) -> float:
        """Radius of the surface of a plain ring with the same area of section."""
        y = np.linspace(-self.width / 2, self.width / 2, 20_001)
        return float(np.mean(self.surface(y)))


def main() -> None:
    heads = ("ring", "finite elements", "wall below the groove", "error", "same area of section", "error")
    rows = []
    for section in sections():
        exact = solved_ratio(section)
        plain = [lame_ratio(section, surface) for surface in (section.bottom, section.mean_radius)]
        cells = [cell for value in plain for cell in (f"{value:.3f}", f"{value / exact - 1:+.1%}")]
        rows.append((section.name, f"{exact:.3f}", *cells))
    show(heads, rows, "Change of the groove's diameter over the interference on the diameter")
    check = Section(name="plain", seat=12.5, bottom=16, groove=1e6, shoulder=1e-3, far_shoulder=1e-3, width=15.0)
    out.print(
        f"plain ring, shaft as wide: {solved_ratio(check, wider=1.0) / lame_ratio(check, 16.0) - 1:+.1e} off Lame"
    )


def sections() -> Iterator[Section]:
    """Inner and outer rings of a few bearings; shoulders 0.2 ball diameters high, grooves 0.52."""
    for name, bore, outside, width, ball, pitch in (
        ("608", 8, 22, 7, 3.969, 15.0),
        ("6205", 25, 52, 15, 7.938, 39.0),
        ("6210", 50, 90, 20, 12.7, 70.0),
        ("6308", 40, 90, 23, 15.081, 65.0),
        ("7014 spindle", 70, 110, 20, 12.7, 90.0),
    ):
        groove = 0.52 * ball
        half = float(np.sqrt(0.2 * ball * (2 * groove - 0.2 * ball)))
        common = {"groove": groove, "shoulder": half, "width": float(width)}
        yield Section(name=f"{name}, inner", seat=bore / 2, bottom=(pitch - ball) / 2, far_shoulder=half, **common)
        far = 0.0 if "spindle" in name else half
        yield Section(name=f"{name}, outer", seat=outside / 2, bottom=(pitch + ball) / 2, far_shoulder=far, **common)


def lame_ratio(section: Section, surface: float) -> float:
    """By Lame: the ring ends at this radius, the groove's bottom moves as the wall does there."""
    if section.sign > 0:
        inner = ThickRing(inner_radius=0.0, outer_radius=section.seat, material=STEEL)
        outer = ThickRing(inner_radius=section.seat, outer_radius=surface, material=STEEL)
        pressure = fit_pressure(inner, outer, interference=1.0)
        return 2 * outer.displacement(section.bottom, inside=pressure)
    inner = ThickRing(inner_radius=surface, outer_radius=section.seat, material=STEEL)
    outer = ThickRing(inner_radius=section.seat, outer_radius=HOUSING * section.seat, material=STEEL)
    return -2 * inner.displacement(section.bottom, outside=fit_pressure(inner, outer, interference=1.0))


def solved_ratio(section: Section, *, wider: float = WIDER) -> float:
    """By finite elements: ring and its counterpart share their nodes' radial places but for the interference."""
    seat, half = section.seat, section.width / 2
    y = np.unique(np.concatenate([np.linspace(-half, half, 61), [0.0, section.shoulder, -section.far_shoulder]]))
    beyond = np.linspace(half, wider * half, 13)[1:] if wider > 1 else np.empty(0)
    end = 1e-3 * seat if section.sign > 0 else HOUSING * seat
    ring = grid(y, 13, lambda line, share: seat + share * (section.surface(line) - seat))
    other = grid(np.concatenate([-beyond[::-1], y, beyond]), 31, lambda _, share: seat + share * (end - seat))
    bases = [Basis(mesh, ElementVector(ElementQuad2()), intorder=4) for mesh in (ring, other)]
    whole = block_diag([elastic.assemble(basis) for basis in bases]).tocsr()
    place = np.hstack([basis.doflocs for basis in bases])
    firsts = (0, bases[0].N)  # of the unknowns of each body
    axial, radial = ([first + dofs_along(basis, k) for first, basis in zip(firsts, bases, strict=True)] for k in (0, 1))

    def nearest(dofs: NDArray[np.intp], radius: float) -> np.intp:
        return dofs[np.argmin(np.hypot(place[0, dofs], place[1, dofs] - radius))]

    seats = []
    for dofs in radial:
        on = dofs[np.isclose(place[1, dofs], seat) & (np.abs(place[0, dofs]) <= half * (1 + 1e-9))]
        seats.append(on[np.argsort(place[0, on])])
    # The ring's radial displacement on the seat is that of its counterpart, plus or less half the interference.
    total = whole.shape[0]
    target, jump = np.arange(total), np.zeros(total)
    target[seats[0]], jump[seats[0]] = seats[1], section.sign * 0.5
    tie = coo_array((np.ones(total), (np.arange(total), target)), shape=(total, total)).tocsr()
    matrix, force = tie.T @ whole @ tie, -(tie.T @ (whole @ jump))
    held = [nearest(dofs, seat) for dofs in axial]  # one place along the axis of each body
    free = np.setdiff1d(np.arange(total), [*seats[0], *held])
    moved = np.zeros(total)
    moved[free] = spsolve(matrix[free][:, free], force[free])
    return section.sign * 2 * float((tie @ moved + jump)[nearest(radial[0], section.bottom)])


def dofs_along(basis: Basis, axis: int) -> NDArray[np.intp]:
    """Unknowns along the bearing's axis, 0, or the radius, 1."""
    return np.concatenate([basis.nodal_dofs[axis], basis.facet_dofs[axis], basis.interior_dofs[axis]])


def grid(along: NDArray[np.float64], count: int, radius) -> MeshQuad:
    """Cells between lines along the axis and so many even shares of the wall."""
    mesh = MeshQuad.init_tensor(along, np.linspace(0, 1, count))
    return MeshQuad(np.stack([mesh.p[0], radius(mesh.p[0], mesh.p[1])]), mesh.t)


@BilinearForm
def elastic(u, v, w):
    """Energy of strains about an axis, over 2 pi; x[0] is axial, x[1] radial."""
    shear = STEEL.youngs_modulus / (2 * (1 + STEEL.poisson_ratio))
    bulk = 2 * shear * STEEL.poisson_ratio / (1 - 2 * STEEL.poisson_ratio)
    du, dv, r = grad(u), grad(v), w.x[1]
    strain_u, strain_v = (du + np.swapaxes(du, 0, 1)) / 2, (dv + np.swapaxes(dv, 0, 1)) / 2
    hoop_u, hoop_v = u[1] / r, v[1] / r
    trace_u, trace_v = du[0, 0] + du[1, 1] + hoop_u, dv[0, 0] + dv[1, 1] + hoop_v
    return (2 * shear * (ddot(strain_u, strain_v) + hoop_u * hoop_v) + bulk * trace_u * trace_v) * r


if __name__ == "__main__":
    run(main)
