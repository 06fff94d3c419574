"""One contact by Hertz and by finite elements: what is reported against what was solved, with ring and sheet."""

import json
import math
from collections.abc import Callable
from dataclasses import replace
from io import StringIO
from types import SimpleNamespace
from typing import Any

import pytest
from rich.console import Console

from analytic.errors import InputError
from analytic.scene import Contact
from analytic.scenefile.read import load_scene, parse_scene
from fembearing.check.comparison import compared
from fembearing.check.contact import solution
from fembearing.check.contact.hertz import corrected_hertz, hertz_quantities
from fembearing.check.contact.reference import solve_reference
from fembearing.check.contact.refinement import COMPARED, Wanted
from fembearing.check.contact.solution import ContactSolution, compare_contact, sheet_in_series, solve_contact
from fembearing.mesh.recipe import Recipe, load_recipe
from fembearing.report.document import Section
from fembearing.report.sections.contacts import contact_table
from fembearing.report.terminal import print_sections
from tests.analytic.specimens import present


def test_the_pressure_of_a_cut_contact_is_not_called_its_peak(cut_contact: ContactSolution) -> None:
    """It is the pressure at y = 0; at the shoulder it has no bound."""
    assert cut_contact.meshes[-1].pressure.max() > 1.02 * cut_contact.numbers.reference.peak_pressure
    out = StringIO()
    print_sections(Console(file=out, width=80), [Section("", [contact_table([cut_contact.numbers])])])
    assert "peak pressure" not in out.getvalue()
    assert "pressure at y = 0, GPa" in out.getvalue()


def test_an_ellipse_over_the_shoulder_is_not_judged(cut_contact: ContactSolution) -> None:
    found, load = cut_contact.numbers, cut_contact.contact.load
    assert found.verdict == "outside validity"
    assert "0.800 mm" in " ".join(found.warnings)
    assert "half of the contact, " in found.method
    shoulder = present(found.shoulder)
    assert (shoulder.sides, shoulder.half) == ({"above": 0.8e-3}, True)
    assert shoulder.centroid.reference < 0 < shoulder.centroid.relative_uncertainty
    # Half an ellipse of height p0 over twice the semi-axis a
    hertz, share, line = found.hertz, shoulder.strip_share, shoulder.strip_line_load
    ridge = math.pi / 2 * hertz.semi_axis_rolling * hertz.peak_pressure
    assert shoulder.hertz_line_load == pytest.approx(ridge, rel=1e-9)
    # Hertz's line load 3 Q/(4 b) (1 - y^2/b^2) is 0.36 of its greatest in the middle of the strip, the edge's own more
    assert 0.36 < line.reference / ridge < 1
    # Each with its own far boundary
    assert line.reference * shoulder.strip_width == pytest.approx(share.reference * load, rel=1e-3)
    for each in (shoulder.centroid, share, line):
        assert each.relative_uncertainty > abs(each.values[-1] / each.values[-2] - 1)


@pytest.mark.nightly
def test_the_answer_does_not_jump_where_the_contact_reaches_its_shoulder(
    contacts: dict[str, Contact], shallow: Callable[[str], Recipe]
) -> None:
    """A quarter is meshed before, a half after: they agree within their uncertainties."""
    reach = 0.931e-3  # m, semi-axis on the meshes
    before, after = (
        solve_reference(replace(contacts["inner"], shoulder=side * reach), Wanted(shallow("race"), accuracy=0.9))
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
    assert solution.numbers.verdict == "pass"
    assert solution.numbers.shoulder is solution.numbers.corrected is None
    assert not solution.numbers.warnings
    assert max(abs(each.difference) for each in solution.numbers.quantities.values()) < 2e-3  # as without a shoulder


@pytest.mark.slow
def test_meshes_are_refined_as_long_as_a_finer_one_could_decide(contacts: dict[str, Contact]) -> None:
    """Two levels reach the accuracy, but the limit lies within their interval."""
    contact, recipe = contacts["inner"], load_recipe("race")
    two = compare_contact(contact, recipe=recipe, tolerance=0.9)
    found = two.numbers.quantities
    off = abs(found["stiffness"].difference)  # Hertz's error is largest in it
    tolerance = off + 0.7 * present(found["stiffness"].relative_uncertainty)
    assert max(abs(each.difference) for each in found.values()) == off
    solution = compare_contact(contact, recipe=recipe, tolerance=tolerance)
    assert max(present(found[name].relative_uncertainty) for name in COMPARED) < tolerance  # where refinement could end
    assert (len(two.meshes), len(solution.meshes)) == (2, 3)
    assert solution.numbers.verdict == "pass"


def test_the_corrected_stiffness_is_that_of_the_corrected_approach(contacts: dict[str, Contact]) -> None:
    """K = Q/delta^1.5, and it is 1.5 times as uncertain."""
    contact = contacts["inner"]
    corrected, reasons = corrected_hertz(contact, hertz=hertz_quantities(contact))
    assert reasons == ()
    quantities = present(corrected).quantities
    assert quantities.stiffness == pytest.approx(contact.load / quantities.approach**1.5, rel=1e-9)
    uncertainty = present(corrected).uncertainty
    assert uncertainty["stiffness"] == pytest.approx(1.5 * uncertainty["approach"], rel=1e-12)


UNSEATED = """
name = "no seats"
tolerance = 0.9
[bearing]
name = "hybrid"
ball_count = 9
ball_diameter = "7.94 mm"
ball_mass = "2.04 g"
ball_material = "steel"
contact_angle = { rule = "given", value = "0.3 rad" }
inner = { bottom_radius = "15.53 mm", groove_radius = "4.13 mm", shoulder_half_width = "3.1 mm", material = "steel" }
outer = { bottom_radius = "23.48 mm", groove_radius = "4.21 mm", shoulder_half_width = "3.1 mm", material = "steel" }
[operation]
axial_load = "900 N"
inner_speed = "100 rpm"
"""


@pytest.mark.slow
def test_the_ring_does_not_change_the_contact() -> None:
    scene = load_scene("6205-dry")
    plain, ringed = (solve_contact(scene, pair="inner", tolerance=0.9, geometry=shape) for shape in ("real", "ring"))
    ring = present(ringed.numbers.ring)
    # A second method, for the size alone: a bonded layer of the ring's thickness under a point load, whose integral of
    # 1 - L(k) over k is 1.377 at nu = 0.3: 0.23 um. The ellipse is as wide as the ring is thick, the shoulders carry.
    layer = 1.377 * 372.2 * (1 - 0.3**2) / (3.1416 * 206e9 * 3.03e-3)
    assert -1.1 * layer < ring.approach < -0.6 * layer
    assert ring.uncertainty < 0.1 * abs(ring.approach)
    assert (ringed.numbers.geometry, plain.numbers.ring) == ("ring", None)
    assert ringed.numbers.quantities == plain.numbers.quantities


def test_without_seats_the_error_names_the_missing_keys() -> None:
    scene = parse_scene(UNSEATED, origin="case.toml")
    with pytest.raises(InputError, match=r"inner: .* bearing\.bore_diameter and bearing\.width"):
        solve_contact(scene, pair="inner", geometry="ring")


def pocket(approach: float, uncertainty: float) -> Any:
    """A pocket under 28 N."""
    return SimpleNamespace(load=28.0, quantities={"approach": compared(0.6e-6, approach, uncertainty * approach)})


def test_the_sheet_is_softer_by_what_it_adds_to_the_approach() -> None:
    """Both approaches off by their half-widths, in opposite directions, stay within the uncertainty."""
    exact, seat = 9.7e7, 0.587e-6
    found = present(sheet_in_series(pocket(seat, 1e-3), pocket(seat + 28.0 / exact, 2e-3)))
    assert found.stiffness == pytest.approx(exact, rel=1e-12)
    off = present(sheet_in_series(pocket(seat * 1.001, 0.0), pocket((seat + 28.0 / exact) * 0.998, 0.0)))
    assert abs(off.stiffness / exact - 1) == pytest.approx(found.uncertainty, rel=0.01)  # to first order
    assert sheet_in_series(pocket(seat, 1e-3), pocket(seat * 1.001, 2e-3)) is None


def test_half_a_contact_says_that_no_stress_below_it_is_computed(
    command, cut_contact: ContactSolution, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(solution, "solve_contact", lambda *_, **__: cut_contact)
    told, printed = (command("contact", *form) for form in (["--json"], []))
    found = json.loads(told.out)
    assert found["subsurface"] is None
    said = [line for line in found["warnings"] if "no stress below the contact" in line]
    assert len(said) == 1
    assert printed.err.count(said[0]) == 1
    assert "Greatest stress" not in printed.out
