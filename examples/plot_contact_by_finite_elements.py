"""
A contact by finite elements
============================

Hertz's formulas hold for two half spaces. A groove is no half space: it closes in on the ball. Finite elements on the
true shapes show how much that matters, and state their own uncertainty.
"""

import matplotlib.pyplot as plt
import numpy as np

import analytic
import fembearing

# %%
# One contact, on several meshes
# ------------------------------
# The ball on the inner race of the built-in 6205 under 500 N. The solver refines its meshes until the required accuracy
# is reached. Two half spaces on the same cells, whose exact answer is known, correct the error of the mesh.

scene = analytic.load_scene("6205-dry")
contact = fembearing.solve_contact(scene, pair="inner", load=500.0, accuracy=0.005)
for mesh in contact.meshes:
    print(f"{mesh.unknowns} unknowns")
for name, each in contact.numbers.quantities.items():
    uncertainty, discrepancy = 100 * each.relative_uncertainty, 100 * each.discrepancy
    print(f"{name:22} {each.reference:11.5g} +- {uncertainty:.2f} %, Hertz {discrepancy:+.2f} %")

# %%
# The pressure along both axes
# ----------------------------
# Along rolling, and across it. The dots are nodes of the finest mesh.

profiles = contact.numbers.pressure_profile
figure, axes = plt.subplots(1, 2, sharey=True, figsize=(7.2, 3.6), layout="constrained")
for axis, (direction, profile) in zip(axes, vars(profiles).items(), strict=True):
    for label, style, line in (("Hertz", "k-", profile.hertz), ("finite elements", "C0o", profile.fe)):
        position, pressure = 1e3 * np.array(line.position), 1e-9 * np.array(line.pressure)
        axis.plot(position, pressure, style, markersize=3, label=label)
    axis.set(xlabel=f"position, {direction}, mm")
    axis.grid(alpha=0.3)
axes[0].set_ylabel("pressure, GPa")
axes[0].legend()
figure.suptitle("Ball on the inner race of a 6205, 500 N")
plt.show()
