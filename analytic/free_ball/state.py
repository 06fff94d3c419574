"""Records of a free ball's contacts and of their nodes. Rates are per unit ring speed, so slip is a length."""

import numpy as np

from analytic.numerics.records import Record, Records

MOST_STRIPS, MOST_NODES = 128, 96  # of a quadrature, across and along rolling
PITCH = MOST_STRIPS + 8  # between rows of numbers of strips: a power of two would share lines of a cache
ROWS = 40  # of numbers of strips, see `strips`

CONTACT_STATE = np.dtype(
    [
        ("load", "f8"),  # Q, N
        ("semi_axis_rolling", "f8"),  # a, m
        ("semi_axis_transverse", "f8"),  # b, m
        ("radius", "f8"),  # of the contact surface across rolling, m
        ("normal_radial", "f8"),  # out of the ball
        ("normal_axial", "f8"),
        ("ring_rate", "f8"),  # of its ring
        ("flexibility", "f8"),  # L/a along rolling, 1/Pa
        ("lean", "f8"),  # how much more it is across
        # The law of traction, as `analytic.oil.traction.PointLaw` has it for speeds per unit ring speed
        ("boundary", "f8"),
        ("plain", "f8"),
        ("limit", "f8"),
        ("eyring", "f8"),
        ("fluidity", "f8"),
        ("share", "f8"),
        ("alpha", "f8"),
        ("bend", "f8"),
        ("exponent", "f8"),
        ("rises", "f8"),
        ("own", "f8"),
        # What the contact does
        ("along", "f8"),  # force on the ball along the orbit, N
        ("across", "f8"),  # and across the groove, N
        ("power", "f8"),  # by slip, N m
        ("spin_power", "f8"),  # part of it by spin, N m
        ("friction", "f8"),  # sum of its magnitudes, N
        ("law_power", "f8"),  # of the law of traction at the slip without creep, N m
        ("unit_power", "f8"),  # of a friction coefficient of 1 at the same slip, N m
    ],
    align=True,
)

QUADRATURE = np.dtype(
    [
        ("strips", "i8"),  # along rolling
        ("nodes", "i8"),  # of a strip, which is marched from its leading edge
        ("across", "f8", (3, MOST_STRIPS)),  # sines, cosines and weights of the angles at which the strips lie
        ("along", "f8", (3, MOST_NODES)),  # likewise of the nodes
        # Second-order backward differences between the nodes, times the half-length: how far stress at the node, at the
        # last one and at the one before pulls the slip. The first step is exact where nothing slides.
        ("steps", "f8", (3, MOST_NODES)),
    ],
    align=True,
)

# What the formulas of a free ball write and read again: arrays that would be made anew at each call
SCRATCH = np.dtype(
    [
        ("velocity", "f8", 4),  # of the ball, as `analytic.free_ball.rotation` has it; where it began, and on trial
        ("start", "f8", 4),
        ("trial", "f8", 4),
        ("passing", "f8", 2),  # speed of the surfaces through both contacts, m per unit w, and for softer ones
        ("softer", "f8", 2),
        ("force", "f8", 4),  # on the ball, and on trial
        ("trial_force", "f8", 4),
        ("tangent", "f8", (4, 4)),
        ("trial_tangent", "f8", (4, 4)),
        ("rows", "f8", (3, 4)),  # slip along a strip, across it and by spin, by the velocity
        ("system", "f8", (4, 4)),
        ("step", "f8", 4),  # of Newton's method, and the next one
        ("next_step", "f8", 4),
        ("strips", "f8", ROWS * PITCH),
        ("flows", "f8", (2, MOST_NODES, 3, PITCH)),  # of `strips.flow_at` in the nodes of both contacts
    ],
    align=True,
)


def scratch() -> Record:
    """For one thread."""
    return np.zeros(1, SCRATCH).view(np.recarray)[0]


def contact_states(balls: int) -> Records:
    """(Z, 2) contacts of balls with inner and outer race."""
    return np.zeros((balls, 2), CONTACT_STATE)
