"""What the numerical film refuses, the shapes of the gap, the oil and the grid."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.oil.viscosity import roelands_viscosity
from analytic.scene import Contact
from fembearing.ehl.ball_on_race import lubricated_contact
from fembearing.ehl.contact import Reach
from fembearing.ehl.grid import graded_faces
from fembearing.ehl.oil import Oil
from fembearing.ehl.shape import BallOnRace, Paraboloid
from fembearing.ehl.solver import require_few_cells
from tests.contacts import STEEL
from tests.ehl.contacts import moes

OIL = Oil(viscosity=0.0127, pressure_viscosity=1.9e-8)
RACE = Contact(
    pair="inner",
    ball_radius=3.97e-3,
    groove_radius=4.13e-3,
    rolling_radius=15.9e-3,
    shoulder=2.56e-3,
    far_shoulder=3.54e-3,
    contact_angle=0.18,
    load=372.0,
    ball_material=STEEL,
    race_material=STEEL,
)


RACE_SHAPE = BallOnRace(ball_radius=3.97e-3, race_radius=15.9e-3, groove_radius=4.13e-3)
USUAL, CIRCLE = moes(23.0, 5.0, 0.47), moes(23.0, 5.0)
WIDE = replace(USUAL, reach=Reach(ahead=0.01, behind=0.01, side=0.02))
MOST = WIDE.load * (5e9 / WIDE.peak_pressure) ** 3  # N: Hertz's pressure goes as the cube root


@pytest.mark.parametrize(
    ("sound", "changes", "message"),
    [
        (USUAL, {"load": 0.0}, r"load must be positive, got 0 N"),
        (USUAL, {"speed": 0.0}, r"at standstill there is no film"),
        (USUAL, {"shape": Paraboloid(rolling_radius=9.5e-3, transverse_radius=4.1e-3)}, r"longer in rolling than"),
        (CIRCLE, {"shape": Paraboloid(rolling_radius=9.500000019e-3, transverse_radius=9.5e-3)}, r"R_x up to R_y"),
        (WIDE, {"load": 1.001 * MOST}, r"Hertz's pressure of 5 GPa exceeds 5 GPa"),
        (USUAL, {"reach": Reach(ahead=2e-6, behind=4e-4, side=6e-4)}, r"ahead of 2 um is shorter than the contact"),
        (USUAL, {"reach": Reach(ahead=4e-4, behind=4e-4, side=2e-6)}, r"ends at 2 um, .* raise shoulder_half_width"),
        (OIL, {"pressure_viscosity": -1e-9}, "pressure_viscosity"),
        (OIL, {"viscosity": 0.0}, "viscosity"),
        (OIL, {"cavitation_pressure": -math.inf}, "cavitation_pressure"),
        (RACE_SHAPE, {"ball_radius": 0.0}, "ball_radius must be positive"),
        (RACE_SHAPE, {"race_radius": 0.0}, "does not fit race_radius 0 m"),
        (RACE_SHAPE, {"race_radius": -3.97e-3}, "does not fit race_radius -0.00397 m"),
        (RACE_SHAPE, {"race_radius": math.nan}, "does not fit race_radius nan m"),
        (RACE_SHAPE, {"groove_radius": 3.97e-3}, "does not fit groove_radius 0.00397 m"),
    ],
)
def test_what_has_no_film_is_refused_in_one_line(sound: Any, changes: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message) as refused:
        replace(sound, **changes)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    ("sound", "changes"),
    [
        (CIRCLE, {"shape": Paraboloid(rolling_radius=9.50000000475e-3, transverse_radius=9.5e-3)}),  # round-off
        (WIDE, {"load": 0.999 * MOST}),
        (OIL, {"pressure_viscosity": 0.0, "cavitation_pressure": 0.0}),
        (RACE_SHAPE, {"race_radius": 1e-4, "groove_radius": 3.98e-3}),
        (RACE_SHAPE, {"race_radius": -4e-3}),
    ],
)
def test_limits_themselves_are_covered(sound: Any, changes: dict[str, Any]) -> None:
    replace(sound, **changes)


def test_a_dry_contact_and_a_pocket_are_refused() -> None:
    with pytest.raises(InputError, match="dry"):
        lubricated_contact(RACE, oil=None, entrainment_speed=0.47)
    with pytest.raises(InputError, match="pocket"):
        lubricated_contact(replace(RACE, pair="pocket"), oil=OIL, entrainment_speed=0.47)


def test_a_ball_on_a_race_is_lubricated_to_its_outline_and_its_shoulders() -> None:
    found = lubricated_contact(RACE, oil=OIL, entrainment_speed=-0.47)
    assert found.speed == 0.47
    assert found.reach.ahead == found.reach.behind == pytest.approx(0.9 * 3.97e-3)
    assert found.reach.side == pytest.approx((2.56e-3 + 3.54e-3) / 2)
    wide = lubricated_contact(replace(RACE, far_shoulder=7e-3), oil=OIL, entrainment_speed=0.47)
    assert wide.reach.side == pytest.approx(0.99 * 3.97e-3)
    given = lubricated_contact(RACE, oil=OIL, entrainment_speed=0.47, ahead=1.1e-3, behind=1.3e-3)
    assert (given.reach.ahead, given.reach.behind) == (1.1e-3, 1.3e-3)
    assert found.ellipticity == pytest.approx((1 / 3.97 - 1 / 4.13) / (1 / 3.97 + 1 / 15.9))


@pytest.mark.parametrize("groove_radius", [4.13e-3, math.inf])
@pytest.mark.parametrize("race_radius", [15.9e-3, -23.8e-3, math.inf])
def test_gap_of_circles_is_the_distance_along_the_normal_of_the_contact(
    race_radius: float, groove_radius: float
) -> None:
    """Both bodies as sets of points: the ball x^2 + y^2 + (z - r)^2 = r^2, the race a torus about its axis."""
    ball = 3.97e-3
    shape = BallOnRace(ball_radius=ball, race_radius=race_radius, groove_radius=groove_radius)
    x, y, step = np.array(1.1e-3), np.array(1.7e-3), 1e-7
    height_of_ball = ball - np.sqrt(ball**2 - x**2 - y**2)
    rise = 0.0 if math.isinf(groove_radius) else groove_radius - np.sqrt(groove_radius**2 - y**2)
    height_of_race = rise
    if not math.isinf(race_radius):  # the axis lies at z = -race_radius; a point of the race keeps its distance from it
        height_of_race = -race_radius + math.copysign(np.sqrt((race_radius + rise) ** 2 - x**2), race_radius)
    np.testing.assert_allclose(shape.gap(x, y), height_of_ball - height_of_race, rtol=1e-9)
    difference = (shape.gap(x + step, y) - shape.gap(x - step, y)) / (2 * step)
    np.testing.assert_allclose(shape.slope(x, y), difference, rtol=1e-6)
    assert shape.radii == pytest.approx((1 / (1 / ball + 1 / race_radius), 1 / (1 / ball - 1 / groove_radius)))


@pytest.mark.parametrize("law", ["roelands", "barus"])
def test_slopes_of_the_oil_are_those_of_differences(law: str) -> None:
    oil = replace(OIL, law=law)
    pressure, step = np.array([3e6, 4e8, 1.7e9]), 1e3
    for values in (oil.log_viscosity, oil.density):
        difference = (values(pressure + step)[0] - values(pressure - step)[0]) / (2 * step)
        np.testing.assert_allclose(values(pressure)[1], difference, rtol=1e-5)  # round-off of a small step


def test_roelands_is_that_of_the_model_and_barus_its_limit() -> None:
    pressure = np.array([0.0, 2e8, 1.3e9])
    model = roelands_viscosity(
        pressure=pressure,
        temperature=313.0,
        viscosity=OIL.viscosity,
        pressure_viscosity=OIL.pressure_viscosity,
        reference_temperature=313.0,
        viscosity_temperature=0.03,
    )
    np.testing.assert_allclose(OIL.viscosity * np.exp(OIL.log_viscosity(pressure)[0]), model, rtol=1e-12)
    small = np.array([1e4])
    barus = replace(OIL, law="barus").log_viscosity(small)[0]
    np.testing.assert_allclose(OIL.log_viscosity(small)[0], barus, rtol=1e-4)  # the next term is 5.1e-9 p


def test_density_starts_at_ambient_and_ends_at_a_third_more() -> None:
    density, slope = OIL.density(np.array([0.0, 1e13]))
    assert density == pytest.approx([1.0, 1.34], rel=1e-4)
    assert slope[0] == pytest.approx(0.34 / 5.9e8)


def test_faces_have_the_sizes_that_are_asked_for_and_one_family() -> None:
    places, sizes = [-7.0, -1.2, 0.4, 3.0], [0.9, 0.11, 0.11, 0.4]
    coarse, fine = (graded_faces(places, sizes, refinement=each) for each in (2.0, 4.0))
    for faces, refinement in ((coarse, 2.0), (fine, 4.0)):
        assert faces[[0, -1]].tolist() == [-7.0, 3.0]
        centre = (faces[1:] + faces[:-1]) / 2
        wanted = np.interp(centre, places, sizes) / refinement
        # The number of cells is rounded, by half a cell in 55, and a cell spans a range of sizes.
        np.testing.assert_allclose(np.diff(faces), wanted, rtol=0.03)
    assert fine.size - 1 == pytest.approx(2 * (coarse.size - 1), abs=1)


def test_cells_of_very_different_sizes_do_not_overflow() -> None:
    """Cells of one size behind ten thousand small ones."""
    faces = graded_faces([0.0, 1.0, 2.0, 30.0], [1e-4, 1e-4, 1e-3, 9.0], refinement=0.9)
    assert np.all(np.diff(faces) > 0)
    assert faces[-1] == 30.0


def test_a_film_too_thin_for_the_memory_is_refused_before_it_is_tried() -> None:
    contact = replace(USUAL, speed=1e-12)
    with pytest.raises(InputError, match=r"too thin .* above 10000: give more speed or less load"):
        require_few_cells(contact, 1.0)
    require_few_cells(USUAL, 1.0)


@pytest.mark.parametrize(("race_radius", "outline"), [(15.9e-3, 3.97e-3), (-23.8e-3, 3.97e-3), (1.2e-3, 1.2e-3)])
def test_bodies_reach_as_far_as_the_smaller_circle(race_radius: float, outline: float) -> None:
    shape = replace(RACE_SHAPE, race_radius=race_radius)
    assert shape.outline == pytest.approx((0.99 * outline, 0.99 * 3.97e-3))
    assert Paraboloid(rolling_radius=0.01, transverse_radius=0.02).outline == (math.inf, math.inf)


def test_beyond_the_outline_of_the_ball_the_race_alone_changes_the_gap() -> None:
    """Its height at the outline is held; the groove and the ring go on."""
    shape, edge = RACE_SHAPE, 0.99 * 3.97e-3
    held = shape.ball_radius - math.sqrt(shape.ball_radius**2 - edge**2)
    x, y = np.array([3.1e-3]), np.array([2.9e-3])  # 4.2 mm from the centre
    rise = 4.13e-3 - math.sqrt(4.13e-3**2 - 2.9e-3**2)
    race = -15.9e-3 + math.sqrt((15.9e-3 + rise) ** 2 - 3.1e-3**2)
    np.testing.assert_allclose(shape.gap(x, y), held - race, rtol=1e-9)  # round-off of 16 mm
    step = 1e-8
    difference = (shape.gap(x + step, y) - shape.gap(x - step, y)) / (2 * step)
    np.testing.assert_allclose(shape.slope(x, y), difference, rtol=1e-6)


@pytest.mark.parametrize("name", ["ahead", "behind", "side"])
def test_oil_ends_outside_the_contact_and_inside_the_bodies(name: str) -> None:
    """At 1.25 semi-axes at least; the ball's outline lies at 3.93 mm."""
    found = lubricated_contact(RACE, oil=OIL, entrainment_speed=0.47)
    least = 1.25 * found.semi_axes[name == "side"]
    for reach, words in ((0.999 * least, "the oil's reach|the oil ends at"), (3.931e-3, "beyond the bodies")):
        with pytest.raises(InputError, match=words):
            replace(found, reach=replace(found.reach, **{name: reach}))
    for reach in (1.001 * least, 3.930e-3):
        replace(found, reach=replace(found.reach, **{name: reach}))


def test_a_share_of_the_thickening_is_a_softer_oil() -> None:
    """Of the logarithm and of its slope alike; incompressible oil keeps its density."""
    pressure = np.array([3e6, 4e8])
    for law in ("roelands", "barus"):
        oil = replace(OIL, law=law)
        for part, whole in zip(oil.log_viscosity(pressure, share=0.3), oil.log_viscosity(pressure), strict=True):
            np.testing.assert_allclose(part, 0.3 * whole, rtol=1e-12)
    density, slope = replace(OIL, compressible=False).density(pressure)
    assert (density.tolist(), slope.tolist()) == ([1.0, 1.0], [0.0, 0.0])
