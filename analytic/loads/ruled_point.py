"""The balls of a point that turn by rule, compiled: all alike under thrust alone, else each for itself."""

from analytic.contact.factors import correction_of_ball
from analytic.loads.ring_balance import RingPoint, RingWork
from analytic.loads.ring_rounds import OPEN, SETTLED, RingLoad, RingNumbers, Round, settle_ruled_ring
from analytic.loads.thrust_ball import first_contacts, thrust_point
from analytic.numerics.compilation import compiled


@compiled
def load_by_rule(ring: RingNumbers, load: RingLoad, point: RingPoint, work: RingWork | None, start: int) -> Round:
    """Write loads, angles and contacts under 1 N; of the first ball alone where all are alike.

    work : None: all are alike, and no ring is compiled;  start : of `settle_ruled_ring`
    """
    if work is not None:
        return settle_ruled_ring(ring, load, point, work, start)
    first, correction = first_contacts(ring.bearing), correction_of_ball(load.factors, 0)
    found = thrust_point(ring.bearing, first, load.force[0], load.rule, correction)
    point.load[0, 0], point.load[1, 0] = found.ball.inner_load, found.ball.outer_load
    point.angle[0, 0], point.angle[1, 0] = found.ball.inner_angle, found.ball.outer_angle
    for k in range(5):
        point.unit[0, k, 0], point.unit[1, k, 0] = found.inner[k], found.outer[k]
    return Round(SETTLED if found.change == 0.0 else OPEN, 0, found.change, 0.0)
