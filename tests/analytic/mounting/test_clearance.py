"""The clearance in operation against geometry, equal materials, free expansion, and the equilibrium of the ring."""

from dataclasses import replace
from typing import Any

import numpy as np

from analytic.loads.ring import ring_equilibrium
from analytic.mounting.clearance import Mounting, mounted
from analytic.scene import Bearing, Clearances, ContactAngle, Groove, Material
from tests import contacts
from tests.refusals import refused

STEEL = replace(contacts.STEEL, thermal_expansion=12.5e-6)
ALUMINIUM = Material(
    name="aluminium", youngs_modulus=70e9, poisson_ratio=0.33, density=2700.0, source="test", thermal_expansion=23.5e-6
)
NITRIDE = replace(STEEL, name="nitride", youngs_modulus=310e9, poisson_ratio=0.26, thermal_expansion=3e-6)
COLD = 293.15
EXACT = 1e-12  # closed forms, rounded a few times
SUBTRACTED = 1e-9  # of a clearance of some um that is the difference of radii of 20 mm


def bearing(**changed: Any) -> Bearing:
    inner, outer = (
        Groove(
            bottom_radius=bottom,
            groove_radius=4.13e-3,
            shoulder_half_width=2.9e-3,
            far_shoulder_half_width=1.7e-3,
            material=STEEL,
        )
        for bottom in (15.525e-3, 23.475e-3)
    )
    known = Bearing(
        name="like a 6205",
        ball_count=9,
        ball_diameter=7.938e-3,
        ball_mass=2.056e-3,
        ball_material=STEEL,
        inner=inner,
        outer=outer,
        bore_diameter=25e-3,
        outside_diameter=52e-3,
        width=15e-3,
    )
    return replace(known, **changed)


def seats(**changed: Any) -> Mounting:
    known: dict[str, Any] = {"shaft_material": STEEL, "housing_material": STEEL}
    return Mounting(**(known | changed))


def seated(given: Bearing | None = None, **changed: Any) -> Clearances:
    return mounted(given or bearing(), seats(**changed))[1]


def test_seats_of_the_rings_material_move_the_grooves_by_the_ratio_of_diameters() -> None:
    """Solid shaft: bore over groove. Housing without end: the ring is part of a plate with a hole, groove over seat."""
    found, known = seated(shaft_interference=14e-6, housing_interference=9e-6), bearing()
    shaft = 14e-6 * 25e-3 / (2 * known.inner.bottom_radius)
    housing = 9e-6 * 2 * known.outer.bottom_radius / 52e-3
    np.testing.assert_allclose(found.unmounted - found.mounted, shaft + housing, rtol=SUBTRACTED)
    assert found.operating == found.mounted  # nothing is warm


def test_a_loose_seat_has_no_effect() -> None:
    found = seated(shaft_interference=-4e-6, housing_interference=-11e-6)
    assert found.operating == found.mounted == found.unmounted
    assert (found.shaft_pressure, found.housing_pressure) == (0, 0)


def test_hollow_shaft_and_thin_housing_press_less() -> None:
    tight: dict[str, Any] = {"shaft_interference": 14e-6, "housing_interference": 9e-6}
    stiff, soft = seated(**tight), seated(**tight, shaft_bore=17e-3, housing_outside_diameter=61e-3)
    assert 0 < soft.shaft_pressure < stiff.shaft_pressure
    assert 0 < soft.housing_pressure < stiff.housing_pressure
    assert stiff.mounted < soft.mounted < soft.unmounted


def test_the_same_temperature_of_one_material_only_scales_the_bearing() -> None:
    warm: dict[str, Any] = {"inner_temperature": COLD + 57, "outer_temperature": COLD + 57}
    found = seated(**warm, shaft_interference=14e-6, housing_interference=9e-6)
    np.testing.assert_allclose(found.shaft_interference, 14e-6, rtol=EXACT)
    np.testing.assert_allclose(found.housing_interference, 9e-6, rtol=EXACT)
    # Rings and balls grow by this share, the clearance with them; what the seats do stays that of the nominal walls.
    growth = 57 * 12.5e-6
    np.testing.assert_allclose(found.operating - found.mounted, growth * found.unmounted, rtol=1e-6)


def test_free_parts_expand_each_by_itself() -> None:
    loose: dict[str, Any] = {"shaft_interference": -90e-6, "housing_interference": -90e-6}
    loose |= {"inner_temperature": COLD + 61, "outer_temperature": COLD + 38}
    known = bearing(ball_material=NITRIDE)
    found = seated(known, **loose, ball_temperature=COLD + 70)
    outer, inner = known.outer.bottom_radius * (1 + 12.5e-6 * 38), known.inner.bottom_radius * (1 + 12.5e-6 * 61)
    by_hand = 2 * (outer - inner - known.ball_diameter * (1 + 3e-6 * 70))
    np.testing.assert_allclose(found.operating, by_hand, rtol=SUBTRACTED)
    assert seated(known, **loose) == seated(known, **loose, ball_temperature=COLD + 49.5)  # the mean of both rings


def test_every_dimension_of_a_ring_grows_with_it() -> None:
    warm, _ = mounted(
        bearing(), seats(shaft_interference=-90e-6, inner_temperature=COLD + 61, outer_temperature=COLD + 38)
    )
    known = bearing()
    for name, rise in (("inner", 61), ("outer", 38)):
        for length in ("bottom_radius", "groove_radius", "shoulder_half_width", "far_shoulder_half_width"):
            ratio = getattr(getattr(warm, name), length) / getattr(getattr(known, name), length)
            np.testing.assert_allclose(ratio, 1 + 12.5e-6 * rise, rtol=EXACT)
    assert warm.ball_mass == known.ball_mass


def test_a_warm_housing_of_aluminium_lets_go_of_the_ring() -> None:
    warm: dict[str, Any] = {"inner_temperature": COLD + 40, "outer_temperature": COLD + 40}
    housing = seated(**warm, housing_material=ALUMINIUM, housing_interference=9e-6)
    np.testing.assert_allclose(housing.housing_interference, 9e-6 - 52e-3 * 11e-6 * 40, rtol=EXACT)
    assert housing.housing_pressure == 0
    assert housing.operating > housing.mounted
    shaft = seated(**warm, shaft_material=ALUMINIUM, shaft_interference=-2e-6)
    np.testing.assert_allclose(shaft.shaft_interference, -2e-6 + 25e-3 * 11e-6 * 40, rtol=EXACT)
    assert shaft.shaft_pressure > 0


def test_the_preload_of_the_balls_is_that_of_the_rings_equilibrium() -> None:
    tight, found = mounted(bearing(), seats(shaft_interference=38e-6))
    assert found.operating < 0
    balls = ring_equilibrium(tight, ContactAngle(rule="solved"))
    np.testing.assert_allclose(balls.balls["load"], found.ball_load, rtol=1e-9)  # the iteration's tolerance
    assert seated().ball_load == 0


def test_what_cannot_be_is_refused() -> None:
    for name in ("bore_diameter", "outside_diameter"):
        refused(lambda: seated(bearing(**{name: None})), f"bearing.{name} is missing")  # noqa: B023
    refused(lambda: seated(bearing(), shaft_bore=float("nan")), "shaft_bore", "finite")


def test_expansion_is_not_needed_where_nothing_is_warm() -> None:
    unknown = replace(STEEL, thermal_expansion=None)
    assert seated(housing_material=unknown, shaft_interference=5e-6).mounted < seated().mounted


def test_each_limit_is_the_first_that_is_refused() -> None:
    """0.5 % of a seat is its largest interference: 125 um of the bore and 260 um of the outside diameter."""
    nearly: dict[str, Any] = {"shaft_interference": 124.9e-6, "housing_interference": 259.9e-6}
    seated(**nearly, shaft_bore=24.9e-3, housing_outside_diameter=52.1e-3)
    for name, value, words in (
        ("shaft_interference", 125.1e-6, "125 um, 0.5% of the seat"),
        ("housing_interference", 260.1e-6, "260 um, 0.5% of the seat"),
        ("shaft_bore", 25e-3, "below bearing.bore_diameter 25 mm"),
        ("shaft_bore", -1e-3, "below bearing.bore_diameter 25 mm"),
        ("housing_outside_diameter", 52e-3, "must exceed bearing.outside_diameter 52 mm"),
    ):
        refused(lambda: seated(None, **{name: value}), f"mounting.{name}", words)  # noqa: B023


def test_each_part_that_gets_warm_needs_its_expansion() -> None:
    """The shaft has the temperature of the inner ring and the housing that of the outer ring; the balls their mean."""
    unknown = replace(STEEL, thermal_expansion=None)
    known = bearing()
    inner, outer = (replace(groove, material=unknown) for groove in (known.inner, known.outer))
    for part, given, seat, warm in (
        ("inner ring", bearing(inner=inner), {}, "inner_temperature"),
        ("outer ring", bearing(outer=outer), {}, "outer_temperature"),
        ("shaft", known, {"shaft_material": unknown}, "inner_temperature"),
        ("housing", known, {"housing_material": unknown}, "outer_temperature"),
        ("balls", bearing(ball_material=unknown), {}, "inner_temperature"),
        ("balls", bearing(ball_material=unknown), {}, "ball_temperature"),
    ):
        refused(lambda: seated(given, **seat, **{warm: COLD + 3}), f"'steel' of the {part} has no")  # noqa: B023
        if part != "balls":
            others = {"inner_temperature", "outer_temperature"} - {warm}
            seated(given, **seat, **dict.fromkeys(others, COLD + 3), ball_temperature=COLD)
