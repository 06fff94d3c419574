"""
Torque of a bearing, by its designation
=======================================

What is printed on the bearing and on the oil drum, with load and speed, is enough for a friction torque. The catalogue
has the dimensions of the bearing and their uncertainty; here the balls are derived from the load ratings.
"""

import matplotlib.pyplot as plt
import numpy as np

import analytic

# %%
# A scene without a file
# ----------------------
# A 6206 with clearance C3 carries 800 N of thrust in a mineral oil at 70 degrees Celsius. A list of speeds makes a
# series of operating points. Texts carry their units; plain numbers are SI.

speeds = [f"{rpm} rpm" for rpm in (50, 100, 200, 400, 800, 1600, 3200)]
scene = analytic.Scene(
    bearing=analytic.bearing("6206/C3"),
    operation=analytic.operation(axial_load="800 N", inner_speed=speeds),
    lubricant=analytic.lubricant("ISO VG 46", temperature="70 degC"),
    surface=analytic.surfaces(finish="ground and honed"),
    hysteresis_loss=0.007,
    tolerance=0.05,
)
torque = analytic.friction_torque(scene)
print(torque)

# %%
# What was left out
# -----------------
# Every effect is decided by an estimate of its share. What is left out is listed with the reason.

for effect in torque.effects:
    print(f"{effect.name:20} {effect.decision:4} {effect.reason}")

# %%
# The torque by effect
# --------------------
# At low speed the surfaces touch and sliding decides. With speed the oil parts them, and its own resistance to being
# rolled over takes the place of sliding.

rpm = torque.inner_speed * 30 / np.pi
parts = {"spin": torque.torque.spin, "conformity": torque.torque.conformity}
parts |= {"hysteresis": torque.torque.hysteresis, "oil that is rolled over": torque.torque.rolling}

figure, axis = plt.subplots(figsize=(7.2, 4.2), layout="constrained")
axis.stackplot(rpm, [1e3 * part for part in parts.values()], labels=list(parts), alpha=0.8)
axis.plot(rpm, 1e3 * torque.torque.total, "k", linewidth=1.5, label="total")
axis.set(xscale="log", xlabel="speed, rpm", ylabel="friction torque, N mm", title="6206/C3 under 800 N of thrust")
axis.legend()
axis.grid(alpha=0.3)
plt.show()
