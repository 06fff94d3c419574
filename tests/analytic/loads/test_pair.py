"""A pair of bearings against Hertz's exponent, statics, single bearings under the same loads, and differences."""

from dataclasses import replace
from typing import Any, Literal

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.loads.pair import PairContacts, PairEquilibrium, pair_equilibrium
from analytic.loads.ring import ring_equilibrium
from analytic.loads.turning import Inertia
from analytic.scene import Arrangement, Bearing, ContactAngle, Operation
from tests.analytic.specimens import made
from tests.refusals import refused

SOLVED = ContactAngle(rule="solved")
STILL = Inertia(centrifugal=False, gyroscopic=False)
HERTZ = PairContacts(inertia=STILL, finite_geometry=False)
STATICS = 1e-9  # of the loads: a thousand times the tolerance of the equilibrium


def bearing(angle: float = 0.7, conformity: float = 0.52, **changed: Any) -> Bearing:
    """Thirteen balls of 7.938 mm at this free contact angle."""
    ball, grooves = 7.938e-3, (conformity, conformity)
    clearance = 2 * (2 * conformity - 1) * ball * (1 - np.cos(angle))
    known = made(ball=ball, pitch=39.1e-3, count=13, grooves=grooves, clearance=clearance, shoulder=0.5)
    return replace(known, **{"width": 15e-3, **changed})


def loads(axial: Any, *, radial: float = 0.0, moment: float = 0.0, speed: float = 0.0) -> Operation:
    thrust = np.array(axial, dtype=float, ndmin=1)
    given = Operation(axial_load=thrust, inner_speed=np.array(speed), radial_load=radial, moment=moment)
    return given.as_series()


def pair(operation: Operation, contacts: PairContacts = HERTZ, **given: Any) -> PairEquilibrium:
    known: dict[str, Any] = {"kind": "O"}
    return pair_equilibrium(bearing(), SOLVED, Arrangement(**(known | given)), operation, contacts)


@pytest.mark.parametrize("kind", ["O", "X"])
def test_the_second_bearing_is_relieved_at_hertz_exponent(kind: Literal["O", "X"]) -> None:
    """Springs Q = K delta^1.5 at a constant angle: the first then has twice its approach, under 2^1.5 preloads."""
    wide = bearing(conformity=0.6)  # A0 of 1.6 mm: the approach of 0.2 um turns the contact by 1e-4 rad
    preload = 3.0
    at = np.array([0.99, 1.01]) * 2**1.5 * preload
    found = pair_equilibrium(wide, SOLVED, Arrangement(kind=kind, preload=preload), loads(at), HERTZ)
    assert found.is_pressed.tolist() == [[True, True], [True, False]]
    assert found.is_relieved.tolist() == [[False, False], [False, True]]
    np.testing.assert_allclose(found.axial_load[0, 1], at[1], rtol=STATICS)
    # dF/dz of both springs at rest is 2 * 1.5 P/z0, with z0 half of the offset.
    at_rest = pair_equilibrium(wide, SOLVED, Arrangement(kind=kind, preload=preload), loads(0.0), HERTZ)
    np.testing.assert_allclose(at_rest.stiffness, 3 * preload / (at_rest.offset / 2), rtol=1e-3)  # the angle opens


def test_forces_and_moments_balance() -> None:
    operation = loads([140.0, 610.0], radial=230.0, moment=-1.7, speed=900.0)
    for given in ({"kind": "O", "preload": 190.0}, {"kind": "X", "offset": 7e-6}, {"kind": "tandem"}):
        found = pair(operation, PairContacts(), **given, distance=31e-3)
        side = np.array([1, 1 if given["kind"] == "tandem" else -1])[:, None]
        first = 31e-3 / 2 if given["kind"] == "X" else -31e-3 / 2
        place = np.array([first, -first])[:, None]
        np.testing.assert_allclose((side * found.axial_load).sum(axis=0), operation.axial_load, rtol=STATICS)
        np.testing.assert_allclose(found.radial_load.sum(axis=0), 230.0, rtol=STATICS)
        about_y = side * found.moment + place * found.radial_load
        np.testing.assert_allclose(about_y.sum(axis=0), -1.7, rtol=100 * STATICS)  # a small difference of large parts


def test_each_bearing_alone_is_loaded_as_in_the_pair() -> None:
    found = pair(
        loads([260.0], radial=120.0, moment=0.9, speed=700.0),
        PairContacts(finite_geometry=False),
        preload=210.0,
    )
    alone = ring_equilibrium(
        bearing(),
        SOLVED,
        axial_load=found.axial_load,
        radial_load_x=found.radial_load,
        moment_y=found.moment,
        inner_speed=700.0,
    )
    heaviest = np.maximum(alone.balls["load"][..., 0], alone.balls["load"][..., 1]).max(axis=-1)
    np.testing.assert_allclose(found.ball_load, heaviest, rtol=1e-6)  # gyroscopic friction settles to 1e-8 or so
    tilts = alone.displacement[..., 4]
    np.testing.assert_allclose(tilts[0, 0], -tilts[1, 0], rtol=1e-6)  # mirrored frames of one shaft
    np.testing.assert_allclose(tilts[0], found.tilt, rtol=1e-6)


@pytest.mark.parametrize("contacts", [HERTZ, PairContacts(inertia=STILL)])
def test_the_stiffness_is_the_slope_of_the_curve(contacts: PairContacts) -> None:
    at = np.array([0.0, 150.0, 480.0, 1300.0])  # the second bearing is relieved at about 570 N
    less, more = (pair(loads(at + step), contacts, preload=200.0) for step in (0.0, 0.5))
    slope, middle = 0.5 / (more.displacement - less.displacement), (less.stiffness + more.stiffness) / 2
    np.testing.assert_allclose(slope, middle, rtol=5e-3)  # K is held, and its change with the angle left out


def test_offset_and_preload_say_the_same() -> None:
    known = pair(loads(0.0), preload=240.0)
    np.testing.assert_allclose(pair(loads(0.0), offset=known.offset).preload, 240.0, rtol=1e-6)
    np.testing.assert_allclose(known.axial_load, 240.0, rtol=1e-6)  # two ways to the load of one displacement
    np.testing.assert_allclose(known.displacement, 0.0, atol=1e-15)


def test_what_no_pair_can_be_is_refused() -> None:
    def paired(**changed: Any) -> object:
        given = {"bearing": bearing(), "contact_angle": SOLVED, "arrangement": Arrangement(kind="O", preload=9.0)}
        return pair_equilibrium(**(given | {"operation": loads(11.0, radial=3.0), "contacts": HERTZ} | changed))

    refused(lambda: paired(contact_angle=ContactAngle(rule="given", value=0.7)), 'rule = "solved"')
    refused(lambda: paired(bearing=bearing(width=None)), "arrangement.distance is missing")
    refused(lambda: paired(bearing=bearing(ball_count=2)), "ball_count = 2")
    for wrong in ({"preload": -5.0}, {"offset": 0.0}, {"preload": 9.0, "distance": 0.0}):
        refused(lambda: paired(arrangement=Arrangement(kind="O", **wrong)), f"arrangement.{list(wrong)[-1]}")  # noqa: B023


def test_a_load_that_no_groove_bears_is_named() -> None:
    """Where contacts are corrected too, which needs the motion of the balls."""
    with pytest.raises(InputError, match=r"radial load of 9000 kN.* moves the rings .* lower the load"):
        pair_equilibrium(
            bearing(),
            SOLVED,
            Arrangement(kind="O", preload=9.0),
            loads(11.0, radial=9e6),
            PairContacts(inertia=STILL, finite_geometry=True),
        )
