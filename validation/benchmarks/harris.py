"""The price of the simplest model of a bearing's friction, beside which `run.py` puts that of this one.

A deep groove ball bearing like a 6206 by Hertz contacts of one stiffness, both equilibria by Newton's method as Harris
has them: the contact angle under thrust, the shift of the inner ring under a radial load. Its torque is rolling at a
share of the load, and spin that the outer race controls. No film, no slip, no tilt, and usual values for constants: a
price, and no reference for a torque.
"""

import numpy as np
from numba import njit

BALLS, BALL, PITCH, CURVATURE = 9, 9.525e-3, 46e-3, 0.04  # curvature: r_i/D + r_o/D - 1
STIFFNESS, FREE_ANGLE = 8.0e9, 0.18  # of both contacts in series, N/m^1.5; rad
FRICTION, ROLLING = 0.06, 0.4e-3  # of spin; rolling friction over the load, at the pitch circle
ENOUGH = 1e-12


@njit
def plain_torque(axial: float, radial: float, speed: float) -> float:
    """Friction torque under thrust or under a radial load, N m; axial, radial : N;  speed : rad/s"""
    total = 0.0
    if radial == 0.0:
        arm, angle = CURVATURE * BALL, FREE_ANGLE
        for _ in range(50):
            stretch = arm * (np.cos(FREE_ANGLE) / np.cos(angle) - 1.0)
            force = BALLS * STIFFNESS * stretch**1.5
            slope = arm * np.cos(FREE_ANGLE) * np.tan(angle) / np.cos(angle)
            change = (axial - force * np.sin(angle)) / (
                force * np.cos(angle) + 1.5 * BALLS * STIFFNESS * stretch**0.5 * slope * np.sin(angle) + 1e-9
            )
            angle += min(max(change, -0.1), 0.1)
            if abs(change) < ENOUGH:
                break
        load = axial / (BALLS * np.sin(angle))
        return BALLS * of_ball(load, angle, speed)
    shift = (5.0 * radial / (BALLS * STIFFNESS)) ** (2.0 / 3.0)
    for _ in range(50):
        force = slope = 0.0
        for j in range(BALLS):
            along = np.cos(2.0 * np.pi * j / BALLS)
            press = max(shift * along, 0.0)
            force += STIFFNESS * press**1.5 * along
            slope += 1.5 * STIFFNESS * press**0.5 * along * along
        change = (radial - force) / slope
        shift += change
        if abs(change) < ENOUGH * shift:
            break
    for j in range(BALLS):
        total += of_ball(STIFFNESS * max(shift * np.cos(2.0 * np.pi * j / BALLS), 0.0) ** 1.5, 0.0, speed)
    return total


@njit
def of_ball(load: float, angle: float, speed: float) -> float:
    """Torque on the ring by one ball whose spin the outer race controls, N m; load : N"""
    ratio = BALL * np.cos(angle) / PITCH
    spin = (1.0 - ratio) / (2.0 * ratio) * np.sin(angle) if speed != 0.0 else 0.0
    semi_axis = 0.012 * load ** (1.0 / 3.0) * BALL
    return 0.375 * FRICTION * load * semi_axis * spin + ROLLING * load * PITCH / 2.0
