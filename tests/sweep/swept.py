"""A scene that is swept: every effect on or off by its own word, so that no series decides otherwise than a point."""

SCENE = """
[scene]
name = "swept"
tolerance = "5 %"
[scene.bearing]
catalog = "6205"
contact_angle = { rule = "solved", free = "0.18 rad" }
[scene.operation]
axial_load = "300 N"
inner_speed = "250 rpm"
[scene.friction]
coefficient = 0.09
hysteresis_loss = 0.007
[scene.effects]
centrifugal = "off"
gyroscopic = "off"
finite_geometry = "off"
conformity = "on"
spin = "on"
hysteresis = "on"
"""
