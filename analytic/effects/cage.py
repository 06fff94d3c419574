"""Whether the cage is computed, and by which method: its closed form at rest, or its motion.

The closed form costs nothing. The motion takes seconds per operating point. `auto` computes it only where the scene
says how the motion starts (`cage.start`), the cage could whirl, and a whirl could cost more than the tolerance.
"""

import numpy as np

from analytic.cage.steady import sliding_torque, whirl_number
from analytic.cage.torque import CageDrive
from analytic.effects.ledger import Ledger
from analytic.effects.table import ENTRIES, LEAST_WHIRL, LONGEST_MOTION
from analytic.scene import Array, Cage, Scene


def decide_cage(scene: Scene, drive: CageDrive | None, ledger: Ledger, *, race: Array) -> None:
    """Decide `cage` and `cage_dynamics`.

    drive : None for a scene without a cage;  race : torque of the races, (n,), N m, to compare the motion with
    """
    if drive is None:
        ledger.decide("cage")
        ledger.decide("cage_dynamics")
    elif ledger.decide("cage"):
        _decide_motion(scene, drive, ledger, race=race)
    else:
        ledger.settle("cage_dynamics", on=False, reason=ENTRIES["cage_dynamics"].idle)


def _decide_motion(scene: Scene, drive: CageDrive, ledger: Ledger, *, race: Array) -> None:
    automatic = scene.effects.get("cage_dynamics", "auto") == "auto"
    number = whirl_number(
        ball_speed=drive.ball_speed,
        ball_radius=drive.bearing.ball_radius,
        half_clearance=drive.shape.half_clearance,
        gravity=drive.gravity,
    )
    largest = float(np.max(number, initial=0.0))
    if automatic and largest < LEAST_WHIRL:
        reason = (
            f"the cage cannot whirl: whirl number {largest:.3g} at most, below {LEAST_WHIRL:g}; it rests, by the "
            "closed form"
        )
        ledger.settle("cage_dynamics", on=False, share=np.zeros_like(race), reason=reason)
        return
    lacks = None
    if drive.cage.start is None:
        lacks = (
            f"cage.start is not given, and with a whirl number of {LEAST_WHIRL:g} or more, here up to {largest:.3g}, a "
            'cage rests or whirls by how it started: give "rest", "ramp", "sudden" or "whirl"'
        )
    elif automatic:
        lacks = _too_long(drive.cage, int(np.count_nonzero(drive.inner_speed)))
    force = np.maximum(drive.whirling_force, 1e-9)  # N: at standstill too, no film is computed without a load
    bound = sliding_torque(
        friction_coefficient=drive.pocket_friction(scene, force).coefficient,
        force=force,
        ball_rate=drive.ball_rate,
        ball_radius=drive.bearing.ball_radius,
    )
    bound = np.where(number < LEAST_WHIRL, 0.0, bound)
    share = np.divide(bound, race, out=np.where(bound > 0, np.inf, 0.0), where=race > 0)
    ledger.decide("cage_dynamics", bound=share, lacks=lacks)


def _too_long(cage: Cage, points: int) -> str | None:
    """What is wrong with a series that takes longer than `auto` allows; None if it does not."""
    simulated = 2 * cage.duration * (cage.seeds + 1) * points  # start-up and measured time; one more for another start
    longest = LONGEST_MOTION * Cage.steps_per_contact / cage.steps_per_contact
    if simulated <= longest:
        return None
    return (
        f"{points} points take {simulated:.3g} s of motion, and beyond {longest:.3g} s at {cage.steps_per_contact} "
        "steps a contact it is not computed unasked: give fewer points, seeds or steps, a shorter duration, or "
        'effects.cage_dynamics = "on"'
    )
