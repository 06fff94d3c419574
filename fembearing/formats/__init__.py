"""The torque of a scene in the forms that other programs read, one file for each.

`axes` reads the ranges of speed, load and temperature, `torque_map` computes the torque over them with its 95 %
interval, and `choice` lists the formats and writes one.
"""
