"""One contact by Hertz and by finite elements: what is reported against what was solved."""

import math
import re
from collections.abc import Callable
from dataclasses import replace
from io import StringIO
from types import SimpleNamespace

import pytest
from rich.console import Console

from analytic.errors import InputError
from analytic.progress import silent
from analytic.scene import Contact
from fembearing.check.contact import solution as module
from fembearing.check.contact.hertz import CorrectedHertz, corrected_hertz, hertz_quantities
from fembearing.check.contact.refinement import COMPARED, Reference, solve_reference
from fembearing.check.contact.solution import ContactSolution, compare_contact
from fembearing.check.contact.warnings import shoulder_warning
from fembearing.grid_convergence import Estimate
from fembearing.mesh.recipe import Recipe, load_recipe
from fembearing.plain_types import plain
from fembearing.report.contact import contact_record
from fembearing.report.phrases import shoulder_lines
from fembearing.report.tables.contacts import contact_table
from fembearing.report.terminal.table import show
from tests.analytic.specimens import present

PARTS = ("meshes", "estimates", "shoulder", "refinement")  # fields that a solution and its reference share


def cut_at(solution: ContactSolution, *, below: float, half: bool) -> ContactSolution:
    """The same solution with a second shoulder, which is farther and reached too."""
    mesh = solution.meshes[-1]
    footprint = replace(mesh.pair.footprint, shoulders=(below, 0.8e-3), half=half)
    return replace(
        solution, meshes=(*solution.meshes[:-1], replace(mesh, pair=replace(mesh.pair, footprint=footprint)))
    )


def test_each_shoulder_that_is_reached_is_named_with_its_side_and_distance(cut_contact: ContactSolution) -> None:
    unequal, equal = cut_at(cut_contact, below=0.8647e-3, half=True), cut_at(cut_contact, below=0.8e-3, half=False)
    for solution, sides in ((cut_contact, {"above": 0.8e-3}), (unequal, {"below": 0.8647e-3, "above": 0.8e-3})):
        assert present(contact_record(solution).shoulder).sides == sides
    words = " ".join(shoulder_lines(contact_record(unequal)))
    assert re.search("y = -0.8647 mm .*y = 0.8 mm.*half of", words)
    assert "one side" not in words
    assert "half of" not in " ".join(shoulder_lines(contact_record(equal)))
    warning = shoulder_warning(unequal.contact, Reference(**{part: getattr(unequal, part) for part in PARTS}))
    assert "y = -0.865 mm and 0.800 mm" in warning


@pytest.mark.parametrize(
    ("part", "changed", "words"),
    [
        ("estimates", {"mesh": math.nan}, "uncertainty of the approach.* nan"),
        ("estimates", {"beyond": math.inf}, "approach, finite elements .* inf"),
        ("hertz", {"approach": math.nan}, "approach, Hertz .* nan"),
    ],
)
def test_a_contact_with_a_number_that_is_not_finite_is_no_result(
    cut_contact: ContactSolution, part: str, changed: dict[str, float], words: str
) -> None:
    if part == "hertz":
        whole: object = replace(cut_contact.hertz, **changed)
    else:
        whole = cut_contact.estimates | {"approach": replace(cut_contact.estimates["approach"], **changed)}
    with pytest.raises(InputError, match=words):
        replace(cut_contact, **{part: whole})


def test_the_pressure_of_a_cut_contact_is_not_called_its_peak(cut_contact: ContactSolution) -> None:
    """It is the pressure at y = 0; at the shoulder it has no bound."""
    pressures = cut_contact.meshes[-1].pressure
    assert pressures.max() > 1.02 * cut_contact.reference.peak_pressure
    out = StringIO()
    show(Console(file=out, width=80), contact_table([(contact_record(cut_contact), cut_contact.verdicts)]))
    assert "peak pressure" not in out.getvalue()
    assert "pressure at y = 0, GPa" in out.getvalue()
    assert present(contact_record(cut_contact).shoulder).peak_pressure_at == 0


def test_an_ellipse_over_the_shoulder_is_not_judged(cut_contact: ContactSolution) -> None:
    solution, narrow = cut_contact, cut_contact.contact
    assert solution.verdict == "outside validity"
    assert "0.800 mm" in " ".join(solution.warnings)
    shoulder = plain(contact_record(solution).shoulder)
    assert solution.shoulders == (0.8e-3,)
    assert shoulder["centroid"]["fe"] < 0 < shoulder["centroid"]["uncertainty"]
    # Hertz's line load 3 Q/(4 b) (1 - y^2/b^2) is 0.36 of its greatest in the middle of the strip, the edge's own more
    assert 0.36 < shoulder["strip_line_load"]["fe"] / shoulder["hertz_line_load"] < 1
    assert shoulder["strip_line_load"]["fe"] * shoulder["strip_width"] == pytest.approx(
        shoulder["strip_share"]["fe"] * narrow.load, rel=1e-3
    )  # each with its own far boundary
    for name in ("centroid", "strip_share", "strip_line_load"):
        values = shoulder[name]["values"]
        assert shoulder[name]["uncertainty"] > abs(values[-1] / values[-2] - 1), name


@pytest.mark.nightly
def test_the_answer_does_not_jump_where_the_contact_reaches_its_shoulder(
    contacts: dict[str, Contact], shallow: Callable[[str], Recipe]
) -> None:
    """A quarter is meshed before, a half after: they agree within their uncertainties."""
    reach = 0.931e-3  # m, semi-axis on the meshes
    before, after = (
        solve_reference(
            replace(contacts["inner"], shoulder=side * reach), recipe=shallow("race"), accuracy=0.9, progress=silent
        )
        for side in (1.01, 0.99)
    )
    assert (before.meshes[-1].pair.footprint.half, after.meshes[-1].pair.footprint.half) == (False, True)
    for name, part in before.estimates.items():
        other = after.estimates[name]
        assert abs(other.value / part.value - 1) < part.total + other.total, name


def test_the_hertzian_idealisation_has_no_shoulder(contacts: dict[str, Contact]) -> None:
    """Its exact answer is Hertz's."""
    narrow = replace(contacts["inner"], shoulder=0.8e-3)
    solution = compare_contact(narrow, recipe=load_recipe("hertzian"), tolerance=0.05)
    assert solution.verdict == "pass"
    assert not solution.shoulder
    assert not solution.warnings
    assert max(map(abs, solution.discrepancy.values())) < 2e-3  # as without a shoulder


@pytest.mark.slow
def test_meshes_are_refined_as_long_as_a_finer_one_could_decide(contacts: dict[str, Contact]) -> None:
    """Two levels reach the accuracy, but the limit lies within their interval."""
    contact, recipe = contacts["inner"], load_recipe("race")
    two = compare_contact(contact, recipe=recipe, tolerance=0.9)
    part = two.estimates["stiffness"]  # Hertz's error is largest in it
    off = abs(two.hertz.stiffness / part.value - 1)
    tolerance = off + 0.7 * part.total
    assert max(map(abs, two.discrepancy.values())) == off
    solution = compare_contact(contact, recipe=recipe, tolerance=tolerance)
    assert max(two.estimates[name].total for name in COMPARED) < tolerance  # where refinement could end
    assert (len(two.meshes), len(solution.meshes)) == (2, 3)
    assert solution.verdict == "pass"


# Semi-axes from the middle to the shoulder
@pytest.mark.parametrize(("distance", "valid"), [(1.04, False), (1.06, True)])
def test_an_ellipse_within_a_twentieth_of_its_shoulder_is_not_judged(
    contacts: dict[str, Contact], monkeypatch: pytest.MonkeyPatch, distance: float, valid: bool
) -> None:
    contact = contacts["inner"]
    solved = replace(hertz_quantities(contact), semi_axis_transverse=0.9e-3)
    meshes = (SimpleNamespace(level=3, quantities=solved, shoulder=None, unknowns=7),)
    values = {name: 3 * (value,) for name, value in vars(solved).items()}
    estimates = {name: Estimate(values=part, order=None, richardson=None, mesh=0.001) for name, part in values.items()}
    reference = SimpleNamespace(meshes=meshes, estimates=estimates, shoulder={}, refinement="twin")
    monkeypatch.setattr(module, "solve_reference", lambda *_, **__: reference)
    monkeypatch.setattr(module, "profiles_of", lambda *_: {})  # the meshes are stand-ins
    judged = compare_contact(replace(contact, shoulder=distance * 0.9e-3), recipe=load_recipe("race"), tolerance=0.4)
    assert judged.valid == valid
    assert judged.verdict == ("pass" if valid else "outside validity")
    assert any("the shoulder is at" in warning for warning in judged.warnings) != valid


def test_above_the_static_limit_the_warning_says_so(
    contacts: dict[str, Contact], shallow: Callable[[str], Recipe]
) -> None:
    """Both sides are elastic, so their agreement proves nothing there."""
    solution = compare_contact(
        replace(contacts["inner"], groove_radius=5.0e-3, load=2250.0), recipe=shallow("race"), tolerance=0.9
    )
    assert solution.reference.peak_pressure > 4.2e9
    assert "above the static limit, 4.2 GPa" in " ".join(solution.warnings)


def test_the_greatest_line_load_of_hertz_is_his_pressure_summed_along_rolling(cut_contact: ContactSolution) -> None:
    """Half an ellipse of height p0 over twice the semi-axis a."""
    hertz = cut_contact.hertz
    assert cut_contact.hertz_line_load == pytest.approx(
        math.pi / 2 * hertz.semi_axis_rolling * hertz.peak_pressure, rel=1e-9
    )
    assert cut_contact.strip_width == pytest.approx(0.08e-3, rel=1e-12)  # a tenth of 0.8 mm
    assert cut_contact.sides == {"above": 0.8e-3}
    whole = replace(cut_contact, shoulder={})
    assert (whole.shoulders, whole.sides, whole.centroid) == ((), {}, 0.0)
    assert cut_contact.centroid == cut_contact.shoulder["centroid"].value


def test_each_quantity_is_compared_with_its_own_uncertainty(cut_contact: ContactSolution) -> None:
    part = cut_contact.estimates["approach"]
    for off, exceeds in ((0.9, False), (1.1, True), (-1.1, True)):
        value = cut_contact.hertz.approach / (1 + off * 0.02)
        estimate = Estimate(values=(value,), order=None, richardson=None, mesh=0.016, domain=0.012)
        found = replace(cut_contact, estimates=cut_contact.estimates | {"approach": estimate})
        assert found.discrepancy["approach"] == pytest.approx(off * 0.02, rel=1e-9)
        assert found.exceeds_uncertainty["approach"] == exceeds
        assert found.comparisons["approach"].resolved == exceeds
        assert found.reference.approach == pytest.approx(value, rel=1e-12)
    assert set(cut_contact.formal_orders.values()) == {None}
    assert replace(cut_contact, shoulder={}).formal_orders["approach"] == 4.0
    assert cut_contact.columns()["uncertainty_approach"] == part.total


def test_a_sheet_is_shown_and_files_begin_with_the_bearing(cut_contact: ContactSolution) -> None:
    sheet = replace(cut_contact, geometry="wall")
    assert (sheet.judged, sheet.shown_verdict) == (False, "shown")
    assert (cut_contact.judged, cut_contact.shown_verdict) == (True, cut_contact.verdict)
    assert cut_contact.stem == "inner-real"
    assert replace(cut_contact, bearing="second").stem == "second-inner-real"
    assert "half of the contact, " in cut_contact.method
    assert "twin" not in cut_contact.method
    assert "corrected by a half-space twin, " in replace(cut_contact, refinement="twin").method


def test_the_interpolation_error_is_that_of_corrected_hertz(cut_contact: ContactSolution) -> None:
    values = replace(cut_contact.hertz, approach=1.03 * cut_contact.estimates["approach"].value)
    corrected = CorrectedHertz(quantities=values, uncertainty={})
    assert replace(cut_contact, corrected=corrected).interpolation_error["approach"] == pytest.approx(0.03, rel=1e-9)
    assert replace(cut_contact, corrected=None).interpolation_error == {}


def test_hertz_is_corrected_on_races_of_true_shape_alone(contacts: dict[str, Contact]) -> None:
    for pair, geometry, correctable in (
        ("inner", "real", True),
        ("outer", "ring", True),
        ("inner", "hertzian", False),
        ("pocket", "real", False),
        ("pocket", "wall", False),
    ):
        contact = replace(contacts["inner"], pair=pair)
        assert module.is_correctable(contact, geometry) == correctable  # pyright: ignore[reportArgumentType]


def test_the_corrected_stiffness_is_that_of_the_corrected_approach(contacts: dict[str, Contact]) -> None:
    """K = Q/delta^1.5, and it is 1.5 times as uncertain."""
    contact = contacts["inner"]
    corrected, reasons = corrected_hertz(contact, hertz=hertz_quantities(contact))
    assert reasons == ()
    quantities = present(corrected).quantities
    assert quantities.stiffness == pytest.approx(contact.load / quantities.approach**1.5, rel=1e-9)
    uncertainty = present(corrected).uncertainty
    assert uncertainty["stiffness"] == pytest.approx(1.5 * uncertainty["approach"], rel=1e-12)
