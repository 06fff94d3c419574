"""Quantities of pint: read where texts with units are, else refused in one line that names field, value and unit."""

from collections.abc import Callable
from typing import Any, Unpack, get_args, get_origin, get_type_hints

import numpy as np
import pint
import pytest

import analytic
from analytic.errors import InputError
from analytic.scene import Operation, Scene
from analytic.scenefile.keys import scene_table

UNIT = pint.UnitRegistry()
Q: Any = UNIT.Quantity  # what is refused fits no annotation either
TABLES: Any = scene_table()  # keys of several kinds
SMOOTH = {"kind": "gaussian", "spacing": "2 um"}


def test_quantities_mean_what_the_same_texts_mean() -> None:
    quantity = analytic.bearing("6206", ball_diameter=Q(9.5, "mm"), inner={"conformity": Q(51.5, "percent")})
    text = analytic.bearing("6206", ball_diameter="9.5 mm", inner={"conformity": "51.5 %"})
    assert quantity == text
    oil = analytic.lubricant("ISO VG 68", temperature=Q(60.0, "degC"), eyring_stress=Q(4.0, "MPa"))
    assert oil == analytic.lubricant("ISO VG 68", temperature=333.15, eyring_stress="4 MPa")
    assert analytic.lubricant("ISO VG 68", viscosity=Q(30, "mPa s")).viscosity == pytest.approx(0.03, rel=1e-15)
    rough = analytic.surfaces(Ra=Q(0.1, "um"), autocorrelation=SMOOTH | {"length": Q(50.0, "um")})
    assert rough == analytic.surfaces(Ra="0.1 um", autocorrelation=SMOOTH | {"length": "50 um"})
    assert analytic.material("100Cr6", youngs_modulus=Q(200, "GPa")).youngs_modulus == 200e9


@pytest.mark.parametrize("load", [Q(np.array([300.0, 500.0]), "kgf"), [Q(300, "kgf"), Q(500, "kgf")]], ids=repr)
def test_a_series_may_be_one_array_or_a_list_of_quantities(load: Any) -> None:
    found = analytic.operation(axial_load=load, inner_speed=Q(90, "rpm"))
    np.testing.assert_allclose(found.axial_load, [300 * 9.80665, 500 * 9.80665], rtol=1e-15)
    np.testing.assert_allclose(found.inner_speed, 3 * np.pi, rtol=1e-15)


def scene(**more: Any) -> Scene:
    return analytic.Scene(
        bearing=analytic.bearing("6206"),
        operation=analytic.operation(axial_load=800.0, inner_speed=52.0),
        friction_coefficient=0.08,
        **more,
    )


@pytest.mark.parametrize("tolerance", [0.003, "0.3 %", Q(0.3, "percent"), Q(0.003, "dimensionless")], ids=repr)
def test_the_tolerance_of_a_torque_takes_the_place_of_the_scenes(tolerance: Any) -> None:
    found = analytic.friction_torque(scene(), tolerance=tolerance)
    np.testing.assert_array_equal(found.torque.total, analytic.friction_torque(scene(tolerance=0.003)).torque.total)
    assert found.effects != analytic.friction_torque(scene(tolerance=0.3)).effects  # fewer are left out


REFUSED: list[tuple[Callable[[], Any], str, str, str]] = [  # field, value and unit of the message
    (lambda: analytic.bearing("6206", ball_diameter=Q(9, "N")), "bearing.ball_diameter", "9 newton", "mm"),
    (lambda: analytic.operation(inner_speed=Q(3, "Hz")), "operation.inner_speed", "3 hertz", "rpm"),
    (lambda: analytic.lubricant("ISO VG 68", temperature=Q(3, "m")), "lubricant.temperature", "3 meter", "degC"),
    (lambda: analytic.surfaces(Ra=Q(3, "N")), "surface.Ra", "3 newton", "um"),
    (lambda: analytic.material("100Cr6", density=Q(3, "N")), "density", "3 newton", "kg/m^3"),
    (lambda: analytic.friction_torque(scene(), tolerance=Q(2, "mm")), "tolerance", "2 millimeter", "%"),
    (lambda: scene(tolerance=Q(5, "percent")), "Scene.tolerance", "5 percent", "a plain number"),
    (lambda: Operation(axial_load=Q(1, "kN"), inner_speed=np.ones(2)), "Operation.axial_load", "1 kilonewton", "in N"),
    (lambda: analytic.ContactAngle(rule="given", value=Q(15, "deg")), "ContactAngle.value", "15 degree", "in rad"),
]


@pytest.mark.parametrize(("call", "field", "value", "unit"), REFUSED, ids=[field for _, field, _, _ in REFUSED])
def test_what_does_not_fit_is_refused_in_one_line(call: Callable[[], Any], field: str, value: str, unit: str) -> None:
    with pytest.raises(InputError) as refused:
        call()
    line = str(refused.value)
    assert "\n" not in line
    assert f"{field} = " in line
    assert value in line
    assert unit in line.partition(value)[2]


@pytest.mark.parametrize(
    ("function", "table", "named"),
    [
        (analytic.bearing, TABLES.find("bearing"), {"catalog"}),
        (analytic.surfaces, TABLES.find("surface"), set()),
        (analytic.lubricant, TABLES.find("lubricant"), {"name", "temperature", "viscosity"}),
        (analytic.material, TABLES.find("bearing.ball_material").kind.inside, {"name"}),
    ],
)
def test_an_editor_knows_the_keys_of_a_table(function: Callable[..., Any], table: Any, named: set[str]) -> None:
    """named : keys with an argument of their own."""
    keywords = next(hint for hint in get_type_hints(function).values() if get_origin(hint) is Unpack)
    assert get_type_hints(get_args(keywords)[0]).keys() | named == table.keys.keys()
