"""
A torque with its 95 % interval
===============================

Clearance, roughness, temperature and the formulas themselves are uncertain. Between which limits does the torque lie if
the stated uncertainties are right, and which input should be known better?
"""

import matplotlib.pyplot as plt

import analytic

# %%
# 512 torques with inputs drawn from their distributions. The seed makes the result repeatable. `workers=1` takes one
# core; without it every core takes part.

scene = analytic.Scene(
    bearing=analytic.bearing("6206"),
    operation=analytic.operation(axial_load="400 N", inner_speed="200 rpm"),
    lubricant=analytic.lubricant("ISO VG 46", temperature="70 degC"),
    surface=analytic.surfaces(finish="ground and honed"),
    spin_rule="balanced",  # closed kinematics, which are quick
    tolerance=0.05,
)
found = analytic.predict(scene, samples=512, seed=1, workers=1)
print(found)
print(f"lower end {1e3 * found.total.low[0]:.2f} +- {1e3 * found.total.low_error[0]:.2f} N mm")
print(f"upper end {1e3 * found.total.high[0]:.2f} +- {1e3 * found.total.high_error[0]:.2f} N mm")

# %%
# What the interval is made of
# ----------------------------
# Each bar is the interval if nothing else were uncertain. The total index of an input is the share of the variance that
# would vanish if the input were known, its products with others included.

causes = ("numerical", "input", "model")
figure, axes = plt.subplots(1, 2, figsize=(7.2, 3.4), layout="constrained")
for row, cause in enumerate(causes):
    low, high = 1e3 * found.made_of[cause][:, 0]
    axes[0].barh(row, high - low, left=low)
low, high = 1e3 * found.total.low[0], 1e3 * found.total.high[0]
axes[0].barh(len(causes), high - low, left=low, color="0.4")
axes[0].axvline(1e3 * found.nominal.torque.total[0], color="k")
axes[0].set_yticks(range(len(causes) + 1), ["numerics", "inputs", "formulas", "all"])
axes[0].set_xlabel("friction torque, N mm")

largest = found.ranked[:6]
axes[1].barh([found.inputs[place].key for place in largest], 100 * found.indices.total[largest, 0])
axes[1].invert_yaxis()
axes[1].set_xlabel("total index, %")
plt.show()
