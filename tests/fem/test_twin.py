"""The twin of a contact against the exact half spaces, against scale, and against finer meshes."""

import time
from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.scene import Contact, Material
from fembearing.fem import twin
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.half_space import contact_modulus, hertz_ellipse
from fembearing.fem.measure import Quantities
from fembearing.fem.solution import solve_on_mesh
from fembearing.fem.twin import shared_axes, twin_factors, twin_on_level
from fembearing.mesh.footprint import Footprint
from fembearing.mesh.half_space import flat_block
from fembearing.mesh.recipe import load_recipe
from tests.contacts import PEEK

RECIPE = load_recipe("race")
NAMES = ("semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach")


def scaled(contact: Contact, *, length: float, modulus: float) -> Contact:
    """The same shape in another size and another stiffness: pressures as `modulus`."""

    def stiffer(material: Material) -> Material:
        return replace(material, youngs_modulus=modulus * material.youngs_modulus)

    lengths = ("ball_radius", "groove_radius", "rolling_radius", "shoulder", "far_shoulder")
    return replace(
        contact,
        **{name: length * getattr(contact, name) for name in lengths},
        load=modulus * length**2 * contact.load,
        ball_material=stiffer(contact.ball_material),
        race_material=stiffer(contact.race_material),
    )


def test_a_nearly_flat_contact_needs_no_more_than_its_twin(contacts: dict[str, Contact]) -> None:
    """At 1e-3 N the bodies are half spaces: corrected quantities are Hertz's, which a mesh alone misses by 0.3 %."""
    contact = replace(contacts["outer"], load=1e-3, groove_radius=4.9e-3)
    modulus = contact_modulus(contact)
    curvatures = 1 / contact.ball_radius + 1 / contact.rolling_radius, 1 / contact.ball_radius - 1 / 4.9e-3
    a, b = hertz_ellipse(curvatures, load=1e-3, modulus=modulus)
    found = twin_on_level(contact, recipe=RECIPE, level=2, start=expected_semi_axes(contact, geometry="real"))
    assert found is not None
    exact = {"semi_axis_rolling": a, "semi_axis_transverse": b, "peak_pressure": 3e-3 / (2 * np.pi * a * b)}
    for name, value in exact.items():
        # 0.01 %: a hundredth of the error of this level. On the cells of a block the twin of the ball leaves 0.07 %.
        assert found.corrected[name] == pytest.approx(value, rel=1e-4), name


def test_the_twin_does_not_depend_on_size_and_stiffness(contacts: dict[str, Contact]) -> None:
    """A contact 3 times as large and 0.7 times as stiff meets the same half spaces, solved once."""
    contact = contacts["inner"]
    other = scaled(contact, length=3.1, modulus=0.7)
    twin._condensed.cache_clear()
    first, second = (
        twin_on_level(each, recipe=RECIPE, level=1, start=expected_semi_axes(each, geometry="real"))
        for each in (contact, other)
    )
    assert first is not None
    assert second is not None
    assert twin._condensed.cache_info().misses == 2  # the ball's and the race's half space
    for name, value in vars(first.factors).items():
        assert getattr(second.factors, name) == pytest.approx(value, rel=1e-9), name  # round-off


def test_a_mesh_with_a_twin_has_one_of_few_axis_ratios() -> None:
    for semi_axes in ((0.11e-3, 0.93e-3), (0.31e-3, 0.31e-3), (0.9e-3, 0.2e-3)):
        rolling, transverse = shared_axes(semi_axes)
        steps = np.log(transverse / rolling) / twin.STEP
        assert steps == pytest.approx(round(steps), abs=1e-9)
        assert rolling * transverse == pytest.approx(semi_axes[0] * semi_axes[1], rel=1e-12)
        np.testing.assert_allclose((rolling, transverse), semi_axes, rtol=twin.STEP / 4 * 1.01)


@pytest.mark.parametrize("pair", ["inner", "outer"])
def test_two_corrected_levels_agree_far_better_than_two_plain_ones(contacts: dict[str, Contact], pair: str) -> None:
    contact = replace(contacts[pair], race_material=PEEK, load=20.0)
    ellipse, solutions = expected_semi_axes(contact, geometry="real"), []
    for level in (1, 2):
        begun = time.perf_counter()
        found = twin_on_level(contact, recipe=RECIPE, level=level, start=ellipse)
        assert found is not None
        assert 0 < found.mesh.seconds < time.perf_counter() - begun
        solutions.append(found)
        ellipse = found.ellipse
    coarse, fine = solutions
    plain = max(abs(getattr(coarse.mesh.quantities, name) / getattr(fine.mesh.quantities, name) - 1) for name in NAMES)
    corrected = max(abs(coarse.corrected[name] / fine.corrected[name] - 1) for name in NAMES)
    assert corrected < plain / 4  # seven and more on the calibration contacts


@pytest.mark.parametrize("pair", ["inner", "outer"])
def test_a_twin_on_the_cells_of_a_plain_block_is_told_by_its_levels(
    contacts: dict[str, Contact], pair: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With other columns and layers than the ball's the corrected levels differ several times as much."""
    contact = replace(contacts[pair], load=372.0)
    axes = shared_axes(expected_semi_axes(contact, geometry="real"))
    meshes = [solve_on_mesh(contact, recipe=RECIPE, level=level, semi_axes=axes) for level in (1, 2)]

    def change(name: str) -> float:
        coarse, fine = (
            getattr(mesh.quantities, name) * getattr(twin_factors(mesh, recipe=RECIPE), name) for mesh in meshes
        )
        return abs(coarse / fine - 1)

    own = {name: change(name) for name in ("semi_axis_rolling", "approach")}
    monkeypatch.setattr(twin, "flat_ball", lambda block: flat_block(block, Footprint(semi_axes=block.semi_axes)))
    assert change("semi_axis_rolling") > 5 * own["semi_axis_rolling"]
    assert change("approach") > 2 * own["approach"]


def test_a_twin_follows_an_extended_block(contacts: dict[str, Contact]) -> None:
    """Added cells change the error of the mesh: without their own twin they would seem to change a tiny contact."""
    contact = replace(contacts["inner"], load=1e-3)
    axes = shared_axes(expected_semi_axes(contact, geometry="real"))
    base, larger = (
        solve_on_mesh(contact, recipe=RECIPE, level=1, semi_axes=axes, extended=far) for far in (False, True)
    )
    own = twin_factors(base, recipe=RECIPE), twin_factors(larger, recipe=RECIPE, extended=True)
    approaches = base.quantities.approach, larger.quantities.approach
    plain = approaches[1] / approaches[0] - 1
    corrected = (1 + plain) * own[1].approach / own[0].approach - 1
    assert abs(plain) > 2e-4
    assert abs(corrected) < abs(plain) / 3  # half spaces have no far boundary to speak of


def test_a_contact_over_its_shoulder_has_no_twin(contacts: dict[str, Contact]) -> None:
    narrow = replace(contacts["inner"], shoulder=0.8e-3)
    assert twin_on_level(narrow, recipe=RECIPE, level=1, start=expected_semi_axes(narrow, geometry="real")) is None


@dataclass(frozen=True)
class Measured:
    """A contact on a mesh, with the parts that are looked at."""

    semi_axes: tuple[float, float]
    seconds: float = 0.0

    @property
    def pair(self) -> Any:
        return SimpleNamespace(footprint=SimpleNamespace(cut=False))

    @property
    def quantities(self) -> Quantities:
        return quantities(*self.semi_axes)


def quantities(rolling: float, transverse: float) -> Quantities:
    rest = {"peak_pressure": 1.9e9, "approach": 7e-6, "stiffness": 1.1e10}
    return Quantities(semi_axis_rolling=rolling, semi_axis_transverse=transverse, **rest)


@pytest.fixture
def meshes(monkeypatch: pytest.MonkeyPatch) -> Any:
    """What a mesh for an ellipse measures across, and what its twin makes of it, over that ellipse; and the meshes."""
    told = SimpleNamespace(measured=1.0, corrected=1.0, made=[])

    def solved(*_: Any, semi_axes: tuple[float, float], **__: Any) -> Measured:
        told.made.append(semi_axes)
        return Measured((semi_axes[0], told.measured * semi_axes[1]))

    monkeypatch.setattr(twin, "solve_on_mesh", solved)
    monkeypatch.setattr(twin, "twin_factors", lambda *_, **__: quantities(1.0, told.corrected / told.measured))
    monkeypatch.setattr(twin, "solver_threads", lambda: 1)
    return told


@pytest.mark.parametrize(("level", "near", "far"), [(1, 0.09, 0.11), (2, 0.015, 0.025), (3, -0.015, -0.025)])
def test_an_ellipse_far_from_its_mesh_gets_another_one(
    contacts: dict[str, Contact], meshes: Any, level: int, near: float, far: float
) -> None:
    """A tenth on the first level, a fiftieth on finer ones; the next mesh is that of the corrected ellipse."""
    start = 0.1e-3, 0.9e-3
    meshes.corrected = 1 + near
    assert twin_on_level(contacts["inner"], recipe=RECIPE, level=level, start=start) is not None
    assert len(meshes.made) == 1
    meshes.made.clear()
    meshes.corrected = 1 + far
    assert twin_on_level(contacts["inner"], recipe=RECIPE, level=level, start=start) is None  # it never settles
    assert len(meshes.made) == twin.MOST_GUESSES
    # axis ratios have steps of 1 %
    assert meshes.made[1][1] / meshes.made[0][1] == pytest.approx(1 + far, rel=0.011)


@pytest.mark.parametrize(("measured", "told"), [(1.29, True), (1.31, False), (0.71, True), (0.69, False)])
def test_an_ellipse_that_its_mesh_does_not_hold_has_no_twin(
    contacts: dict[str, Contact], meshes: Any, measured: float, told: bool
) -> None:
    meshes.measured = measured
    found = twin_on_level(contacts["inner"], recipe=RECIPE, level=2, start=(0.1e-3, 0.9e-3))
    assert (found is not None) == told
