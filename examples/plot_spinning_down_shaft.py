"""
A shaft that spins down
=======================

A rotor of 0.02 kg m² turns at 6000 rpm on two bearings 6206, each under 150 N along and 400 N across the axis. The
motor is switched off. Friction alone brakes the rotor and heats the oil, which cools to its surroundings. The friction
torque is a function inside a SciPy integration over time.
"""

from dataclasses import replace

import matplotlib.pyplot as plt
import numpy as np
from scipy.integrate import solve_ivp

import analytic

# %%
# The rotor and its surroundings
# ------------------------------

INERTIA = 0.02  # kg m^2
AXIAL, RADIAL = 150.0, 400.0  # N, on each of two bearings
SURROUNDINGS, HEAT_CAPACITY, COOLING = 313.15, 180.0, 0.9  # K, J/K, W/K of one bearing with its seats, assumed
FASTEST, SLOWEST = 6000 * np.pi / 30, 1.0  # rad/s

# %%
# The torque as a function
# ------------------------
# Everything is settled when the function is made; a call takes a quarter of a millisecond.

scene = replace(
    analytic.load_scene("6206"),
    operation=analytic.operation(axial_load="150 N", radial_load="400 N", inner_speed="6000 rpm"),
    lubricant=analytic.lubricant("ISO VG 46", temperature="40 degC"),
    surface=analytic.surfaces(finish="ground and honed"),
    spin_rule="balanced",  # closed kinematics: free balls take some fifty times as long
)
torque_of = analytic.torque_function(scene)


# %%
# Speed and temperature over time
# -------------------------------


def brake(_time: float, state: np.ndarray) -> tuple[float, float]:
    """How fast speed and temperature change."""
    speed, temperature = state
    torque = torque_of(axial_load=AXIAL, radial_load=RADIAL, inner_speed=speed, temperature=temperature)
    return -2 * torque / INERTIA, (torque * speed - COOLING * (temperature - SURROUNDINGS)) / HEAT_CAPACITY


def stands(_time: float, state: np.ndarray) -> float:
    return state[0] - SLOWEST


stands.terminal = True  # type: ignore[attr-defined]
run = solve_ivp(brake, (0.0, 3600.0), (FASTEST, SURROUNDINGS), events=stands, rtol=1e-6, max_step=2.0)
speed, temperature = run.y
torque = torque_of.series(axial_load=AXIAL, radial_load=RADIAL, inner_speed=speed, temperature=temperature)
print(f"stands after {run.t[-1]:.0f} s, {run.nfev} torques; the oil reaches {temperature.max() - 273.15:.1f} degC")

# %%
# The torque falls while the film thins, and rises again where the surfaces touch.

figure, axes = plt.subplots(3, 1, sharex=True, figsize=(7.2, 7.0), layout="constrained")
rows = (
    (speed * 30 / np.pi, "speed, rpm"),
    (torque * 1e3, "torque of one bearing, N mm"),
    (temperature - 273.15, "oil, degC"),
)
for axis, (values, label) in zip(axes, rows, strict=True):
    axis.plot(run.t, values)
    axis.set_ylabel(label)
    axis.grid(alpha=0.3)
axes[-1].set_xlabel("time, s")
axes[0].set_title("A shaft on two bearings 6206 spins down by their friction")
plt.show()
