"""The parts of the torque of a scene by the kernel alone: the numbers of the series, or no answer at all."""

from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from analytic import friction_torque, load_scene
from analytic.function import AT_REST
from analytic.oil.variation import Variation
from analytic.prediction.first_order import first_order_ends
from analytic.prediction.formulas import with_model_uncertainty
from analytic.prediction.settled import level_of, settled_parts
from analytic.result import TorqueParts
from analytic.scene import Arrangement, Losses, Operation, Scene
from tests.analytic.specimens import present

SCENES = Path(__file__).parents[3] / "validation" / "scenes"
ROUND_OFF = 1e-11  # the ring settles to 1e-12 of its load
OTHER = Variation(film=0.83, rolling=1.21, asperity_pressure=1.7)
SPEED, AXIAL = np.array([14.0, 0.0, -880.0]), np.array([380.0, 700.0, 910.0])  # one stands, in one inertia counts


def settled(name: str, effects: dict[str, Any] | None = None, **changed: Any) -> Scene:
    """With a tolerance that every level of nodes meets, so that the series takes no finer one."""
    scene = load_scene(SCENES / f"{name}.toml" if (SCENES / f"{name}.toml").exists() else name)
    return replace(scene, **{"tolerance": 0.3, "effects": {**AT_REST, **(effects or {})}, **changed})


def require_the_series(scene: Scene) -> None:
    own = present(settled_parts(scene, OTHER, level_of(scene)))
    series = friction_torque(scene, variation=OTHER).torque
    for name in (each.name for each in fields(TorqueParts)):
        mine, its = getattr(own, name), getattr(series, name)
        assert (mine is None) == (its is None), name
        if its is not None:
            close = ROUND_OFF if scene.spin_rule != "free" else 1e-4  # free balls settle to 5e-5 at a tolerance of 5 %
            np.testing.assert_allclose(mine, its, rtol=close, atol=close * series.total.max(), err_msg=name)


@pytest.mark.parametrize("radial", [0.0, 430.0])
@pytest.mark.parametrize("rule", ["balanced", "free"])
@pytest.mark.parametrize("name", ["6205-dry", "paper_6205", "6205_physical"])
def test_every_part_is_that_of_the_series(name: str, rule: Any, radial: float) -> None:
    loads = Operation(axial_load=AXIAL, inner_speed=SPEED, radial_load=np.full(3, radial))
    require_the_series(settled(name, spin_rule=rule, operation=loads, losses=Losses(seals=3e-3)))


@pytest.mark.parametrize("left_out", ["hysteresis", "rolling", "spin", "asperities", "finite_geometry", "creep"])
def test_what_is_off_stays_off(left_out: str) -> None:
    require_the_series(settled("6205_physical", effects={left_out: "off"}))


def test_one_level_serves_every_sample() -> None:
    """The level is that of the point that needs the finest; a scene with a finer tolerance has a finer one."""
    scene = settled("6205_physical")
    assert level_of(replace(scene, tolerance=1e-4)) > level_of(scene) == 1


def test_what_only_the_series_computes_has_no_answer() -> None:
    scene = settled("6205_physical")
    far = Operation(axial_load=np.array([300.0, 9e6]), inner_speed=np.array([40.0, 40.0]))
    assert settled_parts(replace(scene, operation=far), OTHER, 0) is None  # off its race
    assert settled_parts(replace(scene, arrangement=Arrangement(kind="tandem", distance=0.02)), OTHER, 0) is None


def test_a_squeezed_cage_has_an_interval_by_the_series() -> None:
    """Balls that lead farther than the pockets leave free: the kernel has no torque of such a cage."""
    scene = load_scene("6205-dry", radial_load="700 N", axial_load="300 N", speed="900 rpm")
    assert scene.cage is not None
    tight = replace(scene, cage=replace(scene.cage, pocket_diameter=7.96e-3, pocket_depth=3.975e-3))
    assert settled_parts(tight, OTHER, 0) is None
    nominal = friction_torque(tight)
    assert nominal.cage is not None
    assert nominal.cage.is_squeezed.all()
    ends = first_order_ends(tight, nominal)
    assert ends is not None
    assert np.all((ends[0] < 0.99 * nominal.torque.total) & (nominal.torque.total < ends[1] / 1.01))
    assert np.all(present(with_model_uncertainty(tight, nominal).model_uncertainty) > 0)
