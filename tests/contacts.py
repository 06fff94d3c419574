"""Materials and the race contacts of a 6205, typed in by hand so that no formula takes part."""

from dataclasses import replace

from analytic.scene import Contact, Material, Ring

STEEL = Material(name="steel", youngs_modulus=206e9, poisson_ratio=0.3, density=7850.0, source="test")
NITRIDE = Material(name="silicon nitride", youngs_modulus=310e9, poisson_ratio=0.27, density=3200.0, source="test")
PEEK = Material(name="peek", youngs_modulus=3.6e9, poisson_ratio=0.38, density=1300.0, source="test")
INNER = Contact(
    pair="inner",
    ball_radius=3.97e-3,
    groove_radius=4.13e-3,
    rolling_radius=16.47e-3,
    shoulder=2.14e-3,
    far_shoulder=3.77e-3,
    contact_angle=0.303,
    load=372.0,
    ball_material=STEEL,
    race_material=STEEL,
)
OUTER = replace(
    INNER, pair="outer", groove_radius=4.21e-3, rolling_radius=-24.41e-3, shoulder=2.11e-3, far_shoulder=3.81e-3
)
INNER_RING = Ring(bottom_radius=15.53e-3, seat_radius=12.5e-3, width=15e-3, shoulder_half_widths=(3.1e-3, 3.1e-3))
OUTER_RING = replace(INNER_RING, bottom_radius=23.48e-3, seat_radius=26e-3)
CONTACTS = {"inner": INNER, "outer": OUTER}
