"""Decisions about conformity, asperities, inlet heating, starvation and spin, before anything slides.

Shares are relative to the least torque that the scene can have: no spin, oil alone. Each is a bound on what the effect
adds: stresses are taken at the mean pressure of each contact, on a long ellipse, times the largest
error of that (`analytic.sliding.methods.largest_error`).
"""

from dataclasses import dataclass, replace

import numpy as np

from analytic.effects.ledger import Ledger
from analytic.effects.table import ENTRIES
from analytic.loads.balls import LoadedBalls
from analytic.oil.lubricated_races import LubricatedRaces
from analytic.oil.rolling import InletFactors
from analytic.scene import Array, Scene
from analytic.sliding.methods import full_spin_lever, largest_error, largest_spin_lever, rolling_lever

LEAST_FILM = 1e-3  # of the isothermal film, or of smooth surfaces' oil: a bound by less is large enough


@dataclass(frozen=True, kw_only=True, eq=False)
class _Friction:
    """Friction of the contacts while the effects are decided; n operating points, m balls."""

    rolls: Array  # (2, n, m) m: torque by conformity without spin for each N of friction
    spins: Array  # (2, n, m) m: bound on what spin adds to it
    uneven: Array  # (2, n, m) bound on true friction over that of mean stresses
    rolling: Array  # (2, n, m) N: friction of each contact that only rolls
    spinning: Array  # (2, n, m) N: of one that spins in full
    floor: Array  # (n,) N m: the least torque


def decide_whether_sliding(ledger: Ledger) -> bool:
    """Settle conformity. Whether sliding has to be computed: by conformity, or by spin unless the scene says off."""
    return ledger.decide("conformity") or not ledger.rules_out("spin")


def decide_sliding(
    scene: Scene,
    balls: LoadedBalls,
    oiled: LubricatedRaces | None,
    ledger: Ledger,
    *,
    rolled: dict[str, Array],
    inlets: InletFactors | None,
) -> None:
    """Settle asperities, inlet_heating, starvation and spin of balls that slide.

    oiled : None where the friction coefficient is given
    rolled : torques of what rolls without sliding, by effect, (n,), N m;  inlets : None without a lubricant
    """
    beside = _least_rolling(rolled, inlets)
    friction = _least_friction(scene, balls, oiled, conforms=ledger.is_on("conformity"), beside=beside)
    friction = _asperities(oiled, ledger, friction)
    friction = _inlets(balls, oiled, ledger, friction, rolled=rolled, inlets=inlets)
    rise = friction.uneven * (friction.spinning * (friction.rolls + friction.spins) - friction.rolling * friction.rolls)
    least = {"inner_control": rise[1], "outer_control": rise[0]}.get(scene.spin_rule, rise.min(axis=0))
    ledger.decide("spin", bound=_over_floor(balls.total(least[None]), friction.floor))


def decide_without_sliding(ledger: Ledger, *, rolled: dict[str, Array], inlets: InletFactors | None) -> None:
    """Settle the same four where neither spin nor conformity is computed: inlets then act on rolling alone."""
    ledger.decide("asperities", lacks=ENTRIES["asperities"].idle)
    floor, rolling = _least_rolling(rolled, inlets), rolled.get("rolling")
    heated = None if rolling is None or inlets is None else _over_floor((1 - inlets.heating) * rolling, floor)
    ledger.decide("inlet_heating", bound=heated, lacks=ENTRIES["inlet_heating"].idle if heated is None else None)
    _starvation(ledger, floor, rolling, inlets)
    ledger.decide("spin")


def _least_rolling(rolled: dict[str, Array], inlets: InletFactors | None) -> Array:
    """(n,) N m: the torque without sliding, with rolling in inlets that heat and starve."""
    least = dict(rolled)
    if "rolling" in rolled and inlets is not None:
        starved = 1.0 if inlets.starvation is None else inlets.starvation
        least["rolling"] = rolled["rolling"] * (inlets.heating * starved)
    return np.asarray(sum(least.values(), start=0.0))


def _least_friction(
    scene: Scene, balls: LoadedBalls, oiled: LubricatedRaces | None, *, conforms: bool, beside: Array
) -> _Friction:
    """Oil alone, or the given coefficient; beside : (n,) N m, the least of the other torques."""
    rolls = rolling_lever(balls) * conforms  # only what counts: without conformity the least sliding torque is 0
    if oiled is None:
        rolling = spinning = np.asarray(scene.friction_coefficient) * balls.load
    else:
        rolling, spinning = (oiled.oil_friction(slip) for slip in _slips(oiled))
    return _Friction(
        rolls=rolls,
        spins=largest_spin_lever(balls),
        uneven=1 + largest_error(balls, None if oiled is None else oiled.lubricant),
        rolling=rolling,
        spinning=spinning,
        floor=balls.total(rolling * rolls) + beside,
    )


def _slips(oiled: LubricatedRaces) -> list[Array]:
    """Slowest and fastest mean sliding of each contact, (2, n, m), m/s: without spin and with all of it."""
    rolls, speed = rolling_lever(oiled.balls), np.abs(oiled.ring_speed)[:, None]
    return [speed * lever for lever in (rolls, rolls + full_spin_lever(oiled.balls))]


def _asperities(oiled: LubricatedRaces | None, ledger: Ledger, friction: _Friction) -> _Friction:
    if oiled is None:
        ledger.decide("asperities")
        return friction
    # Whether heat thins the film is decided later: asperities are bounded as if it did.
    thinned = 1.0 if ledger.rules_out("inlet_heating") else oiled.heating_factor
    share = oiled.largest_asperity_share(thinned)
    touching = share * _boundary(oiled) * friction.uneven
    # Oil under less load is less viscous by far, and shears beside what touches; its film is hardly thicker.
    left = np.maximum(1 - share - oiled.largest_asperity_area(thinned), 0.0)
    thin = [
        oil - left * oiled.oil_friction(slip, oil_share=1 - share)
        for oil, slip in zip((friction.rolling, friction.spinning), _slips(oiled), strict=True)
    ]
    relieved = np.maximum(*thin) * friction.uneven / np.maximum(thinned, LEAST_FILM)
    most = np.maximum(touching, relieved) * (friction.rolls + friction.spins)
    total = oiled.balls.total
    if not ledger.decide("asperities", bound=_over_floor(total(most), friction.floor)):
        return friction
    lost = np.minimum(relieved / friction.uneven, (1 - LEAST_FILM) * friction.rolling) * friction.rolls
    return replace(
        friction,
        rolling=friction.rolling + touching,
        spinning=friction.spinning + touching,
        floor=friction.floor - total(lost),
    )


def _inlets(
    balls: LoadedBalls,
    oiled: LubricatedRaces | None,
    ledger: Ledger,
    friction: _Friction,
    *,
    rolled: dict[str, Array],
    inlets: InletFactors | None,
) -> _Friction:
    """Heating and starvation."""
    rolling = rolled.get("rolling")
    if inlets is None:
        for name in ("inlet_heating", "starvation"):
            ledger.decide(name)
        return friction
    loss = 0.0 if rolling is None else (1 - inlets.heating) * rolling
    thinner = np.zeros_like(friction.rolling)
    if oiled is not None:
        factor = oiled.heating_factor
        if oiled.lubricant.traction == "eyring_sinh":
            thinner = friction.spinning * (1 / np.maximum(factor, LEAST_FILM) - 1)
        if ledger.is_on("asperities"):
            more = oiled.largest_asperity_share(factor) - oiled.largest_asperity_share()
            thinner = thinner + more * _boundary(oiled)
        loss = loss + balls.total(friction.uneven * thinner * (friction.rolls + friction.spins))
    acts = rolling is not None or oiled is not None
    heated = ledger.decide(
        "inlet_heating",
        bound=_over_floor(np.asarray(loss), friction.floor),
        lacks=None if acts else ENTRIES["inlet_heating"].idle,
    )
    if heated:
        rolling = None if rolling is None else rolling * inlets.heating
        friction = replace(friction, spinning=friction.spinning + thinner)
    _starvation(ledger, friction.floor, rolling, inlets)
    return friction


def _starvation(ledger: Ledger, floor: Array, rolling: Array | None, inlets: InletFactors | None) -> None:
    """rolling : (n,) N m, with inlets that heat where that is on; None: left out."""
    if rolling is None or inlets is None or inlets.starvation is None:
        ledger.decide("starvation", bound=np.zeros_like(floor), lacks=ENTRIES["starvation"].idle)
    else:
        ledger.decide("starvation", bound=_over_floor((1 - inlets.starvation) * rolling, floor))


def _over_floor(part: Array, floor: Array) -> Array:
    """part/floor: a bound on the share of an effect; infinite where there is no other torque."""
    part, floor = np.broadcast_arrays(part, floor)
    return np.divide(part, floor, out=np.where(part > 0, np.inf, 0.0), where=floor > 0)


def _boundary(oiled: LubricatedRaces) -> Array:
    """(2, n, m) N: friction if asperities carried all."""
    return oiled.surface.boundary_friction * oiled.balls.load
