"""What the kernel writes: a record for each ball, and one for each operating point. SI; rates per unit ring speed.

Fields of two numbers belong to the inner and to the outer race.
"""

import numpy as np

from analytic.loads.kinematics import BallMotion
from analytic.numerics.records import dtype_of

BALL = np.dtype(
    [
        ("load", "f8", 2),  # Q, N
        ("angle", "f8", 2),  # al, rad; negative where the ball is pressed towards -z
        ("semi_axis_rolling", "f8", 2),  # a, m
        ("semi_axis_transverse", "f8", 2),  # b, m
        ("peak_pressure", "f8", 2),  # p0, Pa
        ("approach", "f8", 2),  # delta, m
        ("stiffness", "f8", 2),  # K, N/m^1.5
        # To the nearer shoulder, a low one where it is not known, m; infinite without load
        ("shoulder_distance", "f8", 2),
        ("friction_coefficient", "f8", 2),  # of the Coulomb friction that loses the same power; NaN: nothing slides
        ("film", "f8", 2),  # h, m; this and both shares are NaN without oil and surface
        ("asperity_share", "f8", 2),  # s, of the load
        ("boundary_share", "f8", 2),  # s_b, of the load
        ("film_capped", "u1", 2),  # the film fills the space between the bodies
        ("film_extrapolated", "u1", 2),  # the ellipse is not of a shape that the film formula was fitted to
        ("starvation_degree", "f8", 2),  # m of the inlet; infinite: flooded
        ("gyroscopic_hold", "f8"),  # gyroscopic moment over the most that friction holds
        ("motion", dtype_of(BallMotion)),
    ],
    align=True,
)

POINT = np.dtype(
    [
        ("total", "f8"),  # torques about the bearing axis, N m
        ("spin", "f8"),
        ("conformity", "f8"),
        ("hysteresis", "f8"),
        ("rolling", "f8"),
        ("cage", "f8"),
        ("sliding_error", "f8"),  # of spin and conformity together, by the nodes that integrate them, N m
        ("residual", "f8"),  # of the equilibrium, relative
        ("level", "i8"),  # of these nodes, from 0
        ("heaviest", "i8"),  # ball
        ("orbit_rate", "f8"),  # w_c/w, mean over the balls; NaN: nothing turns a ball
        ("ball_rate", "f8"),  # w_b/w, mean over the balls
        ("holding_moment", "f8"),  # about y, at the ring whose tilt is held, N m; 0 where one ball stands for all
        ("contact_angle", "f8"),  # |al|, mean over balls and races, rad
        ("ball_lead", "f8"),  # A, m, see `analytic.cage.drive`
        ("lead_across", "f8"),  # sum over the balls of sin(psi)/w_c
        ("slowness", "f8"),  # sum of w/w_c over the balls
        ("peak_pressure", "f8", 2),  # of the worst ball, Pa
        ("cut_off", "f8", 2),  # of the worst ball: share of its load beyond a shoulder
        ("rolling_force", "f8", 2),  # of the oil on all balls, N
        ("most_friction", "f8", 2),  # of all balls, in contacts that slide as fast as they roll, N
        ("gyroscopic_hold", "f8"),  # of the worst ball in the loaded zone
        # Of the lightest ball: its own forces over its load; infinite without load
        ("centrifugal_share", "f8"),
        ("gyroscopic_share", "f8"),  # gyroscopic moment of an upright ball over its radius
        ("weight_share", "f8"),
        ("rolling_extrapolated", "u1", 2),
        ("beyond_fit", "?"),  # a contact lies outside the fit for finite geometry
        ("fit_applied", "?"),  # the fit changes a contact
        ("status", "i8"),
        ("steps", "i8"),  # of the last equilibrium
        ("left", "f8"),  # residual of what has not settled, in the unit of its equilibrium
        ("tolerance", "f8"),  # on it
        ("worst_ball", "i8"),  # which the status is about
    ],
    align=True,
)

# How a point ends: settled, or what has no answer there.
(
    SETTLED,
    NO_THRUST,
    NO_DISTRIBUTION,
    THROWN,
    THROWN_WASHERS,
    OPEN_ANGLE,
    OPEN_FORCES,
    LOOSE_BALL,
    LOOSE_RING,
    BEYOND_GROOVE,
    BEYOND_SHOULDER,
    NO_STEADY_ROTATION,
    NO_SHARED_LOAD,
    NO_SPIN_BALANCE,
    NO_CREEP_SPEED,
) = range(15)
