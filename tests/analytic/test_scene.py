"""What follows from the nouns of a scene: geometry of a bearing, losses, operating points, an arrangement."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.scene import (
    Arrangement,
    Groove,
    Losses,
    Operation,
    OwnTraction,
    Scene,
    ShearedPockets,
)
from tests.analytic.specimens import BEARING_6205, FINISH, OIL, thrust, with_clearance
from tests.analytic.test_thrust_bearing import BEARING as THRUST_BEARING
from tests.contacts import INNER, STEEL
from tests.refusals import refused


def test_a_bearing_has_its_pitch_clearance_and_centre_distance_by_hand() -> None:
    """Of table 1 of the paper, mm: 15.53 + 23.48, 2 (23.48 - 15.53 - 7.94), 4.13 + 4.21 - 7.94."""
    assert BEARING_6205.ball_radius == pytest.approx(3.97e-3, rel=1e-12)
    assert BEARING_6205.pitch_diameter == pytest.approx(39.01e-3, rel=1e-12)
    assert BEARING_6205.diametral_clearance == pytest.approx(20e-6, rel=1e-9)  # a small difference
    assert BEARING_6205.groove_centre_distance == pytest.approx(0.40e-3, rel=1e-9)


def test_a_bearing_is_a_deep_groove_bearing_by_its_series() -> None:
    for series, is_deep in (("62", True), ("618", True), ("72 B", False), ("NSK 72 C", False)):
        assert replace(BEARING_6205, series=series).is_deep_groove == is_deep
        assert replace(with_clearance(BEARING_6205, 0.5e-3), series=series).is_deep_groove == is_deep
    assert not THRUST_BEARING.is_deep_groove


@pytest.mark.parametrize(("degrees", "is_deep"), [(19.9, True), (20.1, False)])
def test_without_a_series_a_deep_groove_bearing_leans_by_twenty_degrees_at_most(degrees: float, is_deep: bool) -> None:
    """The clearance lets the groove centres, A_0 apart, lean by the angle: P_d = 2 A_0 (1 - cos al)."""
    clearance = 2 * 0.40e-3 * (1 - np.cos(np.radians(degrees)))
    assert with_clearance(BEARING_6205, clearance).is_deep_groove == is_deep
    assert with_clearance(BEARING_6205, -clearance).is_deep_groove  # preload closes the angle


def test_grease_starves_as_measured_in_a_deep_groove_bearing_alone() -> None:
    grease = replace(OIL, supply="grease")
    angular = replace(BEARING_6205, series="72 B")
    for oil, bearing, is_measured in (
        (grease, BEARING_6205, True),
        (OIL, BEARING_6205, False),
        (replace(grease, starvation_degree=3.0), BEARING_6205, False),
        (grease, angular, False),
    ):
        assert oil.starves_as_measured(bearing) == is_measured


def test_the_supply_starves_where_nothing_else_is_known() -> None:
    grease = replace(OIL, supply="grease")
    for oil, bearing, starves in (
        (OIL, BEARING_6205, True),
        (grease, replace(BEARING_6205, series="72 B"), True),
        (grease, BEARING_6205, False),
        (replace(OIL, starvation_degree=3.0), BEARING_6205, False),
        (OIL, replace(BEARING_6205, bore_diameter=None), False),
        (OIL, replace(BEARING_6205, outside_diameter=None), False),
    ):
        assert oil.starves_by_replenishment(bearing) == starves


def test_a_far_shoulder_is_as_far_as_the_near_one_unless_given() -> None:
    groove = Groove(bottom_radius=15e-3, groove_radius=4e-3, shoulder_half_width=3.1e-3, material=STEEL)
    assert groove.half_widths == (3.1e-3, 3.1e-3)
    assert replace(groove, far_shoulder_half_width=0.0).half_widths == (3.1e-3, 0.0)
    assert replace(groove, shoulder_half_width=None, far_shoulder_half_width=2e-3).half_widths == (None, 2e-3)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"kind": "tandem", "preload": 130.0}, 'preload does not go with kind = "tandem"'),
        ({"kind": "tandem", "offset": 2e-6}, 'offset does not go with kind = "tandem"'),
        ({"kind": "O", "preload": 130.0, "offset": 2e-6}, "leave one of them out"),
        ({"kind": "X"}, "needs one of preload and offset"),
    ],
)
def test_an_arrangement_has_one_clamping_or_is_a_tandem(given: dict[str, Any], words: str) -> None:
    refused(lambda: Arrangement(**given), words)


def test_clamped_pairs_and_tandems_are_arrangements() -> None:
    assert Arrangement(kind="O", preload=0.0).preload == 0
    assert Arrangement(kind="X", offset=2e-6).preload is None
    assert Arrangement(kind="tandem").offset is None


def test_declared_losses_are_those_of_seals_and_drag() -> None:
    assert Losses().total is None
    assert Losses(seals=3e-3).total == 3e-3
    assert Losses(seals=3e-3, drag=0.8e-3).total == pytest.approx(3.8e-3, rel=1e-12)
    assert not Losses(seals=3e-3, drag=0.8e-3).has_oil
    pockets = ShearedPockets(clearance=2e-4, thickness=9e-4)
    for name, value in (("oil_flow", 0.0), ("oil_share", 0.02), ("pockets", pockets)):
        assert Losses(**{name: value}).has_oil  # pyright: ignore[reportArgumentType]


def test_thrust_has_neither_a_radial_load_nor_a_moment() -> None:
    pure = thrust(310.0, 470.0)
    assert pure.is_thrust
    assert not replace(pure, radial_load=np.array([0.0, 3.0])).is_thrust
    assert not replace(pure, moment=-0.2).is_thrust


def test_a_series_has_arrays_of_one_length() -> None:
    series = Operation(axial_load=np.array([310.0, 470.0]), inner_speed=np.array(31.0), moment=0.7).as_series()
    for name, expected in (
        ("axial_load", [310.0, 470.0]),
        ("inner_speed", [31.0, 31.0]),
        ("radial_load", [0.0, 0.0]),
        ("moment", [0.7, 0.7]),
    ):
        np.testing.assert_array_equal(getattr(series, name), expected)
    one = Operation(axial_load=np.array(310.0), inner_speed=np.array(31.0)).as_series()
    assert one.axial_load.shape == (1,)
    unlike = Operation(axial_load=np.array([1.0, 2.0]), inner_speed=np.array([1.0, 2.0, 3.0]))
    refused(unlike.as_series, "shapes that do not fit")
    refused(Operation(axial_load=np.array([]), inner_speed=np.array([])).as_series, "is empty")


@pytest.mark.parametrize(
    ("given", "has_friction"),
    [
        ({}, False),
        ({"lubricant": OIL}, False),
        ({"surface": FINISH}, False),
        ({"lubricant": OIL, "surface": FINISH}, True),
        ({"friction_coefficient": 0.0}, True),
    ],
)
def test_friction_is_given_or_follows_from_oil_and_surface(given: dict[str, Any], has_friction: bool) -> None:
    assert Scene(bearing=BEARING_6205, operation=thrust(310.0), **given).has_friction == has_friction


def test_a_loss_factor_that_is_not_given_is_the_usual_one() -> None:
    scene = Scene(bearing=BEARING_6205, operation=thrust(310.0))
    assert scene.loss_factor == 0.007
    assert replace(scene, hysteresis_loss=0.0).loss_factor == 0


def test_a_law_of_the_user_names_its_package_and_its_table() -> None:
    table = np.ones((2, 7))
    own = OwnTraction(name="carreau", sha256="0123456789abcdef", rows=table)
    assert own.origin == "carreau, SHA-256 0123456789ab"
    packed = OwnTraction(name="carreau", sha256="0123456789abcdef", distribution="oils", version="2.1", rows=table)
    assert packed.origin == "carreau of oils 2.1, SHA-256 0123456789ab"
    assert own.table is table


def test_a_contact_leans_by_its_angle_but_on_a_washer_and_has_a_nearer_shoulder() -> None:
    contact = replace(INNER, shoulder=1.3e-3, far_shoulder=4.2e-3, contact_angle=0.31)
    assert (contact.tilt, contact.nearer_shoulder) == (0.31, 1.3e-3)
    assert replace(contact, rolling_radius=np.inf).tilt == 0
    assert replace(contact, far_shoulder=0.9e-3).nearer_shoulder == 0.9e-3


def test_a_scene_shows_what_identifies_it_in_one_line() -> None:
    scene = Scene(bearing=BEARING_6205, operation=thrust(310.0, 470.0, speed=[10.0, 20.0]), name="rig", tolerance=0.03)
    assert repr(scene) == "Scene(rig, 6205, 2 points, 95.49 to 191 rpm, 310 to 470 N axial, tolerance 0.03)"


SCENE = Scene(bearing=BEARING_6205, operation=thrust(310.0, 89.0), friction_coefficient=0.08)


@pytest.mark.parametrize("tolerance", [0.0, 0, -0.03, float("nan"), float("inf"), "5 %", None])
def test_the_tolerance_of_a_scene_is_positive(tolerance: Any) -> None:
    refused(lambda: replace(SCENE, tolerance=tolerance), "Scene.tolerance must be")


@pytest.mark.parametrize("count", [9.5, float("nan"), float("inf"), "9", None])
def test_balls_are_counted_in_whole_numbers(count: Any) -> None:
    message = f"Bearing.ball_count must be a whole number, got {count!r}"
    refused(lambda: replace(BEARING_6205, ball_count=count), message)
    for whole in (9, 9.0, np.int64(9)):
        counted = replace(BEARING_6205, ball_count=whole).ball_count  # pyright: ignore[reportArgumentType]
        assert (counted, type(counted)) == (9, int)


@pytest.mark.parametrize(
    "down", [(0.0, 0.0, 0.0), [1, 0], "x", float("nan"), (float("nan"), 0.6, 0.8), (0.0, -9.81, 0.0), ("0", "0", "1")]
)
def test_down_is_a_unit_vector(down: Any) -> None:
    refused(lambda: replace(SCENE, down=down), "Scene.down must be a unit vector", f"got {down!r}", "(1.0, 0.0, 0.0)")


def test_a_unit_vector_may_be_rounded_to_two_digits() -> None:
    for down in (None, (0.6, -0.8, 0.0), [0.0, 0.0, -1.0], (0.58, 0.58, -0.58)):
        assert replace(SCENE, down=down).down == down  # pyright: ignore[reportArgumentType]
