"""
A ball in a thin sheet: a contact that becomes a ring
=====================================================

The sheet of a cage pocket bends on its rim. A thick sheet presses back at the centre of the contact, as a half space
does. A thin sheet yields there, and the ball rests on a ring: the warning gives its pressure and its radius.
"""

# %%
# The pocket of a 6205 under 28 N, with sheets of 0.9 mm and of 0.1 mm.
from dataclasses import replace

import matplotlib.pyplot as plt
import numpy as np

import analytic
import fembearing

scene = analytic.load_scene("6205-dry")
solved = {}
for thickness in (0.9e-3, 0.1e-3):
    cage = replace(scene.cage, wall_thickness=thickness)
    solved[thickness] = fembearing.solve_contact(
        replace(scene, cage=cage), pair="pocket", geometry="wall", load=28.0, accuracy=0.05
    )
print(solved[0.1e-3].numbers.warnings[-1])

# %%
# The pressure of each node over its distance from the centre. Both sheets carry the same load.
fig, (thick, thin) = plt.subplots(1, 2, figsize=(8, 3.5), layout="constrained")
for panel, (thickness, contact) in zip((thick, thin), solved.items(), strict=True):
    mesh = contact.meshes[-1]
    bears = mesh.force > 0
    panel.plot(np.hypot(mesh.x, mesh.y)[bears] * 1e3, mesh.pressure[bears] * 1e-6, ".")
    panel.set(
        title=f"sheet of {thickness * 1e3:g} mm",
        xlabel="distance from the centre, mm",
        ylabel="pressure, MPa",
        ylim=(0, None),
    )
plt.show()
