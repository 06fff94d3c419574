"""The ladders of scenes: which methods there are, and bounds that cover the errors."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scene import Autocorrelation, Contact, ContactAngle, HeightMapFile, Scene, Surface
from analytic.scenefile.read import load_scene
from fembearing.check.contact.refinement import COMPARED
from fembearing.check.contact.solution import compare_contact
from fembearing.check.cost.ladder import Ladder, measured
from fembearing.check.cost.scene_cost import FORMULA_LADDERS, contact_ladder_of, contact_methods, films, measure_cost
from fembearing.mesh.recipe import load_recipe
from tests.analytic.specimens import present

DRY = load_scene("6205-dry")
LOAD = "load of the heaviest ball"


def ladder_of(quantity: str, scene: Scene, tolerance: float = 0.01) -> Ladder:
    """With each method run twice, and errors within their bounds."""
    ladder = measured(quantity, *FORMULA_LADDERS[quantity](scene), tolerance=tolerance, repeats=1)
    for method in ladder.methods:
        assert method.error is None or method.bound is None or method.error <= method.bound, method.name
    return ladder


def operated(scene: Scene = DRY, **given: Any) -> Scene:
    return replace(scene, operation=replace(scene.operation, **given))


def one_point(axial_load: float, inner_speed: float) -> dict[str, Any]:
    return {"axial_load": np.array([axial_load]), "inner_speed": np.array([inner_speed])}


def test_methods_under_thrust_have_the_errors_of_what_they_leave_out() -> None:
    free, frozen, still, moving, ring = ladder_of(LOAD, DRY).methods
    # Q goes as 1/sin al; 0.3031: an independent calculation of the loaded angle, to four digits
    assert free.error == pytest.approx(np.sin(0.3031) / np.sin(0.18) - 1, abs=4e-4)
    assert present(frozen.error) < 1e-4
    assert present(moving.error) < 1e-10 < present(still.error) < 1e-4  # centrifugal force at 500 rpm: 2.8e-5
    assert ring.error is None
    fitted, exact = ladder_of("Hertz contact", DRY).methods
    assert 0.01 < present(fitted.error) < 0.042  # the fits' stated range to a ratio of 100
    assert exact.chosen


@pytest.mark.parametrize("change", [{"radial_load": 50.0}, {"moment": 0.4}, {"inner_speed": np.array([700.0])}])
def test_bounds_of_thrust_alone_are_no_wider_than_a_few_errors(change: dict[str, Any]) -> None:
    """Stribeck's 4.37 is rounded up to 5, and what inertia does was chosen on random scenes: two to three errors."""
    methods = ladder_of(LOAD, operated(**change)).methods
    for method, most in zip(methods[:3], (1.7, 4, 4), strict=True):
        assert present(method.bound) < most * present(method.error), method.name


def test_a_radial_load_or_a_preload_leaves_fewer_methods() -> None:
    pulled = ladder_of(LOAD, operated(radial_load=2500.0), tolerance=0.1)
    assert all(0.4 < present(method.error) < 1 for method in pulled.methods[1:-1])  # the heaviest ball: 4.37 Fr/Z
    assert pulled.methods[-1].chosen
    assert len(ladder_of(LOAD, operated(axial_load=np.zeros(1), radial_load=330.0)).methods) == 1
    outer = replace(DRY.bearing.outer, bottom_radius=DRY.bearing.outer.bottom_radius - 20e-6)
    tight = replace(DRY, bearing=replace(DRY.bearing, outer=outer), contact_angle=ContactAngle(rule="solved"))
    failed = [method.failed for method in ladder_of(LOAD, tight).methods]
    assert [words and "preload" in words for words in failed] == [True, True, None, None, None]


def test_more_nodes_have_smaller_errors_within_their_uncertainty() -> None:
    physical = load_scene(Path(__file__).parents[3] / "validation" / "scenes" / "6205_physical.toml")
    ladder = ladder_of("friction torque", operated(physical, **one_point(830.0, 17.0)), tolerance=1e-3)
    errors = [present(method.error) for method in ladder.methods[:-1]]
    assert errors == sorted(errors, reverse=True)
    assert present(present(ladder.cheapest(1e-3)).bound) <= 1e-3
    # At a low speed a rule and rigid balls have one kinematics; nothing bounds what both miss.
    rule, rigid, *marched = ladder_of("how balls turn", operated(**one_point(1000.0, 17.0)), tolerance=0.03).methods
    assert present(rule.error) == pytest.approx(present(rigid.error), abs=5e-3)  # nodes of both
    assert rule.bound is rigid.bound is marched[-1].error is None
    assert present(marched[0].error) < present(rigid.error)


@pytest.mark.parametrize(
    ("kind", "spacing", "sizes"),
    [
        ("gaussian", 3e-6, [128, 256, 512]),
        ("exponential", 2e-6, [256, 512, 1024]),
        ("gaussian", 4e-6, []),  # more than a tenth of the correlation length
        ("gaussian", 0.05e-6, []),  # more than twice the points that the largest map has along a side
    ],
)
def test_bounds_of_generated_surfaces_fall_with_their_size(kind: Any, spacing: float, sizes: list[int]) -> None:
    """Differences of heights miss slopes of a smooth surface only, by the square of spacing over length."""
    rough = Surface(rms_roughness=0.4e-6, autocorrelation=Autocorrelation(kind=kind, length=30e-6, spacing=spacing))
    closed, *generated = ladder_of("roughness", replace(DRY, surface=rough)).methods
    assert closed.chosen
    assert [method.name for method in generated] == [f"generated, {size} x {size}" for size in sizes]
    missed = [present(each.bound) - 60e-6 / (size * spacing) for each, size in zip(generated, sizes, strict=True)]
    assert missed == pytest.approx([0.01 if kind == "gaussian" else 0.0] * len(sizes), abs=1e-9)


@pytest.mark.parametrize("start", [None, "whirl"])
def test_the_closed_form_of_a_cage_is_chosen_only_where_it_rests(start: Any) -> None:
    cage = replace(present(DRY.cage), start=start, steps_per_contact=44)
    ladder = ladder_of("cage torque", replace(operated(**one_point(900.0, -83.0)), cage=cage), tolerance=0.1)
    assert [method.name for method in ladder.methods[1:]] == [f"motion, {n} steps a contact" for n in (11, 22, 44, 88)]
    assert [method.bound is None for method in ladder.methods] == [True, True, False, False, False]
    error = present(ladder.methods[0].error)
    assert (
        error < 0.04 if start is None else error > 0.5
    )  # a whirling cage hits its balls with far more than its weight
    assert ladder.methods[0].chosen is (start is None)


MAP = Surface(height_map=HeightMapFile(path="race.npy", spacing=2e-6))


@pytest.mark.parametrize(
    ("quantity", "change", "words"),
    [
        ("friction torque", {"friction_coefficient": None}, "neither friction.coefficient nor"),
        ("friction torque", {"microslip": "as_printed"}, "as_printed"),
        ("friction torque", {"effects": {"spin": "off", "conformity": "off"}}, "nothing slides"),
        ("how balls turn", {"effects": {"spin": "off"}}, "do not turn freely"),
        (LOAD, {"contact_angle": ContactAngle(rule="given", value=0.21)}, "fixes the angle"),
        ("roughness", {}, r"no \[surface\]"),
        ("roughness", {"surface": MAP}, "measured"),
        ("cage torque", {"cage": None}, r"no \[cage\]"),
        ("cage torque", {"operation": operated(**one_point(700.0, 0.0)).operation}, "stands still"),
    ],
)
def test_a_scene_without_such_a_ladder_says_why(quantity: str, change: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError, match=words):
        FORMULA_LADDERS[quantity](replace(DRY, **change))


def test_a_tolerance_must_be_positive() -> None:
    with pytest.raises(InputError, match=r"tolerance.*0"):
        measure_cost(DRY, tolerance=0.0)


def test_errors_of_a_contact_fall_within_bounds_from_hertz_to_all_meshes(contacts: dict[str, Contact]) -> None:
    """Measured, and taken from a solution, whose numbers give the errors here; the contact is outside the fits."""
    recipe = replace(load_recipe("race"), levels=(1, 2, 3))
    *methods, pair, extrapolated = measured(
        "contact", *contact_methods(contacts["inner"], recipe), tolerance=0.01, repeats=1
    ).methods
    assert [method.name[-7:] for method in methods[2:]] == [f"level {level}" for level in (1, 2, 3, 1, 2)]
    for method in methods:
        assert present(method.error) < present(method.bound) < 10 * present(method.error), method.name
    assert present(pair.error) < present(pair.bound) + present(extrapolated.bound)
    solved = compare_contact(contacts["inner"], recipe=recipe, tolerance=0.01)
    taken = contact_ladder_of(solved).methods
    numbers = solved.numbers
    corrected = present(numbers.corrected).quantities
    found_by = [
        {name: numbers.quantities[name].production for name in COMPARED},
        {name: getattr(corrected, name) for name in COMPARED},
        *({name: getattr(mesh.quantities, name) for name in COMPARED} for mesh in solved.meshes),
    ]
    for method, found in zip(taken[:-1], found_by, strict=True):
        off = [found[name] / numbers.estimates[name].limit - 1 for name in COMPARED]
        assert method.error == pytest.approx(np.max(np.abs(off)), rel=1e-9)
    seconds = [mesh.seconds for mesh in solved.meshes]
    assert [method.seconds for method in taken[2:]] == pytest.approx([*seconds, sum(seconds)], abs=1e-3)


@pytest.mark.nightly
def test_errors_of_a_film_fall_from_grid_to_grid() -> None:
    film, force = (measured("film", *each, tolerance=0.02) for each in films(load_scene("paper_6205")))
    for ladder, limit in ((film, 0.05), (force, 0.06)):  # the stated error of the fit, and the solution's own
        _, fit, *grids, reference = ladder.methods
        assert (present(fit.error) < limit, reference.error) == (True, None)
        errors, seconds = zip(*((present(each.error), present(each.seconds)) for each in grids), strict=True)
        assert (errors, seconds) == (tuple(sorted(errors)[::-1]), tuple(sorted(seconds)))
