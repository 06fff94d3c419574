"""The measured quantities on pressures with known semi-axes and peak; and the first guess."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.scene import Array
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.fem.elasticity import strip_integrals, surface_mass
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.measure import STRIP, nodal_pressure, peak_pressure, semi_axis, shoulder_load, uncut_semi_axes
from fembearing.mesh.pair import PairMesh, pair_mesh
from fembearing.mesh.recipe import load_recipe
from tests.contacts import CONTACTS, OUTER

A, B, PEAK = 0.13e-3, 0.77e-3, 1.9e9  # m, m, Pa


@pytest.fixture(scope="module")
def pair() -> PairMesh:
    return pair_mesh(OUTER, recipe=load_recipe("hertzian"), level=3, semi_axes=(A, B))


def semi_ellipsoid(x: Array, y: Array) -> Array:
    return PEAK * np.sqrt(np.maximum(1 - (x / A) ** 2 - (y / B) ** 2, 0.0))


def test_semi_axes_of_a_semi_ellipsoidal_pressure() -> None:
    """Forces of the pressure on a fine even grid, with different semi-axes in x and y."""
    step = (np.arange(400) + 0.5) / 400
    x, y = (axis.ravel() for axis in np.meshgrid(A * step, B * step))
    force = semi_ellipsoid(x, y)
    np.testing.assert_allclose(semi_axis(x, force), A, rtol=2e-4)  # the grid's own error at the edge
    np.testing.assert_allclose(semi_axis(y, force), B, rtol=2e-4)


def test_peak_pressure_is_fitted_through_scatter() -> None:
    """Exact on the pressure itself; one wrong node at the centre, where raw values are worst, has little weight."""
    random = np.random.default_rng(9)
    x, y = random.uniform(0, A, 300), random.uniform(0, B, 300)
    x[0] = y[0] = 0.0
    area = random.uniform(0.4, 1.9, 300) * A * B / 300
    pressure = semi_ellipsoid(x, y)
    np.testing.assert_allclose(peak_pressure(x, y, pressure, area, semi_axes=(A, B)), PEAK, rtol=1e-12)  # round-off
    # The measured axes only choose the nodes
    np.testing.assert_allclose(peak_pressure(x, y, pressure, area, semi_axes=(1.03 * A, 0.96 * B)), PEAK, rtol=1e-12)
    pressure[0] *= 1.3
    assert 0 < peak_pressure(x, y, pressure, area, semi_axes=(A, B)) / PEAK - 1 < 0.02  # one of 150 nodes, 30 % off
    area[0] *= 1e-8
    np.testing.assert_allclose(peak_pressure(x, y, pressure, area, semi_axes=(A, B)), PEAK, rtol=1e-7)  # by its area


def test_nodal_pressure_gives_back_the_pressure_behind_the_forces(pair: PairMesh) -> None:
    """Any pressure that the shape functions can represent comes back exactly; this one falls along both axes."""
    x, y, _ = pair.upper.mesh.doflocs[:, pair.upper.touching]
    mass = surface_mass(pair.upper.mesh, pair.upper.touching)
    carrying = mass.diagonal() > 0
    assert carrying.sum() > 0.8 * carrying.size
    pressure = np.where(carrying, PEAK * (1.2 - 0.4 * x / A - 0.3 * y / B), 0.0)
    force = mass @ pressure
    found = nodal_pressure(force, mass)
    np.testing.assert_allclose(found, pressure, atol=1e-10 * PEAK)  # round-off times the condition of the mass
    total = PEAK * np.asarray(mass.sum(axis=1)).ravel()
    np.testing.assert_allclose(total.sum(), PEAK * mass.sum(), rtol=1e-12)
    assert 0.5 < mass.sum() / (1.4**2 * np.pi * A * B / 4) < 1  # quarter of the patch less its outermost cells


@pytest.mark.parametrize("name", ["inner", "outer"])
def test_the_first_guess_is_that_of_half_spaces(name: str) -> None:
    """From nearly round to nearly a line; the two directions are not exchanged."""
    for conformity in (0.505, 0.53, 0.7, 3.1):
        for load in (2e-3, 372.0):
            contact = replace(CONTACTS[name], groove_radius=conformity * 7.94e-3, load=load)
            exact = hertz_quantities(contact)
            expected = exact.semi_axis_rolling, exact.semi_axis_transverse
            np.testing.assert_allclose(expected_semi_axes(contact), expected, rtol=1e-12)  # round-off of a curvature


def test_over_both_sides_a_slope_does_not_change_the_peak() -> None:
    """In a cut contact p^2 has a transverse slope; the peak is its value at the centre, not its largest."""
    random = np.random.default_rng(4)
    x, y = random.uniform(0, A, 300), random.uniform(-B, 0.6 * B, 300)
    pressure = PEAK * np.sqrt(np.maximum(1 - (x / A) ** 2 - (y / B) ** 2 + 0.21 * y / B, 0.0))
    area = random.uniform(0.4, 1.9, 300) * A * B / 300
    found = peak_pressure(x, y, pressure, area, semi_axes=(A, B), half=True)
    np.testing.assert_allclose(found, PEAK, rtol=1e-12)  # round-off


def test_a_strip_has_the_area_of_its_part_of_the_ellipse(pair: PairMesh) -> None:
    """Shape functions sum to one, so that their integrals over a strip sum to its area; x and y differ."""
    x, y, _ = pair.upper.mesh.doflocs[:, pair.upper.touching]
    inside = np.hypot(x / A, y / B) < 1 + 1e-9
    low, high = 0.31 * B, 0.43 * B
    found = strip_integrals(pair.upper.mesh, pair.upper.touching[inside], low=low, high=high)
    middles = np.linspace(low, high, 2001)[:-1] + (high - low) / 4000
    area = np.mean(A * np.sqrt(1 - (middles / B) ** 2)) * (high - low)
    assert found.sum() == pytest.approx(area, rel=0.01)  # 30 points each way of a facet that the border crosses
    assert found @ y[inside] / found.sum() == pytest.approx((low + high) / 2, rel=0.01)  # as good


def test_the_uncut_side_alone_tells_the_ellipse() -> None:
    """Twice that side, with nodes on y = 0 counted once: the forces on the other side do not matter."""
    random = np.random.default_rng(6)
    x, y = random.uniform(0, A, 200), random.uniform(-B, B, 200)
    y[:20] = 0.0
    force = random.uniform(0.2, 1.7, 200)
    side = y < 0
    whole = np.append(x[side], [*x[side], *x[:20]]), np.append(y[side], [*-y[side], *y[:20]])
    both = np.append(force[side], [*force[side], *force[:20]])
    expected = semi_axis(whole[0], both), semi_axis(whole[1], both)
    for share in (1.0, 3.0):  # of the forces beyond y = 0
        found = uncut_semi_axes(x, y, np.where(y > 0, share * force, force))
        np.testing.assert_allclose(found, expected, rtol=1e-12)  # round-off


def test_a_strip_of_an_even_line_load_has_its_share() -> None:
    """q N/m from -s to s: a strip of 0.1 s has a twentieth of it, half on one side of x = 0."""
    line, shoulder = 3.1e5, 0.7e-3
    load = 2 * shoulder * line
    found = shoulder_load(centroid=-0.1e-3, strip_force=line * STRIP * shoulder / 2, shoulder=shoulder, load=load)
    np.testing.assert_allclose((found.strip_share, found.strip_line_load), (STRIP / 2, line), rtol=1e-12)
    assert found.centroid == -0.1e-3
