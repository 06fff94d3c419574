"""Bodies under pressure and tractions against half spaces on rectangles, Betti, symmetry and finer meshes."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scene import Array, Contact, Material
from fembearing.creep.half_space import HalfSpaces
from fembearing.creep.strips import Strips
from fembearing.fem.compliance import WHOLE, PairCompliance, sampled_pair, tangent_frame, values_of, whole_compliance
from fembearing.fem.elasticity import surface_mass
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.half_space import approach_under, contact_modulus, plane_strain_modulus, pressed_rectangle
from fembearing.fem.traction import ACROSS, ALONG, NORMAL, Axis, worked
from fembearing.fem.twin import shared_axes
from fembearing.mesh.bodies import Block, BodyMesh
from fembearing.mesh.footprint import Footprint
from fembearing.mesh.half_space import flat_block
from fembearing.mesh.recipe import load_recipe
from tests.contacts import CONTACTS, INNER, NITRIDE, PEEK

RECIPE = load_recipe("race")
ALLOY = Material(name="alloy", youngs_modulus=71.0, poisson_ratio=0.34, density=2.7, source="test")
RIGID = Material(name="rigid", youngs_modulus=1e12, poisson_ratio=0.5, density=2.7, source="test")
AXES = 0.8, 1.7
FRAME = np.eye(3)[:, :, None]
AXIS = np.array([term.axis for term in WHOLE])
CUT = 24  # rectangles in each direction; their error is 1.6 % of a work, that of the mesh 4 %


def flat(level: int, side: int) -> BodyMesh:
    block = Block(recipe=RECIPE, level=level, semi_axes=AXES, reach=4 * AXES[1])
    return flat_block(block, Footprint(semi_axes=AXES), side=1 if side > 0 else -1)


def sampled(body: BodyMesh) -> Array:
    """(m, terms) forces under sqrt(1 - x^2/a^2 - y^2/b^2) times each term."""
    x, y = (body.mesh.doflocs[axis, body.touching] / AXES[axis] for axis in range(2))
    root = np.sqrt(np.maximum(0, 1 - x**2 - y**2))
    return surface_mass(body.mesh, body.touching) @ (root[:, None] * values_of(WHOLE, x, y))


def rectangles() -> Strips:
    """Over the ellipse, without the offsets that suit rolling."""
    faces = -np.cos(np.linspace(0, np.pi, CUT + 1))
    middle = (faces[1:] + faces[:-1]) / 2
    half = AXES[0] * np.sqrt(1 - middle**2)
    strips = Strips(middle=AXES[1] * middle, width=AXES[1] * np.diff(faces), rear=-half, front=half, cells=CUT)
    length = 2 * half / CUT
    vars(strips)["length"] = length
    vars(strips)["edges"] = -half[:, None] + length[:, None] * np.arange(CUT + 1)
    return strips


@pytest.fixture(scope="module")
def by_rectangles() -> Array:
    """(terms, terms) work of each load on the displacement by each other one, on a half space."""
    strips = rectangles()
    x, y, area = strips.x.ravel(), strips.y.ravel(), strips.area.ravel()
    x_over, y_over = x / AXES[0], y / AXES[1]
    load = np.sqrt(1 - x_over**2 - y_over**2)[:, None] * values_of(WHOLE, x_over, y_over)
    moved = np.zeros((3, x.size, len(WHOLE)))
    tangential = HalfSpaces(ball=ALLOY, race=RIGID)
    influence = tangential.by_traction(strips, x, y)
    for number, term in enumerate(WHOLE):
        if term.axis == NORMAL:
            pressure = load[:, number]
            moved[:2, :, number] = tangential.by_pressure(strips, pressure.reshape(CUT, CUT), x, y)
            sides = np.repeat(strips.length, CUT) / 2, np.repeat(strips.width, CUT) / 2
            for each, (half_x, half_y) in enumerate(zip(*sides, strict=True)):
                sunk = pressed_rectangle(x - x[each], y - y[each], half_sides=(half_x, half_y))
                moved[2, :, number] += sunk * pressure[each] * area[each] / (np.pi * plane_strain_modulus(ALLOY))
        else:
            moved[:2, :, number] = influence[:, term.axis] @ load[:, number]
    work = np.array([(load[:, n] * area) @ moved[term.axis] for n, term in enumerate(WHOLE)])
    pulls = (AXIS[:, None] == NORMAL) & (AXIS != NORMAL)  # pressed_rectangle has no part along the surface: by Betti
    return np.where(pulls, work.T, work)


@pytest.mark.parametrize("side", [1, -1])
def test_a_half_space_works_as_on_rectangles(by_rectangles: Array, side: int) -> None:
    """Of either side, all three components, each by each: Cerruti, Boussinesq and the planes of all four parities."""
    body = flat(2, side)
    directions = FRAME * np.array([1, 1, side])[:, None]
    found = 4 * worked(
        body, material=ALLOY, directions=directions, terms=WHOLE, force=sampled(body), depth=1 if side > 0 else -1
    )
    size = np.sqrt(np.diag(by_rectangles))
    error, scaled = (found - by_rectangles) / np.outer(size, size), by_rectangles / np.outer(size, size)
    same = AXIS[:, None] == AXIS
    assert np.abs(error[same]).max() < 0.06
    assert np.abs(scaled[~same]).max() > 0.1  # one component moves the others
    assert np.abs(error[~same]).max() < 0.01
    # Betti holds to the error of the far boundary: forces at nodes act there as the load itself.
    np.testing.assert_allclose(found / np.outer(size, size), found.T / np.outer(size, size), atol=1e-4)


def axes_of(contact: Contact) -> tuple[float, float]:
    return shared_axes(expected_semi_axes(contact, geometry="real"))


@cache
def whole(contact: Contact, level: int, semi_axes: tuple[float, float] | None = None) -> PairCompliance:
    axes = axes_of(contact) if semi_axes is None else semi_axes
    return whole_compliance(contact, recipe=RECIPE, level=level, semi_axes=axes)


def disk() -> tuple[Array, Array, Array]:
    """Places in the unit circle, and a load of 1 N over them as Hertz's."""
    ticks = (np.arange(30) + 0.5) / 15 - 1
    x, y = (part.ravel() for part in np.meshgrid(ticks, ticks))
    inside = x**2 + y**2 < 1
    x, y = x[inside], y[inside]
    root = np.sqrt(1 - x**2 - y**2)
    return x, y, root / root.sum()


def on_plane(contact: Contact, race: Material) -> PairCompliance:
    """A sphere on a plane, with a contact so large that the sphere adds per cents."""
    shape = {"groove_radius": np.inf, "rolling_radius": np.inf, "shoulder": np.inf, "far_shoulder": np.inf}
    a, _ = expected_semi_axes(replace(contact, **shape))
    return whole(replace(contact, **shape, contact_angle=0.0, race_material=race), 1, (3 * a, 3 * a))


@pytest.fixture(scope="module")
def on_flat() -> PairCompliance:
    return on_plane(INNER, NITRIDE)


def test_a_plane_adds_nothing_however_soft(on_flat: PairCompliance) -> None:
    """Beside its own yielding, 50 times that of the ball, where one direction of a push would be as large."""
    soft = on_plane(INNER, PEEK)
    x, y, load = disk()
    a, _ = soft.semi_axes
    place = a * x, a * y
    approach = approach_under((a, a), load=1.0, modulus=contact_modulus(soft.contact))
    push = load * np.array([np.ones_like(x) + x, 0.7 - y, 1.1 + 0 * x])
    found, ball = (moved(each, push, place=place, loaded=place) / approach for each in (soft, on_flat))
    # Columns of the plane start where the normals of the ball meet it: a 2 % wider grid than that of its twin.
    np.testing.assert_allclose(np.ptp(found - ball, axis=1), 0, atol=0.02)


Places = tuple[Array, Array]


def moved(pair: PairCompliance, push: Array, *, place: Places, loaded: Places) -> Array:
    """(3, m) displacement of all components by forces (3, m) of all components."""
    axes: tuple[Axis, ...] = (ALONG, ACROSS, NORMAL)
    return np.array(
        [
            np.sum([pair.added_influence(place, loaded, moves=moves, by=by) @ push[by] for by in axes], axis=0)
            for moves in axes
        ]
    )


@pytest.mark.parametrize("turn", [np.pi / 2, np.pi / 5])
def test_a_sphere_on_a_plane_has_no_direction(on_flat: PairCompliance, turn: float) -> None:
    """A turned load moves it by the turned displacement: all parities, and the coupling of components, agree."""
    x, y, load = disk()
    cosine, sine = np.cos(turn), np.sin(turn)
    matrix = np.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]])
    before = cosine * x + sine * y, -sine * x + cosine * y  # where the turned load comes from

    def push(x: Array, y: Array) -> Array:
        return load * np.array([0.7 + 0.3 * x - 0.4 * x * y, -0.2 + 0.5 * x + y**2, 1 + 0.6 * y])

    a, _ = on_flat.semi_axes
    place, source = (a * x, a * y), (a * before[0], a * before[1])
    found = moved(on_flat, matrix @ push(*before), place=place, loaded=place)
    expected = matrix @ moved(on_flat, push(*before), place=source, loaded=source)
    # A quarter turn swaps x and y, which the mesh does too. Else the cells' own directions are left, on a first level.
    allowed = 1e-11 if turn == np.pi / 2 else 0.01
    for component in range(3):
        size = np.ptp(expected[component])
        np.testing.assert_allclose(found[component] / size, expected[component] / size, atol=allowed)


@pytest.mark.parametrize("pair", ["inner", "outer"])
def test_a_first_level_is_near_a_second_one(pair: str) -> None:
    """Each load by Hertz's form times a term; the error is over the approach of that load along the normal."""
    contact = CONTACTS[pair]
    axes = axes_of(contact)
    first, second = (whole(contact, level) for level in (1, 2))
    x, y, load = disk()
    place = axes[0] * x, axes[1] * y
    approach = approach_under(axes, load=1.0, modulus=contact_modulus(contact))
    largest = 0.0
    for axis in (ALONG, ACROSS):
        for term in (np.ones_like(x), x, y, x * y):
            for moves in (ALONG, ACROSS):
                coarse, fine = (
                    each.added_influence(place, place, moves=moves, by=axis) @ (load * term) / approach
                    for each in (first, second)
                )
                coarse, fine = (each - np.average(each, weights=load) for each in (coarse, fine))
                largest = max(largest, float(np.ptp(fine)))
                assert np.abs(coarse - fine).max() < 6e-3, (axis, moves)
    assert largest > 0.02  # what is added counts


@pytest.mark.parametrize("pair", ["inner", "outer"])
def test_even_pressure_is_that_of_the_condensed_bodies(pair: str) -> None:
    """Condensation has another far field, another fit and no tractions."""
    contact = CONTACTS[pair]
    axes = axes_of(contact)
    _, condensed = sampled_pair(contact, recipe=RECIPE, level=2, semi_axes=axes, sides="even")
    x, y, load = disk()
    place = axes[0] * x, axes[1] * y
    approach = approach_under(axes, load=1.0, modulus=contact_modulus(contact))
    found = whole(contact, 2).added_displacement(*place, load) / approach
    expected = condensed.added_displacement(*place, load) / approach
    assert np.abs(expected).min() > 0.02
    np.testing.assert_allclose(found, expected, atol=3e-4)  # noise of single nodes, which both smooth


@pytest.mark.parametrize("pair", ["inner", "outer"])
def test_maxwell_and_betti(pair: str) -> None:
    """What one load does to the displacement of another one, that one does to it."""
    found = whole(replace(CONTACTS[pair], race_material=NITRIDE), 1).added
    size = np.abs(found).max()
    couples = found[np.ix_(AXIS == NORMAL, AXIS != NORMAL)]
    assert np.abs(couples).max() > 0.05 * size
    # The far boundary of a block is that of a half space, which its groove is not.
    np.testing.assert_allclose(found, found.T, atol=4e-3 * size)


def test_outside_the_ellipse_the_edge_holds() -> None:
    pair = whole(INNER, 1)
    rng = np.random.default_rng(7)
    angle, far = rng.uniform(0, 2 * np.pi, 9), rng.uniform(1.1, 30.0, 9)
    edge = pair.semi_axes[0] * np.cos(angle), pair.semi_axes[1] * np.sin(angle)
    outside = far * edge[0], far * edge[1]
    load = rng.uniform(0.2, 0.9, 9)
    for moves in (ALONG, ACROSS, NORMAL):
        for by in (ALONG, ACROSS, NORMAL):
            inner, outer = (pair.added_influence(each, each, moves=moves, by=by) for each in (edge, outside))
            np.testing.assert_allclose(outer, inner, atol=1e-12 * np.abs(inner).max())  # round-off
    np.testing.assert_allclose(
        pair.added_displacement(*outside, load), pair.added_displacement(*edge, load), rtol=1e-12
    )


def test_a_contact_that_a_shoulder_cuts_off_is_refused() -> None:
    contact = replace(INNER, shoulder=0.9e-3)
    with pytest.raises(InputError, match=r"372 N .* past its shoulder .* or take half spaces") as caught:
        whole(contact, 1)
    assert "\n" not in str(caught.value)


def test_a_frame_on_a_surface_is_turned_upright_about_a_level_axis() -> None:
    """Rodrigues's rotation that takes z to the normal upwards."""
    for tilt, turn in ((0.3, 0.7), (0.9, -2.1)):
        level = np.array([np.cos(turn), np.sin(turn), 0.0])
        cross = np.array([[0, 0, level[1]], [0, 0, -level[0]], [-level[1], level[0], 0]])
        rotation = np.eye(3) + np.sin(tilt) * cross + (1 - np.cos(tilt)) * cross @ cross
        frame = tangent_frame(-rotation[:, [2]])[:, :, 0]
        np.testing.assert_allclose(frame, rotation.T, atol=1e-15)  # rows are the turned x, y and z
