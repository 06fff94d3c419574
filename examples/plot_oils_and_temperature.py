"""
Which oil, and how warm
=======================

The catalogue has oils by their ISO class. An oil of one's own takes two viscosities from its data sheet and the kind of
its base oil.
"""

import matplotlib.pyplot as plt
import numpy as np

import analytic

# %%
# Three mineral oils, and one from a data sheet.

oils = {
    "ISO VG 32": {"name": "ISO VG 32"},
    "ISO VG 68": {"name": "ISO VG 68"},
    "ISO VG 150": {"name": "ISO VG 150"},
    "data sheet": {"viscosity": ["46 cSt at 40 degC", "7.9 cSt at 100 degC"], "base_oil": "PAO"},
}
bearing = analytic.bearing("6206")
operation = analytic.operation(axial_load="600 N", inner_speed="1500 rpm")
surface = analytic.surfaces(finish="ground and honed")
celsius = np.arange(20.0, 101.0, 10.0)

curves = {}
for name, keys in oils.items():
    torques, films = [], []
    for temperature in celsius:
        scene = analytic.Scene(
            bearing=bearing,
            operation=operation,
            lubricant=analytic.lubricant(temperature=temperature + 273.15, **keys),
            surface=surface,
            tolerance=0.05,
        )
        torque = analytic.friction_torque(scene)
        torques.append(1e3 * torque.torque.total[0])
        films.append(torque.film.inner[0] / torque.gap_roughness)
    curves[name] = torques, films
    print(f"{name:11} {torques[0]:6.1f} N mm at {celsius[0]:.0f} degC, {torques[-1]:5.1f} at {celsius[-1]:.0f} degC")

# %%
# A thick oil resists being rolled over; a thin one lets the surfaces touch. Below a film ratio of about 3 asperities
# carry part of the load.

figure, axes = plt.subplots(2, 1, sharex=True, figsize=(7.2, 6.0), layout="constrained")
for name, (torques, films) in curves.items():
    axes[0].plot(celsius, torques, "o-", label=name)
    axes[1].plot(celsius, films, "o-", label=name)
axes[0].set(ylabel="friction torque, N mm", title="6206, 600 N of thrust, 1500 rpm")
axes[0].legend()
axes[1].axhline(3, color="0.5", linewidth=1)
axes[1].set(xlabel="oil, degC", ylabel="film over rms roughness", yscale="log")
for axis in axes:
    axis.grid(alpha=0.3)
plt.show()
