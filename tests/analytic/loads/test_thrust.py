"""Thrust equilibrium against the balances that define it, another program, and at speed the ring and each ball."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.contact.factors import ContactCorrection, ContactFactors
from analytic.contact.hertz import contact_modulus, hertz_contact
from analytic.errors import InputError
from analytic.loads.numbers import free_angle
from analytic.loads.ring import ring_equilibrium
from analytic.loads.state import approaches
from analytic.loads.thrust import thrust_equilibrium, thrust_equilibrium_frozen
from analytic.loads.turning import Inertia
from analytic.numerics.records import Records
from analytic.scene import Bearing, ContactAngle
from tests.analytic.specimens import loaded_contacts, with_clearance
from tests.contacts import PEEK
from tests.refusals import refused

SOLVED = ContactAngle(rule="solved")
LOADS = 10.0 ** np.arange(-12, 13, 2)  # N, from nothing to what no bearing survives


def assert_balanced(balls: Records, bearing: Bearing, load: np.ndarray) -> None:
    """The force along the axis, the springs of both races, and the distance of the groove centres."""
    al, Q = balls["angle"][..., 0], balls["load"][..., 0]
    np.testing.assert_allclose(bearing.ball_count * Q * np.sin(al), load, rtol=1e-9)  # near pi/2 and 0 al is exact
    for race in loaded_contacts(balls):
        np.testing.assert_allclose(race.stiffness * race.approach**1.5, Q, rtol=1e-12)  # round-off
    radial = bearing.groove_centre_distance - bearing.diametral_clearance / 2
    stretched = bearing.groove_centre_distance + approaches(balls).sum(axis=-1)
    # Round-off of al near pi/2, times the stretched distance; a nanometre of 0.4 mm is far below any tolerance.
    np.testing.assert_allclose(stretched * np.cos(al), radial, rtol=1e-12, atol=1e-15 * float(stretched.max()))


@pytest.mark.parametrize("clearance", [31e-6, 20e-6, 2e-9, 0.0, -3e-9, -14e-6, -0.2e-3])
def test_forces_and_distances_balance_at_any_load(bearing_6205: Bearing, clearance: float) -> None:
    bearing = with_clearance(bearing_6205, clearance)
    balls = thrust_equilibrium(bearing, SOLVED, axial_load=LOADS)
    for index, load in enumerate(LOADS):
        one = thrust_equilibrium(bearing, SOLVED, axial_load=load)
        assert_balanced(one, bearing, load)
        np.testing.assert_allclose(one["angle"], balls["angle"][index], rtol=1e-13)  # alone or in a series
    assert np.all(np.diff(balls["angle"], axis=0) >= 0)
    assert np.all(balls["angle"] < np.pi / 2)
    free = free_angle(bearing)
    if clearance:  # at 0 its round-off decides
        assert (free is None) == (clearance < 0)
    if free is not None:
        np.testing.assert_allclose(np.cos(free), 1 - clearance / (2 * 0.40e-3), rtol=1e-12)


@pytest.mark.parametrize(
    ("free", "angle", "ball_load"),
    [(0.0, 0.2580, 435), (0.10, 0.2723, 413), (0.18, 0.3031, 372), (0.2241, 0.3266, 346)],
)
def test_6205_under_1000_newton(bearing_6205: Bearing, free: float, angle: float, ball_load: float) -> None:
    """Values of an independent calculation, with E = 206 GPa and nu = 0.3; the last digit is rounded."""
    balls = thrust_equilibrium(bearing_6205, ContactAngle(rule="solved", free=free), axial_load=1000.0)
    np.testing.assert_allclose(balls["angle"], angle, atol=0.5e-4)
    np.testing.assert_allclose(balls["load"], ball_load, atol=0.5)


def test_each_race_has_its_own_material(bearing_6205: Bearing) -> None:
    """At one ball load a soft outer ring leaves the inner contact as it is; delta ~ E*^(-2/3) on the outer."""
    given = ContactAngle(rule="given", value=0.18)
    soft = replace(bearing_6205, outer=replace(bearing_6205.outer, material=PEEK))
    hard, mixed = (thrust_equilibrium(bearing, given, axial_load=300.0) for bearing in (bearing_6205, soft))
    np.testing.assert_allclose(approaches(mixed)[0], approaches(hard)[0], rtol=1e-13)  # the same calculation
    steel_side = (1 - 0.3**2) / 206e9
    ratio = (2 * steel_side / (steel_side + (1 - 0.38**2) / 3.6e9)) ** (2 / 3)
    np.testing.assert_allclose(approaches(hard)[1] / approaches(mixed)[1], ratio, rtol=1e-12)  # round-off


@pytest.mark.parametrize(
    ("angle", "load", "words"),
    [
        (SOLVED, 0.0, ("axial_load", "0.0", "positive")),
        (SOLVED, [3.0, -2.0], ("axial_load", "-2.0", "index [1]")),
        (SOLVED, float("nan"), ("axial_load", "nan")),
        (ContactAngle(rule="given"), 5.0, ("given contact angle", "None")),
        (ContactAngle(rule="given", value=0.0), 5.0, ("given contact angle", "0.0")),
        (ContactAngle(rule="given", value=float("nan")), 5.0, ("given contact angle", "nan")),
        (ContactAngle(rule="solved", free=-0.1), 5.0, ("free", "-0.1")),
        (ContactAngle(rule="solved", free=18.0), 5.0, ("free", "18.0", "degrees")),
    ],
)
def test_a_bad_argument_is_named(bearing_6205: Bearing, angle: ContactAngle, load, words) -> None:
    refused(lambda: thrust_equilibrium(bearing_6205, angle, axial_load=load), *words)


def test_a_bearing_without_an_angle_is_refused(bearing_6205: Bearing) -> None:
    with pytest.raises(InputError, match=r"diametral clearance 0\.81 mm must be below 2 A0 = 0\.8 mm"):
        free_angle(with_clearance(bearing_6205, 0.81e-3))
    narrow = replace(bearing_6205, inner=replace(bearing_6205.inner, groove_radius=3.97e-3))
    for angle in (SOLVED, ContactAngle(rule="given", value=0.18)):
        with pytest.raises(InputError, match=r"inner groove_radius 3\.97 mm must exceed .* line"):
            thrust_equilibrium(narrow, angle, axial_load=5.0)


@pytest.mark.parametrize("free", [0.0, 0.18, 0.61])
def test_frozen_contacts_balance_with_the_stiffness_of_the_free_angle(bearing_6205: Bearing, free: float) -> None:
    """One load in each decade; the stiffness by hand, from the curvatures of the races at al0."""
    loads = LOADS[LOADS < 1e6]
    balls = thrust_equilibrium_frozen(bearing_6205, ContactAngle(rule="solved", free=free), axial_load=loads)
    steel, radius, cosine = bearing_6205.ball_material, bearing_6205.ball_radius, np.cos(free)
    middle = bearing_6205.pitch_diameter / 2
    along = {
        "inner": 1 / radius + cosine / (middle - radius * cosine),
        "outer": 1 / radius - cosine / (middle + radius * cosine),
    }
    for side, (race, curvature) in enumerate(along.items()):
        across = 1 / radius - 1 / getattr(bearing_6205, race).groove_radius
        modulus = contact_modulus(steel, steel)
        hand = hertz_contact(curvature_x=curvature, curvature_y=across, load=balls["load"][:, 0], modulus=modulus)
        np.testing.assert_allclose(approaches(balls)[:, side], hand.approach, rtol=1e-12)  # round-off
    al, distance = balls["angle"][:, 0], bearing_6205.groove_centre_distance
    np.testing.assert_allclose(bearing_6205.ball_count * balls["load"][:, 0] * np.sin(al), loads, rtol=1e-12)
    stretched = (distance + approaches(balls).sum(axis=-1)) * np.cos(al)
    np.testing.assert_allclose(stretched, distance * np.cos(free), rtol=1e-12)


@pytest.mark.parametrize(
    ("clearance", "angle", "load", "words"),
    [
        (20e-6, ContactAngle(rule="given", value=0.18), 5.0, ("frozen", "rule 'given'", "thrust_equilibrium")),
        (-14e-6, SOLVED, 5.0, ("frozen", "preload of 14 um", "thrust_equilibrium")),
        (20e-6, SOLVED, -2.0, ("axial_load", "-2.0")),
        (20e-6, ContactAngle(rule="solved", free=18.0), 5.0, ("free", "18.0", "degrees")),
        (0.81e-3, SOLVED, 5.0, ("diametral clearance", "2 A0")),
    ],
)
def test_what_a_frozen_stiffness_cannot_do_is_refused(bearing_6205: Bearing, clearance, angle, load, words) -> None:
    refused(lambda: thrust_equilibrium_frozen(with_clearance(bearing_6205, clearance), angle, axial_load=load), *words)


@pytest.mark.parametrize(("centrifugal", "gyroscopic"), [(True, True), (True, False), (False, True)])
@pytest.mark.parametrize("free", [0.18, None])
def test_balls_at_speed_are_those_of_the_ring(
    bearing_6205: Bearing, free: float | None, centrifugal: bool, gyroscopic: bool
) -> None:
    rule = ContactAngle(rule="solved", free=free)
    load = np.array([41.0, 230.0, 890.0, 2600.0])
    speed = np.array([-740.0, 320.0, 1900.0, 2700.0])
    factors = ContactFactors(approach=np.array([0.93, 0.97, 1.02, 1.01]), semi_axis_rolling=1.03)
    loaded: dict[str, Any] = {"axial_load": load, "inner_speed": speed, "inertia": Inertia(centrifugal, gyroscopic)}
    balls = thrust_equilibrium(bearing_6205, rule, **loaded, correction=ContactCorrection(outer=factors))
    each = factors._replace(approach=np.repeat(np.asarray(factors.approach)[:, None], bearing_6205.ball_count, axis=1))
    ring = ring_equilibrium(bearing_6205, rule, **loaded, correction=ContactCorrection(outer=each))
    for name in ("load", "angle"):
        # The ring stops at 1e-11 of its forces, some of which are hundreds of the light ball's.
        np.testing.assert_allclose(balls[name], ring.balls[name][:, 4], rtol=1e-8)
    np.testing.assert_allclose(approaches(balls), approaches(ring.balls)[:, 4], rtol=1e-8)
