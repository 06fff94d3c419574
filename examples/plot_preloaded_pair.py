"""
A preloaded pair
================

Two preloaded angular contact bearings back to back are stiff under the smallest load, but the preload adds torque. How
much preload is enough?
"""

from dataclasses import replace

import matplotlib.pyplot as plt
import numpy as np

import analytic
from analytic.scene import Arrangement

# %%
# Two 7205 with a contact angle of 30 degrees carry 400 N of thrust together.

scene = analytic.Scene(
    bearing=analytic.bearing("7205A"),
    operation=analytic.operation(axial_load="400 N", inner_speed="3000 rpm"),
    lubricant=analytic.lubricant("ISO VG 32", temperature="60 degC"),
    surface=analytic.surfaces(finish="ground and honed"),
    spin_rule="balanced",
    tolerance=0.05,
)
preloads = np.array([20.0, 50.0, 100.0, 200.0, 400.0])  # N
stiffness, torques = [], []
for preload in preloads:
    pair = replace(scene, arrangement=Arrangement(kind="O", preload=float(preload)))
    torque = analytic.friction_torque(pair)
    stiffness.append(1e-6 * torque.pair.equilibrium.stiffness[0])
    torques.append(1e3 * torque.torque.total[0])
    relieved = torque.pair.equilibrium.is_relieved[:, 0].any()
    print(f"{preload:5.0f} N: {stiffness[-1]:5.0f} N/um, {torques[-1]:5.1f} N mm{', one relieved' if relieved else ''}")

# %%
# The preload has to be large enough that the second bearing keeps its load: then both carry, and the stiffness jumps.

figure, axes = plt.subplots(1, 2, figsize=(7.2, 3.4), layout="constrained")
axes[0].semilogx(preloads, stiffness, "o-")
axes[0].set(xlabel="preload, N", ylabel="axial stiffness, N/um")
axes[1].semilogx(preloads, torques, "o-", color="tab:red")
axes[1].set(xlabel="preload, N", ylabel="friction torque of both, N mm")
for axis in axes:
    axis.set_xticks(preloads, [f"{preload:.0f}" for preload in preloads])
    axis.minorticks_off()
    axis.grid(alpha=0.3)
figure.suptitle("Two 7205A back to back, 400 N of thrust, 3000 rpm")
plt.show()
