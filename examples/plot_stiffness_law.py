"""
The stiffness law of a contact
==============================

Hertz's contact stiffens as :math:`F = K \\delta^{1.5}`. Finite elements at several loads give the exponent of the true
contact, with an uncertainty.
"""

import matplotlib.pyplot as plt
import numpy as np

import analytic
import fembearing

# %%
# Loads within a factor of six share one mesh, so that a series costs little more than its first contact.

scene = analytic.load_scene("6205-dry")
loads = [80.0, 200.0, 450.0]
series = fembearing.solve_load_series(scene, pair="outer", loads=loads, accuracy=0.01)
assert series.law is not None
print(f"exponent {series.law.exponent:.4f} +- {series.law.exponent_uncertainty:.4f}, Hertz 1.5")

# %%
# The approach of the true contact is smaller than Hertz's, the more so the larger the ellipse is against the groove.

approach = np.array([point.approach.reference for point in series.points])
hertz = np.array([point.approach.production for point in series.points])
uncertainty = np.array([point.approach.relative_uncertainty for point in series.points])

figure, axes = plt.subplots(1, 2, figsize=(7.2, 3.6), layout="constrained")
axes[0].loglog(1e6 * hertz, loads, "k", label="Hertz")
axes[0].loglog(1e6 * approach, loads, "o", label="finite elements")
axes[0].set(xlabel="approach, um", ylabel="load, N")
axes[0].set_yticks(loads, [f"{load:.0f}" for load in loads])
axes[0].set_xticks([2, 3, 4, 5, 6, 8], ["2", "3", "4", "5", "6", "8"])
axes[0].legend()
axes[1].errorbar(loads, 100 * (hertz / approach - 1), yerr=100 * uncertainty * hertz / approach, fmt="o", capsize=3)
axes[1].set(xlabel="load, N", ylabel="Hertz over finite elements less 1, %", xscale="log")
axes[1].set_xticks(loads, [f"{load:.0f}" for load in loads])
for axis in axes:
    axis.minorticks_off()
    axis.grid(alpha=0.3)
figure.suptitle("Ball on the outer race of a 6205")
plt.show()
