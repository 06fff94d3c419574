"""Whether the cage is computed, and by which method: its closed form at rest, or its motion.

The closed form costs nothing. The motion takes seconds per operating point. `auto` computes it only where the scene
says how the motion starts (`cage.start`), the cage could whirl, and a whirl could cost more than the tolerance.
"""

import numpy as np
from numpy.typing import NDArray

from analytic.cage.drive import LARGEST_GRIP, CageDrive
from analytic.cage.steady import sliding_torque, whirl_number
from analytic.effects.ledger import Ledger
from analytic.effects.table import ENTRIES, LEAST_WHIRL, LONGEST_FREE_MOTION, LONGEST_MOTION
from analytic.scene import Array, Cage, Scene
from analytic.words import length_of

LEAST_FORCE = 1e-9  # N: at standstill too, no film is computed without a load


def decide_cage(scene: Scene, drive: CageDrive | None, ledger: Ledger, *, race: Array) -> NDArray[np.bool_]:
    """Decide `cage`, `cage_dynamics` and `ball_dynamics`; (n,) where balls and cage move together.

    drive : None for a scene without a cage;  race : torque of the races, (n,), N m, to compare the motion with
    """
    if drive is None:
        ledger.decide("cage")
        ledger.decide("cage_dynamics")
    elif ledger.decide("cage"):
        _decide_motion(scene, drive, ledger, race=race)
    else:
        ledger.settle("cage_dynamics", on=False, reason=ENTRIES["cage_dynamics"].idle)
    return _decide_ball_dynamics(scene, drive, ledger, race=race)


def _decide_ball_dynamics(scene: Scene, drive: CageDrive | None, ledger: Ledger, *, race: Array) -> NDArray[np.bool_]:
    """Balls move freely where a whirl needs more grip than given balls have, or where they lead too far."""
    nowhere, entry = np.zeros(race.shape, dtype=bool), ENTRIES["ball_dynamics"]
    rests = drive is not None and drive.cage.start is None and not np.any(drive.is_squeezed)
    if drive is None or rests or not ledger.is_on("cage"):
        ledger.decide("ball_dynamics", lacks=entry.idle)
        return nowhere
    force = np.maximum(drive.whirling_force, LEAST_FORCE)
    mu = drive.pocket_friction(scene, force).coefficient
    turns = drive.inner_speed != 0
    needs = turns & (drive.is_squeezed | (ledger.is_on("cage_dynamics") & drive.slides(mu)))
    number = float(np.max(drive.grip_number(mu)))
    automatic = scene.effects.get("ball_dynamics", "auto") == "auto"
    lacks = None
    if automatic and not np.any(needs):
        still = f"grip number {number:.3g} at most, balls roll below {LARGEST_GRIP:g}"
        lacks = still if ledger.is_on("cage_dynamics") else entry.idle
    elif drive.friction_coefficient is None:
        lacks = 'friction of the races not computed: set effects.spin and effects.conformity to "auto"'
    elif automatic:
        lacks = _too_long(drive.cage, int(np.count_nonzero(needs)), LONGEST_FREE_MOTION, "ball_dynamics")
        lacks = None if lacks is None else f"grip number {number:.3g} at most, and {lacks}"
    demanded = f"grip number {number:.3g}, balls slide above {LARGEST_GRIP:g}"
    if np.any(drive.is_squeezed):
        lead = float(np.max(np.abs(drive.grip.ball_lead)))
        demanded = f"ball lead up to {length_of(lead)}, free clearance of the pockets {length_of(drive.room)}"
    on = ledger.decide("ball_dynamics", bound=np.where(needs, np.inf, 0.0), lacks=lacks, demanded=demanded)
    return (needs if automatic else turns) & on


def _decide_motion(scene: Scene, drive: CageDrive, ledger: Ledger, *, race: Array) -> None:
    if drive.cage.start is None:
        ledger.decide("cage_dynamics")
        return
    if np.all(drive.is_squeezed):
        ledger.settle("cage_dynamics", on=False, share=np.zeros_like(race), reason=_too_tight(drive))
        return
    automatic = scene.effects.get("cage_dynamics", "auto") == "auto"
    number = whirl_number(
        ball_speed=drive.ball_speed,
        ball_radius=drive.bearing.ball_radius,
        half_clearance=drive.shape.half_clearance,
        gravity=drive.gravity,
    )
    largest = float(np.max(number, initial=0.0))
    if automatic and largest < LEAST_WHIRL:
        reason = f"no whirl: whirl number {largest:.3g} at most, limit {LEAST_WHIRL:g}; closed form of a cage at rest"
        ledger.settle("cage_dynamics", on=False, share=np.zeros_like(race), reason=reason)
        return
    lacks = None
    if automatic:
        lacks = _too_long(drive.cage, int(np.count_nonzero(drive.inner_speed)), LONGEST_MOTION, "cage_dynamics")
    force = np.maximum(drive.whirling_force, LEAST_FORCE)
    bound = sliding_torque(
        friction_coefficient=drive.pocket_friction(scene, force).coefficient,
        force=force,
        ball_rate=drive.ball_rate,
        ball_radius=drive.bearing.ball_radius,
    )
    bound = np.where((number < LEAST_WHIRL) | drive.is_squeezed, 0.0, bound)
    share = np.divide(bound, race, out=np.where(bound > 0, np.inf, 0.0), where=race > 0)
    ledger.decide("cage_dynamics", bound=share, lacks=lacks)


def _too_tight(drive: CageDrive) -> str:
    """Why no motion on given balls is computed where they lead too far."""
    lead = float(np.max(np.abs(drive.grip.ball_lead)))
    return (
        f"ball lead up to {length_of(lead)}, free clearance of the pockets {length_of(drive.room)}: the balls squeeze "
        "the cage; a motion on given balls needs wider pockets, less radial load or less moment"
    )


def _too_long(cage: Cage, points: int, most: float, effect: str) -> str | None:
    """What is wrong with a series that takes longer than `auto` allows; None if it does not. most : s of motion."""
    simulated = 2 * cage.duration * (cage.seeds + 1) * points  # start-up and measured time; one more for another start
    longest = most * Cage.steps_per_contact / cage.steps_per_contact
    if simulated <= longest:
        return None
    return (
        f"skipped: {points} points need {simulated:.3g} s of motion, limit {longest:.3g} s at "
        f"{cage.steps_per_contact} steps per contact; give fewer points, seeds or steps, a shorter duration, or "
        f'effects.{effect} = "on"'
    )
