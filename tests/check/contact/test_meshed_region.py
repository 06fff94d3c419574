"""What a larger block says of the far boundary: where the effect of its size is known, and on still larger blocks."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.scene import Contact
from fembearing.check.contact.meshed_region import FADING, LEFT_BY_MESHES, UNCERTAIN, boundary_effect, lands_of
from fembearing.check.contact.reference import LEAST, OF_LARGER, blocks_of, on_level, solve_reference
from fembearing.check.contact.refinement import Wanted
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.measure import Quantities
from fembearing.fem.pixel_contact import press_pair
from fembearing.fem.solution import solve_on_mesh
from fembearing.mesh import race
from fembearing.mesh.footprint import Sides
from fembearing.mesh.recipe import load_recipe
from tests.contacts import STEEL

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
    width.
    """
    recipe = load_recipe("race")
    long = replace(contacts["inner"], groove_radius=0.5026 * 2 * contacts["inner"].ball_radius, load=7.3)
    contact = long if pair == "long" else contacts[pair]
    own = on_level([contact], [expected_semi_axes(contact, geometry="real")], recipe=recipe, level=1)
    stated = blocks_of(own, recipe=recipe, left=OF_LARGER).effect(contact.load, recipe)
    axes = own.ellipses()

    def corrected(further: float) -> dict[str, float]:
        monkeypatch.setattr(race, "FURTHER", further)
        found = on_level([contact], axes, recipe=recipe, level=2, extended=further > 1).compliance.at(contact.load)
        return vars(press_pair(found, load=contact.load).quantities)

    block, near, far = (corrected(further) for further in (1.0, 2.0, 2.9))
    for name in ("semi_axis_rolling", "semi_axis_transverse", "peak_pressure"):
        beyond = (far[name] / block[name] - 1) / (1 - 2.9**-FADING)
        # a tenth of the least uncertainty of a quantity: the long ellipse has almost no far boundary
        assert abs(beyond - stated[name].beyond) < stated[name].domain + LEAST / 10 < 5e-4, name
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
    """What the lands of half of the contact add to the effect of the larger block; no mean of two quarters.

    Without lands the effect is that of the compliance; plain meshes show what lands add. The level is the finest on
    which no cell of that half is inside out.
    """
    contact, recipe = steep(pair, size=size), load_recipe("race")
    found = solve_reference(contact, Wanted(recipe, accuracy=2e-3)).estimates["approach"]
    axes = expected_semi_axes(contact, geometry="real")
    sides: tuple[Sides, ...] = ("even", "both")
    even, both = (
        [
            solve_on_mesh(contact, recipe=recipe, level=level, semi_axes=axes, extended=extended, sides=side)
            for extended in (False, True)
        ]
        for side in sides
    )
    changes = [larger.quantities.approach / block.quantities.approach for block, larger in (even, both)]
    block, larger = (
        on_level([contact], [axes], recipe=recipe, level=level, extended=extended, sides="even").compliance
        for extended in (False, True)
    )
    approaches = [press_pair(each.at(contact.load), load=contact.load).quantities.approach for each in (block, larger)]
    lands = changes[1] / changes[0]
    assert abs(lands - 1) > 2e-4  # they count
    assert abs(approaches[1] / approaches[0] * lands - 1 - found.beyond) < found.domain < 1e-3


def test_without_a_land_that_is_too_steep_the_approach_is_less_certain() -> None:
    """A land 0.45 rad beyond a large contact at 40 degrees: cells under it turn inside out."""
    contact, recipe = steep("inner", size=0.36), load_recipe("race")
    axes = expected_semi_axes(contact, geometry="real")
    assert not solve_on_mesh(contact, recipe=recipe, level=1, semi_axes=axes, extended=True).bodies.has_lands
    found = solve_reference(contact, Wanted(recipe, accuracy=0.02)).estimates
    even = solve_reference(replace(contact, contact_angle=0.0), Wanted(recipe, accuracy=0.02)).estimates
    assert found["approach"].domain >= lands_of(contact) > 1e-3
    assert found["peak_pressure"].domain < 1e-3
    for name in ("approach", "peak_pressure"):  # the lands are all that differs
        assert abs(found[name].value / even[name].value - 1) < found[name].total + 1e-3, name
