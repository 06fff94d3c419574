"""The torque of balls on races: loads, sliding and rolling together, as the decisions of the scene have it.

The balls are first loaded and turned by closed kinematics. From these it is decided what counts. Where their own axis
counts they then turn freely, which changes loads and angles too, and all is computed from the balls that come out.
"""

from dataclasses import dataclass

import numpy as np

from analytic.contact.factors import ContactCorrection
from analytic.effects.ledger import Ledger, share_in
from analytic.effects.limits import require_on_grooves
from analytic.effects.loads import ChosenBalls, chosen_balls
from analytic.effects.sliding import Resisting, decide_creep, decide_sliding, decide_whether_sliding, mixed_contacts
from analytic.effects.table import ENTRIES
from analytic.errors import require_finite
from analytic.loads.balls import LoadedBalls
from analytic.oil.inlets import inlets_of
from analytic.oil.lubricated_races import lubricate_races
from analytic.oil.mixed import MixedContact
from analytic.oil.rolling import (
    HYSTERESIS_LOSS,
    RollingResistance,
    houpert_rolling,
    hydrodynamic_rolling,
    hysteresis_moment,
    rolling_torque,
)
from analytic.oil.traction import CoulombTraction
from analytic.oil.variation import Variation
from analytic.oil.viscosity import inlet_viscosity
from analytic.scene import Array, Operation
from analytic.sliding.ball import Tractions
from analytic.sliding.methods import Sliding, SlidingModel, race_sliding
from analytic.solve.freely import slide_freely

BY_SLIP = ("spin", "conformity")


@dataclass(frozen=True, kw_only=True, eq=False)
class RaceTorque:
    """What the races resist, and of which balls; (n,) operating points."""

    chosen: ChosenBalls  # with the balls that turn as computed
    parts: dict[str, Array]  # N m
    resisting: Resisting
    resistance: RollingResistance | None  # None: rolling is left out
    mixed: MixedContact | None  # None: nothing slides, or its coefficient is given
    sliding: Sliding | None  # None: nothing slides
    sliding_number: Array | None  # (2, n) of each race; None: nothing slides, or rolling is left out
    gyroscopic_hold: Array | None  # of the worst ball; None: nothing slides, or the moment is left out

    @property
    def balls(self) -> LoadedBalls:
        return self.chosen.balls

    @property
    def total(self) -> Array:
        """(n,) N m."""
        return sum(self.parts.values(), start=np.zeros(self.balls.load.shape[1]))

    @property
    def sliding_part(self) -> Array:
        """(n,) N m, the part by spin and conformity."""
        slipping = (part for name, part in self.parts.items() if name in BY_SLIP)
        return sum(slipping, start=np.zeros(self.balls.load.shape[1]))


def race_torque(
    ledger: Ledger, operation: Operation, *, correction: ContactCorrection | None, variation: Variation
) -> RaceTorque:
    """The races' part of the torque; settles every effect of balls and races.

    operation : the scene's, every array (n,);  correction, variation : as in `analytic.torque.friction_torque`
    Raises InputError and ConvergenceError as the loads and the sliding do.
    """
    scene, speed = ledger.scene, operation.inner_speed
    require_finite(**{"operation.inner_speed": speed})
    chosen = chosen_balls(scene, operation, ledger, correction=correction)
    ledger.decide("hysteresis")
    ledger.decide("rolling")
    slides = decide_whether_sliding(ledger)
    resisting, resistance = _resisting(ledger, chosen.balls, speed, slides=slides, variation=variation)
    estimate = decide_sliding(scene, resisting, ledger, slides=slides)
    creep = decide_creep(scene, estimate, ledger, slides=slides)
    turns = slides and not ledger.rules_out("gyroscopic") and ENTRIES["gyroscopic"].lacks(scene) is None
    sliding: Sliding | None = None
    mixed = estimate.decided
    allowed = scene.tolerance - ledger.left_out

    if slides and creep is not None:
        # Where there is no contact, the search for the balls' rotation takes seconds.
        require_on_grooves(scene.bearing, operation, chosen.balls)
        free = slide_freely(
            scene,
            {name: ledger.is_on(name) for name in ledger.made},
            creep=creep,
            correction=correction,
            variation=variation,
            allowed=float(np.min(allowed)),
        )
        chosen, sliding = chosen.turning(free.balls), free.sliding
        resisting, resistance = _resisting(ledger, chosen.balls, speed, slides=slides, variation=variation)
        mixed = mixed_contacts(ledger, resisting)
    if slides and sliding is None:
        model = SlidingModel(
            spins=ledger.is_on("spin"),
            conforms=ledger.is_on("conformity"),
            spin_rule="balanced" if scene.spin_rule == "free" else scene.spin_rule,
            microslip=scene.microslip,
            method=scene.sliding,
        )
        laws = _tractions(ledger, resisting, mixed)
        sliding = race_sliding(
            chosen.balls, laws, model, ring_speed=speed, other_torque=_other(ledger, resisting), allowed=allowed
        )
    parts = {"hysteresis": resisting.constant} if ledger.is_on("hysteresis") else {}
    if resisting.rolling is not None:
        parts["rolling"] = _rolled(ledger, resisting)
    if sliding is not None:
        parts |= {name: getattr(sliding, name) for name in BY_SLIP if ledger.is_on(name)}
    races = RaceTorque(
        chosen=chosen,
        parts=parts,
        resisting=resisting,
        resistance=resistance,
        mixed=mixed,
        sliding=sliding,
        sliding_number=estimate.sliding_number() if slides else None,
        gyroscopic_hold=estimate.gyroscopic_hold(scene) if turns else None,
    )
    reason = ENTRIES["hysteresis"].lacks(scene)
    if reason is not None:
        most = share_in(_hysteresis(chosen.balls, HYSTERESIS_LOSS[1]), races.total)
        ledger.settle("hysteresis", on=False, share=most, reason=reason)
    return races


def _hysteresis(balls: LoadedBalls, loss: float) -> Array:
    """(n,) torque by hysteresis, N m; loss : alpha'."""
    return balls.total(hysteresis_moment(balls.contacts, hysteresis_loss=loss) * balls.contacts.rolling_rate)


def _other(ledger: Ledger, resisting: Resisting) -> Array:
    """(n,) torque by all but sliding, N m."""
    return resisting.constant if resisting.rolling is None else resisting.constant + _rolled(ledger, resisting)


def _rolled(ledger: Ledger, resisting: Resisting) -> Array:
    """(n,) torque by hydrodynamic rolling, N m."""
    assert resisting.rolling is not None
    assert resisting.inlets is not None
    left = resisting.inlets.rolling_factor(heats=ledger.is_on("inlet_heating"), starves=ledger.is_on("starvation"))
    return resisting.balls.total(resisting.rolling * left)


def _resisting(
    ledger: Ledger, balls: LoadedBalls, speed: Array, *, slides: bool, variation: Variation
) -> tuple[Resisting, RollingResistance | None]:
    """What resists the balls; speed : w, (n,), rad/s."""
    scene, lubricant = ledger.scene, ledger.scene.lubricant
    constant = np.zeros(balls.load.shape[1])
    if ledger.is_on("hysteresis"):
        assert scene.hysteresis_loss is not None
        constant = _hysteresis(balls, scene.hysteresis_loss)
    resistance: RollingResistance | None = None
    rolling: Array | None = None
    if ledger.is_on("rolling"):
        assert lubricant is not None
        oil, entrainment = inlet_viscosity(lubricant), speed[:, None] * balls.motion.entrainment_speed
        if variation.rolling_formula == "houpert":
            resistance = houpert_rolling(
                balls.contacts,
                viscosity=oil.viscosity,
                pressure_viscosity=oil.pressure_viscosity,
                entrainment_speed=entrainment,
            )
        else:
            resistance = hydrodynamic_rolling(balls.contacts, viscosity=oil.viscosity, entrainment_speed=entrainment)
        rolling = variation.rolling * rolling_torque(resistance, entrainment_rate=balls.motion.entrainment_speed)
    oiled = None
    if slides and lubricant is not None and scene.surface is not None:
        oiled = lubricate_races(
            scene.bearing,
            balls,
            lubricant=lubricant,
            surface=scene.surface,
            ring_speed=speed,
            variation=variation,
        )
    resisting = Resisting(
        balls=balls,
        constant=constant,
        rolling=rolling,
        inlets=None if lubricant is None else inlets_of(scene.bearing, balls, lubricant, ring_speed=speed),
        oiled=oiled,
        friction_coefficient=scene.friction_coefficient or 0.0,
    )
    return resisting, resistance


def _tractions(ledger: Ledger, resisting: Resisting, mixed: MixedContact | None) -> Tractions:
    oiled = resisting.oiled
    if oiled is None or mixed is None:
        assert ledger.scene.friction_coefficient is not None
        law = CoulombTraction(friction_coefficient=ledger.scene.friction_coefficient)
        return law, law
    return oiled.traction(mixed.race(0)), oiled.traction(mixed.race(1))
