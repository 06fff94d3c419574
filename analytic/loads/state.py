"""The state of a ring and its balls at one operating point: records that the compiled formulas read and write.

A settled state is a start for the next operating point. Fields of two numbers belong to the inner and to the outer
race, or are a radial and an axial component, as their comments say. Rates are per unit ring speed w.
"""

import numpy as np

from analytic.contact.factors import ContactCorrection, ContactFactors
from analytic.contact.hertz import HertzContact
from analytic.loads.kinematics import BallMotion
from analytic.loads.turning import ForcesOfTurning
from analytic.numerics.records import Record, Records, dtype_of
from analytic.scene import Array

FREEDOMS = 5  # of a ring: along z, x and y, tilts about x and y
TILTS = 2  # of these

BALL_STATE = np.dtype(
    [
        # How the inner groove at the ball follows the freedoms of its ring; see `ring_balance.groove_travel`
        ("offset", "f8"),  # along z where nothing is displaced, m
        ("travel", "f8", (2, FREEDOMS)),  # radial and axial; tilts times R
        ("weight", "f8", 2),  # radial and axial, N
        # Contacts
        ("inner_factors", dtype_of(ContactFactors)),  # on Hertz's contact
        ("outer_factors", dtype_of(ContactFactors)),
        ("inner_unit", dtype_of(HertzContact)),  # contact under 1 N
        ("outer_unit", dtype_of(HertzContact)),
        ("load", "f8", 2),  # Q on both races, N
        ("angle", "f8", 2),  # al on both races, rad
        # Forces; radial and axial, N
        ("turning", dtype_of(ForcesOfTurning)),  # because the ball turns
        ("own", "f8", 2),  # of the ball's own, held by a round
        ("next_own", "f8", 2),  # of the next round
        ("friction", "f8", 2),  # of the ball on the inner groove
        ("force", "f8", 2),  # of the contact on the inner groove
        # Place; radial and axial, m
        ("inner_arm", "f8", 2),  # from the ball to the inner groove's centre
        ("outer_arm", "f8", 2),  # from the outer groove's centre to the ball
        ("moved", "f8", 2),  # by its own force
        # A ball that turns freely
        ("velocity", "f8", 4),  # v of `analytic.free_ball.rotation`, m; NaN: not known
        ("radius", "f8"),  # r, m
        ("orbit_radius", "f8"),  # m
        ("inertia", "f8"),  # J w^2/r^2, kg/s^2; 0: the gyroscopic moment does not count
        ("motion", dtype_of(BallMotion)),
        ("given", "f8", 3),  # centrifugal force and friction on both races that the last round had, N; NaN: not known
        ("gave", "f8", 3),  # what came of it
        ("left", "f8", 3),  # the difference
        ("residual", "f8"),  # of the rotation, over all friction
        # Where a free ball begins, over what the rule gives it
        ("start_velocity", "f8", 4),  # more than that by rule, m
        ("start_angle", "f8", 2),  # more than that by rule, rad
        ("start_load", "f8", 2),  # factor on that by rule
        ("start_forces", "f8", 3),  # as `given`, N
        ("ruled_angle", "f8", 2),  # by the rule, rad
        ("ruled_load", "f8", 2),  # N
    ],
    align=True,
)

RING_STATE = np.dtype(
    [
        ("load", "f8", FREEDOMS),  # on the ring, N; moments over R
        ("force", "f8", FREEDOMS),  # load and friction of the balls, held by a round
        ("place", "f8", FREEDOMS),  # m; tilts times R
        ("tangent", "f8", (FREEDOMS, FREEDOMS)),  # second derivative of the energy, N/m
        ("gradient", "f8", FREEDOMS),  # of the energy, N: what holds a freedom that is held
        ("step", "f8", FREEDOMS),  # of Newton's method
        ("origin", "f8", FREEDOMS),  # place from which a step goes
        ("factor", "f8", (FREEDOMS, FREEDOMS)),  # of the tangent
        ("held", "i8"),  # how many of the last freedoms are held at their place: 0, or TILTS
        ("passes", "i8"),  # quadrature in which free balls settled last; 0: no start is known
    ],
    align=True,
)


def ring_state() -> Record:
    """A ring without load."""
    return np.zeros(1, RING_STATE).view(np.recarray)[0]


def ball_states(count: int) -> Records:
    """(Z,) balls that are concentric with their ring, with contacts by Hertz."""
    balls = np.zeros(count, BALL_STATE)
    for side in ("inner_factors", "outer_factors"):
        for name in ContactFactors._fields:
            balls[side][name] = np.nan if name == "peak_pressure" else 1.0
    balls["start_load"] = 1.0
    return balls


def factors_of(correction: ContactCorrection) -> Array:
    """(n, 2, 4, Z) with axes of 1 where all points or all balls have the same factors; one of (n,) is of all balls."""
    given = [np.asarray(value) for side in (correction.inner, correction.outer) for value in side]
    each = (value if value.ndim > 1 else value.reshape(-1, 1) for value in given)
    together = np.stack(np.broadcast_arrays(*each), axis=1)
    return np.array(together.reshape(len(together), 2, 4, -1), dtype=np.float64)


def correct_balls(balls: Records, factors: Array) -> None:
    """Write the factors on Hertz's contacts; balls : (n, Z);  factors : (n or 1, 2, 4, Z or 1)"""
    for race, side in enumerate(("inner_factors", "outer_factors")):
        for place, name in enumerate(ContactFactors._fields):
            balls[side][name] = factors[:, race, place]


def approaches(balls: Records) -> Array:
    """(..., 2) delta on both races under the balls' loads, m."""
    unit = np.stack([balls["inner_unit"]["approach"], balls["outer_unit"]["approach"]], axis=-1)
    return unit * np.cbrt(balls["load"]) ** 2
