"""The count of scenes whose stated uncertainty does not hold sees a wrong statement."""

from dataclasses import replace

from analytic.result import FrictionTorque
from analytic.scene import Scene
from analytic.torque import friction_torque
from validation.promises.run import is_broken, judged, summary

SEED = 880170  # one operating point, free of chance: any that is not refused would do


def test_a_torque_outside_its_uncertainty_is_counted() -> None:
    """A solver whose torque depends on the tolerance by 1 %, and that states a thousandth of that."""

    def boasting(scene: Scene) -> FrictionTorque:
        honest = friction_torque(replace(scene, tolerance=0.01))
        factor = 1.01 if scene.tolerance == 0.01 else 1.0
        torque = replace(honest.torque, total=factor * honest.torque.total)
        return replace(honest, torque=torque, numerical_uncertainty=0.0 * honest.torque.total + 5e-6)

    def honest(scene: Scene) -> FrictionTorque:
        return friction_torque(replace(scene, tolerance=0.01))

    outside, inside = judged(SEED, boasting), judged(SEED, honest)
    assert 900 < outside.ratio < 1100  # 1 % over 5e-6 of both
    assert inside.ratio == 0
    assert is_broken([outside])
    assert not is_broken([inside])
    assert is_broken([inside, replace(inside, unsettled="did not converge")])
    assert any(str(SEED) in line and "ratio" in line for line in summary([outside, inside]))
