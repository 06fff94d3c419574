"""A scene in the numbers that the kernel takes: made once, for any operating point."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from analytic.cage.drive import resting_cage
from analytic.cage.pocket import NO_POCKET, PocketNumbers, pocket_gap, pocket_numbers
from analytic.cage.steady import RestingCage
from analytic.contact.factors import ContactCorrection
from analytic.contact.finite_geometry_fit import POWERS, FitNumbers, fit_record
from analytic.errors import require_non_negative
from analytic.free_ball.rotation import free_quadratures
from analytic.free_ball.state import contact_states, scratch
from analytic.free_ball.turning import FreeNumbers, free_numbers, outer_groove_centres
from analytic.loads.ring_balance import placed_balls
from analytic.loads.ring_rounds import RingNumbers
from analytic.loads.ring_series import ring_numbers, weight_of_ball
from analytic.loads.state import factors_of, ring_state
from analytic.numerics.records import Record, Records, copied, record_in, record_of
from analytic.oil.law_table import kept_table
from analytic.oil.race_resistance import NO_OIL, RaceResistance, gap_law_of, resistance_of
from analytic.oil.variation import NOMINAL, Variation
from analytic.oil.viscosity import OilNumbers, oil_numbers
from analytic.scene import Array, Cage, Lubricant, Operation, OwnTraction, Scene
from analytic.sliding.ball import NODES
from analytic.sliding.long_ellipse import RULES
from analytic.surface.gap import SMOOTH_GAP, GapNumbers, gap_forms


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
    creep: bool  # of the surfaces of free balls
    cage: bool


class ModelNumbers(NamedTuple):
    """The record of a model."""

    ring: RingNumbers
    arm: float  # R of the inner groove centres, m
    counted: Counted
    tilt: float  # of the ring about y, at which it is held, rad; NaN: it tilts freely
    weighs_alike: bool  # the weights count under thrust alone too, where their direction is given
    oil: OilNumbers  # at the scene's temperature
    warm: OilNumbers  # at that of the last operating point
    has_oil: bool
    resistance: RaceResistance
    spin_rule: int  # of `long_ellipse.RULES`
    as_printed: bool  # moments of micro-slip as [Paper] prints them
    free: FreeNumbers
    level: int  # of nodes, the first one, from 0
    allowed: float  # error of sliding, relative to the torque, beyond which the next level follows
    cold: bool  # free balls of every operating point begin by rule
    cage: RestingCage
    pocket: PocketNumbers
    declared: float  # torque of seals and drag, N m


NO_CAGE = RestingCage(0.0, 0.0, False, 0.0, np.inf, 1, 1.0, 1.0)

# Along x, as a radial load: the direction of gravity where the scene gives none. Under thrust alone it is across the
# axis, where the weights of balls that are alike cancel around the bearing to first order.
ALONG_THE_LOAD = (1.0, 0.0, 0.0)
LIMITS = (0.01, 0.001, 0.0001)  # tolerances, see `first_level`


class Tables(NamedTuple):
    """What a model has of arrays."""

    fit: FitNumbers  # for finite geometry, a record
    cubics: Array  # splines of the gap laws
    nodes: Records  # of contacts that balls by rule slide on, `sliding.ball.NODES`
    quadratures: Records  # of contacts of free balls, `free_ball.rotation.free_quadratures`
    law: Array  # table of a user's law of traction; (0, 0): none
    factors: Array  # (n or 1, 2, 4, Z or 1) given on Hertz's contacts; (0, 2, 4, 1): none


@dataclass(frozen=True, kw_only=True, eq=False)
class Model:
    """A scene without its operating points."""

    numbers: ModelNumbers  # a record
    tables: Tables
    balls: Records  # (Z,) of `state.BALL_STATE`, at rest
    is_free: bool  # whether the balls turn as friction has it; else by rule
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


class Workspace(NamedTuple):
    """The state of one operating point after the other: what one leaves is the start of the next."""

    ring: Record  # of `state.RING_STATE`
    balls: Records  # (Z,) of `state.BALL_STATE`
    contacts: Records  # (Z, 2) of `free_ball.state.CONTACT_STATE`
    scratch: Record  # of `free_ball.state.SCRATCH`
    powers: Array  # of `finite_geometry_fit.geometry_of`


def workspace(model: Model) -> Workspace:
    """A state for one thread."""
    contacts = contact_states(len(model.balls))
    return Workspace(ring_state(), copied(model.balls), contacts, scratch(), np.zeros(POWERS))


def first_level(tolerance: float) -> int:
    """Level of nodes of `sliding.ball.LEVELS` and `free_ball.rotation.LEVELS` that a tolerance begins with, from 0.

    tolerance : of the torque, relative
    From 1 % on the first, from 0.1 % on the second, from 0.01 % on the third, else the fourth. Free balls take the next
    one after it, which is compared with it: levels miss up to 2.5, 0.7 and 0.1 % of the torque of a 6205 by sliding.
    """
    return sum(tolerance < limit for limit in LIMITS)


def model_of(
    scene: Scene,
    counted: Mapping[str, bool],
    *,
    free: bool,
    correction: ContactCorrection | None = None,
    variation: Variation = NOMINAL,
) -> Model:
    """The model of a scene.

    counted : whether each effect of `Counted` counts; those left out do not
    free : whether the balls turn as friction has it; else by the scene's spin rule
    correction : factors on Hertz's contacts in place of those of the fit;  variation : of the formulas
    Models that differ in the operating points alone are one, which is kept. Raises InputError as the formulas do that
    take the scene's numbers.
    """
    parts = (*(Same(getattr(scene, name)) for name in OF_MODEL), Same(correction), Same(variation))
    tilt = None if np.isnan(scene.operation.held_tilt) else scene.operation.held_tilt
    return _kept_model(parts, tilt, tuple(counted.items()), free).with_numbers()


@dataclass(frozen=True, eq=False)
class Same:
    """A key by identity, of something that does not change."""

    it: Any

    def __hash__(self) -> int:
        return id(self.it)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Same) and other.it is self.it


# What a model has of a scene besides the tilt and the effects that count.
OF_MODEL = (
    *("bearing", "contact_angle", "cage", "lubricant", "surface", "friction_coefficient", "hysteresis_loss"),
    *("elastic_rolling", "losses", "spin_rule", "microslip", "down", "tolerance"),
)


@lru_cache(maxsize=16)
def _kept_model(
    parts: tuple[Same, ...], tilt: float | None, counted: tuple[tuple[str, bool], ...], free: bool
) -> Model:
    """As `model_of`; parts : of OF_MODEL, correction and variation, which the cache keeps alive;  tilt : None: free"""
    *values, correction, variation = (part.it for part in parts)
    nowhere = Operation(axial_load=np.zeros(1), inner_speed=np.zeros(1))
    scene = Scene(operation=nowhere, **dict(zip(OF_MODEL, values, strict=True)))
    effects, bearing = _counted_of(dict(counted)), scene.bearing
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
        tilt=np.nan if tilt is None else tilt,
        weighs_alike=scene.down is not None,
        oil=oil,
        warm=oil,
        has_oil=scene.lubricant is not None,
        resistance=resistance_of(scene, forms[:2], lambda name: getattr(effects, name), variation),
        spin_rule=RULES["balanced" if scene.spin_rule == "free" else scene.spin_rule],
        as_printed=scene.microslip == "as_printed",
        free=free_numbers(bearing, orbit=orbit, creeps=effects.creep, inertia=inertia),
        level=first_level(scene.tolerance),
        allowed=scene.tolerance / 2,
        cold=True,
        cage=NO_CAGE if cage is None else resting_cage(bearing, cage),
        pocket=NO_POCKET if cage is None else pocket_numbers(scene, cage, forms[2]),
        declared=float(scene.losses.total or 0.0),
    )
    weight = weight_of_ball(bearing, scene.down or ALONG_THE_LOAD) if effects.weight else (0.0, 0.0, 0.0)
    return Model(
        numbers=record_of(numbers),
        tables=_tables_of(scene, cubics, correction),
        balls=placed_balls(bearing, weight=weight),
        is_free=free,
        temperature=0.0 if scene.lubricant is None else float(scene.lubricant.temperature),
    )


def _tables_of(scene: Scene, cubics: Array, correction: ContactCorrection | None) -> Tables:
    return Tables(
        fit=fit_record(),
        cubics=cubics,
        nodes=NODES,
        quadratures=free_quadratures(),
        law=_law_of(scene.lubricant),
        factors=np.ones((0, 2, 4, 1)) if correction is None else factors_of(correction),
    )


def _law_of(lubricant: Lubricant | None) -> Array:
    law = None if lubricant is None else lubricant.traction
    return kept_table(law) if isinstance(law, OwnTraction) else np.zeros((0, 0))


def _counted_of(counted: Mapping[str, bool]) -> Counted:
    return Counted(*(bool(counted.get(name, False)) for name in Counted._fields))


def _gap_laws(scene: Scene, cage: Cage | None) -> list[GapNumbers]:
    """Of the balls on inner race, outer race and cage pockets."""
    bearing, ball = scene.bearing, scene.bearing.ball_material
    races = [gap_law_of(scene, (ball, groove.material)) for groove in (bearing.inner, bearing.outer)]
    return [*races, SMOOTH_GAP if cage is None else pocket_gap(scene, cage)]
