"""
A measured surface
==================

Ra is one number, and two surfaces with the same Ra may differ in the length of their waves. A height map has both. Here
two generated maps stand for measured ones.
"""

from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib.pyplot as plt
import numpy as np

import analytic
from analytic.scene import Autocorrelation
from analytic.surface.roughness import generated_surface

# %%
# Two surfaces of the same roughness, with waves of 10 and of 25 micrometres. A file holds heights in metres, as .npy or
# .csv.

SCENE = """
name = "6205 on a measured surface"
tolerance = "5 %"

[bearing]
catalog = "6205"

[operation]
axial_load = "500 N"
inner_speed = ["20 rpm", "60 rpm", "200 rpm", "600 rpm"]

[lubricant]
name = "ISO VG 32"
temperature = "80 degC"

[surface]
height_map = {{ path = "{file}", spacing = "1 um" }}
"""

found = {}
with TemporaryDirectory() as folder:
    for length in (10e-6, 25e-6):
        waves = Autocorrelation(kind="gaussian", length=length, spacing=1e-6)
        heights = generated_surface(rms_roughness=0.12e-6, autocorrelation=waves, points=256, seed=3).heights
        name = f"waves of {1e6 * length:.0f} um"
        np.save(Path(folder, "race.npy"), heights)
        Path(folder, "scene.toml").write_text(SCENE.format(file="race.npy"), "utf-8")
        torque = analytic.friction_torque(analytic.load_scene(Path(folder, "scene.toml")))
        rpm = torque.inner_speed * 30 / np.pi
        found[name] = heights, torque.asperity_share.inner
        print(f"{name}: {1e3 * torque.torque.total[0]:.1f} N mm at {rpm[0]:.0f} rpm")

# %%
# Short waves are steep: they carry more of the load at the same film.

figure, axes = plt.subplots(1, 3, figsize=(9.0, 3.2), layout="constrained")
for axis, (name, (heights, share)) in zip(axes, found.items(), strict=False):
    image = axis.imshow(1e6 * heights, extent=(0, 256, 0, 256), vmin=-0.4, vmax=0.4)
    axis.set(title=name, xlabel="um")
    axes[2].semilogx(rpm, 100 * share, "o-", label=name)
figure.colorbar(image, ax=axes[1], label="height, um", shrink=0.6)
axes[2].set(xlabel="speed, rpm", ylabel="load on asperities, %")
axes[2].set_xticks(rpm, [f"{speed:.0f}" for speed in rpm])
axes[2].minorticks_off()
axes[2].grid(alpha=0.3)
axes[2].legend()
plt.show()
