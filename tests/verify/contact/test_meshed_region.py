"""What a larger block says of the far boundary: where the effect of its size is known, and on still larger blocks."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scene import Contact
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.measure import Quantities
from fembearing.fem.solution import solve_on_mesh
from fembearing.fem.twin import TwinSolution, twin_factors, twin_on_level
from fembearing.mesh import race
from fembearing.mesh.recipe import load_recipe
from fembearing.progress import silent
from fembearing.verify.contact import meshed_region
from fembearing.verify.contact.meshed_region import (
    FADING,
    Boundary,
    boundary_effect,
    boundary_effect_with_twin,
    sides_farther,
    with_effect_of_sides,
)
from fembearing.verify.contact.reference import solve_reference
from fembearing.verify.contact.uncertainty import (
    LEFT_BY_MESHES,
    LEFT_BY_TWIN,
    LEFT_WITH_TWIN,
    SIDES_COARSE,
    SIDES_LEFT,
    SIDES_LEFT_IN_OTHERS,
    STEEP,
    STIFFNESS,
    UNCERTAIN,
)
from tests.contacts import INNER, STEEL

ENDLESS = Quantities(
    semi_axis_rolling=0.12e-3, semi_axis_transverse=0.7e-3, peak_pressure=2.1e9, approach=6.2e-6, stiffness=2.4e10
)


def block(size: float) -> Any:
    """Semi-axes and pressure have a limit, which they near with the assumed power; approach and stiffness have none."""
    left = 3e-3 * size**-FADING
    quantities = Quantities(
        semi_axis_rolling=ENDLESS.semi_axis_rolling * (1 - left),
        semi_axis_transverse=ENDLESS.semi_axis_transverse * (1 + 2 * left),
        peak_pressure=ENDLESS.peak_pressure * (1 - 3 * left),
        approach=ENDLESS.approach * (1 - 2e-3 * np.log(size)),
        stiffness=ENDLESS.stiffness * (1 + 3e-3 * np.log(size)),
    )
    mesh = SimpleNamespace(doflocs=np.array([[0.0, size], [0.3, 0.0]]))
    return SimpleNamespace(quantities=quantities, shoulder=None, pair=SimpleNamespace(lower=SimpleNamespace(mesh=mesh)))


@pytest.mark.parametrize(("size", "further"), [(2.5, 5.0), (3.0, 4.6)])
def test_semi_axes_and_pressure_are_those_of_an_endless_block(size: float, further: float) -> None:
    near = block(size)
    effects = boundary_effect(near, block(further))
    for name in ("semi_axis_rolling", "semi_axis_transverse", "peak_pressure"):
        value = getattr(near.quantities, name) * (1 + effects[name].beyond)
        assert value == pytest.approx(getattr(ENDLESS, name), rel=1e-9)  # round-off
        assert effects[name].domain == pytest.approx(UNCERTAIN * abs(effects[name].beyond), rel=1e-12)


@pytest.mark.parametrize(("size", "further"), [(2.5, 5.0), (3.0, 4.6)])
def test_the_approach_is_that_of_the_larger_block(size: float, further: float) -> None:
    near, far = block(size), block(further)
    effects = boundary_effect(near, far)
    for name in ("approach", "stiffness"):
        value = getattr(near.quantities, name) * (1 + effects[name].beyond)
        assert value == pytest.approx(getattr(far.quantities, name), rel=1e-12)  # round-off
        assert effects[name].domain == pytest.approx(LEFT_BY_MESHES * abs(effects[name].beyond), rel=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("pair", ["outer", "long"])
def test_the_first_level_predicts_larger_blocks_on_the_second(
    contacts: dict[str, Contact], monkeypatch: pytest.MonkeyPatch, pair: str
) -> None:
    """A block 2.9 times as large for semi-axes and pressure, to their limit; the one twice as large for the approach.

    On the outer race the approach has no limit: the largest block changes it again. The long ellipse has 33 times its
    width, where the first level is off by what the twins do not correct.
    """
    recipe = load_recipe("race")
    long = replace(contacts["inner"], groove_radius=0.5026 * 2 * contacts["inner"].ball_radius, load=7.3)
    contact = long if pair == "long" else contacts[pair]
    coarse = twin_on_level(contact, recipe=recipe, level=1, start=expected_semi_axes(contact, geometry="real"))
    assert coarse is not None
    stated = boundary_effect_with_twin(coarse, recipe=recipe)

    def corrected(further: float) -> dict[str, float]:
        monkeypatch.setattr(race, "FURTHER", further)
        extended = further > 1
        mesh = solve_on_mesh(contact, recipe=recipe, level=2, semi_axes=coarse.ellipse, extended=extended)
        return TwinSolution(mesh=mesh, factors=twin_factors(mesh, recipe=recipe, extended=extended)).corrected

    block, near, far = (corrected(further) for further in (1.0, 2.0, 2.9))
    for name in ("semi_axis_rolling", "semi_axis_transverse", "peak_pressure"):
        beyond = (far[name] / block[name] - 1) / (1 - 2.9**-FADING)
        assert abs(beyond - stated[name].beyond) < stated[name].domain < 5e-4, name
    approach = stated["approach"]
    assert abs(near["approach"] / block["approach"] - 1 - approach.beyond) < approach.domain < 5e-4
    assert pair != "outer" or abs(far["approach"] / near["approach"] - 1) > abs(approach.beyond) / 4


def steep(pair: str, *, size: float) -> Contact:
    """A steel contact at 40 degrees, with a semi-axis of `size` ball radii and lands 0.45 rad beyond it."""
    angle, radius = 0.698, 3.97e-3
    inner = pair == "inner"
    groove = 2 * radius * (0.52 if inner else 0.53)
    ring = 19.5e-3 / np.cos(angle)
    contact = Contact(
        pair="inner" if inner else "outer",
        ball_radius=radius,
        groove_radius=groove,
        rolling_radius=ring - radius if inner else -ring - radius,
        shoulder=groove * np.sin(np.arcsin(size * radius / groove) + 0.45),
        far_shoulder=groove * np.sin(angle + 0.5),
        contact_angle=angle,
        load=100.0,
        ball_material=STEEL,
        race_material=STEEL,
    )
    for _ in range(9):  # the ellipse grows a little slower than the cube root of the load
        across = expected_semi_axes(contact, geometry="real")[1]
        contact = replace(contact, load=contact.load * (size * radius / across) ** 3)
    return contact


@pytest.mark.parametrize(
    ("pair", "size", "level"),
    [
        pytest.param("outer", 0.25, 2, marks=pytest.mark.nightly),
        pytest.param("inner", 0.2, 1, marks=pytest.mark.slow),
    ],
)
def test_at_forty_degrees_the_approach_has_its_lands_up_to_the_larger_block(pair: str, size: float, level: int) -> None:
    """Half of the contact with both lands on the larger block, over the quarter on the block; no sum of two quarters.

    The level is the finest on which no cell of that half is inside out.
    """
    contact, recipe = steep(pair, size=size), load_recipe("race")
    found = solve_reference(contact, recipe=recipe, accuracy=2e-3, progress=silent).estimates["approach"]
    axes = expected_semi_axes(contact, geometry="real")
    quarter = solve_on_mesh(contact, recipe=recipe, level=level, semi_axes=axes)
    half = solve_on_mesh(contact, recipe=recipe, level=level, semi_axes=axes, extended=True, sides="both")
    change = half.quantities.approach / quarter.quantities.approach
    assert abs(found.sides) > 4e-4  # the lands count
    assert abs((1 + found.beyond) * (1 + found.sides) / change - 1) < found.domain < 1e-3


def test_lands_too_steep_for_the_larger_block_widen_the_interval(monkeypatch: pytest.MonkeyPatch) -> None:
    """The approach by the sine of the angle and the stiffness by its power; the pressure is that of the block."""
    contact = steep("outer", size=0.2)

    def refused_with_sides(*_: Any, sides: str = "even", **__: Any) -> Any:
        if sides != "even":
            raise InputError("inside out")
        return SimpleNamespace(upper=None, quantities=ENDLESS)

    monkeypatch.setattr(meshed_region, "solve_on_mesh", refused_with_sides)
    assert sides_farther(contact, recipe=load_recipe("race"), level=1, semi_axes=(1e-4, 8e-4)) is None
    boundary = dict.fromkeys(vars(ENDLESS), Boundary(domain=1e-4))
    sides = dict.fromkeys(vars(ENDLESS), 2e-4)
    known, unknown = (
        with_effect_of_sides(boundary, sides, contact, transverse=8e-4, farther=farther) for farther in (0.0, None)
    )
    wider = {name: unknown[name].domain - known[name].domain for name in known}
    for name, power in (("approach", 1.0), ("stiffness", STIFFNESS)):
        square = (power * SIDES_LEFT["approach"] * 2e-4) ** 2
        land = power * STEEP * np.sin(0.698)
        assert wider[name] == pytest.approx(np.sqrt(square + land**2) - np.sqrt(square), rel=1e-9)
    assert wider["peak_pressure"] == pytest.approx(0, abs=1e-15)


def solved(**values: float) -> Any:
    """A mesh with these in place of the endless block's."""
    pair = SimpleNamespace(semi_axes=(0.12e-3, 0.7e-3))
    return SimpleNamespace(quantities=replace(ENDLESS, **values), shoulder=None, pair=pair, contact=CONTACT, level=2)


CONTACT = replace(INNER, rolling_radius=15.6e-3, shoulder=3.1e-3, far_shoulder=2.4e-3, contact_angle=0.31)


def test_both_sides_give_the_mean_of_their_quarters() -> None:
    """The approach by 0.2 % and 0.1 % more, the pressure by 0.06 % less and 0.02 % more."""
    above = solved(approach=1.002 * ENDLESS.approach, peak_pressure=0.9994 * ENDLESS.peak_pressure)
    below = solved(approach=1.001 * ENDLESS.approach, peak_pressure=1.0002 * ENDLESS.peak_pressure)
    boundary = dict.fromkeys(vars(ENDLESS), Boundary(beyond=0.03, domain=1e-4))
    found = meshed_region.with_sides(boundary, solved(), above, below, farther=0.0)
    expected = {"approach": 1.5e-3, "peak_pressure": -2e-4, "semi_axis_rolling": 0.0}
    for name, share in expected.items():
        assert found[name].sides == pytest.approx(share, abs=1e-12), name  # round-off
        assert found[name].beyond == 0.03
    # The meshes leave a share of the largest of these effects, that on the approach, and the cells (b/r)^2 of theirs.
    coarse = SIDES_COARSE * (0.7 / 3.97) ** 2
    for name, left in (("approach", SIDES_LEFT["approach"]), ("stiffness", SIDES_LEFT_IN_OTHERS)):
        assert found[name].domain == pytest.approx(1e-4 + left * 1.5e-3 + coarse, rel=1e-9), name


def test_lands_on_the_larger_block_move_the_approach_and_the_stiffness_by_its_power() -> None:
    boundary, sides = dict.fromkeys(vars(ENDLESS), Boundary(domain=1e-4)), dict.fromkeys(vars(ENDLESS), 2e-4)
    how: Any = {"transverse": 7e-4, "farther": -3e-3}
    found, less = (with_effect_of_sides(boundary, sides, CONTACT, **how, left=left) for left in (0.25, 0.125))
    assert found["approach"].sides == pytest.approx(1.0002 * 0.997 - 1, rel=1e-9)  # round-off
    assert found["stiffness"].sides == pytest.approx(1.0002 * 0.997**-1.5 - 1, rel=1e-9)
    assert found["peak_pressure"].sides == pytest.approx(2e-4, rel=1e-9)
    coarse = 1e-4 + SIDES_COARSE * (0.7 / 3.97) ** 2
    for part, left in ((found, 0.25), (less, 0.125)):
        lands = np.hypot(SIDES_LEFT["approach"] * 2e-4, left * 3e-3)
        assert part["approach"].domain == pytest.approx(coarse + lands, rel=1e-9)


def test_the_true_sides_change_the_larger_block_more(monkeypatch: pytest.MonkeyPatch) -> None:
    """Even sides 6 and 6.3 um; true ones 6.1 and 6.2, on the larger block 6.5 and 6.9: 6.7/6.3 over 6.15/6."""
    approaches = {"even": (6.0, 6.3), "above": (6.1, 6.5), "below": (6.2, 6.9)}

    def solve(*_: Any, sides: str = "even", extended: bool = False, **__: Any) -> Any:
        return SimpleNamespace(upper="ball", quantities=SimpleNamespace(approach=1e-6 * approaches[sides][extended]))

    monkeypatch.setattr(meshed_region, "solve_on_mesh", solve)
    found = sides_farther(CONTACT, recipe=load_recipe("race"), level=1, semi_axes=(1e-4, 8e-4))
    assert found == pytest.approx((6.7 / 6.3) / (6.15 / 6.0) - 1, rel=1e-9)  # round-off


def test_a_block_has_a_far_boundary_and_half_spaces_and_sheets_have_none(monkeypatch: pytest.MonkeyPatch) -> None:
    for geometry, far, bounded in (("real", 5, True), ("wall", 5, True), ("wall", 0, False), ("hertzian", 5, False)):
        recipe: Any = replace(load_recipe("race"), geometry=geometry)
        mesh: Any = SimpleNamespace(pair=SimpleNamespace(lower=SimpleNamespace(far=np.zeros(far))))
        assert meshed_region.has_boundary(mesh, recipe=recipe) == bounded
    near, larger = block(2.5), block(5.0)
    monkeypatch.setattr(meshed_region, "_larger", lambda *_, **__: larger)
    for bounded in (True, False):
        monkeypatch.setattr(meshed_region, "has_boundary", lambda *_, bounded=bounded, **__: bounded)
        found = meshed_region.far_boundary(near, recipe=load_recipe("race"))
        assert found == (boundary_effect(near, larger) if bounded else dict.fromkeys(vars(ENDLESS), Boundary()))


def test_a_twin_of_both_blocks_leaves_a_share_of_what_it_corrects(monkeypatch: pytest.MonkeyPatch) -> None:
    """Twins correct the approach of the block by 1 % and of the larger one by 1.2 %: so much less is beyond it."""
    near, larger = block(2.5), block(5.0)
    corrected = {"approach": 0.988 * larger.quantities.approach}
    monkeypatch.setattr(meshed_region, "_larger", lambda *_, **__: larger)
    monkeypatch.setattr(meshed_region, "twin_factors", lambda *_, **__: None)
    monkeypatch.setattr(meshed_region, "TwinSolution", lambda **_: SimpleNamespace(corrected=corrected))
    solution: Any = SimpleNamespace(mesh=near, corrected={"approach": 0.99 * near.quantities.approach})
    found = boundary_effect_with_twin(solution, recipe=load_recipe("race"))["approach"]
    plain = larger.quantities.approach / near.quantities.approach - 1
    own = (1 + plain) * 0.988 / 0.99 - 1
    assert found.beyond == pytest.approx(own, rel=1e-9)
    assert found.domain == pytest.approx(LEFT_WITH_TWIN * abs(own) + LEFT_BY_TWIN * abs(own - plain), rel=1e-9)


def test_an_effect_of_a_quantity_that_is_0_is_none() -> None:
    assert meshed_region.changes({"centroid": 0.0, "load": 4.0}, {"centroid": 3.0, "load": 5.0}) == {
        "centroid": 0.0,
        "load": 0.25,
    }
