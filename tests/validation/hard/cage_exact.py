"""Exact answers of the hard cases of pockets and cages, from the formulas as printed."""

from collections.abc import Callable

import mpmath
from mpmath import mpf

STIFFNESS, CLEARANCE, OFF_AXIS = "6e10", "0.1e-3", "0.13e-3"  # N/m^1.5, m, m


def both_shells(across: mpf, offset: mpf) -> mpf:
    """Force, N, on a ball between two shells with centres `offset` off its plane: equation 14 of [Paper] for each."""
    distance = mpmath.hypot(across, offset)
    return 2 * mpf(STIFFNESS) * (distance - mpf(CLEARANCE)) ** mpf("1.5") * across / distance


def damping(restitution: mpf) -> mpf:
    """The root l of l (1 + e) = ln((1 + l)/(1 - l e)) other than 0."""
    e = restitution

    def excess(factor: mpf) -> mpf:
        return (mpmath.log1p(factor) - mpmath.log1p(-factor * e) - factor * (1 + e)) / factor**2

    with mpmath.workdps(80):
        bounds = (1 - e) / 10, (1 - mpf(10) ** -12) / e
        return mpmath.findroot(excess, bounds, solver="anderson", tol=mpf(10) ** -100, maxsteps=500)


def impact_time() -> mpf:
    """Contact time of 0.31 kg at 1e-12 m/s: 2 d/v int_0^1 dz/sqrt(1 - z^2.5), by quadrature."""
    deepest = (mpf("1.25") * mpf("0.31") * mpf("1e-24") / mpf(STIFFNESS)) ** mpf("0.4")
    whole = mpmath.quad(lambda z: 1 / mpmath.sqrt(1 - z ** mpf("2.5")), [0, mpf("0.5"), 1])
    return 2 * whole * deepest / mpf("1e-12")


def hung_between_shells() -> mpf:
    """Force on a ball as deep beyond the edge of both shells as the weight presses it into one sphere."""
    offset, clearance = mpf("0.04e-3"), mpf(CLEARANCE)
    weight = mpf("6.58e-3") * mpf("9.80665")
    across = mpmath.sqrt(clearance**2 - offset**2) + mpmath.cbrt((weight / mpf(STIFFNESS)) ** 2)
    return both_shells(across, offset)


def unbounded_friction() -> mpf:
    """mu m g r (w_b/w) (2/pi) E/sqrt(1 + mu^2), its mean slip by quadrature."""
    lean = mpmath.sin(mpf("0.18")) ** 2
    slip = mpmath.quad(lambda phi: mpmath.sqrt(1 - lean * mpmath.sin(phi) ** 2), [0, mpmath.pi / 2]) * 2 / mpmath.pi
    mu = mpf("1e9")
    force = mpf("6.58e-3") * mpf("9.80665") * mu / mpmath.sqrt(1 + mu**2)
    return force * mpf("2.358") * mpf("3.97e-3") * slip


CAGE: dict[str, Callable[[], mpf]] = {
    "pocket: ball on the plane": lambda: mpf(STIFFNESS) * (mpf(OFF_AXIS) - mpf(CLEARANCE)) ** mpf("1.5"),
    "pocket: both shells": lambda: both_shells(mpf(OFF_AXIS), mpf("0.04e-3")),
    "pocket: sliding at 1e-12 m/s": lambda: mpf("0.13") * 7 / mpf("1e-3"),
    "impact: restitution 0.05": lambda: damping(mpf("0.05")),
    "impact: restitution 1 - 2^-16": lambda: damping(1 - mpf(2) ** -16),
    "impact: 1e-12 m/s": impact_time,
    "cage: one ball": lambda: mpf("6.58e-3") * mpf("9.80665"),
    "cage: one ball between both shells": hung_between_shells,
    "cage: very large friction": unbounded_friction,
}
