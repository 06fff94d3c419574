"""The stiffness law of a series: against Hertz where Hertz is exact, and against single solves on the true groove."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scene import Contact
from analytic.scenefile.read import load_scene
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.check.contact.load_series import LoadPoint, LoadSeries, StiffnessLaw, compare_series, solve_load_series
from fembearing.check.contact.reference import ends_before_shoulder, solve_reference
from fembearing.check.contact.refinement import FORMAL_ORDERS, Wanted
from fembearing.check.contact.solution import solve_contact
from fembearing.grid_convergence import CAUTIOUS, LEAST
from fembearing.mesh.recipe import Recipe, load_recipe
from tests.analytic.specimens import present

LOADS = np.geomspace(11.0, 980.0, 13)  # a factor of 89: three meshes


def uncertainty(point: LoadPoint) -> float:
    """Of the approach, relative."""
    return present(point.approach.relative_uncertainty)


def exponent_uncertainty(law: StiffnessLaw | None) -> float:
    """The uncertainty of a law that has one."""
    assert law is not None
    return present(law.exponent_uncertainty)


@pytest.fixture(scope="module")
def ideal(contacts: dict[str, Contact]) -> LoadSeries:
    return compare_series(contacts["outer"], recipe=load_recipe("hertzian"), loads=LOADS, tolerance=0.05)


@pytest.fixture(scope="module")
def real(contacts: dict[str, Contact]) -> LoadSeries:
    return compare_series(contacts["outer"], recipe=load_recipe("race"), loads=LOADS, tolerance=0.05)


def test_the_idealisation_has_the_law_of_hertz(ideal: LoadSeries) -> None:
    law = present(ideal.law)
    assert abs(law.exponent - 1.5) < exponent_uncertainty(law) < 0.005  # 0.005: a third of the true groove's departure
    middle = (ideal.points[6].approach.production, ideal.points[6].load)
    # K is extrapolated to an approach of 1 m: the law is compared where the loads are. 0.2 %: half of OFF_MESH and more
    np.testing.assert_allclose(law.stiffness * middle[0] ** law.exponent, middle[1], rtol=2e-3)
    stiffness = law.stiffness * middle[0] ** (law.exponent - 1.5)
    np.testing.assert_allclose(stiffness, ideal.hertz_stiffness, rtol=2e-3)


def test_the_idealisation_is_hertz_within_its_uncertainties(ideal: LoadSeries) -> None:
    for point in ideal.points:
        assert abs(point.approach.difference) < uncertainty(point) < 0.005  # OFF_MESH and a little more
        assert abs(present(point.tangent) / point.hertz_tangent - 1) < present(point.tangent_uncertainty) < 0.02
    assert ideal.verdict == "pass"
    assert ideal.meshes == 3


def test_the_tangent_of_hertz_is_the_slope_of_his_loads(ideal: LoadSeries, contacts: dict[str, Contact]) -> None:
    """By a central difference over a thousandth of the load."""
    point = ideal.points[4]
    above, below = (
        hertz_quantities(replace(contacts["outer"], load=point.load * factor)).approach for factor in (1.001, 0.999)
    )
    np.testing.assert_allclose(point.hertz_tangent, 0.002 * point.load / (above - below), rtol=1e-6)  # second order


@pytest.mark.slow
def test_the_groove_stiffens_as_in_single_solves(real: LoadSeries, contacts: dict[str, Contact]) -> None:
    """From two contacts on their own meshes, at the ends of the series."""
    singles = []
    for load in (LOADS[0], LOADS[-1]):
        contact = replace(contacts["outer"], load=float(load))
        singles.append(solve_reference(contact, Wanted(load_recipe("race"), accuracy=0.9)))
    low, high = (single.estimates["approach"] for single in singles)
    span = np.log(LOADS[-1] / LOADS[0])
    exponent = span / np.log(high.value / low.value)
    law = present(real.law)
    assert exponent > 1.5
    assert law.exponent - 1.5 > exponent_uncertainty(law)
    uncertain = exponent**2 * (low.total + high.total) / span
    assert abs(law.exponent - exponent) < exponent_uncertainty(law) + uncertain
    for point, single in ((real.points[0], low), (real.points[-1], high)):
        assert abs(point.approach.reference / single.value - 1) < uncertainty(point) + single.total


@pytest.mark.slow
def test_tangents_integrate_to_the_loads(real: LoadSeries, ideal: LoadSeries) -> None:
    """Over the approach, from the first load to the last."""
    for series in (real, ideal):
        approach = np.array([point.approach.reference for point in series.points])
        tangent = np.array([point.tangent for point in series.points], dtype=float)
        exponent = tangent * approach / LOADS  # d ln F / d ln delta
        # 0.1 %: the ends are off by at most 0.4 % of an approach, over a range of e^4.5 in load
        np.testing.assert_allclose(np.trapezoid(exponent, np.log(approach)), np.log(LOADS[-1] / LOADS[0]), rtol=1e-3)


@pytest.mark.slow
def test_a_series_is_refined_to_the_required_accuracy(contacts: dict[str, Contact]) -> None:
    """On shared meshes approaches are 0.3 % uncertain; on their own meshes a tenth of that or less."""
    recipe, loads = load_recipe("hertzian"), [650.0, 140.0, 650.0, 290.0]
    rough = compare_series(contacts["inner"], recipe=recipe, loads=loads, tolerance=0.05)
    fine = compare_series(contacts["inner"], recipe=recipe, loads=loads, tolerance=0.001)
    assert [point.load for point in fine.points] == loads
    assert max(uncertainty(point) for point in rough.points) > 0.001
    for point, before in zip(fine.points, rough.points, strict=True):
        assert abs(point.approach.difference) < uncertainty(point) < 0.001
        assert abs(point.approach.reference / before.approach.reference - 1) < present(
            point.approach.relative_uncertainty
        ) + uncertainty(before)
    assert fine.law is not None
    assert abs(fine.law.exponent - 1.5) < exponent_uncertainty(fine.law) < exponent_uncertainty(rough.law)
    assert fine.verdict == "pass"
    assert not fine.warnings


@pytest.mark.slow
def test_a_pocket_has_a_series_too() -> None:
    """Against a single solve: the sheet bends on its rim at any load."""
    scene = load_scene("6205-dry")
    series = solve_load_series(scene, pair="pocket", loads=[5.0, 12.0, 28.0], geometry="wall")
    point = series.points[-1]
    single = solve_contact(scene, pair="pocket", load=point.load, geometry="wall", accuracy=0.02)
    alone = single.numbers.estimates["approach"]
    assert abs(point.approach.reference / alone.value - 1) < uncertainty(point) + alone.total < 0.02
    assert point.approach.production == single.numbers.hertz.approach
    # Springs in a row, delta = (F/K)^(2/3) + c F: an exponent between 1.5 and 1.
    uncertain = exponent_uncertainty(series.law)
    assert 1 + uncertain < present(series.law).exponent < 1.5 - uncertain
    assert series.verdict == "shown"
    assert "the sheet of 0.9 mm bends" in " ".join(series.warnings)


@pytest.mark.parametrize(
    ("loads", "words"), [([], "one or more"), ([20.0, -3.0], "-3.0"), ([float("inf")], "inf"), ([9e4, 3.0], "90000 N")]
)
def test_mistakes_are_one_line(loads: list[float], words: str) -> None:
    with pytest.raises(InputError, match=words) as caught:
        solve_load_series(load_scene("6205-dry"), pair="inner", loads=loads)
    assert "\n" not in str(caught.value)


def test_loads_above_the_static_limit_have_one_warning(
    contacts: dict[str, Contact], shallow: Callable[[str], Recipe]
) -> None:
    """A ball in a wide groove: 4.2 GPa at about 1800 N."""
    series = compare_series(
        replace(contacts["inner"], groove_radius=5.0e-3),
        recipe=shallow("race"),
        loads=[2600.0, 700.0, 2250.0],
        tolerance=0.9,
    )
    (message,) = (warning for warning in series.warnings if "static limit" in warning)
    assert "at 2250 N is above the static limit, 4.2 GPa" in message


def test_a_ring_is_of_one_load_and_an_accuracy_is_not_below_0() -> None:
    scene = load_scene("6205-dry")
    with pytest.raises(InputError, match="'ring' is that of one load"):
        solve_load_series(scene, pair="inner", loads=[200.0], geometry="ring")
    with pytest.raises(InputError, match="accuracy"):
        solve_load_series(scene, pair="inner", loads=[200.0], accuracy=-0.01)


def test_a_series_has_all_quantities_where_the_compliance_gives_them(
    contacts: dict[str, Contact], shallow: Callable[[str], Recipe]
) -> None:
    contact = replace(contacts["inner"], shoulder=0.9e-3, far_shoulder=0.9e-3, contact_angle=0.0)
    loads = [70.0, 200.0, 400.0]  # ellipses of 0.53, 0.76 and 0.96 mm: the last is cut off, and not judged
    assert [ends_before_shoulder(replace(contact, load=load)) for load in loads] == [True, True, False]
    series = compare_series(contact, recipe=shallow("race"), loads=loads, tolerance=0.9)
    found = [set(point.quantities) for point in series.points]
    assert found == [set(FORMAL_ORDERS), set(FORMAL_ORDERS), {"approach"}]
    assert series.law is not None
    assert [point.approach.verdict for point in series.points] == ["pass", "pass", "outside validity"]
    assert "from 400 N on the contact reaches its shoulder" in " ".join(series.warnings)
    over = present(series.points[2].approach.study)
    assert over.richardson is None  # there no order is assumed
    assert over.mesh >= CAUTIOUS * abs(1 - over.values[0] / over.values[1]) + LEAST
    for point in series.points:
        hertz = vars(hertz_quantities(replace(contact, load=point.load)))
        assert {name: each.production for name, each in point.quantities.items()} == {
            name: hertz[name] for name in point.quantities
        }
    table = series.to_dataset()
    np.testing.assert_array_equal(table["load"], loads)
    np.testing.assert_array_equal(table["approach"], [point.approach.reference for point in series.points])
    np.testing.assert_allclose(
        table["discrepancy_approach"], table["hertz_approach"] / table["approach"] - 1, rtol=1e-9
    )
