"""Balls of production: which differ, what holds them, and marched creep against sliding in the limit of no creep."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scene import Scene
from fembearing.check.creep.production import by_formula, by_march, models_of, produced
from tests.check.creep.test_scene_creep import THRUST, UNEQUAL, scene_of


@pytest.fixture(scope="module")
def scene() -> Scene:
    return scene_of(THRUST)


@pytest.mark.parametrize("off", ["spin", "conformity"])
def test_a_slip_without_one_of_its_parts_is_refused(scene: Scene, off: str) -> None:
    with pytest.raises(InputError, match=rf'effects\.{off} = "off" neglects a part of the slip: use "auto"'):
        models_of(replace(scene, effects={off: "off"}))


@pytest.mark.parametrize("operation", [THRUST, UNEQUAL.format(-3)])
def test_with_little_friction_all_slides_and_the_march_is_the_formula(operation: str) -> None:
    production = produced(scene_of(operation, friction="coefficient = 2e-4"))
    for marched, formula in zip(by_march(production), by_formula(production), strict=True):
        assert marched.slip_share > 0.99
        for name in ("spin_creepage", "spin_moment", "rolling_moment", "torque"):
            # A long ellipse instead of one that is nine times as long as wide. It lacks the turn by conformity, which
            # matters the more to the moment of rolling the less spin leaves of it.
            loose = {"rolling_moment": 0.25, "torque": 0.1}.get(name, 0.08)
            np.testing.assert_allclose(getattr(marched, name), getattr(formula, name), rtol=loose, err_msg=name)
        # Against slip by spin and conformity at the ends of the contact, which is about 1e-2.
        np.testing.assert_allclose(marched.creepage_along, formula.creepage_along, atol=3e-4)
        push = 2e-4 * production.heaviest[0]["load"].max()
        assert abs(marched.transverse_force) < 0.3 * push
        assert abs(marched.creepage_across) < 3e-4


def test_with_much_friction_nearly_all_sticks() -> None:
    production = produced(scene_of(THRUST, friction="coefficient = 1.5"))
    for found in by_march(production):
        assert 0 < found.slip_share < 0.4
