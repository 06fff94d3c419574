"""
A map of the torque over load and speed
=======================================

Points that differ in load and speed alone are one series: a thousand of them take seconds. Maps over other inputs, and
larger ones, are computed by sweeps, which use all cores and continue where they were stopped.
"""

import matplotlib.pyplot as plt
import numpy as np

import analytic

# %%
# Every pair of thrust and speed, both in even steps of their logarithm.

loads, speeds = np.geomspace(50.0, 2000.0, 30), np.geomspace(3.0, 600.0, 30)  # N, rad/s
axial_load, inner_speed = (grid.ravel() for grid in np.meshgrid(loads, speeds, indexing="ij"))
scene = analytic.Scene(
    bearing=analytic.bearing("6206"),
    operation=analytic.operation(axial_load=axial_load, inner_speed=inner_speed),
    lubricant=analytic.lubricant("ISO VG 46", temperature="70 degC"),
    surface=analytic.surfaces(finish="ground and honed"),
    spin_rule="balanced",  # closed kinematics, which are quick
    tolerance=0.05,
)
torque = analytic.friction_torque(scene)
print(torque)

# %%
# The result as labelled arrays, with units and meanings.

results = torque.to_dataset()
print(results["torque_total"].attrs, results["film_inner"].attrs)

# %%
# Where the torque has its valley
# -------------------------------
# On the left the surfaces touch, on the right the oil resists being rolled over. On the white line the film is as thick
# as the rms roughness of both surfaces together.

shape = (loads.size, speeds.size)
rpm = speeds * 30 / np.pi
total = 1e3 * torque.torque.total.reshape(shape)
ratio = (torque.film.inner / torque.gap_roughness).reshape(shape)
figure, axis = plt.subplots(figsize=(7.2, 4.6), layout="constrained")
levels = np.geomspace(total.min(), total.max(), 21)
filled = axis.contourf(rpm, loads, total, levels=levels, norm="log")
axis.contour(rpm, loads, ratio, levels=[1.0], colors="white")
axis.set(xscale="log", yscale="log", xlabel="speed, rpm", ylabel="axial load, N", title="Friction torque of a 6206")
figure.colorbar(filled, label="friction torque, N mm", format="%.3g")
plt.show()
