"""The ladders of the closed forms: which methods a scene has, their errors, and bounds that cover the errors."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scene import Autocorrelation, Contact, ContactAngle, HeightMapFile, Scene, Surface
from analytic.scenefile.read import load_scene
from fembearing.check.cost import formula_ladders
from fembearing.check.cost.formula_ladders import (
    friction_methods,
    hertz_methods_of,
    load_methods,
    roughness_methods,
    turning_methods,
)
from fembearing.check.cost.ladder import Ladder, UntimedLadder, measured
from tests.analytic.specimens import present

SCENES = Path(__file__).parents[3] / "validation" / "scenes"
pytestmark = pytest.mark.usefixtures("timed_once")


@pytest.fixture(scope="module")
def scene() -> Scene:
    return load_scene("6205-dry")


@pytest.fixture(scope="module")
def oiled() -> Scene:
    """At one speed, with oil, roughness and a sinh traction."""
    whole = load_scene(SCENES / "6205_physical.toml")
    one = replace(whole.operation, axial_load=np.array([830.0]), inner_speed=np.array([17.0]))
    return replace(whole, operation=one)


def errors_of(ladder: Ladder) -> list[float]:
    return [method.error for method in ladder.methods if method.error is not None]


def check_bounds(ladder: Ladder) -> None:
    for method in ladder.methods:
        if method.error is not None and method.bound is not None:
            assert method.error <= method.bound, method.name


def test_fitted_hertz_is_a_few_per_cent_off_and_exact_for_a_circle(contacts: dict[str, Contact]) -> None:
    ladder = measured(hertz_methods_of((contacts["inner"], contacts["outer"])), tolerance=0.01)
    fitted, exact = ladder.methods
    assert [fitted.name, exact.name] == ["fitted", "exact"]
    assert 0.01 < present(fitted.error) < 0.042  # the fits' stated range to a ratio of 100; here 32 and 15
    check_bounds(ladder)
    assert exact.chosen
    flat = replace(contacts["inner"], groove_radius=1e9, rolling_radius=1e9)
    (error,) = errors_of(measured(hertz_methods_of((flat,)), tolerance=0.01))
    assert error == pytest.approx(0, abs=1e-8)  # 4 mm in 1e9 m


def test_the_load_under_thrust_has_five_methods(scene: Scene) -> None:
    ladder = measured(load_methods(scene), tolerance=0.01)
    free, frozen, still, moving, ring = ladder.methods
    # Q goes as 1/sin al; 0.3031: an independent calculation of the loaded angle, to four digits
    assert free.error == pytest.approx(np.sin(0.3031) / np.sin(0.18) - 1, abs=4e-4)
    assert present(frozen.error) < 1e-4
    assert still.error is not None
    assert still.error < 1e-4  # centrifugal force over load at 500 rpm: 2.8e-5
    assert present(moving.error) < 1e-10 < still.error  # two solvers of one equilibrium
    assert ring.error is None
    assert not free.chosen
    check_bounds(ladder)


def test_a_radial_load_leaves_only_the_ring(scene: Scene) -> None:
    """The heaviest ball carries 4.37 Fr/Z and more: no method for thrust comes close."""
    pulled = replace(scene, operation=replace(scene.operation, radial_load=2500.0))
    ladder = measured(load_methods(pulled), tolerance=0.1)
    assert ladder.chosen is ladder.methods[-1]
    assert all(0.4 < error < 1 for error in errors_of(ladder)[1:])
    check_bounds(ladder)


def test_a_preload_leaves_no_free_angle(scene: Scene) -> None:
    outer = replace(scene.bearing.outer, bottom_radius=scene.bearing.outer.bottom_radius - 20e-6)
    bearing = replace(scene.bearing, outer=outer)
    tight = replace(scene, bearing=bearing, contact_angle=ContactAngle(rule="solved", free=None))
    free, frozen, *others = measured(load_methods(tight), tolerance=0.01).methods
    assert "preload" in (free.failed or "")
    assert "preload" in (frozen.failed or "")
    assert free.seconds is None
    assert not any(method.failed for method in others)


def test_more_nodes_have_smaller_errors_within_their_uncertainty(oiled: Scene) -> None:
    ladder = measured(friction_methods(oiled), tolerance=1e-3)
    errors = [present(method.error) for method in ladder.methods[:-1]]
    assert errors == sorted(errors, reverse=True)
    assert present(present(ladder.chosen).bound) <= 1e-3
    check_bounds(ladder)


def test_ways_to_turn_become_more_accurate(scene: Scene) -> None:
    """At a low speed a rule and rigid balls have one kinematics; nothing bounds what both miss."""
    dry = replace(
        scene, operation=replace(scene.operation, axial_load=np.array([1000.0]), inner_speed=np.array([17.0]))
    )
    ladder = measured(turning_methods(dry), tolerance=0.03)
    rule, rigid, *marched = ladder.methods
    assert present(rule.error) == pytest.approx(present(rigid.error), abs=5e-3)  # nodes of both
    assert rule.bound is rigid.bound is marched[-1].error is None
    assert present(marched[0].error) < present(rigid.error)
    assert ladder.chosen in marched
    check_bounds(ladder)


def test_a_generated_surface_has_the_moments_of_its_ensemble(oiled: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    """For any seed, within bounds that fall with the size of the surface; the closed form is exact and the cheapest."""
    monkeypatch.setattr(formula_ladders, "LARGEST_MAP", 512)
    for kind, seed in (("gaussian", 3), ("exponential", 4), ("gaussian", 5)):
        monkeypatch.setattr(formula_ladders, "SEED", seed)
        rough = Surface(
            rms_roughness=0.4e-6,
            autocorrelation=Autocorrelation(kind=kind, length=30e-6, spacing=2e-6),  # pyright: ignore[reportArgumentType]
        )
        ladder = measured(roughness_methods(replace(oiled, surface=rough)), tolerance=0.1)
        closed, *generated = ladder.methods
        assert closed.error is None
        assert closed.chosen
        assert [method.name for method in generated] == ["generated, 256 x 256", "generated, 512 x 512"]
        check_bounds(ladder)
        bounds = [method.bound for method in generated if method.bound is not None]
        assert len(bounds) == len(generated)
        assert bounds == sorted(bounds, reverse=True)


def test_differences_of_heights_miss_slopes_of_a_smooth_surface_only(
    oiled: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By the square of spacing over length, 0.01 here; an exponential surface has no slope of its own to miss."""
    monkeypatch.setattr(formula_ladders, "LARGEST_MAP", 512)

    def bound(kind: Literal["gaussian", "exponential"]) -> float:
        rough = Surface(rms_roughness=0.4e-6, autocorrelation=Autocorrelation(kind=kind, length=30e-6, spacing=3e-6))
        _, generated, *_ = measured(roughness_methods(replace(oiled, surface=rough)), tolerance=0.1).methods
        return present(generated.bound)

    assert bound("gaussian") > bound("exponential") + 0.005


@pytest.mark.parametrize(
    ("spacing", "largest", "sizes"),
    [(4e-6, 512, []), (2e-6, 127, []), (2e-6, 128, [256]), (3e-6, 256, [128, 256]), (30e-6 / 12.8, 256, [128, 256])],
)
def test_a_surface_of_too_wide_a_spacing_or_too_many_points_is_not_generated(
    oiled: Scene, monkeypatch: pytest.MonkeyPatch, spacing: float, largest: int, sizes: list[int]
) -> None:
    """At most a tenth of the correlation length of 30 um, and twice the points of the largest map along a side."""
    monkeypatch.setattr(formula_ladders, "LARGEST_MAP", largest)
    correlation = Autocorrelation(kind="gaussian", length=30e-6, spacing=spacing)
    rough = Surface(rms_roughness=0.4e-6, autocorrelation=correlation)
    closed, *generated = roughness_methods(replace(oiled, surface=rough)).methods
    assert closed.name == "closed-form moments"
    assert [method.name for method in generated] == [f"generated, {size} x {size}" for size in sizes]


def without_friction(scene: Scene) -> Scene:
    return replace(scene, friction_coefficient=None)


def of_given_angle(scene: Scene) -> Scene:
    return replace(scene, contact_angle=ContactAngle(rule="given", value=0.21))


def smooth(scene: Scene) -> Scene:
    correlation = Autocorrelation(kind="gaussian", length=30e-6, spacing=2e-6)
    return replace(scene, surface=Surface(rms_roughness=0.0, autocorrelation=correlation))


def of_a_map(scene: Scene) -> Scene:
    return replace(scene, surface=Surface(height_map=HeightMapFile(path="race.npy", spacing=2e-6)))


@pytest.mark.parametrize(
    ("methods", "change", "words"),
    [
        (friction_methods, without_friction, "neither friction.coefficient nor both"),
        (friction_methods, lambda scene: replace(scene, microslip="as_printed"), "as_printed"),
        (
            friction_methods,
            lambda scene: replace(scene, effects={"spin": "off", "conformity": "off"}),
            "nothing slides",
        ),
        (turning_methods, without_friction, "neither friction.coefficient nor both"),
        (turning_methods, lambda scene: replace(scene, effects={"spin": "off"}), "do not turn freely"),
        (load_methods, of_given_angle, "fixes the angle"),
        (roughness_methods, lambda scene: scene, r"no \[surface\]"),
        (roughness_methods, smooth, "smooth surface"),
        (roughness_methods, of_a_map, "measured"),
    ],
)
def test_a_scene_without_such_a_ladder_says_why(
    scene: Scene, methods: Callable[[Scene], UntimedLadder], change: Callable[[Scene], Scene], words: str
) -> None:
    with pytest.raises(InputError, match=words):
        methods(change(scene))


@pytest.mark.parametrize("change", [{"radial_load": 50.0}, {"moment": 0.4}, {"inner_speed": np.array([700.0])}])
def test_bounds_of_thrust_alone_are_no_wider_than_a_few_errors(scene: Scene, change: dict[str, Any]) -> None:
    """Stribeck's 4.37 is rounded up to 5, and what inertia does was chosen on random scenes: two to three errors."""
    ladder = measured(load_methods(replace(scene, operation=replace(scene.operation, **change))), tolerance=0.01)
    free, frozen, still, *_ = ladder.methods
    assert present(free.error) < present(free.bound) < 1.7 * present(free.error)
    for method in (frozen, still):
        assert present(method.error) < present(method.bound) < 4 * present(method.error), method.name
