"""What a larger block says of the far boundary, on quantities whose dependence on the size is known."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from fembearing.compare.contact.meshed_region import FADING, LEFT_BY_MESHES, UNCERTAIN, boundary_effect
from fembearing.fem.measure import Quantities

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
