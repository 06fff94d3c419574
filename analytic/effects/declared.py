"""Losses that the scene declares: torques of seals and drag, and oil outside the contacts, by its own formulas.

Nothing is decided here: a loss counts if its input is declared. A loss of the oil without its input has an estimate by
usual values, which says whether it could matter.
"""

from dataclasses import replace

import numpy as np

from analytic.effects.ledger import SWITCHED_OFF, Ledger, share_in
from analytic.effects.table import (
    DECLARED,
    ENTRIES,
    JET_RISE,
    OIL_HEAT,
    OIL_LOSSES,
    USUAL_POCKETS,
    USUAL_SHARE,
)
from analytic.errors import InputError, require_non_negative
from analytic.oil.losses import StirredOil, stirred_oil
from analytic.oil.viscosity import oil_numbers
from analytic.scene import Array, Losses, Scene, ShearedPockets


def scene_losses(ledger: Ledger, computed: Array, speed: Array, factor: float) -> dict[str, Array]:
    """Parts that there are, (n,) N m: "oil" outside the contacts, "declared" of seals and drag; settles all of them.

    computed : (n,) N m, the torque of all that is computed;  speed : (n,) rad/s;  factor : on the losses of the oil
    Raises InputError for a loss below 0, for an input of a loss of the oil that is off, and as `stirred_oil`.
    """
    scene, losses = ledger.scene, ledger.scene.losses
    given = {name: getattr(losses, name) for name in DECLARED}
    require_non_negative(**{f"losses.{name}": value for name, value in given.items() if value is not None})
    declared, stirred = losses.total, stirred_oil(scene, losses)
    parts = {} if stirred is None else _parts(scene, stirred, speed, factor)
    found = {"oil": np.sum([*parts.values()], axis=0)} if parts else {}
    if declared is not None:
        found["declared"] = np.full_like(computed, declared)
    total = sum(found.values(), start=computed)
    for name, value in given.items():
        share = None if value is None else share_in(np.full_like(total, value), total)
        if name == "seals" and value is None and scene.bearing.seals_rub:
            share = np.full_like(total, np.inf)
        lacks, origin = ENTRIES[name].lacks(scene), losses.origins.get(name)
        given_by = ENTRIES[name].given if origin is None else f"{origin.status}: {origin.source}"
        ledger.settle(name, on=lacks is None, share=share, reason=lacks or given_by)
    for name in OIL_LOSSES:
        lacks, is_off = ENTRIES[name].lacks(scene), ledger.rules_out(name)
        if lacks is None and is_off:
            raise InputError(f'effects.{name} = "off" contradicts its input in [losses]: leave one of them out')
        if lacks is None:
            ledger.settle(name, on=True, share=share_in(parts[name], total), reason=ENTRIES[name].given)
            continue
        share = _estimate(scene, name, speed, total)
        usual = "" if share is None else "; size estimated from usual values"
        ledger.settle(name, on=False, share=share, reason=f"{SWITCHED_OFF if is_off else lacks}{usual}")
    return found


def _parts(scene: Scene, stirred: StirredOil, speed: Array, factor: float) -> dict[str, Array]:
    """(n,) N m of each of OIL_LOSSES."""
    assert scene.lubricant is not None
    viscosity = oil_numbers(scene.lubricant).viscosity
    return {
        "through_flow": factor * stirred.through_flow(speed),
        "cage_shear": factor * stirred.cage_shear(speed, viscosity),
        "ball_drag": factor * stirred.ball_drag(speed, viscosity),
    }


def _estimate(scene: Scene, name: str, speed: Array, total: Array) -> Array | None:
    """(n,) share of a loss of the oil that lacks its input, by usual values; None: not known, or counted elsewhere."""
    oil, ball, losses = scene.lubricant, scene.bearing.ball_diameter, scene.losses
    if oil is None or oil.supply not in USUAL_SHARE:
        return None
    if name == "cage_shear" and scene.cage is not None and not scene.cage.gives_way:
        return None
    if name == "ball_drag" and losses.drag is not None:
        return None
    pockets = ShearedPockets(clearance=USUAL_POCKETS[0] * ball, thickness=USUAL_POCKETS[1] * ball)
    usual = stirred_oil(replace(scene, cage=None), Losses(oil_share=USUAL_SHARE[oil.supply], pockets=pockets))
    assert usual is not None
    if name != "through_flow":
        return share_in(_parts(scene, usual, speed, 1.0)[name], total)
    if oil.supply != "oil_jet":
        return None
    accelerated = (2 * usual.ball_rate * speed) ** 2 / (OIL_HEAT * JET_RISE)
    return np.divide(accelerated, 1 - accelerated, out=np.full(total.shape, np.inf), where=accelerated < 1)
