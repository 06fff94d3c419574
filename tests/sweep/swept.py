"""The scene of the sweeps. It turns every effect on or off, so that a series decides as a single point does.

Balls turn by a rule: free ones take as many nodes as the worst point of a series needs.
"""

SCENE = """
[scene]
name = "swept"
tolerance = "5 %"
[scene.bearing]
catalog = "paper_6205"
contact_angle = { rule = "solved", free = "0.18 rad" }
[scene.operation]
axial_load = "300 N"
inner_speed = "250 rpm"
[scene.friction]
coefficient = 0.09
hysteresis_loss = 0.007
spin_rule = "balanced"
[scene.effects]
centrifugal = "off"
gyroscopic = "off"
finite_geometry = "off"
conformity = "on"
spin = "on"
hysteresis = "on"
"""
