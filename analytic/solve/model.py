"""A scene in the numbers that the kernel takes: made once, for any operating point."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from analytic.cage.drive import resting_cage
from analytic.cage.pocket import NO_POCKET, PocketNumbers, pocket_gap, pocket_numbers
from analytic.cage.steady import RestingCage
from analytic.contact.factors import ContactCorrection
from analytic.contact.finite_geometry_fit import FitNumbers, fit_record
from analytic.errors import require_non_negative
from analytic.free_ball.rotation import Creep, quadratures_of
from analytic.free_ball.state import QUADRATURE, contact_states
from analytic.free_ball.turning import FreeNumbers, free_numbers, outer_groove_centres
from analytic.loads.ring_balance import placed_balls
from analytic.loads.ring_rounds import RingNumbers
from analytic.loads.ring_series import factors_of, ring_numbers, weight_of_ball
from analytic.loads.state import ring_state
from analytic.numerics.records import Record, Records, copied, record_in, record_of
from analytic.oil.law_table import kept_table
from analytic.oil.race_resistance import NO_OIL, RaceResistance, gap_law_of, resistance_of
from analytic.oil.variation import NOMINAL, Variation
from analytic.oil.viscosity import OilNumbers, oil_numbers
from analytic.scene import Array, Bearing, Cage, Lubricant, OwnTraction, Scene
from analytic.sliding.judge import NODES, SINGLE_COEFFICIENT
from analytic.sliding.long_ellipse import RULES
from analytic.surface.gap import GapLaw, gap_forms


class Counted(NamedTuple):
    """Which effects count."""

    load_distribution: bool
    weight: bool
    centrifugal: bool
    gyroscopic: bool
    finite_geometry: bool
    asperities: bool
    inlet_heating: bool
    starvation: bool
    spin: bool
    conformity: bool
    hysteresis: bool
    rolling: bool  # resistance of the oil to it
    unloaded_balls: bool  # in oil: they roll too
    cage: bool


class ModelNumbers(NamedTuple):
    """The record of a model."""

    ring: RingNumbers
    arm: float  # R of the inner groove centres, m
    counted: Counted
    tilt: float  # of the ring about y, at which it is held, rad; NaN: it tilts freely
    farthest: bool  # finite geometry by the factors at the far end of what is not known outside the fit's range
    oil: OilNumbers  # at the scene's temperature
    warm: OilNumbers  # at that of the last operating point
    has_oil: bool
    resistance: RaceResistance
    spin_rule: int  # of `long_ellipse.RULES`
    method: int  # of sliding, as numbered in `analytic.sliding.judge`
    judges: bool  # the error of the method is estimated
    free: FreeNumbers
    allowed: float  # error of the sliding of free balls, relative to the whole torque
    passes: int  # quadrature of free balls; 0: the first that is accurate enough
    cold: bool  # free balls of every operating point begin by rule
    nearly: bool  # one rough pass is enough for free balls whose start is known
    cage: RestingCage
    pocket: PocketNumbers
    declared: float  # torque of seals and drag, N m


NO_CAGE = RestingCage(0.0, 0.0, False, 0.0, np.inf, 1, 1.0, 1.0)


NO_QUADRATURES: Records = np.zeros(0, QUADRATURE)


class Tables(NamedTuple):
    """What a model has of arrays."""

    fit: FitNumbers  # for finite geometry, a record
    cubics: Array  # splines of the gap laws
    nodes: Records  # of contacts that balls by rule slide on, `judge.NODES`
    quadratures: Records  # of contacts of free balls; none of balls by rule
    law: Array  # table of a user's law of traction; (0, 0): none
    factors: Array  # (n or 1, 2, 4, Z or 1) given on Hertz's contacts; (0, 2, 4, 1): none


@dataclass(frozen=True, kw_only=True, eq=False)
class Model:
    """A scene without its operating points."""

    numbers: ModelNumbers  # a record
    tables: Tables
    balls: Records  # (Z,) of `state.BALL_STATE`, at rest
    weights: Array  # (Z, 2) of the balls, radial and axial, N; 0 where their direction is not known
    creep: Creep | None  # of freely turning balls; None: they turn by rule
    temperature: float  # of the oil, K; 0 without

    def at(self, points: NDArray[np.intp]) -> "Model":
        """The model of some operating points: factors that are given belong to points.

        Parameters
        ----------
        points : ndarray, shape (k,)
            Numbers of the points, from 0.

        Returns
        -------
        Model
            Of k points.
        """
        factors = self.tables.factors
        return self if len(factors) < 2 else replace(self, tables=self.tables._replace(factors=factors[points]))

    def with_numbers(self, **changed: float) -> "Model":
        """The model with other fields of `ModelNumbers`.

        Parameters
        ----------
        **changed : float
            By their names, each in the unit of its field.

        Returns
        -------
        Model
            With a record of its own.
        """
        numbers = copied(self.numbers)
        for name, value in changed.items():
            numbers[name] = value
        return replace(self, numbers=record_in(numbers))

    def counting(self, counted: Mapping[str, bool]) -> "Model":
        """The model with other effects; those that are not named do not count.

        Parameters
        ----------
        counted : mapping of str to bool
            Whether each effect of `Counted` counts.

        Returns
        -------
        Model
            With a record of its own.
        """
        numbers, effects = copied(self.numbers), _counted_of(counted)
        numbers["counted"] = effects
        resistance = numbers["resistance"]
        resistance["rolls"] = effects.rolling
        resistance["elastic"] = effects.hysteresis
        for race in ("inner", "outer"):
            lubrication = resistance[race]
            supply = lubrication["supply"]
            lubrication["asperities"], lubrication["heats"] = effects.asperities, effects.inlet_heating
            known = supply["churned"][0] or not (np.isnan(supply["degree"][0]) and np.isnan(supply["rate"][0]))
            lubrication["starves"] = effects.starvation and known
        return replace(self, numbers=record_in(numbers), balls=self._weighed(self.weights * effects.weight))

    def turning_freely(self, bearing: Bearing, creep: Creep) -> "Model":
        """The model with balls that turn as friction has it.

        Parameters
        ----------
        bearing : Bearing
            That of the model.
        creep : str
            How the surfaces creep: none, closed or marched.

        Returns
        -------
        Model
            With a record of its own.
        """
        numbers = copied(self.numbers)
        counted = numbers["counted"]
        inertia = bool(counted["centrifugal"][0]), bool(counted["gyroscopic"][0])
        orbit = float(numbers["free"]["orbit"][0])
        numbers["free"] = record_of(free_numbers(bearing, orbit=orbit, creep=creep, inertia=inertia))
        tables = self.tables._replace(quadratures=quadratures_of(creep))
        return replace(self, numbers=record_in(numbers), creep=creep, tables=tables)

    def weighing(self, weights: Array) -> "Model":
        """The model with balls of this weight.

        Parameters
        ----------
        weights : ndarray, shape (Z, 2)
            Radial and axial, N.

        Returns
        -------
        Model
            With balls of its own.
        """
        return replace(self, weights=weights, balls=self._weighed(weights))

    def _weighed(self, weights: Array) -> Records:
        balls = copied(self.balls)
        balls["weight"] = weights
        return balls


class Workspace(NamedTuple):
    """The state of one operating point after the other: what one leaves is the start of the next."""

    ring: Record  # of `state.RING_STATE`
    balls: Records  # (Z,) of `state.BALL_STATE`
    contacts: Records  # (Z, 2) of `free_ball.state.CONTACT_STATE`


def workspace(model: Model) -> Workspace:
    """A state for one thread."""
    return Workspace(ring_state(), copied(model.balls), contact_states(len(model.balls)))


def model_of(
    scene: Scene,
    counted: Mapping[str, bool],
    *,
    method: int = SINGLE_COEFFICIENT,
    judges: bool = True,
    creep: Creep | None = None,
    allowed: float = 0.0,
    passes: int = 0,
    cold: bool = True,
    nearly: bool = False,
    correction: ContactCorrection | None = None,
    farthest: bool = False,
    variation: Variation = NOMINAL,
) -> Model:
    """The model of a scene.

    counted : whether each effect of `Counted` counts; those left out do not
    method, judges : for balls that turn by rule, as in `ModelNumbers`
    creep : how the surfaces of freely turning balls creep; None: the balls turn by the scene's spin rule
    allowed, passes, cold, nearly, farthest : as in `ModelNumbers`
    correction : factors on Hertz's contacts in place of those of the fit;  variation : of the formulas
    Raises InputError as the formulas do that take the scene's numbers.
    """
    effects, bearing = _counted_of(counted), scene.bearing
    boundary = 0.0 if scene.surface is None else scene.surface.boundary_friction
    require_non_negative(ball_mass=bearing.ball_mass, hysteresis_loss=scene.loss_factor, boundary_friction=boundary)
    oil = NO_OIL if scene.lubricant is None else oil_numbers(scene.lubricant)
    cage = scene.cage if effects.cage else None
    forms, cubics = gap_forms(*_gap_laws(scene, cage))
    ring = ring_numbers(bearing, scene.contact_angle)
    orbit, inertia = outer_groove_centres(bearing, ring.bearing), (effects.centrifugal, effects.gyroscopic)
    numbers = ModelNumbers(
        ring=ring,
        arm=bearing.inner.bottom_radius + bearing.inner.groove_radius,
        counted=effects,
        tilt=scene.operation.held_tilt,
        farthest=farthest,
        oil=oil,
        warm=oil,
        has_oil=scene.lubricant is not None,
        resistance=resistance_of(scene, forms[:2], lambda name: getattr(effects, name), variation),
        spin_rule=RULES["balanced" if scene.spin_rule == "free" else scene.spin_rule],
        method=method,
        judges=judges,
        free=free_numbers(bearing, orbit=orbit, creep=creep or "none", inertia=inertia),
        allowed=allowed,
        passes=passes,
        cold=cold,
        nearly=nearly,
        cage=NO_CAGE if cage is None else resting_cage(bearing, cage),
        pocket=NO_POCKET if cage is None else pocket_numbers(scene, cage, forms[2]),
        declared=float(scene.losses.total or 0.0),
    )
    balls, weights = placed_balls(bearing), weights_of(bearing, scene.down)
    if effects.weight:
        balls["weight"] = weights
    return Model(
        numbers=record_of(numbers),
        tables=_tables_of(scene, cubics, creep, correction),
        balls=balls,
        weights=weights,
        creep=creep,
        temperature=0.0 if scene.lubricant is None else float(scene.lubricant.temperature),
    )


def _tables_of(scene: Scene, cubics: Array, creep: Creep | None, correction: ContactCorrection | None) -> Tables:
    return Tables(
        fit=fit_record(),
        cubics=cubics,
        nodes=NODES,
        quadratures=NO_QUADRATURES if creep is None else quadratures_of(creep),
        law=_law_of(scene.lubricant),
        factors=np.ones((0, 2, 4, 1)) if correction is None else factors_of(correction),
    )


def _law_of(lubricant: Lubricant | None) -> Array:
    law = None if lubricant is None else lubricant.traction
    return kept_table(law) if isinstance(law, OwnTraction) else np.zeros((0, 0))


def _counted_of(counted: Mapping[str, bool]) -> Counted:
    return Counted(*(bool(counted.get(name, False)) for name in Counted._fields))


def weights_of(bearing: Bearing, down: tuple[float, float, float] | None) -> Array:
    """(Z, 2) of the balls, radial and axial, N; down : direction of gravity, of length 1; None: not known"""
    if down is None:
        return np.zeros((bearing.ball_count, 2))
    return placed_balls(bearing, weight=weight_of_ball(bearing, down))["weight"].copy()


def _gap_laws(scene: Scene, cage: Cage | None) -> list[GapLaw | None]:
    """Of the balls on inner race, outer race and cage pockets."""
    bearing, ball = scene.bearing, scene.bearing.ball_material
    races = [gap_law_of(scene, (ball, groove.material)) for groove in (bearing.inner, bearing.outer)]
    return [*races, None if cage is None else pocket_gap(scene, cage)]
