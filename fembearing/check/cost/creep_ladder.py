"""The ladder of friction in the contacts: the formula, marched creep, and rolling contact of half spaces."""

import numpy as np

from analytic.scene import Array, Scene
from analytic.solve.solution import points_of, solved
from fembearing.check.cost.ladder import UntimedLadder, UntimedMethod
from fembearing.check.creep.production import models_of, produced
from fembearing.check.creep.scene_creep import reference_torque, scene_at_heaviest

FINEST = 0.02  # least uncertainty that is asked of the reference


def creep_methods(scene: Scene) -> UntimedLadder:
    """Torque by sliding of all balls at the operating point of the heaviest one. Raises InputError as `creep_of`."""
    given, _ = scene_at_heaviest(scene)
    production = produced(given)
    ruled, free = models_of(given)
    points = points_of(given.operation, free.temperature)
    tolerance, uncertainty = max(scene.tolerance, FINEST), [np.inf]

    def by_reference() -> Array:
        torque, error, _ = reference_torque(production, tolerance=tolerance)
        uncertainty[0] = error / torque
        return np.array([torque])

    return UntimedLadder(
        quantity="sliding in the contacts",
        reference="stick and slip on half spaces; all balls at the operating point of the heaviest one",
        methods=(
            UntimedMethod(
                name="formula, closed kinematics",
                run=lambda: solved(ruled, points).sliding_torque,
                bound=lambda: np.inf,
            ),
            UntimedMethod(
                name="free balls, marched creep", run=lambda: solved(free, points).sliding_torque, bound=lambda: np.inf
            ),
            UntimedMethod(name="stick and slip", run=by_reference, bound=lambda: uncertainty[0], may_refer=True),
        ),
    )
