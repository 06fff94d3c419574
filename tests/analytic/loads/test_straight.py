"""A ring whose tilt is held: against springs, a textbook's integral, and the ring under the moment that holds it."""

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import fsolve

from analytic.loads.numbers import free_angle
from analytic.loads.ring import RingEquilibrium, ring_equilibrium
from analytic.scene import Bearing, ContactAngle
from tests.analytic.specimens import with_clearance
from tests.refusals import refused

SOLVED = ContactAngle(rule="solved")


def straight_ring(
    bearing: Bearing, *, free_angle: float, spring: float, axial_load: float, radial_load: float, tilt: float = 0.0
) -> tuple[NDArray[np.float64], float]:
    """(Z,) ball loads, N, and the moment that holds the ring, N m: Q = K delta^1.5 between centres of the grooves.

    spring : K of both contacts in series, N/m^1.5
    """
    psi = 2 * np.pi * np.arange(bearing.ball_count) / bearing.ball_count
    apart = bearing.inner.groove_radius + bearing.outer.groove_radius - bearing.ball_diameter
    arm = bearing.inner.bottom_radius + bearing.inner.groove_radius

    def loads(place: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        across = apart * np.cos(free_angle) + place[0] * np.cos(psi)
        along = apart * np.sin(free_angle) + place[1] - arm * tilt * np.cos(psi)
        stretched = np.maximum(np.hypot(across, along) - apart, 0.0)
        return spring * stretched**1.5, np.arctan2(along, across)

    def unbalanced(place: NDArray[np.float64]) -> list[float]:
        load, angle = loads(place * 1e-6)
        radial = np.sum(load * np.cos(angle) * np.cos(psi)) - radial_load
        return [radial / radial_load, np.sum(load * np.sin(angle)) / axial_load - 1]

    place = fsolve(unbalanced, [10.0, 10.0], xtol=1e-13)
    assert np.abs(unbalanced(place)).max() < 1e-10  # Newton's method at round-off
    load, angle = loads(place * 1e-6)
    return load, -arm * float(np.sum(load * np.sin(angle) * np.cos(psi)))


def springs_of(ring: RingEquilibrium) -> NDArray[np.float64]:
    """(Z,) K of both contacts of each ball in series, N/m^1.5."""
    softness = ring.balls["inner_unit"]["approach"] + ring.balls["outer_unit"]["approach"]
    return softness**-1.5


@pytest.fixture(scope="module")
def open_bearing(bearing_6205: Bearing) -> Bearing:
    return with_clearance(bearing_6205, 33e-6)


@pytest.mark.parametrize(
    ("axial", "radial", "tilt"), [(300.0, 1050.0, 4e-4), (640.0, 270.0, 0.0), (410.0, 230.0, 7e-4)]
)
def test_the_balls_of_a_straight_ring_are_those_of_springs(
    open_bearing: Bearing, axial: float, radial: float, tilt: float
) -> None:
    """With K of each ball, which the solver exports."""
    found = ring_equilibrium(open_bearing, SOLVED, axial_load=axial, radial_load_x=radial, tilts=(0.0, tilt))
    springs: Any = springs_of(found)
    load, moment = straight_ring(
        open_bearing,
        free_angle=free_angle(open_bearing) or np.nan,
        spring=springs,
        axial_load=axial,
        radial_load=radial,
        tilt=tilt,
    )
    np.testing.assert_allclose(
        found.balls["load"][..., 0], load, rtol=0, atol=1e-8 * load.max()
    )  # of the rounds and of fsolve
    np.testing.assert_allclose(found.moment, [0.0, moment], rtol=1e-8, atol=1e-10)
    np.testing.assert_allclose(found.displacement[3:], [0.0, tilt], rtol=1e-15)  # over the arm and times it


HELD: dict[str, Any] = {"axial_load": 310.0, "radial_load_x": 540.0, "radial_load_y": -170.0, "inner_speed": 900.0}


def test_the_moment_that_holds_a_ring_leaves_it_there_when_it_is_free(open_bearing: Bearing) -> None:
    for tilts in ((0.0, 0.0), (-3e-4, 8e-4)):
        held = ring_equilibrium(open_bearing, SOLVED, tilts=tilts, **HELD)
        moment_x, moment_y = held.moment
        free = ring_equilibrium(open_bearing, SOLVED, moment_x=moment_x, moment_y=moment_y, **HELD)
        # Two solutions of the same rounds: their last steps are 1e-12 of the load, on a soft tilt.
        np.testing.assert_allclose(free.displacement[3:], tilts, rtol=0, atol=1e-11)
        np.testing.assert_allclose(free.balls["load"][..., 0], held.balls["load"][..., 0], rtol=1e-8, atol=1e-7)
        scale = np.abs(held.stiffness).max()
        np.testing.assert_allclose(free.stiffness / scale, held.stiffness / scale, rtol=0, atol=1e-9)


def test_a_moment_beside_tilts_is_refused(open_bearing: Bearing) -> None:
    refused(
        lambda: ring_equilibrium(open_bearing, SOLVED, axial_load=300.0, moment_y=0.7, tilts=(0.0, 0.0)),
        "leave one of them out",
    )
