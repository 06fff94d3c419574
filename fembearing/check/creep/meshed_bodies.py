"""Ball and race of true shape in rolling contact: half spaces, and what finite elements add to them."""

from dataclasses import dataclass, replace

import numpy as np

from analytic.contact.geometry import RACES, race_contact
from analytic.scene import Array, Scene
from fembearing.check.creep.production import ProducedBall
from fembearing.creep.ball import Elasticity, TurningBall
from fembearing.creep.half_space import HalfSpaces
from fembearing.creep.strips import Strips
from fembearing.fem.compliance import PairCompliance, meshed_pair
from fembearing.fem.traction import ACROSS, ALONG, NORMAL, Axis

CENTRE = 1e-3  # semi-axes: where the displacement along rolling is still linear


@dataclass(frozen=True, kw_only=True)
class MeshedBodies:
    """Half spaces with what the true shapes of ball and race add; see `fembearing.creep.half_space.Influence`.

    Shapes are their own mirror images along and across, so that either direction of rolling has the same addition. The
    stretch along rolling that pressure causes in the centre is left out all over: it changes the radius on which the
    ball rolls, as the approach does, and not its friction.
    """

    half_spaces: HalfSpaces
    compliance: PairCompliance

    def by_traction(self, strips: Strips, x: Array, y: Array) -> Array:
        """As `Influence` has it."""
        influence = self.half_spaces.by_traction(strips, x, y)
        for moves in (ALONG, ACROSS):
            for by in (ALONG, ACROSS):
                added = self.compliance.added_influence((x, y), _middles(strips), moves=moves, by=by)
                influence[moves, by] += added * strips.area.ravel()
        return influence

    def by_pressure(self, strips: Strips, pressure: Array, x: Array, y: Array) -> Array:
        """As `Influence` has it."""
        force, (a, _) = (pressure * strips.area).ravel(), self.compliance.semi_axes

        def added(x: Array, y: Array, moves: Axis) -> Array:
            return self.compliance.added_influence((x, y), _middles(strips), moves=moves, by=NORMAL) @ force

        near = CENTRE * a
        behind, ahead = added(np.array([-near, near]), np.zeros(2), ALONG)
        stretch = (ahead - behind) / (2 * near)
        moved = self.half_spaces.by_pressure(strips, pressure, x, y)
        return moved + np.array([added(x, y, ALONG) - stretch * x, added(x, y, ACROSS)])


def _middles(strips: Strips) -> tuple[Array, Array]:
    return strips.x.ravel(), strips.y.ravel()


def with_meshed_bodies(scene: Scene, ball: ProducedBall) -> TurningBall:
    """The ball on races of true shape, sampled under the loads of production; Hertz's pressure stays.

    Raises InputError as `meshed_pair`.
    """
    bearing = scene.bearing

    def elasticity(k: int) -> Elasticity:
        angle, load = (float(ball.state[name][k]) for name in ("angle", "load"))
        contact = race_contact(bearing, RACES[k], contact_angle=angle, ball_load=load)
        half_spaces = HalfSpaces(ball=contact.ball_material, race=contact.race_material)
        return Elasticity(influence=MeshedBodies(half_spaces=half_spaces, compliance=meshed_pair(contact)))

    return replace(ball.turning, elasticity=(elasticity(0), elasticity(1)))
