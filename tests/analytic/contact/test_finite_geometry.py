"""The correction for finite geometry: its limits, its range, and finite elements outside its fit."""

from dataclasses import replace
from functools import cache
from importlib import import_module
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from analytic.contact.factors import ContactFactors, corrected
from analytic.contact.finite_geometry import contact_shape, finite_geometry_factors
from analytic.contact.finite_geometry_fit import SMALL, ContactShape, stored_fit
from analytic.contact.hertz import loaded_hertz, unit_hertz
from analytic.scene import Contact, Material

NAMES = ("semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach")
SHAPE = ContactShape(
    conformity=0.521,
    rolling_curvature=0.27,
    size=0.23,
    ball_poisson_ratio=0.27,
    race_poisson_ratio=0.31,
    ball_share=0.43,
    shoulder=0.61,
    far_shoulder=0.61,
)


@cache
def program(name: str) -> Any:
    """A program of validation/correction."""
    return import_module(f"validation.correction.{name}")


def factors(shape: ContactShape) -> dict[str, NDArray[np.float64]]:
    found = finite_geometry_factors(shape).factors
    return {name: np.asarray(getattr(found, name)) for name in NAMES}


def test_a_point_contact_is_hertz() -> None:
    """Deviations fade at least in proportion to the size times its logarithm, and are 0 at size 0."""
    sizes = np.array([0.0, 1e-12, 1e-6, 1e-3])
    for shape in (SHAPE, SHAPE._replace(rolling_curvature=-0.17, ball_share=0.9)):
        for factor in factors(shape._replace(size=sizes)).values():
            assert factor[0] == 1
            assert (np.abs(factor[1:] - 1) < 0.3 * sizes[1:] * -np.log(sizes[1:])).all()
    assert all(
        term["powers"].get("size", 0) + term["powers"].get("relative_load", 0) >= 1
        for quantity in stored_fit()["quantity"].values()
        for term in quantity["terms"]
    )


def test_only_ratios_matter(contacts: dict[str, Contact]) -> None:
    """A bearing three times as large of bodies seven times as stiff, under 9 x 7 times the load."""
    plain = contacts["inner"]

    def stiffer(material: Material) -> Material:
        return replace(material, youngs_modulus=7 * material.youngs_modulus)

    lengths = ("ball_radius", "groove_radius", "rolling_radius", "shoulder", "far_shoulder")
    scaled = replace(
        plain,
        **{name: 3 * getattr(plain, name) for name in lengths},
        load=63 * plain.load,
        ball_material=stiffer(plain.ball_material),
        race_material=stiffer(plain.race_material),
    )
    one, other = contact_shape(plain), contact_shape(scaled)
    np.testing.assert_allclose(one, other, rtol=1e-12)  # round-off
    assert one.ball_share == pytest.approx(0.5, rel=1e-12)
    assert one.conformity == pytest.approx(4.13 / 7.94, rel=1e-12)
    assert one.rolling_curvature == pytest.approx(3.97 / 16.47, rel=1e-12)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("conformity", 0.5049),
        ("rolling_curvature", -0.98),
        ("size", 0.46),
        ("ball_poisson_ratio", 0.49),
        ("ball_share", 0.001),
        ("far_shoulder", 0.08),
        ("contact_angle", 0.84),
    ],
)
def test_beyond_the_range_the_correction_is_held_with_a_warning(name: str, value: float) -> None:
    base = SHAPE._replace(size=0.05) if "shoulder" in name else SHAPE
    base = base._replace(far_shoulder=0.83, contact_angle=0.31)
    inside = getattr(base, name)
    found = finite_geometry_factors(base._replace(**{name: np.array([inside, value, inside])}))
    np.testing.assert_array_equal(found.covered, [True, False, True])
    (warning,) = found.warnings
    assert name.replace("_", " ") in warning
    assert f"{np.rad2deg(value) if name == 'contact_angle' else value:.4g}" in warning
    border = stored_fit()["range"][name.removeprefix("far_")][int(value > inside)]
    held = finite_geometry_factors(base._replace(**{name: np.array(border)}))
    for quantity in NAMES:
        grown = 1.0 if name != "size" else (value / border) ** (1 if quantity == "approach" else 2)
        change, there = (np.asarray(getattr(each.factors, quantity)) - 1 for each in (found, held))
        assert change[0] == change[2]
        assert change[1] == pytest.approx(float(found.applied[1] * grown * there), rel=1e-9)
        assert found.uncertainty[quantity][1] > held.uncertainty[quantity]


@pytest.mark.parametrize(
    ("name", "border", "step"),
    [
        *(("conformity", 0.505, -0.0025), ("size", 0.45, 0.05), ("rolling_curvature", 0.48, 0.12)),
        *(("shoulder", 0.1, -0.05), ("far_shoulder", 0.1, -0.05), ("contact_angle", 0.8, 0.1)),
    ],
)
def test_beyond_the_range_nothing_jumps_and_two_steps_away_hertz_stays(name: str, border: float, step: float) -> None:
    """From within the range to far outside, in steps of which each changes little."""
    base = SHAPE._replace(size=0.03 if "shoulder" in name else 0.1, shoulder=0.7, far_shoulder=0.8)
    found = finite_geometry_factors(base._replace(**{name: border + step * np.linspace(-0.1, 2.1, 2201)}))
    for quantity in NAMES:
        factor, uncertainty = np.asarray(getattr(found.factors, quantity)), found.uncertainty[quantity]
        change = np.max(np.abs(factor - 1))
        assert np.max(np.abs(np.diff(factor))) < 0.02 * change  # a jump would be a good part of it
        assert np.max(np.abs(np.diff(uncertainty))) < 0.02 * np.max(uncertainty)
        assert factor[-1] == 1
        assert uncertainty[-1] > change
    assert "is not applied" in found.warnings[0]


def test_a_contact_near_its_shoulder_is_held() -> None:
    name = "approach"
    near, far = (
        finite_geometry_factors(SHAPE._replace(size=0.4, shoulder=0.4 * ratio, far_shoulder=0.4 * ratio))
        for ratio in (1.14, 1.16)
    )
    assert not near.covered
    assert "nearer to the shoulder" in near.warnings[0]
    assert far.covered
    assert far.warnings == ()
    assert getattr(near.factors, name) == pytest.approx(float(getattr(far.factors, name)), abs=1e-4)
    cut = finite_geometry_factors(SHAPE._replace(size=0.4, shoulder=0.4 * 0.84, far_shoulder=0.4 * 0.84))
    assert getattr(cut.factors, name) == 1  # past the shoulder the pressure is not Hertz's
    assert cut.uncertainty[name] > abs(float(getattr(far.factors, name)) - 1)


def test_a_correction_brings_its_own_peak_pressure() -> None:
    hertz = loaded_hertz(unit_hertz(300.0, 11.0, 1.1e11), 210.0)
    plain = ContactFactors(semi_axis_rolling=1.03, semi_axis_transverse=0.96)
    own, filled = (corrected(hertz, factors) for factors in (plain._replace(peak_pressure=1.02), plain))
    assert own.peak_pressure == pytest.approx(1.02 * hertz.peak_pressure, rel=1e-14)
    volume = 2 / 3 * np.pi * filled.peak_pressure * filled.semi_axis_x * filled.semi_axis_y
    assert volume == pytest.approx(210.0, rel=1e-13)  # round-off


def test_a_contact_without_load_is_hertz_wherever_it_is() -> None:
    """At the bottom of a counterbored groove, at its shoulder, for example."""
    found = finite_geometry_factors(SHAPE._replace(size=np.array([0.0, 0.1]), far_shoulder=0.0))
    np.testing.assert_array_equal(found.covered, [True, False])
    assert np.asarray(found.factors.approach)[0] == 1


# The fit against its solves


@pytest.mark.parametrize("group", ["held out", "bearing", "shoulders held out"])
@pytest.mark.parametrize("name", NAMES)
def test_unseen_solves_lie_within_the_stated_uncertainty(name: str, group: str) -> None:
    """At least nine in ten; for the smallest with the solve's own uncertainty. Uncorrected Hertz is far off."""
    solves = program("fit").solves_of(group)
    found = finite_geometry_factors(solves.shape)
    assert found.covered.all()
    allowed = found.uncertainty[name] + solves.uncertainty[name]
    error = np.asarray(getattr(found.factors, name)) - solves.ratio[name]
    assert error.size >= 35
    assert np.mean(np.abs(error) <= allowed) >= 0.9
    large = np.asarray(solves.shape.size) >= SMALL  # below, the solves are less certain than the correction
    assert np.mean(np.abs(error)[large] <= found.uncertainty[name][large]) >= 0.9
    assert np.mean(np.abs(1 - solves.ratio[name]) <= allowed) < 0.6


@pytest.mark.parametrize("name", NAMES)
def test_solves_beyond_the_range_lie_within_the_grown_uncertainty(name: str) -> None:
    """All of them, those kept back from the choice of the steps included. Uncorrected Hertz is far off."""
    solves = program("fit").solves_of("beyond")
    found = finite_geometry_factors(solves.shape)
    assert np.sum(~found.covered) == 18  # the others have nearer shoulders than when they were drawn
    error = np.asarray(getattr(found.factors, name)) - solves.ratio[name]
    assert error.size == 36
    assert np.all(np.abs(error) <= found.uncertainty[name] + solves.uncertainty[name])
    assert np.mean(np.abs(1 - solves.ratio[name]) <= found.uncertainty[name] + solves.uncertainty[name]) < 0.4


@pytest.mark.parametrize("name", NAMES)
def test_the_stored_fit_is_that_of_the_stored_solves(name: str) -> None:
    """Terms chosen and fitted again, without the unseen sets."""
    fit = program("fit")
    again, stored = fit.fit_of(fit.solves_of("fit", "shoulders"), name), stored_fit()["quantity"][name]
    assert again.terms == [term["powers"] for term in stored["terms"]]
    coefficients = [term["coefficient"] for term in stored["terms"]]
    # Tolerance: 8 digits are stored, and the columns are nearly parallel
    np.testing.assert_allclose(again.coefficients, coefficients, rtol=1e-5)
    for group in (("held out", "shoulders held out"), ("bearing",)):
        error = again.error(fit.solves_of(*group), name)
        assert fit.rms(error) == pytest.approx(stored[group[0].replace(" ", "_")]["rms"], rel=0.03)  # 2 digits stored


def test_the_range_is_that_of_the_solves() -> None:
    solve = program("solve")
    assert stored_fit()["range"] == {name: list(limits) for name, limits in solve.RANGE.items()}
    rows = solve.read_rows()
    for name, (low, high) in solve.SIDES.items():
        values = np.array([float(row[name]) for row in rows if row["set"] == "shoulders"])
        assert low <= values.min() < low + 0.1 * (high - low)
        assert high - 0.1 * (high - low) < values.max() <= high
    for name, (low, high) in solve.BOX.items():
        values = np.array([float(row[name]) for row in rows if row["set"] == "fit"])
        assert low <= values.min() < low + 0.05 * (high - low)
        assert high - 0.05 * (high - low) < values.max() <= high
