"""The tables of a torque, by cells that are worked out by hand: parts, heaviest ball, pair, changes."""

from dataclasses import replace
from typing import Any

from analytic.result import BearingOfPair, FrictionCoefficients, OnRaces, PairPoint, TorqueParts, TorqueUncertainty
from fembearing.report.report import BeforeAndAfter, ChangeByFit, ChangeRecord, PartChanges
from fembearing.report.tables.torque import ball_table, change_table, pair_table, torque_table
from fembearing.report.torque import Band
from tests.report.prediction_rows import content, prediction_of
from tests.report.torque_rows import loaded, lost, point, record


def uncertain(model: float | None, parts: dict[str, float] | None = None) -> TorqueUncertainty:
    return TorqueUncertainty(numerical=0.013, model=model, model_parts=parts)


def bearing(**changed: Any) -> BearingOfPair:
    given: dict[str, Any] = {"axial_load": 450.0, "radial_load": 0.0, "moment": 0.0, "ball_load": 72.0}
    given |= {"is_pressed": True, "is_relieved": False, "torque": 0.023}
    return BearingOfPair(**given | changed)


PAIR = PairRows(
    kind="O",
    preload=120.0,
    offset=3e-6,
    distance=0.031,
    points=(
        PairPoint(displacement=2e-6, tilt=0.0, stiffness=85e6, bearings=(bearing(), bearing(axial_load=-250.0))),
        PairPoint(
            displacement=4e-6,
            tilt=3e-4,
            stiffness=64e6,
            bearings=(bearing(moment=2.5), bearing(axial_load=0.0, ball_load=0.0, is_relieved=True)),
        ),
    ),
)
BARE = TorqueParts(total=0.04, race=0.04, spin=0.0171, conformity=0.0229, hysteresis=None)


def test_a_point_has_its_parts_uncertainties_interval_and_band() -> None:
    """A part below a millionth of the total, 4e-8 N m, is what the balance of the balls leaves; None has no column."""
    parts = replace(BARE, rolling=4.2e-8, cage=3.8e-8, declared=0.0023)
    slow, fast = prediction_of(content()).points  # 21 and 34 N mm, from 0.6 to 1.9 of it
    torque = record(
        point(0, torque=parts, uncertainty=uncertain(0.21, {"film": 0.21})),
        point(1, uncertainty=uncertain(None)),
        point(2, torque=parts, uncertainty=uncertain(0.22, {"film": 0.22})),
        left_out=(lost(1),),
        prediction=replace(prediction_of(content()), points=(slow, slow, fast)),
        catalogue_band=Band(low=(0.03, 0.035, 0.031), high=(0.05, 0.055, 0.061), values={}, note="a band"),
    )
    table = torque_table(torque, "6205", range(3))
    assert [head.short or head.text for head in table.heads] == [
        *("#", "rpm", "Fa, N", "spin", "conf.", "roll.", "cage", "decl."),
        *("total", "+-", "+- of formulas, 95 %", "95 %", "catalogue"),
    ]
    assert [head.text for head in table.heads if head.wide] == ["+- of formulas, 95 %"]
    common = ["17.10", "22.90", "4.200e-05", "0", "2.300", "40.00", "1.3 %"]
    assert table.groups[0].rows == [
        ["1", "600", "700", *common, "21 %", "12.6-39.9", "30-50"],
        ["2", "750", "720", *[""] * 5, "left out", *[""] * 4],
        ["3", "900", "740", *common, "22 %", "20.4-64.6", "31-61"],
    ]
    assert table.label == "Friction torque of 6205"


def test_a_torque_alone_has_its_parts_and_the_solver_error() -> None:
    nothing = TorqueParts(total=0.0, race=0.0, spin=0.0, conformity=0.0, hysteresis=None)
    loads = {"axial_load": 700.0, "radial_load": 130.0}
    torque = record(point(0, torque=BARE, **loads), point(1, torque=nothing, **loads), pair=PAIR)
    table = torque_table(torque, "6205", range(2))
    assert [head.text for head in table.heads][3:] == ["radial load, N", "spin", "conformity", "total", "+-"]
    assert table.groups[0].rows == [
        ["1", "600", "700", "130", "17.10", "22.90", "40.00", "1.3 %"],
        ["2", "750", "700", "130", "0", "0", "0.000", "1.3 %"],
    ]
    assert table.label == "Friction torque of two 6205, axial load 700 N, radial load 130 N"


def pressed(number: int, angle: float, pocket: float | None) -> TorquePoint:
    return point(
        number,
        contact_angle=angle,
        contact=OnRaces(
            inner=loaded(310.0 + 20 * number),
            outer=loaded(290.0, semi_axis_rolling=0.14e-3, semi_axis_transverse=0.75e-3, peak_pressure=1.5e9),
        ),
        friction_coefficient=FrictionCoefficients(inner=0.0612, outer=0.0573, pocket=pocket),
        film=OnRaces(inner=0.321e-6, outer=0.287e-6),
        asperity_share=OnRaces(inner=0.143, outer=0.0876),
    )


def test_the_heaviest_ball_has_a_row_for_each_race() -> None:
    points = pressed(0, 0.3013, 0.11), point(1), pressed(2, 0.2821, 0.12), pressed(3, 0.3232, None)
    torque = record(*points, left_out=(lost(1),), gap_roughness=0.25e-6)
    table = ball_table(torque, [0, 1, 2])
    assert [head.text for head in table.heads] == [
        *("#", "race", "load, N", "p0, GPa", "a, mm", "b, mm"),
        *("mu", "film, um", "film/roughness", "asperities, %", "contact angle, deg (rad)"),
    ]
    inner = ["1.700", "0.1200", "0.8800", "0.0612", "0.321", "1.28", "14.3"]  # 0.321 of 0.25 um
    outer = ["outer", "290.0", "1.500", "0.1400", "0.7500", "0.0573", "0.287", "1.15", "8.76", ""]
    assert table.groups[0].rows == [
        ["1", "inner", "310.0", *inner, "17.26 (0.3013)"],
        ["1", *outer],
        ["3", "inner", "350.0", *inner, "16.16 (0.2821)"],
        ["3", *outer],
    ]
    assert table.notes == [
        "Contact angle 16.16 deg (0.2821 rad) to 18.52 deg (0.3232 rad), mean of both races. a along rolling, b "
        "transverse; asperities: their share of the load.",
        "Friction coefficient of ball on pocket: 0.11, 0.12.",
    ]


def test_each_bearing_of_a_pair_has_its_loads_and_the_first_one_the_stiffness() -> None:
    """A load that neither bearing has at any point has no column."""
    table = pair_table(PAIR, range(2))
    assert [head.text for head in table.heads][2:] == ["Fa, N", "M, N mm", "ball, N", "torque, N mm", "dFa/dz, N/um"]
    assert table.groups[0].rows == [
        ["1", "first", "450", "0", "72", "23", "85"],
        ["1", "second", "-250", "0", "72", "23", ""],
        ["2", "first", "450", "2500", "72", "23", "64"],
        ["2", "second, relieved", "0", "0", "0", "23", ""],
    ]


CHANGE = ChangeRecord(
    contact_angle=BeforeAndAfter(production=(0.3013, 0.2821), corrected=(0.2998, None)),
    torque=BeforeAndAfter(production=(0.042, 0.053), corrected=(0.0433, None)),
    change=PartChanges(total=(0.031, None), race=None, spin=None, conformity=None, hysteresis=None, rolling=None),
    uncertainty=0.0137,
    uncertainties={},
    finite_geometry=ChangeByFit(change=(0.0267, None), uncertainty=(0.0043, None)),
    verdict="undecided",
    note="All contacts are real.",
)


def test_a_change_stands_beside_that_of_the_fit() -> None:
    points = [point(0), point(1), point(2)]
    table = change_table(points, CHANGE, range(2))
    assert [head.text for head in table.heads][-2:] == ["change, %", "by the fit, %"]
    assert table.groups[0].rows == [
        ["1", "600", "700", "42.00", "17.26 (0.3013)", "43.30", "17.18 (0.2998)", "+3.10", "+2.67"],
        ["2", "750", "720", "53.00", "16.16 (0.2821)", "-", "-", "-", "-"],
    ]
    words, fit, verdict = table.notes
    assert "the change has a numerical uncertainty of 1.37 %. -:" in words
    assert "+- 0.43 %" in fit
    assert verdict.endswith("not all within the tolerance: undecided.")
    fitted = ChangeByFit(change=(0.0267, 0.02), uncertainty=(0.0031, 0.0058))
    assert "+- 0.58 %" in change_table(points, replace(CHANGE, finite_geometry=fitted), [0]).notes[1]
