"""The stiffness law of a series: exact where Hertz is, and beside single solves where the true groove departs."""

import json
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from analytic.errors import InputError
from analytic.scene import Contact
from analytic.scenefile import builtin_scene, load_scene
from fembearing.compare.discrepancy import hertz_quantities, solve_contact
from fembearing.compare.progress import silent
from fembearing.compare.reference import solve_reference
from fembearing.compare.stiffness_law import LawData, LoadSeries, compare_series, fit_law, solve_load_series
from fembearing.mesh.recipe import Geometry, load_recipe

LOADS = np.geomspace(11.0, 980.0, 13)  # a factor of 89: three meshes


def data(load: np.ndarray, approach: np.ndarray, *, common: float = 0.0, crossing: float = 0.0) -> LawData:
    return LawData(
        load=load, approach=approach, common=np.full(load.size, common), crossing=np.full(load.size, crossing)
    )


@pytest.fixture(scope="module")
def ideal(contacts: dict[str, Contact]) -> LoadSeries:
    return compare_series(contacts["outer"], recipe=load_recipe("hertzian"), loads=LOADS, tolerance=0.05)


@pytest.fixture(scope="module")
def real(contacts: dict[str, Contact]) -> LoadSeries:
    return compare_series(contacts["outer"], recipe=load_recipe("race"), loads=LOADS, tolerance=0.05)


@given(exponent=st.floats(1.0, 2.0), stiffness=st.floats(1e3, 1e12), count=st.integers(2, 9))
def test_a_power_law_is_found_again(exponent: float, stiffness: float, count: int) -> None:
    load = np.geomspace(2.3, 710.0, count)
    law = fit_law(data(load, (load / stiffness) ** (1 / exponent)))
    assert law is not None
    np.testing.assert_allclose(law.exponent, exponent, rtol=1e-12)  # round-off
    np.testing.assert_allclose(law.stiffness, stiffness, rtol=1e-9)  # round-off, far from the loads
    assert law.exponent_uncertainty < 1e-9
    assert law.stiffness_uncertainty < 1e-8


@given(seed=st.integers(0, 2**32 - 1), range_of_loads=st.floats(3.0, 1e6))
def test_no_common_error_moves_the_exponent_further_than_propagated(seed: int, range_of_loads: float) -> None:
    """Signs drawn at random, and those of a tilt, which is the worst."""
    load = np.geomspace(1.9, 1.9 * range_of_loads, 8)
    signs = np.random.default_rng(seed).choice([-1.0, 1.0], (5, load.size))
    for sign in (*signs, np.sign(np.arange(load.size) - 3.5)):
        law = fit_law(data(load, (load / 2.5e10) ** (2 / 3) * (1 + 2e-3 * sign), common=2e-3))
        assert law is not None
        # 1 %: propagation is linear, an error of 0.2 % is not quite
        assert abs(law.exponent - 1.5) <= 1.01 * law.propagated
        assert abs(np.log(law.stiffness / 2.5e10)) <= 1.01 * law.stiffness_uncertainty


def test_errors_off_the_mesh_average_out_only_between_loads_apart() -> None:
    few, many, wide = (
        fit_law(data(load, load ** (2 / 3), crossing=3e-3))
        for load in (np.geomspace(10.0, 60.0, 7), np.geomspace(10.0, 60.0, 400), np.geomspace(10.0, 3600.0, 14))
    )
    assert few is not None
    assert many is not None
    assert wide is not None
    np.testing.assert_allclose(many.propagated, few.propagated, rtol=0.35)  # as the loads fall into cells
    assert wide.propagated < few.propagated / 2


def test_the_idealisation_has_the_law_of_hertz(ideal: LoadSeries) -> None:
    law = ideal.law
    assert law is not None
    assert abs(law.exponent - 1.5) < law.exponent_uncertainty < 0.005  # 0.005: a third of the true groove's departure
    middle = (ideal.points[6].hertz_approach, ideal.points[6].load)
    # K is extrapolated to an approach of 1 m: the law is compared where the loads are. 0.2 %: half of OFF_MESH and more
    np.testing.assert_allclose(law.load(middle[0]), middle[1], rtol=2e-3)
    stiffness = law.stiffness * middle[0] ** (law.exponent - 1.5)
    np.testing.assert_allclose(stiffness, ideal.hertz_stiffness, rtol=2e-3)


def test_the_idealisation_is_hertz_within_its_uncertainties(ideal: LoadSeries) -> None:
    for point in ideal.points:
        assert abs(point.discrepancy) < point.approach.total < 0.005  # OFF_MESH and some
        assert point.tangent is not None
        assert point.tangent_uncertainty is not None
        assert abs(point.tangent / point.hertz_tangent - 1) < point.tangent_uncertainty < 0.02
    assert ideal.verdict == "pass"
    assert ideal.meshes == 3


def test_hertz_stands_beside_with_its_tangent(ideal: LoadSeries) -> None:
    """The tangent is the slope of Hertz's own loads: a central difference, a thousandth of the load apart."""
    point = ideal.points[4]
    above, below = (
        hertz_quantities(replace(ideal.contact, load=point.load * factor)).approach for factor in (1.001, 0.999)
    )
    np.testing.assert_allclose(point.hertz_tangent, 0.002 * point.load / (above - below), rtol=1e-6)  # second order


def test_the_groove_stiffens_as_single_solves_say(real: LoadSeries, contacts: dict[str, Contact]) -> None:
    """From two contacts on their own meshes, at the ends of the series."""
    singles = []
    for load in (LOADS[0], LOADS[-1]):
        contact = replace(contacts["outer"], load=float(load))
        singles.append(solve_reference(contact, recipe=load_recipe("race"), accuracy=0.9, progress=silent))
    low, high = (single.estimates["approach"] for single in singles)
    span = np.log(LOADS[-1] / LOADS[0])
    exponent = span / np.log(high.value / low.value)
    law = real.law
    assert law is not None
    assert exponent > 1.5
    assert law.exponent - 1.5 > law.exponent_uncertainty
    uncertain = exponent**2 * (low.total + high.total) / span
    assert abs(law.exponent - exponent) < law.exponent_uncertainty + uncertain
    for point, single in ((real.points[0], low), (real.points[-1], high)):
        assert abs(point.approach.value / single.value - 1) < point.approach.total + single.total


def test_tangents_lead_from_load_to_load(real: LoadSeries, ideal: LoadSeries) -> None:
    """Integrated over the approach they give the loads."""
    for series in (real, ideal):
        approach = np.array([point.approach.value for point in series.points])
        tangent = np.array([point.tangent for point in series.points], dtype=float)
        exponent = tangent * approach / LOADS  # d ln F / d ln delta
        # 0.1 %: the ends are off by at most 0.4 % of an approach, over a range of e^4.5 in load
        np.testing.assert_allclose(np.trapezoid(exponent, np.log(approach)), np.log(LOADS[-1] / LOADS[0]), rtol=1e-3)


def test_json_holds_plain_numbers(ideal: LoadSeries) -> None:
    told = json.loads(json.dumps(ideal.to_json(), allow_nan=False))
    assert [part["load"] for part in told["loads"]] == LOADS.tolist()
    assert told["loads"][3]["approach"]["fe"] == ideal.points[3].approach.value
    assert told["loads"][3]["tangent"]["hertz"] == ideal.points[3].hertz_tangent
    assert ideal.law is not None
    assert told["law"]["exponent"] == ideal.law.exponent
    assert told["law"]["stiffness_uncertainty"] == ideal.law.stiffness_uncertainty
    assert told["hertz_law"] == {"stiffness": ideal.hertz_stiffness, "exponent": 1.5}


@pytest.mark.parametrize("slope", [0.61, 2 / 3])
def test_a_stiffness_is_as_uncertain_as_its_extrapolation_to_one_metre(slope: float) -> None:
    """An error that tilts the line of two loads: ln K moves by the whole way from there to 1 m."""
    load = np.array([20.0, 500.0])
    approach = 3e-7 * load**slope
    law = fit_law(data(load, approach, common=1e-4))
    assert law is not None
    moved = [fit_law(data(load, approach * (1 + 1e-4 * np.array(signs)))) for signs in ((1, -1), (-1, 1), (1, 1))]
    shifts = [abs(np.log(other.stiffness / law.stiffness)) for other in moved if other is not None]
    np.testing.assert_allclose(law.stiffness_uncertainty, max(shifts), rtol=3e-3)  # first order in 1e-4


def test_a_series_is_refined_until_it_is_as_sure_as_was_asked(contacts: dict[str, Contact]) -> None:
    """Off their meshes approaches are 0.3 % uncertain; each on its own comes below a tenth of that."""
    recipe, loads = load_recipe("hertzian"), [650.0, 140.0, 650.0]
    rough = compare_series(contacts["inner"], recipe=recipe, loads=loads, tolerance=0.05)
    fine = compare_series(contacts["inner"], recipe=recipe, loads=loads, tolerance=0.001)
    assert [point.load for point in fine.points] == loads
    assert max(point.approach.total for point in rough.points) > 0.001
    for point, before in zip(fine.points, rough.points, strict=True):
        assert abs(point.discrepancy) < point.approach.total < 0.001
        assert abs(point.approach.value / before.approach.value - 1) < point.approach.total + before.approach.total
    assert fine.law is not None
    assert rough.law is not None
    assert abs(fine.law.exponent - 1.5) < fine.law.exponent_uncertainty < rough.law.exponent_uncertainty
    assert fine.verdict == "pass"
    assert not fine.warnings


@pytest.mark.parametrize("geometry", ["real", "wall"])
def test_a_pocket_has_a_series_too(geometry: Geometry) -> None:
    """Beside single solves: the seat stiffens as its contact widens, the sheet bends on its rim whatever the load."""
    scene = load_scene(builtin_scene("6205"))
    loads = [5.0, 28.0] if geometry == "wall" else [5.0, 60.0]
    found = solve_load_series(scene, pair="pocket", loads=loads, geometry=geometry)
    for point in found.points:
        single = solve_contact(scene, pair="pocket", load=point.load, geometry=geometry, accuracy=0.02)
        alone = single.estimates["approach"]
        assert abs(point.approach.value / alone.value - 1) < point.approach.total + alone.total < 0.02
        assert point.hertz_approach == single.hertz.approach
    assert found.law is not None
    assert found.judged == (geometry == "real")
    told = found.to_json()
    if geometry == "wall":
        # Springs in a row, delta = (F/K)^(2/3) + c F: an exponent between 1.5 and 1.
        assert 1 + found.law.exponent_uncertainty < found.law.exponent < 1.5 - found.law.exponent_uncertainty
        assert told["verdict"] == "shown"
        assert "the sheet of 0.9 mm bends" in " ".join(found.warnings)
    else:
        assert 1.5 < found.law.exponent < 1.5 + 2 * found.law.exponent_uncertainty
        assert told["verdict"] == "pass"


def test_one_load_has_no_law_and_repeated_ones_do_not_sharpen_it(contacts: dict[str, Contact]) -> None:
    recipe = load_recipe("hertzian")
    alone = compare_series(contacts["inner"], recipe=recipe, loads=[372.0], tolerance=0.05)
    assert alone.law is None
    assert alone.points[0].tangent is None
    assert abs(alone.points[0].discrepancy) < alone.points[0].approach.total < 2e-3  # on its own mesh
    json.dumps(alone.to_json(), allow_nan=False)
    pair = compare_series(contacts["inner"], recipe=recipe, loads=[650.0, 140.0], tolerance=0.05)
    again = compare_series(contacts["inner"], recipe=recipe, loads=[140.0, 650.0, 140.0, 650.0], tolerance=0.05)
    assert pair.law is not None
    assert pair.law == again.law
    assert pair.law.misfit is None
    assert [point.load for point in again.points] == [140.0, 650.0, 140.0, 650.0]


def test_an_ellipse_over_the_shoulder_is_not_judged(contacts: dict[str, Contact]) -> None:
    narrow = replace(contacts["outer"], shoulder=0.6e-3)  # the semi-axis is 0.77 mm at 372 N, 0.35 mm at 35 N
    found = compare_series(narrow, recipe=load_recipe("race"), loads=[372.0, 35.0], tolerance=0.05)
    assert [point.verdict for point in found.points] == ["outside validity", "pass"]
    assert "from 372 N on the contact reaches its shoulder" in " ".join(found.warnings)


@pytest.mark.parametrize(
    ("loads", "words"), [([], "one or more"), ([20.0, -3.0], "-3.0"), ([float("inf")], "inf"), ([9e4, 3.0], "90000 N")]
)
def test_mistakes_are_one_line(loads: list[float], words: str) -> None:
    with pytest.raises(InputError, match=words) as caught:
        solve_load_series(load_scene(builtin_scene("6205")), pair="inner", loads=loads)
    assert "\n" not in str(caught.value)
