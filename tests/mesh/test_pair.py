"""The meshed bodies against their exact shapes, and the levels of a recipe against each other."""

import re
from contextlib import nullcontext
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray
from skfem import MeshHex2

from analytic.contact.geometry import pocket_contact
from analytic.errors import InputError
from fembearing.mesh.ball import block_of_ball, flat_ball
from fembearing.mesh.bodies import BodyMesh
from fembearing.mesh.footprint import Footprint
from fembearing.mesh.pair import PairMesh, pair_mesh
from fembearing.mesh.quality import mesh_quality
from fembearing.mesh.race import widest_on_race
from fembearing.mesh.recipe import load_recipe
from tests.analytic.specimens import BEARING_6205, STAMPED_CAGE
from tests.contacts import CONTACTS, INNER, OUTER

Array = NDArray[np.float64]
PAIRS, RECIPES = ("inner", "outer"), ("race", "hertzian")
SEMI_AXES = {"inner": (0.100e-3, 0.936e-3), "outer": (0.135e-3, 0.771e-3)}  # m, about those of 372 N
ROUND_OFF = 1e-12  # of a coordinate relative to the body's size, after a few dozen operations


def made(pair: str, recipe: str, level: int, extended: bool = False) -> PairMesh:
    shape = load_recipe(recipe)
    return pair_mesh(CONTACTS[pair], recipe=shape, level=level, semi_axes=SEMI_AXES[pair], extended=extended)


def surface(body: BodyMesh) -> Array:
    return body.mesh.doflocs[:, body.surface]


@pytest.mark.parametrize("level", [1, 2, pytest.param(4, marks=pytest.mark.slow)])
@pytest.mark.parametrize("recipe", RECIPES)
@pytest.mark.parametrize("pair", PAIRS)
def test_no_cell_is_inside_out(pair: str, recipe: str, level: int) -> None:
    """Over seven decades of load and grooves from tight to open; coarse cells fold most easily."""
    # N; level 4 costs the most and folds the least
    sizes = (1e-3, 0.21, 37.0, 620.0, 5000.0) if level < 4 else (1e-3, 620.0)
    for load in sizes:
        for conformity in (0.507, 0.53, 0.71):
            contact = replace(CONTACTS[pair], load=load, groove_radius=conformity * 7.94e-3)
            # the ellipse grows as load^(1/3) and, roughly, as the square root of how closely the groove fits
            longer = min(np.sqrt(0.02 / (conformity - 0.5)), 2.0) * np.cbrt(load / 372.0)
            semi_axes = SEMI_AXES[pair][0] * np.cbrt(load / 372.0), SEMI_AXES[pair][1] * longer
            if recipe == "race" and semi_axes[1] > 0.47 * contact.ball_radius:
                continue  # as good as half the ball's width; wider than 0.5 is refused, see below
            bodies = pair_mesh(contact, recipe=load_recipe(recipe), level=level, semi_axes=semi_axes)
            for body in (bodies.upper, bodies.lower):
                quality = mesh_quality(body.mesh)
                assert quality.valid, (load, conformity, body.name, quality)
                assert quality.least_determinant > 0, (load, conformity, body.name, quality)


def test_a_contact_too_wide_for_its_ball_is_refused() -> None:
    """With the load up to which the mesh holds: there is a mesh for its ellipse, and none for a little more."""
    contact, recipe = INNER, load_recipe("race")
    with pytest.raises(InputError, match=r"too wide for a ball of radius 3\.97 mm") as caught:
        pair_mesh(contact, recipe=recipe, level=1, semi_axes=(1.4e-3, 2.1e-3))
    assert "\n" not in str(caught.value)
    found = re.search(r"about (\S+) N", str(caught.value))
    assert found is not None
    share = (float(found[1]) / contact.load) ** (1 / 3)
    for factor, possible in ((0.98, True), (1.02, False)):  # two digits of the load are 1.7 % of a length or less
        axes = (factor * share * 1.4e-3, factor * share * 2.1e-3)
        with nullcontext() if possible else pytest.raises(InputError, match="too wide"):
            pair_mesh(contact, recipe=recipe, level=1, semi_axes=axes)


@pytest.mark.parametrize("clearance", [0.5e-6, 10e-6, 0.2e-3])
def test_a_conformal_pocket_is_meshed_up_to_its_limit_and_refused_beyond(clearance: float) -> None:
    """The limit is below a third of the ball's radius; on all levels, with the larger block."""
    cage = replace(STAMPED_CAGE, pocket_diameter=BEARING_6205.ball_diameter + clearance)
    contact, recipe = pocket_contact(BEARING_6205, cage, load=5.0), load_recipe("race")
    limit = widest_on_race(contact) / recipe.patch.margin_size
    assert 0.3 * contact.ball_radius < limit < contact.ball_radius / 3
    for level in recipe.levels[:3]:
        within = pair_mesh(contact, recipe=recipe, level=level, semi_axes=(0.99 * limit, 0.99 * limit), extended=True)
        assert all(mesh_quality(body.mesh).valid for body in (within.upper, within.lower))
    with pytest.raises(InputError, match=r"^pocket: 5 N .* about \S+ N\. Lower the load, or raise pocket_clearance"):
        pair_mesh(contact, recipe=recipe, level=1, semi_axes=(1.01 * limit, 1.01 * limit))


def test_a_folded_cell_is_detected_and_located() -> None:
    """mesh_quality itself: if it looked at |det J|, every mesh above would pass."""
    mesh = made("inner", "hertzian", 2).upper.mesh
    corner, centre = mesh.t[0, 17], mesh.p[:, mesh.t[:, 17]].mean(axis=1)
    folded = mesh.doflocs.copy()
    folded[:, corner] += 2.3 * (centre - folded[:, corner])  # past the centre: the corner turns inwards
    before, after = mesh_quality(mesh), mesh_quality(MeshHex2(folded, mesh.t))
    assert before.valid
    assert not after.valid
    assert after.negative_points > 0
    assert corner in mesh.t[:, after.worst_cell]
    assert np.abs(np.array(after.worst_place) - centre).max() < 3 * np.abs(mesh.p[:, corner] - centre).max()


def test_the_balls_volume_converges_to_an_octant() -> None:
    radius = OUTER.ball_radius
    exact = 4 / 3 * np.pi * radius**3 / 8
    errors = [abs(mesh_quality(made("outer", "race", level).upper.mesh).volume / exact - 1) for level in (1, 2, 3, 4)]
    assert errors[-1] < 1e-3
    # Quadratic cells on a smooth map would give order 4; this map is flat along the cube's outer edges, hence less.
    assert np.log(errors[1] / errors[3]) / np.log(2) > 2.5, errors


def test_the_balls_surface_is_a_sphere() -> None:
    ball = made("inner", "race", 3).upper
    radius = INNER.ball_radius
    x, y, z = surface(ball)
    np.testing.assert_allclose(x**2 + y**2 + (z - radius) ** 2, radius**2, rtol=ROUND_OFF)
    assert np.ptp(z) > 0.3 * radius  # the surface is more than its pole


@pytest.mark.parametrize("pair", PAIRS)
def test_the_races_surface_is_a_torus(pair: str) -> None:
    """In cylinder coordinates about the ring's axis the groove is a circle of radius r_g with its bottom on the ring.

    The ring's axis runs along y through z = -R; on the outer ring R < 0, so it lies on the ball's side.
    """
    contact = CONTACTS[pair]
    x, y, z = surface(made(pair, "race", 3).lower)
    from_axis = np.hypot(x, z + contact.rolling_radius)
    centre = abs(contact.rolling_radius) + np.sign(contact.rolling_radius) * contact.groove_radius
    groove = y < contact.shoulder
    circle = (from_axis - centre) ** 2 + y**2
    np.testing.assert_allclose(circle[groove], contact.groove_radius**2, rtol=1e-10)  # R/r_g round-offs of from_axis
    land = from_axis[~groove]
    assert land.size > 0
    assert groove.sum() > land.size
    np.testing.assert_allclose(land, land[0], rtol=ROUND_OFF)  # beyond the shoulder a cylinder, as high as the shoulder
    height = contact.groove_radius - np.sqrt(contact.groove_radius**2 - contact.shoulder**2)
    np.testing.assert_allclose((land[0] - abs(contact.rolling_radius)) * np.sign(contact.rolling_radius), height)


@pytest.mark.parametrize("pair", PAIRS)
def test_touching_nodes_face_each_other_along_the_balls_normal(pair: str) -> None:
    bodies = made(pair, "race", 2)
    radius = CONTACTS[pair].ball_radius
    ball = bodies.upper.mesh.doflocs[:, bodies.upper.touching]
    race = bodies.lower.mesh.doflocs[:, bodies.lower.touching]
    outwards = (ball - np.array([[0.0], [0.0], [radius]])) / radius
    np.testing.assert_allclose(bodies.normal, outwards, atol=ROUND_OFF)
    np.testing.assert_allclose(np.linalg.norm(bodies.normal, axis=0), 1.0, rtol=ROUND_OFF)
    np.testing.assert_allclose(race - ball, bodies.gap * outwards, atol=ROUND_OFF * radius)
    centre = np.hypot(*ball[:2]).argmin()
    assert abs(bodies.gap[centre]) < ROUND_OFF * radius
    others = np.delete(bodies.gap, centre)
    assert others.min() > 1e-9  # m: the ball touches at one point; the next node is at least 1 nm away
    assert bodies.gap.max() > 5e-6


@pytest.mark.parametrize("pair", PAIRS)
def test_the_idealised_gap_is_that_of_the_true_bodies_near_the_centre(pair: str) -> None:
    """On a mesh so small that quartic terms vanish; a wrong sign of either radius of the race fails here."""
    small = 2.1e-6, 13e-6  # m; (y/r)^2 is 1e-5
    real, ideal = (pair_mesh(CONTACTS[pair], recipe=load_recipe(r), level=1, semi_axes=small) for r in RECIPES)
    spread = ideal.gap.max()
    np.testing.assert_allclose(real.gap, ideal.gap, atol=3e-5 * spread)  # (margin y/r)^2 = 2e-5, and round-off
    assert spread > 0
    np.testing.assert_array_equal(ideal.normal[:2], 0.0)
    np.testing.assert_array_equal(ideal.normal[2], -1.0)  # out of the upper body is down
    above, below = (b.mesh.doflocs[:, b.touching] for b in (ideal.upper, ideal.lower))
    np.testing.assert_allclose(above, below, atol=1e-12 * small[1])


@pytest.mark.parametrize("recipe", RECIPES)
def test_node_sets_are_where_their_conditions_belong(recipe: str) -> None:
    bodies = made("outer", recipe, 2)
    reach = load_recipe(recipe).domain.extent * SEMI_AXES["outer"][1]
    for body in (bodies.upper, bodies.lower):
        place = body.mesh.doflocs
        for axis in (0, 1):
            in_plane = place[axis] < 1e-16 * np.abs(place).max()  # the cosine of pi/2 is 6e-17
            np.testing.assert_array_equal(body.planes[axis], np.flatnonzero(in_plane))
        assert set(body.touching) < set(body.surface)
        if body.name == "ball":
            radius = OUTER.ball_radius
            np.testing.assert_array_equal(body.planes[2], np.flatnonzero(np.abs(place[2] - radius) < 1e-9 * radius))
            assert body.far.size == 0
        else:
            edge = np.abs(place).max(axis=0) if recipe == "hertzian" else np.maximum(place[0], place[1])
            outside = (edge > (1 - 1e-9) * reach) | (np.abs(place[2]) > (1 - 1e-9) * reach)
            np.testing.assert_array_equal(body.far, np.flatnonzero(outside))
            assert not set(body.touching) & set(body.far)
            assert body.planes[2].size == 0


def lines(body: BodyMesh) -> list[Array]:
    """Where the cells' corners lie along x and y on the surface and along z under the centre, increasing."""
    corners = np.unique(body.mesh.t)
    place, on_surface = body.mesh.doflocs[:, corners], np.isin(corners, body.surface)
    zero = np.abs(place) < 1e-12 * np.abs(place).max()
    return [
        np.sort(place[0, on_surface & zero[1]]),
        np.sort(place[1, on_surface & zero[0]]),
        np.sort(np.abs(place[2, zero[0] & zero[1]])),
    ]


@pytest.mark.parametrize("recipe", RECIPES)
def test_levels_divide_every_cell_in_the_same_number(recipe: str) -> None:
    """Level n cuts each cell of level 1 into n, n, n, the outermost too: else an observed order means nothing."""
    shape = load_recipe(recipe).cells
    coarse = made("inner", recipe, 1)
    for level in (2, 3):
        fine = made("inner", recipe, level)
        for side in ("upper", "lower"):
            few, many = getattr(coarse, side), getattr(fine, side)
            assert many.mesh.t.shape[1] == level**3 * few.mesh.t.shape[1]
            for axis, (old, new) in enumerate(zip(lines(few), lines(many), strict=True)):
                least = shape.depth if axis == 2 else shape.core + shape.rings
                assert old.size - 1 >= least
                assert new.size - 1 == level * (old.size - 1)
                # columns of a race start where Newton's steps and their finite difference stop
                np.testing.assert_allclose(new[::level], old, atol=1e-11 * old[-1])


@pytest.mark.parametrize("level", [1, 3])
@pytest.mark.parametrize("recipe", RECIPES)
def test_a_ring_of_cell_faces_lies_on_the_expected_ellipse(recipe: str, level: int) -> None:
    bodies = made("inner", recipe, level)
    mesh = bodies.upper.mesh
    a, b = SEMI_AXES["inner"]
    reach = np.hypot(mesh.doflocs[0] / a, mesh.doflocs[1] / b)
    on_surface = np.isin(np.arange(reach.size), bodies.upper.surface)
    ring = on_surface & (np.abs(reach - 1) < 1e-9)  # the cube's map and its inverse cost a few digits
    base = load_recipe(recipe).cells
    assert ring.sum() == 4 * level * base.core + 1  # corners and middle nodes of two sides of the core
    margin = load_recipe(recipe).patch.margin_size
    rim = on_surface & (np.abs(reach - margin) < 1e-9)
    assert rim.sum() == ring.sum()
    assert reach[bodies.upper.touching].max() < margin - 1e-9  # nodes on the margin's rim and beyond stay free
    assert (reach[on_surface] < margin - 1e-9).sum() == bodies.upper.touching.size
    facets = mesh.facets[:, np.isin(mesh.facets, bodies.upper.surface).all(axis=0)]
    crossed = (reach[facets] < 1 - 1e-9).any(axis=0) & (reach[facets] > 1 + 1e-9).any(axis=0)
    assert not crossed.any()
    assert (reach[facets] < 1 + 1e-9).all(axis=0).sum() == (base.core**2 + 2 * base.core * base.inside) * level**2


@pytest.mark.parametrize("recipe", RECIPES)
def test_extending_adds_cells_around_a_block_and_moves_none(recipe: str) -> None:
    """The difference measures the effect of the far boundary, so that nothing else may differ."""
    shape = load_recipe(recipe)
    less, whole = (
        pair_mesh(INNER, recipe=shape, level=2, semi_axes=SEMI_AXES["inner"], extended=extended)
        for extended in (False, True)
    )
    np.testing.assert_array_equal(whole.gap, less.gap)
    for side in ("upper", "lower"):
        full, cut = getattr(whole, side), getattr(less, side)
        if full.name == "ball":
            np.testing.assert_array_equal(full.mesh.doflocs, cut.mesh.doflocs)
            continue
        distance = np.abs(cut.mesh.doflocs[:, :, None] - full.mesh.doflocs[:, None, :]).max(axis=0).min(axis=1)
        assert distance.max() < 1e-12 * np.abs(full.mesh.doflocs).max()  # round-off
        for before, after in zip(lines(full), lines(cut), strict=True):
            assert after.size < before.size
            assert before.max() == pytest.approx(2 * after.max(), rel=1e-9)  # round-off
        assert cut.far.size > 0
        assert not set(cut.far) & set(cut.touching)


@pytest.mark.parametrize("level", [1, 2])
def test_the_flat_ball_has_the_columns_and_the_layers_of_the_ball(level: int) -> None:
    """Upside down it is a lower body: column by column both have the same places, and depths on the load's axis."""
    contact, recipe = INNER, load_recipe("race")
    ball = pair_mesh(contact, recipe=recipe, level=level, semi_axes=SEMI_AXES["inner"]).upper
    flat = flat_ball(block_of_ball(contact, recipe, level, Footprint(semi_axes=SEMI_AXES["inner"])))
    scale = ROUND_OFF * contact.ball_radius
    assert np.abs(flat.mesh.doflocs[2, flat.surface]).max() < scale
    assert flat.mesh.doflocs[2].max() < scale
    np.testing.assert_allclose(*(body.mesh.doflocs[:2, body.touching] for body in (ball, flat)), rtol=0, atol=scale)
    seen, depths = [], []
    for place in (ball.mesh.doflocs, flat.mesh.doflocs):
        x, y, z = np.round(place / contact.ball_radius, 9)
        seen.append(np.array([x, y])[:, np.lexsort((y, x))])
        depths.append(np.sort(np.abs(z[np.hypot(x, y) == 0])))
    np.testing.assert_allclose(*seen, rtol=0, atol=2e-9)  # of rounding
    np.testing.assert_allclose(*depths, rtol=0, atol=2e-9)
    assert mesh_quality(flat.mesh).valid
