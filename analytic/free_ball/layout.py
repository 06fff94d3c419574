"""Which column of an array holds what, for the compiled loop and its callers. SI; rates per unit ring speed."""

# A contact: load, semi-axes along and across rolling, radius of its surface, its normal out of the ball (radial,
# axial), rate of its ring, flexibility L/a, and the fields of its `analytic.oil.traction.PointLaw` for speeds per unit
# ring speed.
LOAD, ROLLING, TRANSVERSE, RADIUS, NORMAL_R, NORMAL_Z, RING, FLEXIBILITY = range(8)
BOUNDARY, PLAIN, LIMIT, EYRING, FLUIDITY, SHARE, GROWTH, EXPONENT = range(8, 16)
CONTACT = 16
# A ball: radius, radius of its orbit, J w^2/r^2
BALL_RADIUS, ORBIT_RADIUS, INERTIA = range(3)
BALL = 3
# What a contact does: force on the ball along the orbit and across the groove, slip power, part of it by spin, sum of
# all friction; and at the same slip without creep the power of the law of traction and that of a friction coefficient
# of 1
ALONG, ACROSS, POWER, SPIN_POWER, FRICTION, LAW_POWER, UNIT_POWER = range(7)
OUTCOME = 7
MOST_STEPS = 100  # of Newton's method
