"""The contact solver against Hertz on the idealisation, and against laws that any elastic contact obeys."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.contact.hertz import HertzContact, contact_modulus, hertz_contact, relative_curvatures
from analytic.errors import ConvergenceError, InputError
from analytic.scene import Contact
from fembearing.fem import solution
from fembearing.fem.contact import press
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.solution import MeshSolution, fitted_on_level, fitted_solution, solve_on_mesh
from fembearing.mesh.recipe import load_recipe
from tests import contacts
from tests.contacts import NITRIDE, STEEL

INNER = replace(contacts.INNER, rolling_radius=16.2e-3, shoulder=2.6e-3, contact_angle=0.18, load=620.0)
OUTER = replace(INNER, pair="outer", groove_radius=4.21e-3, rolling_radius=-23.8e-3)
NAMES = ("semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach")


def hertz(contact: Contact) -> HertzContact:
    curvature_x, curvature_y = relative_curvatures(contact)
    modulus = contact_modulus(contact.ball_material, contact.race_material)
    return hertz_contact(curvature_x=curvature_x, curvature_y=curvature_y, load=contact.load, modulus=modulus)


def errors(found: MeshSolution, exact: HertzContact) -> np.ndarray:
    """Relative, of both semi-axes, peak pressure and approach."""
    expected = np.array([exact.semi_axis_x, exact.semi_axis_y, exact.peak_pressure, exact.approach])
    return np.array([getattr(found.quantities, name) for name in NAMES]) / expected - 1


def solve(contact: Contact, recipe: str = "hertzian", level: int = 2, **sizes: tuple[float, float]) -> MeshSolution:
    made = load_recipe(recipe)
    semi_axes = sizes.get("semi_axes")
    if semi_axes is None:
        fitted = fitted_solution(contact, recipe=made)
        if fitted.level == level:
            return fitted
        semi_axes = fitted.pair.semi_axes
    return solve_on_mesh(contact, recipe=made, level=level, semi_axes=semi_axes)


@pytest.fixture(scope="module")
def fitted() -> MeshSolution:
    return fitted_solution(INNER, recipe=load_recipe("hertzian"))


@pytest.fixture(scope="module")
def real() -> MeshSolution:
    return solve(INNER, "race")


@pytest.mark.parametrize(
    "contact",
    [
        pytest.param(INNER, marks=pytest.mark.nightly, id="inner"),
        pytest.param(OUTER, marks=pytest.mark.slow, id="outer"),
    ],
)
def test_the_idealisation_agrees_with_hertz_within_a_tenth_of_a_per_cent(contact: Contact) -> None:
    """On the finest level; and the errors fall with an order."""
    exact = hertz(contact)
    semi_axes = (float(exact.semi_axis_x), float(exact.semi_axis_y))
    coarse, fine = (np.abs(errors(solve(contact, level=level, semi_axes=semi_axes), exact)) for level in (2, 4))
    assert fine.max() < 1e-3  # the aim; 2e-4 is usual
    # The square-root edge of the pressure leaves at least order 1.5; peak pressure is accurate too early to show one.
    assert (np.log2(coarse[[0, 1, 3]] / fine[[0, 1, 3]]) > 1.5).all()


@pytest.mark.parametrize("load", [2.1e-3, 50.0, 2000.0])
def test_the_idealisation_is_as_accurate_under_any_load(load: float) -> None:
    """Its mesh grows with the ellipse, so the relative errors are those of 620 N, which the test above bounds."""
    light = replace(INNER, load=load)
    exact, other = hertz(INNER), hertz(light)
    semi_axes = (float(exact.semi_axis_x), float(exact.semi_axis_y))
    scaled = (float(other.semi_axis_x), float(other.semi_axis_y))
    expected = errors(solve(INNER, level=1, semi_axes=semi_axes), exact)
    np.testing.assert_allclose(errors(solve(light, level=1, semi_axes=scaled), other), expected, atol=1e-8)  # round-off


@pytest.mark.parametrize(
    "contact",
    [
        replace(INNER, rolling_radius=3.2e-3, groove_radius=31.0e-3, race_material=NITRIDE),  # longer along rolling
        replace(INNER, groove_radius=1e9, rolling_radius=1e9),  # a sphere on a plane
        replace(INNER, groove_radius=4.01e-3),  # conformity 0.505
    ],
    ids=["across, ceramic", "circle", "close conformity"],
)
def test_other_ellipses_and_materials_meet_hertz_too(contact: Contact) -> None:
    assert np.abs(errors(solve(contact, level=3), hertz(contact))).max() < 3e-3  # of the third level


def test_approach_goes_as_load_to_two_thirds_on_one_fixed_mesh() -> None:
    """One mesh, made for the largest ellipse, and one condensation under loads 1 : 8."""
    largest = replace(INNER, load=8 * INNER.load)
    found = solve(largest, level=3, semi_axes=expected_semi_axes(largest))
    loads = INNER.load * np.array([1.0, 2.0, 4.0, 8.0])
    approaches = []
    for load in loads:
        _, approach, _ = press(
            compliance=2 * found.upper.compliance,  # half spaces of one material are mirror images
            drift=8 * found.upper.drift,  # of the whole load, a quarter of which is pressed
            gap=found.pair.gap,
            lever=-found.pair.normal[2],
            load=load / 4,
            start=found.force > 0,
        )
        approaches.append(approach)
    np.testing.assert_allclose(approaches[-1], found.quantities.approach, rtol=1e-9)  # round-off: nothing was mixed up
    slope = np.polyfit(np.log(loads), np.log(approaches), 1)[0]
    # 0.5 %: the smallest ellipse is half as wide as its mesh expects, has half the cells and its edge crosses cells
    np.testing.assert_allclose(slope, 2 / 3, rtol=5e-3)


def test_nodal_forces_carry_the_load(fitted: MeshSolution, real: MeshSolution) -> None:
    for found in (fitted, real):
        along = found.force * -found.pair.normal[2]
        np.testing.assert_allclose(4 * along.sum(), INNER.load, rtol=1e-10)  # round-off
        assert (found.force >= 0).all()


@pytest.mark.slow
def test_true_shapes_differ_from_the_idealisation_and_less_so_under_less_load() -> None:
    """In the longer semi-axis, which the curved groove shortens by about (b/r)^2: 9.5^(2/3) = 4.5 between the loads."""

    def transverse(contact: Contact, recipe: str) -> tuple[float, float]:
        """Over Hertz's value, so that loads can be compared; and its tolerance."""
        unit = float(hertz(contact).semi_axis_y)
        second = fitted_solution(contact, recipe=load_recipe(recipe))
        meshes = [second, solve(contact, recipe, level=3, semi_axes=second.pair.semi_axes)]
        coarse, fine = (mesh.quantities.semi_axis_transverse / unit for mesh in meshes)
        return fine, abs(fine - coarse)  # convergence index: 1.25/(1.5^2 - 1) = 1 times the last change

    ideal, off = transverse(INNER, "hertzian")  # the same under any load, see above
    departures = []
    for load in (1900.0, 200.0):
        real, uncertain = transverse(replace(INNER, load=load), "race")
        departures.append(abs(real / ideal - 1))
        assert departures[-1] > off + uncertain
    assert departures[0] > 3 * departures[1]


@pytest.mark.parametrize("scale", [0.6, 1.6, 10.0])
def test_a_poor_first_guess_is_corrected(scale: float, fitted: MeshSolution) -> None:
    a, b = expected_semi_axes(INNER)
    mended = fitted_solution(INNER, recipe=load_recipe("hertzian"), guess=(scale * a, b / scale))
    np.testing.assert_allclose(mended.pair.semi_axes, fitted.pair.semi_axes, rtol=0.02)  # each within 1 % of its own
    for name in NAMES:  # 0.2 %: less than the second level's own error, which is all that the mesh may change
        np.testing.assert_allclose(getattr(mended.quantities, name), getattr(fitted.quantities, name), rtol=2e-3)


@pytest.mark.parametrize("side", ["ball_material", "race_material"])
@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"poisson_ratio": 0.5}, "steel: poisson_ratio must lie above -1 and below 0.5, got 0.5"),
        ({"poisson_ratio": -1.0}, "got -1"),
        ({"poisson_ratio": float("nan")}, "got nan"),
        ({"youngs_modulus": -2.1e11}, "youngs_modulus must be positive"),
        ({"youngs_modulus": float("inf")}, "youngs_modulus must be positive and finite, got inf"),
    ],
)
def test_an_impossible_material_is_refused(side: str, changed: dict[str, float], words: str) -> None:
    bad = replace(INNER, **{side: replace(STEEL, **changed)})
    with pytest.raises(InputError, match=words):
        fitted_solution(bad, recipe=load_recipe("hertzian"))
    with pytest.raises(InputError, match=words):
        solve_on_mesh(bad, recipe=load_recipe("hertzian"), level=1, semi_axes=(0.1e-3, 1e-3))


@pytest.mark.parametrize(("name", "value"), [("load", 0.0), ("ball_radius", -3e-3), ("groove_radius", float("nan"))])
def test_an_impossible_contact_is_refused(name: str, value: float) -> None:
    with pytest.raises(InputError, match=f"{name} must be positive"):
        fitted_solution(replace(INNER, **{name: value}), recipe=load_recipe("hertzian"))


@pytest.fixture
def measured(monkeypatch: pytest.MonkeyPatch) -> Any:
    """What each mesh in turn measures of both axes, over its own; and the meshes made."""
    told = SimpleNamespace(ratios=[], made=[])

    def solved(*_: Any, semi_axes: tuple[float, float], **__: Any) -> Any:
        ratio = told.ratios[min(len(told.made), len(told.ratios) - 1)]
        told.made.append(semi_axes)
        return SimpleNamespace(semi_axes=(ratio[0] * semi_axes[0], ratio[1] * semi_axes[1]))

    monkeypatch.setattr(solution, "solve_on_mesh", solved)
    return told


def test_a_size_that_never_fits_is_named_with_its_misfit(measured: Any) -> None:
    measured.ratios = [(1.1, 0.93)]
    with pytest.raises(ConvergenceError, match=r"size of the contact did not converge in 12 .*1\.0e-01 of a semi-axis"):
        fitted_on_level(INNER, recipe=load_recipe("race"), level=1, start=(0.2, 1.1), good=0.02)


def test_the_other_side_of_a_cut_contact_tells_its_ellipse() -> None:
    """The quarter's ellipse where the nearer or the farther shoulder takes a tenth of it; the cut one less."""
    axes, recipe = expected_semi_axes(INNER, geometry="real"), load_recipe("race")
    whole = solve_on_mesh(INNER, recipe=recipe, level=1, semi_axes=axes)
    for near, far in ((0.9, 3.0), (3.0, 0.9)):
        contact = replace(INNER, shoulder=near * axes[1], far_shoulder=far * axes[1])
        found = solve_on_mesh(contact, recipe=recipe, level=1, semi_axes=axes)
        np.testing.assert_allclose(found.semi_axes[0], whole.semi_axes[0], rtol=0.02)
        assert 0.99 < found.semi_axes[1] / whole.semi_axes[1] < 1.03  # the error of a first level
        assert found.quantities.semi_axis_transverse < 0.985 * found.semi_axes[1]
        assert found.quantities.peak_pressure == pytest.approx(whole.quantities.peak_pressure, rel=0.03)
