"""How far a ring's groove moves when the ring is fitted: python validation/benchmarks/mounting.py

The model takes a ring as thick as its wall below the groove (`analytic.mounting`). This program solves rings with their
true section, groove and shoulders, by finite elements of the section about the axis: the inner ring on a solid shaft
three times as wide, the outer ring in a housing of twice its diameter, without friction between them. It prints the
change of the groove's diameter over the interference, beside that of the model and of a ring with the same area of
section. Needs a few seconds.
"""

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


def sections() -> list[Section]:
    """Inner and outer rings of a few bearings; shoulders 0.2 ball diameters high, grooves 0.52."""
    rings = []
    for name, bore, outside, width, ball, pitch, one_sided in (
        ("608", 8, 22, 7, 3.969, 15.0, False),
        ("6205", 25, 52, 15, 7.938, 39.0, False),
        ("6210", 50, 90, 20, 12.7, 70.0, False),
        ("6308", 40, 90, 23, 15.081, 65.0, False),
        ("7014 spindle", 70, 110, 20, 12.7, 90.0, True),
    ):
        groove = 0.52 * ball
        half = float(np.sqrt(0.2 * ball * (2 * groove - 0.2 * ball)))
        common = {"groove": groove, "shoulder": half, "width": float(width)}
        inner, outer = f"{name}, inner", f"{name}, outer"
        rings.append(Section(name=inner, seat=bore / 2, bottom=(pitch - ball) / 2, far_shoulder=half, **common))
        far = 0.0 if one_sided else half
        rings.append(Section(name=outer, seat=outside / 2, bottom=(pitch + ball) / 2, far_shoulder=far, **common))
    return rings


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
    half = section.width / 2
    y = np.unique(np.concatenate([np.linspace(-half, half, 61), [0.0, section.shoulder, -section.far_shoulder]]))
    beyond = np.linspace(half, wider * half, 13)[1:] if wider > 1 else np.empty(0)
    far = np.concatenate([-beyond[::-1], y, beyond])
    ring = grid(
        y, np.linspace(0, 1, 13), lambda line, share: section.seat + share * (section.surface(line) - section.seat)
    )
    end = 1e-3 * section.seat if section.sign > 0 else HOUSING * section.seat
    other = grid(far, np.linspace(0, 1, 31), lambda line, share: section.seat + share * (end - section.seat) + 0 * line)
    bases = [Basis(mesh, ElementVector(ElementQuad2()), intorder=4) for mesh in (ring, other)]
    stiffness = [elastic.assemble(basis) for basis in bases]
    first = bases[0].N
    places = [basis.doflocs for basis in bases]
    radial = [np.arange(0, basis.N) for basis in bases]
    seats = []
    for basis, place in zip(bases, places, strict=True):
        on_seat = np.flatnonzero(np.isclose(place[1], section.seat) & (np.abs(place[0]) <= half * (1 + 1e-9)))
        across = np.concatenate([basis.nodal_dofs[1], basis.facet_dofs[1], basis.interior_dofs[1]])
        on_seat = np.intersect1d(on_seat, across)
        seats.append(on_seat[np.argsort(place[0, on_seat])])
    assert len(seats[0]) == len(seats[1])
    # The ring's radial displacement on the seat is that of its counterpart, plus or less half the interference.
    total = first + bases[1].N
    target = np.arange(total)
    target[seats[0]] = first + seats[1]
    jump = np.zeros(total)
    jump[seats[0]] = section.sign * 0.5
    tie = coo_array((np.ones(total), (np.arange(total), target)), shape=(total, total)).tocsr()
    whole = block_diag(stiffness).tocsr()
    matrix, force = tie.T @ whole @ tie, -(tie.T @ (whole @ jump))
    axial = [np.concatenate([basis.nodal_dofs[0], basis.facet_dofs[0], basis.interior_dofs[0]]) for basis in bases]
    held = []  # one place along the axis of each body
    for index, (dofs, place) in enumerate(zip(axial, places, strict=True)):
        held.append(dofs[np.argmin(np.hypot(place[0, dofs], place[1, dofs] - section.seat))] + index * first)
    free = np.setdiff1d(np.arange(total), [*seats[0], *held])
    moved = np.zeros(total)
    moved[free] = spsolve(matrix[free][:, free], force[free])
    moved = tie @ moved + jump
    across = np.intersect1d(radial[0], np.concatenate([bases[0].nodal_dofs[1], bases[0].facet_dofs[1]]))
    bottom = across[np.argmin(np.hypot(places[0][0, across], places[0][1, across] - section.bottom))]
    return section.sign * 2 * float(moved[bottom])


def grid(along: NDArray[np.float64], shares: NDArray[np.float64], radius) -> MeshQuad:
    """Cells between lines along the axis and shares of the wall."""
    mesh = MeshQuad.init_tensor(along, shares)
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
