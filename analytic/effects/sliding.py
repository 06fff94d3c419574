"""Which effects of sliding a scene calls for, before anything slides: asperities, inlet heating, starvation, spin.

Shares are told of the least torque that there can be, rolling without spin on oil alone, and they are bounds on what an
effect adds: stresses are taken at the mean pressure of each contact, on a long ellipse, times how much that may miss
(`analytic.sliding.methods.most_missed`).
"""

from dataclasses import dataclass, replace

import numpy as np

from analytic.effects.ledger import Choices, share_in
from analytic.loads.balls import LoadedBalls
from analytic.oil.lubricated_races import LubricatedRaces
from analytic.oil.mixed import MixedContact
from analytic.oil.viscosity import inlet_viscosity
from analytic.scene import Array, Lubricant, Scene
from analytic.sliding.methods import full_spin, largest_spin_rise, most_missed, rolling_power
from fembearing.compare.torque.catalogue_models import inlet_shear_factor, replenishment_factor

LEAST_FILM = 1e-3  # of the isothermal film, or of smooth surfaces' oil: a bound by less is large enough


@dataclass(frozen=True, kw_only=True, eq=False)
class _Rubbing:
    """What is known of sliding as the effects are decided; n operating points, m balls."""

    rolls: Array  # (2, n, m) m: torque by conformity without spin, per N of friction
    spins: Array  # (2, n, m) m: what spin can add to it
    uneven: Array  # (2, n, m) true over found by mean stresses, at most
    force: Array  # (2, n, m) N: friction of each contact that only rolls
    spinning: Array  # (2, n, m) N: of one that spins in full
    floor: Array  # (n,) N m: the least torque


def chosen_lubrication(
    scene: Scene,
    balls: LoadedBalls,
    oiled: LubricatedRaces | None,
    choices: Choices,
    *,
    speed: Array,
    rolled: dict[str, Array],
) -> tuple[MixedContact | None, dict[str, Array]]:
    """The load shared by oil and asperities, and the torques of rolling that heating and starvation leave.

    oiled : None where the friction coefficient is given;  speed : w, (n,), rad/s
    rolled : torques of what rolls without sliding, by effect, (n,), N m
    """
    kept = {} if scene.lubricant is None else _kept_of_rolling(scene, scene.lubricant, speed)
    least = dict(rolled)
    if "rolling" in rolled:
        least["rolling"] = rolled["rolling"] * np.prod(list(kept.values()), axis=0)
    rubbing = _least(scene, balls, oiled, speed, beside=sum(least.values(), start=np.zeros_like(speed)))
    rubbing, asperities = _with_asperities(scene, balls, oiled, choices, speed, rubbing)
    rubbing, heating, rolling = _with_inlets(scene, balls, oiled, choices, rubbing, asperities, kept, rolled)
    _spin(scene, balls, choices, rubbing)
    shared = None if oiled is None else oiled.shared(asperities=asperities, heating_factor=heating)
    return shared, rolled | ({} if rolling is None else {"rolling": rolling})


def _least(scene: Scene, balls: LoadedBalls, oiled: LubricatedRaces | None, speed: Array, *, beside: Array) -> _Rubbing:
    """Oil alone, or the given coefficient; beside : (n,) N m, the least of what else there is."""
    rolls = rolling_power(balls)
    if oiled is None:
        force = spinning = np.asarray(scene.friction_coefficient) * balls.load
    else:
        force, spinning = (oiled.oil_friction(slip) for slip in _slips(balls, speed))
    return _Rubbing(
        rolls=rolls,
        spins=largest_spin_rise(balls),
        uneven=1 + most_missed(balls, None if oiled is None else oiled.lubricant),
        force=force,
        spinning=spinning,
        floor=balls.total(force * rolls) + beside,
    )


def _slips(balls: LoadedBalls, speed: Array) -> list[Array]:
    """Slowest and fastest mean sliding of each contact, (2, n, m), m/s: without spin and with all of it."""
    rolls = rolling_power(balls)
    return [np.abs(speed)[:, None] * lever for lever in (rolls, rolls + full_spin(balls))]


def _with_asperities(
    scene: Scene,
    balls: LoadedBalls,
    oiled: LubricatedRaces | None,
    choices: Choices,
    speed: Array,
    rubbing: _Rubbing,
) -> tuple[_Rubbing, bool]:
    if oiled is None:
        choices.settled("asperities", on=False, reason="the friction coefficient is given")
        return rubbing, False
    # Whether the film is thinned by heat is decided later: asperities are bounded as if it were.
    thinned = 1.0 if scene.effects.get("inlet_heating") == "off" else oiled.heating_factor
    share = oiled.largest_asperity_share(thinned)
    touching = share * _boundary(oiled) * rubbing.uneven
    # Oil that bears less is less viscous by far, and shears beside what touches; its film is hardly thicker.
    left = np.maximum(1 - share - oiled.largest_asperity_area(thinned), 0.0)
    thin = [
        oil - left * oiled.oil_friction(slip, borne=1 - share)
        for oil, slip in zip((rubbing.force, rubbing.spinning), _slips(balls, speed), strict=True)
    ]
    relieved = np.maximum(*thin) * rubbing.uneven / np.maximum(thinned, LEAST_FILM)
    most = np.maximum(touching, relieved) * (rubbing.rolls + rubbing.spins)
    if not choices.calls_for("asperities", share=share_in(balls.total(most), rubbing.floor)):
        return rubbing, False
    lost = np.minimum(relieved / rubbing.uneven, (1 - LEAST_FILM) * rubbing.force) * rubbing.rolls
    return replace(
        rubbing,
        force=rubbing.force + touching,
        spinning=rubbing.spinning + touching,
        floor=rubbing.floor - balls.total(lost),
    ), True


def _with_inlets(
    scene: Scene,
    balls: LoadedBalls,
    oiled: LubricatedRaces | None,
    choices: Choices,
    rubbing: _Rubbing,
    asperities: bool,
    kept: dict[str, Array],
    rolled: dict[str, Array],
) -> tuple[_Rubbing, Array | float, Array | None]:
    """Heating and starvation; with the factor of heating on the film, and the torque of rolling where there is any."""
    if scene.lubricant is None:
        for name in ("inlet_heating", "starvation"):
            choices.calls_for(name, share=None, lacks="no lubricant is given")
        return rubbing, 1.0, None
    rolling = rolled.get("rolling", np.zeros_like(rubbing.floor))
    loss, factor, heating = (1 - kept["inlet_heating"]) * rolling, 1.0, 1.0
    thinner = np.zeros_like(rubbing.force)
    if oiled is not None:
        factor = oiled.heating_factor
        if scene.lubricant.traction == "eyring_sinh":
            thinner = rubbing.spinning * (1 / np.maximum(factor, LEAST_FILM) - 1)
        if asperities:
            more = oiled.largest_asperity_share(factor) - oiled.largest_asperity_share()
            thinner = thinner + more * _boundary(oiled)
        loss = loss + balls.total(rubbing.uneven * thinner * (rubbing.rolls + rubbing.spins))
    if choices.calls_for("inlet_heating", share=share_in(loss, rubbing.floor)):
        heating, rolling = factor, rolling * kept["inlet_heating"]
        rubbing = replace(rubbing, spinning=rubbing.spinning + thinner)
    starved = kept.get("starvation")
    lacks = "bearing.bore_diameter and bearing.outside_diameter are not given" if starved is None else None
    loss = None if starved is None else share_in((1 - starved) * rolling, rubbing.floor)
    if choices.calls_for("starvation", share=loss, lacks=lacks) and starved is not None:
        rolling = rolling * starved
    return rubbing, heating, rolling if "rolling" in rolled else None


def _spin(scene: Scene, balls: LoadedBalls, choices: Choices, rubbing: _Rubbing) -> None:
    rise = rubbing.uneven * (rubbing.spinning * (rubbing.rolls + rubbing.spins) - rubbing.force * rubbing.rolls)
    least = {"inner_control": rise[1], "outer_control": rise[0]}.get(scene.spin_rule, rise.min(axis=0))
    choices.calls_for("spin", share=share_in(balls.total(least[None]), rubbing.floor))


def _kept_of_rolling(scene: Scene, lubricant: Lubricant, speed: Array) -> dict[str, Array]:
    """(n,) of the hydrodynamic rolling torque, what heating and starvation of the inlets leave; by SKF's factors."""
    bearing, nu = scene.bearing, inlet_viscosity(lubricant).viscosity / lubricant.density
    bore, outside = bearing.bore_diameter, bearing.outside_diameter
    mean = bearing.pitch_diameter if bore is None or outside is None else (bore + outside) / 2
    kept = {
        "inlet_heating": inlet_shear_factor(mean_diameter=mean, ring_speed=np.abs(speed), kinematic_viscosity=nu),
    }
    if bore is not None and outside is not None:
        kept["starvation"] = replenishment_factor(
            bore_diameter=bore,
            outside_diameter=outside,
            ring_speed=np.abs(speed),
            kinematic_viscosity=nu,
            lubrication=lubricant.supply,
        )
    return kept


def _boundary(oiled: LubricatedRaces) -> Array:
    """(2, n, m) N: friction if asperities carried all."""
    return oiled.surface.boundary_friction * oiled.balls.load
