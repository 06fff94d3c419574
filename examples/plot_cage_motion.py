"""
A cage that whirls
==================

A cage may hang on its balls, or whirl: its centre circles, and centrifugal force presses it against all balls. Which of
the two it does depends on how it started. Its motion is integrated from impact to impact.
"""

import matplotlib.pyplot as plt
import numpy as np

import analytic
from analytic.scene import Cage
from fembearing.check.cage_record import record_cage

# %%
# A 6205 with a sheet-steel cage
# ------------------------------
# The cage starts in a whirl. Short motions and two seeds keep the example quick; a scene has four seeds of 0.2 s.

ball = analytic.bearing("6205").ball_diameter
scene = analytic.Scene(
    bearing=analytic.bearing("6205"),
    operation=analytic.operation(axial_load="1000 N", inner_speed="300 rpm"),
    friction_coefficient=0.1,
    spin_rule="balanced",
    cage=Cage(
        pocket_diameter=ball + 0.2e-3,
        pocket_depth=4e-3,
        wall_thickness=1e-3,
        mass=10e-3,
        material=analytic.material("steel"),
        start="whirl",
        seeds=2,
        duration=0.03,
    ),
    effects={"cage_dynamics": "on"},
    tolerance=0.05,
)
torque = analytic.friction_torque(scene)
record = record_cage(scene, torque, 0)
assert record is not None
print(f"state: {record.statistics.state}, torque of the cage {1e3 * record.statistics.torque:.2f} N mm")
print(f"largest force on a pocket {record.statistics.max_force:.1f} N")

# %%
# The orbit of the cage's centre, and the forces of the balls on their pockets.

series = record.series
force = np.linalg.norm(series.force, axis=2)
figure, axes = plt.subplots(1, 2, figsize=(7.2, 3.6), layout="constrained")
axes[0].plot(1e3 * series.centre[:, 0], 1e3 * series.centre[:, 1], linewidth=0.8)
axes[0].set(xlabel="x, mm", ylabel="y, mm", aspect="equal", title="centre of the cage")
last = series.time > series.time[-1] - 0.01
for number in range(0, force.shape[1], 3):
    axes[1].plot(1e3 * series.time[last], force[last, number], linewidth=0.8, label=f"ball {number + 1}")
axes[1].set(xlabel="time, ms", ylabel="force on the pocket, N")
axes[1].legend()
for axis in axes:
    axis.grid(alpha=0.3)
plt.show()
