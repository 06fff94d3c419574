"""Rolling contact with friction against published solutions, limits and invariants."""

import numpy as np
import pytest

from analytic.oil.traction import PointLaw
from fembearing.creep.friction import settle, sliding_law
from fembearing.creep.half_space import HalfSpaces
from fembearing.creep.rolling import Creepages, rolling_friction, rolling_surfaces
from fembearing.creep.strips import Strips, ellipse_strips, hertz_pressure
from tests.creep.bodies import (
    HYBRID,
    LIKE,
    LOAD,
    ROLLING,
    TRANSVERSE,
    case,
    conformity,
    forces,
    of_modulus,
    race_strips,
)

SOLID = PointLaw(boundary=1e6)  # sticks everywhere


@pytest.mark.parametrize(
    ("ratio", "poisson_ratio", "published"),
    [  # Kalker's C11, C22, C23 [Kalker1990] table E3, and C33 where known
        (0.1, 0.25, (3.31, 2.52, 0.473, 8.28)),
        (0.2, 0.25, (3.37, 2.63, 0.603, 4.27)),
        (0.5, 0.25, (3.62, 3.01, 0.929, 1.93)),
        (1.0, 0.25, (4.12, 3.67, 1.47, 1.19)),
        (0.1, 0.0, (2.51, 2.51, 0.334)),
        (1.0, 0.0, (3.40, 3.40, 1.33, 1.21)),
        (0.3, 0.5, (4.80, 2.81, 0.889)),
        (1.0, 0.5, (5.20, 3.98, 1.63)),
    ],
)
def test_small_creepage_has_the_coefficients_of_kalker(
    ratio: float, poisson_ratio: float, published: tuple[float, ...]
) -> None:
    body = of_modulus(poisson_ratio, 0.7e9)
    mean = 1.3e-4
    strips = ellipse_strips(
        semi_axis_rolling=mean * ratio**0.5, semi_axis_transverse=mean / ratio**0.5, count=20, cells=12
    )
    pressure = hertz_pressure(strips, load=LOAD)
    found = rolling_friction(
        rolling_surfaces(strips, HalfSpaces(ball=body, race=body)),
        Creepages(2e-9, 0.0, 3e-9, 5e-6),
        pressure=pressure,
        law=sliding_law(SOLID, pressure=pressure, speed=0.7),
    )
    response = -found.response / 0.7e9 / mean**2
    coefficients = [response[0, 0], response[2, 2], response[2, 3] / mean, response[3, 3] / mean**2]
    # Kalker has three digits, and 20 strips an error of 1 %.
    np.testing.assert_allclose(coefficients[: len(published)], published, rtol=0.015)
    np.testing.assert_allclose(-response[3, 2], response[2, 3], rtol=3e-3)  # reciprocity, of strips of unlike length


def test_cylinders_roll_as_carter_has_them() -> None:
    """[Johnson1985] section 8.3: force, and stick at the leading edge over sqrt(1 - F/mu P) of the length.

    One very wide strip is plane strain.
    """
    half, modulus, poisson_ratio = 1.7e-4, 83e9, 0.3
    body = of_modulus(poisson_ratio, modulus)
    radius = 9e-3
    peak = half / radius * modulus / (1 - poisson_ratio) / 2  # E* a/2R with E* = G/(1 - nu)
    wide = Strips(
        middle=np.array([0.0]), width=np.array([2e3 * half]), rear=np.array([-half]), front=np.array([half]), cells=160
    )
    pressure = hertz_pressure(wide, load=np.pi / 2 * peak * half * wide.width[0])
    surfaces, found = rolling_surfaces(wide, HalfSpaces(ball=body, race=body)), None
    creepage = -0.6 * 0.13 * half / radius
    for _ in range(3):  # slip is taken where rectangles have slid
        found = rolling_friction(
            surfaces,
            Creepages(creepage),
            pressure=pressure,
            law=sliding_law(PointLaw(boundary=0.13), pressure=pressure, speed=0.7),
            start=found,
        )
    assert found is not None
    load = np.sum(pressure * wide.area)
    # Ends of a strip that is a thousand times as wide as long: 1e-3; and 160 rectangles.
    expected = -0.13 * half / radius * (1 - np.sqrt(1 - found.force_along / load / 0.13))
    np.testing.assert_allclose(expected, creepage, rtol=3e-3)
    sticks = np.hypot(*found.slip)[0] < 1e-9 * np.max(np.hypot(*found.slip))
    edge = wide.edges[0, np.argmax(sticks)]
    stuck = np.sqrt(1 - found.force_along / load / 0.13)
    np.testing.assert_allclose((half - edge) / (2 * half), stuck, atol=1 / 80)  # two rectangles
    assert found.slip_share == pytest.approx(1 - stuck, abs=1 / 80)
    assert not sticks[0]
    assert sticks[-1]  # the leading edge sticks, the trailing one slips


def test_a_long_ellipse_rolls_as_its_strips_do_by_carter() -> None:
    """Hertz has p0 a'/a on a strip of half-length a', so that each has the relative radius E* a/(2 p0)."""
    body, long, reach = LIKE.ball, 16 * ROLLING, 0.5
    contact = case(ellipse_strips(semi_axis_rolling=ROLLING, semi_axis_transverse=long, count=24, cells=14))
    modulus, peak = body.youngs_modulus / 2 / (1 - body.poisson_ratio**2), 1.5 * LOAD / np.pi / ROLLING / long
    friction, found = 0.07, None
    for _ in range(3):
        found = contact.rolls(Creepages(reach * friction * 2 * peak / modulus), friction, found)
    assert found is not None
    across = np.sin(np.linspace(-np.pi / 2, np.pi / 2, 2001))
    half = np.sqrt(1 - across**2)
    stuck = np.maximum(1 - reach / np.maximum(half, 1e-9), 0.0)
    expected = np.trapezoid(0.75 * half**2 * (1 - stuck**2), across)
    np.testing.assert_allclose(-found.force_along / friction / LOAD, expected, rtol=0.015)  # 24 strips, and b/a = 16


def test_a_static_contact_yields_as_cattaneo_and_mindlin_have_it() -> None:
    """Displacement 3 mu P (2 - nu)/(8 G a) [1 - (1 - F/mu P)^(2/3)] of like bodies [Johnson1985] section 7.2.

    Their solution leaves out the small slip across the force, and displacement here is taken at the middle.
    """
    body, half = of_modulus(0.3, 79e9), 1.9e-4
    strips = ellipse_strips(semi_axis_rolling=half, semi_axis_transverse=half, count=24, cells=24)
    pressure = hertz_pressure(strips, load=LOAD)
    size = strips.x.size
    moved = HalfSpaces(ball=body, race=body).by_traction(strips, strips.x.ravel(), strips.y.ravel())
    matrix = moved.transpose(0, 2, 1, 3).reshape(2 * size, 2 * size)
    law = sliding_law(PointLaw(boundary=0.11), pressure=pressure, speed=0.7)
    most = 3 * 0.11 * LOAD * (2 - 0.3) / (8 * 79e9 * half)
    shift = -0.6 * most
    found = settle(
        matrix,
        np.concatenate([np.full(size, shift), np.zeros(size)]),
        law,
        stiffness=2 / (np.diag(matrix)[:size] + np.diag(matrix)[size:]),
        patterns=np.zeros((2 * size, 1)),
        start=np.zeros(2 * size),
    )
    force = np.sum(found.traction[:size] * strips.area.ravel())
    expected = 1 - (1 - 0.6) ** 1.5
    np.testing.assert_allclose(force / 0.11 / LOAD, expected, rtol=0.01)  # 24 x 24, and the slip that they leave out


@pytest.mark.parametrize(("spin", "along"), [(0.31, 0.37), (0.0, 0.35), (0.9, 0.2)])
def test_without_creep_tractions_oppose_the_slip_of_rigid_bodies(spin: float, along: float) -> None:
    """Forces of mu p over the ellipse, by quadrature over its angles."""
    creepages, friction = conformity(spin, along), 1e-7
    bend, roots = creepages.along_bend, np.roots([creepages.along_bend, -creepages.spin, creepages.along])
    contact = case(race_strips(30, 16, sides=tuple(np.sort(roots[np.isreal(roots)].real))))
    found = contact.rolls(creepages, friction)
    found = contact.rolls(creepages, friction, found)
    peak = 1.5 * LOAD / np.pi / ROLLING / TRANSVERSE

    nodes, weights = np.polynomial.legendre.leggauss(300)
    across, length = np.meshgrid(np.pi / 2 * nodes, np.pi / 2 * nodes, indexing="ij")
    y, x = TRANSVERSE * np.sin(across), ROLLING * np.cos(across) * np.sin(length)
    slip = np.stack([creepages.along + bend * y**2 - creepages.spin * y, (creepages.spin - 2 * bend * y) * x])
    weight = np.outer(weights, weights) * (np.pi / 2) ** 2 * np.cos(across) ** 3 * np.cos(length) ** 2
    e_x, e_y = -slip / np.hypot(*slip) * weight
    whole = np.array([np.sum(e_x), np.sum(x * e_y - y * e_x), np.sum(y * y * e_x - 2 * x * y * e_y)])
    along_force, spin_moment, bend_moment = friction * peak * ROLLING * TRANSVERSE * whole
    scale = friction * LOAD
    # 30 strips: slip turns round within some.
    np.testing.assert_allclose(found.force_along, along_force, atol=0.01 * scale)
    np.testing.assert_allclose(found.spin_moment, spin_moment, atol=5e-3 * scale * TRANSVERSE)
    np.testing.assert_allclose(found.bend_moment, bend_moment, atol=3e-3 * scale * TRANSVERSE**2)


CASES = [  # creepages of spin and of free rolling, friction
    (conformity(0.23, 0.35), 0.1),
    (conformity(0.02, 0.36), 0.12),
    (conformity(-0.6, 0.3), 0.05),
    (conformity(0.1, 0.35)._replace(across=4e-4), 0.08),
]


@pytest.mark.parametrize("influence", [LIKE, HYBRID])
@pytest.mark.parametrize(("creepages", "friction"), CASES)
def test_power_is_positive_and_that_of_forces_times_creepages(
    creepages: Creepages, friction: float, influence: HalfSpaces
) -> None:
    contact, found = case(race_strips(16, 10), influence), None
    for _ in range(4):
        found = contact.rolls(creepages, friction, found)
    assert found is not None
    assert found.power > 0
    assert np.all(np.sum(found.traction * found.slip, axis=0) <= 1e-12 * found.power / found.strips.area)
    # The surfaces store nothing that they do not give back: what remains is the error of ten rectangles. Pressure that
    # moves unlike surfaces along each other gives a part of its own.
    if influence is LIKE:
        np.testing.assert_allclose(found.friction_power, found.power, rtol=0.025)


def test_responses_are_derivatives_of_the_forces() -> None:
    contact, (creepages, friction) = case(race_strips(10, 6)), CASES[3]
    found = contact.rolls(creepages, friction)
    for number, size in enumerate((1e-5, 30.0, 1e-5, 0.03)):
        step = 1e-4 * size
        above, below = (
            contact.rolls(Creepages(*(np.array(creepages) + sign * step * np.eye(4)[number])), friction, None).forces
            for sign in (1, -1)
        )
        # A rectangle that begins to slip is a kink: few do over this step.
        expected = (above - below) / (2 * step)
        np.testing.assert_allclose(found.response[:, number], expected, rtol=2e-3, atol=1e-3 * np.max(np.abs(expected)))


@pytest.mark.parametrize("influence", [LIKE, HYBRID])
def test_mirrored_creepages_have_mirrored_forces(influence: HalfSpaces) -> None:
    contact, (creepages, friction) = case(race_strips(12, 8), influence), CASES[3]
    mirrored = creepages._replace(across=-creepages.across, spin=-creepages.spin)
    here, there = (contact.rolls(each, friction) for each in (creepages, mirrored))
    np.testing.assert_allclose(forces(there), forces(here) * [1, -1, -1], atol=1e-7 * friction * LOAD)  # settled
    np.testing.assert_allclose(there.traction[0], here.traction[0][::-1], atol=1e-7 * np.max(here.traction))
    np.testing.assert_allclose(there.traction[1], -here.traction[1][::-1], atol=1e-7 * np.max(here.traction))


def test_a_reversed_slip_reverses_the_forces_of_like_materials_only() -> None:
    for influence, same in ((LIKE, True), (HYBRID, False)):
        contact, (creepages, friction) = case(race_strips(12, 8), influence), CASES[0]
        here, there = (contact.rolls(Creepages(*(sign * np.array(creepages))), friction) for sign in (1, -1))
        close = np.allclose(forces(there), -forces(here), atol=1e-6 * friction * LOAD)
        assert close == same


def test_published_prototype_of_one_contact() -> None:
    """Of a 6205: M_z, M_r and F_y over mu Q b, mu Q b^2/R and mu Q by a separate program, at friction 0.1.

    That program leaves out that conformity turns the bodies: a slip of the pressed bodies takes it off.
    """
    friction, found = 0.1, None
    creepages = conformity(0.23, 0.35)
    contact = case(race_strips(24, 12, sides=(-5.7e-4, 1.4e-4)))
    turns = creepages.along_bend * contact.surfaces.patterns[..., 1] * np.array([0.0, 1.0])[:, None, None]
    contact = contact._replace(pressed=-turns)
    for _ in range(8):
        found = contact.rolls(creepages, friction, found)
        along = creepages.along - found.force_along / found.response[0, 0]
        creepages = creepages._replace(along=along)
    assert found is not None
    assert abs(found.force_along) < 1e-4 * friction * LOAD
    scale = friction * LOAD
    rolling = np.sum(found.traction[0] * (found.strips.y / TRANSVERSE) ** 2 * found.strips.area) / 2 / scale
    # Three digits, extrapolated there from 14 and 28 rectangles; its F_y has two.
    np.testing.assert_allclose(abs(found.spin_moment) / scale / TRANSVERSE, 0.207, rtol=0.01)
    np.testing.assert_allclose(abs(rolling), 0.0569, rtol=0.015)
    np.testing.assert_allclose(abs(found.force_across) / scale, 0.17, atol=0.006)


def test_a_slip_of_the_pressed_bodies_acts_as_the_creepage_of_its_pattern() -> None:
    surfaces, pressure, _ = case(race_strips(6, 5))
    law = sliding_law(PointLaw(boundary=0.07), pressure=pressure, speed=0.7)
    part, rest = Creepages(3e-4, 0.0, -2e-4, 0.09), Creepages(1e-4, 0.0, 7e-4, 0.05)
    together = Creepages(*np.add(part, rest))
    found = rolling_friction(surfaces, rest, pressure=pressure, law=law, pressed=surfaces.patterns @ np.array(part))
    expected = rolling_friction(surfaces, together, pressure=pressure, law=law)
    np.testing.assert_allclose(forces(found), forces(expected), rtol=1e-9)  # both end where Newton's method does
