"""
Balls under a radial load
=========================

A radial load presses on a few balls only. The equilibrium of the inner ring gives each ball its own load and contact
angle, and the ring its displacement and stiffness.
"""

import matplotlib.pyplot as plt
import numpy as np

import analytic

# %%
# A 6310 under 5 kN of radial load and little thrust, with two clearances.

loads = {}
for clearance in ("CN", "C4"):
    scene = analytic.Scene(
        bearing=analytic.bearing("6310", clearance=clearance),
        operation=analytic.operation(radial_load="5 kN", axial_load="300 N", inner_speed="1500 rpm"),
        lubricant=analytic.lubricant("ISO VG 68", temperature="70 degC"),
        surface=analytic.surfaces(finish="ground and honed"),
        spin_rule="balanced",  # closed kinematics: the balls' own axes are not the subject here
        tolerance=0.05,
    )
    torque = analytic.friction_torque(scene)
    ring = torque.ring
    loads[clearance] = ring.azimuth, ring.load[0].max(axis=0)
    print(f"{clearance}: torque {1e3 * torque.torque.total[0]:.1f} N mm")
    print(f"    the ring moves {1e6 * ring.displacement[0, 1]:.1f} um along the radial load")
    print(f"    stiffness {1e-6 * ring.stiffness[0, 1, 1]:.0f} N/um")

# %%
# More clearance leaves the load to fewer balls.

figure, axis = plt.subplots(figsize=(5.4, 4.6), layout="constrained", subplot_kw={"projection": "polar"})
width = 2 * np.pi / len(loads["CN"][0]) / 2.6
for place, (clearance, (azimuth, load)) in enumerate(loads.items()):
    axis.bar(azimuth.ravel() + (place - 0.5) * width, load, width=width, label=f"clearance {clearance}")
axis.set_title("Load of each ball, N; radial load at 0 degrees")
axis.legend(loc="lower left")
plt.show()
