"""What the numerical film refuses, the shapes of the gap, the oil and the grid."""

import math
from dataclasses import replace

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.oil.viscosity import roelands_viscosity
from analytic.scene import Contact
from fembearing.ehl.ball_on_race import lubricated_contact
from fembearing.ehl.contact import LubricatedContact, Reach
from fembearing.ehl.grid import cell_count, graded_faces
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


def changed(**changes: object) -> LubricatedContact:
    return replace(moes(23.0, 5.0, 0.47), **changes)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"load": 0.0}, r"load must be positive, got 0 N"),
        ({"speed": 0.0}, r"at standstill there is no film"),
        ({"shape": Paraboloid(rolling_radius=9.5e-3, transverse_radius=4.1e-3)}, r"longer in rolling than across"),
        ({"load": 3e4}, r"exceeds 5 GPa"),
        ({"reach": Reach(ahead=2e-6, behind=4e-4, side=6e-4)}, r"reach ahead of 2 um is shorter than the contact"),
        ({"reach": Reach(ahead=4e-4, behind=4e-4, side=2e-6)}, r"the oil ends at 2 um, .* raise shoulder_half_width"),
    ],
)
def test_what_has_no_film_is_refused_in_one_line(changes: dict[str, object], message: str) -> None:
    with pytest.raises(InputError, match=message) as refused:
        changed(**changes)
    assert "\n" not in str(refused.value)


def test_a_negative_reach_is_refused() -> None:
    with pytest.raises(InputError, match="behind must be positive"):
        Reach(ahead=0.003, behind=-0.002, side=0.004)


def test_oil_that_reaches_beyond_the_ball_is_refused() -> None:
    with pytest.raises(InputError, match="beyond the bodies"):
        lubricated_contact(RACE, oil=OIL, entrainment_speed=0.47, ahead=4.1e-3)


def test_a_dry_contact_and_a_pocket_are_refused() -> None:
    with pytest.raises(InputError, match="dry"):
        lubricated_contact(RACE, oil=None, entrainment_speed=0.47)
    with pytest.raises(InputError, match="pocket"):
        lubricated_contact(replace(RACE, pair="pocket"), oil=OIL, entrainment_speed=0.47)


def test_tension_needs_a_pressure_below_ambient() -> None:
    with pytest.raises(InputError, match="at most ambient"):
        Oil(viscosity=0.012, pressure_viscosity=2e-8, cavitation_pressure=2e5)


def test_a_ball_on_a_race_is_lubricated_to_its_outline_and_its_shoulders() -> None:
    found = lubricated_contact(RACE, oil=OIL, entrainment_speed=-0.47)
    assert found.speed == 0.47
    assert found.reach.ahead == pytest.approx(0.9 * 3.97e-3)
    assert found.reach.side == pytest.approx((2.56e-3 + 3.54e-3) / 2)
    assert found.ellipticity == pytest.approx((1 / 3.97 - 1 / 4.13) / (1 / 3.97 + 1 / 15.9))


@pytest.mark.parametrize("race_radius", [15.9e-3, -23.8e-3, math.inf])
def test_gap_of_circles_is_the_distance_along_the_normal_of_the_contact(race_radius: float) -> None:
    """Both bodies as sets of points: the ball x^2 + y^2 + (z - r)^2 = r^2, the race a torus about its axis."""
    ball, groove = 3.97e-3, 4.13e-3
    shape = BallOnRace(ball_radius=ball, race_radius=race_radius, groove_radius=groove)
    x, y = 1.1e-3, 1.7e-3
    height_of_ball = ball - math.sqrt(ball**2 - x**2 - y**2)
    rise = groove - math.sqrt(groove**2 - y**2)
    if math.isinf(race_radius):
        height_of_race = rise
    else:  # the axis lies at z = -race_radius; a point of the race keeps its distance from it
        distance = abs(-race_radius - rise)
        height_of_race = -race_radius + math.copysign(math.sqrt(distance**2 - x**2), race_radius)
    assert float(shape.gap(np.array(x), np.array(y))) == pytest.approx(height_of_ball - height_of_race, rel=1e-9)
    step = 1e-7
    difference = (shape.gap(np.array(x + step), np.array(y)) - shape.gap(np.array(x - step), np.array(y))) / (2 * step)
    assert float(shape.slope(np.array(x), np.array(y))) == pytest.approx(float(difference), rel=1e-6)


def test_circles_osculate_the_paraboloid_of_their_radii() -> None:
    shape = BallOnRace(ball_radius=3.97e-3, race_radius=15.9e-3, groove_radius=4.13e-3)
    rolling, across = shape.radii
    near = Paraboloid(rolling_radius=rolling, transverse_radius=across)
    x, y = np.array([2e-5, 0.0]), np.array([0.0, 9e-5])
    # The next term of a circle is (x/r)^2/4 of the first, and of the groove's two circles it is thrice that of one.
    np.testing.assert_allclose(shape.gap(x, y), near.gap(x, y), rtol=2e-3)


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


@pytest.mark.parametrize("refinement", [0.31, 1.7])
@pytest.mark.parametrize("sizes", [[0.3, 0.02, 0.02, 0.6], [0.5, 0.5, 0.5, 0.5]])
def test_cells_are_counted_without_a_grid(sizes: list[float], refinement: float) -> None:
    places = [-4.0, -1.1, 0.7, 9.0]
    faces = graded_faces(places, sizes, refinement=refinement)
    assert cell_count(places, sizes, refinement=refinement) == len(faces) - 1


def test_cells_of_very_different_sizes_do_not_overflow() -> None:
    """Cells of one size behind ten thousand small ones."""
    faces = graded_faces([0.0, 1.0, 2.0, 30.0], [1e-4, 1e-4, 1e-3, 9.0], refinement=0.9)
    assert np.all(np.diff(faces) > 0)
    assert faces[-1] == 30.0


def test_a_film_too_thin_for_the_memory_is_refused_before_it_is_tried() -> None:
    contact = changed(speed=1e-12)
    with pytest.raises(InputError, match=r"too thin .* above 10000: give more speed or less load"):
        require_few_cells(contact, 1.0)
    require_few_cells(changed(), 1.0)
