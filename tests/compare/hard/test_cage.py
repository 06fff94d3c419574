"""Pockets and cages among the hard cases: every literal by 40 digits, from the formulas as printed."""

from collections.abc import Callable

import mpmath
import pytest
from mpmath import mpf

from fembearing.compare.hard.cage import CAGE_CASES
from tests.compare.hard.many_digits import off_by

STIFFNESS, ROOM, ACROSS = "6e10", "0.1e-3", "0.13e-3"  # N/m^1.5, m, m


def both_shells(across: mpf, offset: mpf) -> mpf:
    """Force on a ball on the plane between two shells, N: equation 14 of each, whose centres lie `offset` off it."""
    distance = mpmath.hypot(across, offset)
    return 2 * mpf(STIFFNESS) * (distance - mpf(ROOM)) ** mpf("1.5") * across / distance


def damping(restitution: mpf) -> mpf:
    """l of l (1 + e) = ln((1 + l)/(1 - l e)), beside its root at 0."""
    e = restitution

    def excess(factor: mpf) -> mpf:
        return (mpmath.log1p(factor) - mpmath.log1p(-factor * e) - factor * (1 + e)) / factor**2

    with mpmath.workdps(80):
        bounds = (1 - e) / 10, (1 - mpf(10) ** -12) / e
        return mpmath.findroot(excess, bounds, solver="anderson", tol=mpf(10) ** -100, maxsteps=500)


def impact_time() -> mpf:
    """Of 0.31 kg that come at 1e-12 m/s: quadrature of the time, 2 d/v int_0^1 dz/sqrt(1 - z^2.5)."""
    deepest = (mpf("1.25") * mpf("0.31") * mpf("1e-24") / mpf(STIFFNESS)) ** mpf("0.4")
    whole = mpmath.quad(lambda z: 1 / mpmath.sqrt(1 - z ** mpf("2.5")), [0, mpf("0.5"), 1])
    return 2 * whole * deepest / mpf("1e-12")


def hung_between_shells() -> mpf:
    """Of a ball as deep beyond both shells' edge as the weight takes it into one sphere."""
    offset, room = mpf("0.04e-3"), mpf(ROOM)
    weight = mpf("6.58e-3") * mpf("9.80665")
    across = mpmath.sqrt(room**2 - offset**2) + mpmath.cbrt((weight / mpf(STIFFNESS)) ** 2)
    return both_shells(across, offset)


def unbounded_friction() -> mpf:
    """mu m g r (w_b/w) (2/pi) E/sqrt(1 + mu^2), its mean slip by quadrature."""
    lean = mpmath.sin(mpf("0.18")) ** 2
    slip = mpmath.quad(lambda phi: mpmath.sqrt(1 - lean * mpmath.sin(phi) ** 2), [0, mpmath.pi / 2]) * 2 / mpmath.pi
    mu = mpf("1e9")
    force = mpf("6.58e-3") * mpf("9.80665") * mu / mpmath.sqrt(1 + mu**2)
    return force * mpf("2.358") * mpf("3.97e-3") * slip


REFERENCES: dict[str, Callable[[], mpf]] = {
    "pocket: across its plane": lambda: mpf(STIFFNESS) * (mpf(ACROSS) - mpf(ROOM)) ** mpf("1.5"),
    "pocket: on either side of its plane": lambda: mpf(1),
    "pocket: beside its plane": lambda: mpf(1),
    "pocket: both shells": lambda: both_shells(mpf(ACROSS), mpf("0.04e-3")),
    "pocket: as deep as half of its diameter": lambda: mpf(1),
    "pocket: no sliding": lambda: mpf(1),
    "pocket: all but no sliding": lambda: mpf("0.13") * 7 / mpf("1e-3"),
    "impact: restitution 0.05": lambda: damping(mpf("0.05")),
    "impact: restitution 1 - 2^-16": lambda: damping(1 - mpf(2) ** -16),
    "impact: 1e-12 m/s": impact_time,
    "cage: an impact at restitution 0.05": lambda: mpf(1),
    "cage: an impact at restitution 1 - 2^-16": lambda: mpf(1),
    "cage: without friction and damping": lambda: mpf(1),
    "cage: no weight and matched speed": lambda: mpf(1),
    "cage: a single ball": lambda: mpf("6.58e-3") * mpf("9.80665"),
    "cage: a single ball between both shells": hung_between_shells,
    "cage: a single ball, hit through the middle": lambda: mpf(-1),
    "cage: a single ball, hit beside the middle": lambda: mpf(-1),
    "cage: balls that lead by all but the clearance": lambda: mpf(1),
    "cage: friction beyond bounds": unbounded_friction,
    "cage: torque of no friction": lambda: mpf(1),
}
NUMBERS = {case.name: case for case in CAGE_CASES if case.expected is not None}


@pytest.mark.parametrize("name", NUMBERS)
def test_every_literal_is_that_of_many_digits(name: str) -> None:
    with mpmath.workdps(40):
        off = off_by(NUMBERS[name], REFERENCES[name]())
    assert off < 3e-16, off  # a double's own rounding


def test_every_number_has_its_reference() -> None:
    assert NUMBERS.keys() == REFERENCES.keys()
