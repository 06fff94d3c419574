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
        ("starvation_degree", "f8", 2),  # m of the inlet; 1: flooded
        ("gyroscopic_hold", "f8"),  # gyroscopic moment over the most that friction holds
        ("gyroscopic_use", "f8"),  # the same over the friction at the ball's own slip
        ("motion", dtype_of(BallMotion)),
    ],
    align=True,
)

OWN_FORCES = "weight", "centrifugal", "gyroscopic"  # effects by what acts on a ball alone
POINT = np.dtype(
    [
        ("total", "f8"),  # torques about the bearing axis, N m
        ("spin", "f8"),
        ("conformity", "f8"),
        ("hysteresis", "f8"),
        ("rolling", "f8"),
        ("cage", "f8"),
        ("coming_off", "f8"),  # change of rolling if balls with little load come off, see `change_without_load`
        ("at_edge", "u1", 3),  # whether each of OWN_FORCES could take a ball off a race, or press it on one
        ("sliding_error", "f8"),  # of spin and conformity together, by the method that integrates them, N m
        ("creep", "f8"),  # estimated share of sliding that elastic creep changes; infinite: of any size
        ("passes", "i8"),  # number of the quadrature by which free balls have settled; 0: they turn by rule
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
    NO_CAGE_DRIVE,
) = range(16)
