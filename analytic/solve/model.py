"""A scene in the numbers that the kernel takes: made once, for any operating point."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from analytic.cage.drive import GRAVITY, pocket_shape_of
from analytic.cage.steady import lead_room
from analytic.contact.factors import ContactCorrection
from analytic.contact.finite_geometry_fit import FitNumbers, fit_record
from analytic.contact.geometry import pocket_contact
from analytic.contact.hertz import contact_modulus
from analytic.effects.declared import declared_torque
from analytic.errors import InputError
from analytic.free_ball.rotation import Creep, quadratures_of
from analytic.free_ball.state import contact_states
from analytic.free_ball.turning import FreeNumbers, free_numbers
from analytic.loads.ring_balance import placed_balls
from analytic.loads.ring_rounds import RingNumbers
from analytic.loads.ring_series import factors_of, ring_numbers, weight_of_ball
from analytic.loads.state import ring_state
from analytic.numerics.records import Record, Records, record_of
from analytic.oil.race_resistance import NO_OIL, SMOOTH_FORM, RaceResistance, gap_law_of, resistance_of
from analytic.oil.variation import NOMINAL, Variation
from analytic.oil.viscosity import OilNumbers, oil_numbers
from analytic.scene import Array, Cage, Scene
from analytic.sliding.judge import NODES, SINGLE_COEFFICIENT
from analytic.sliding.long_ellipse import RULES
from analytic.surface.gap import GapForm, GapLaw, gap_forms


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
    cage: bool


class CageNumbers(NamedTuple):
    """A cage at rest on its balls."""

    mass: float  # kg
    gravity: float  # g along or across the axis, m/s^2
    lies_along: bool  # gravity is along the axis
    drag: float  # N m s
    room: float  # lead of the balls that the pockets leave free, m
    coefficient: float  # of ball on pocket; NaN: by oil and surface
    curvature: float  # of ball against pocket, 1/m, both ways
    modulus: float  # Pa
    largest_gap: float  # m
    gap: GapForm
    boundary_friction: float


class ModelNumbers(NamedTuple):
    """The record of a model."""

    ring: RingNumbers
    arm: float  # R of the inner groove centres, m
    counted: Counted
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
    cage: CageNumbers
    declared: float  # torque of seals and drag, N m


NO_CAGE = CageNumbers(0.0, 0.0, False, 0.0, np.inf, 0.0, 1.0, 1.0, 1.0, SMOOTH_FORM, 0.0)


class Tables(NamedTuple):
    """What a model has of arrays."""

    fit: FitNumbers  # for finite geometry, a record
    cubics: Array  # splines of the gap laws
    nodes: Records  # of contacts that balls by rule slide on, `judge.NODES`
    quadratures: Records  # of contacts of free balls
    factors: Array  # (n or 1, 2, 4, Z or 1) given on Hertz's contacts; (0, 2, 4, 1): none


@dataclass(frozen=True, kw_only=True, eq=False)
class Model:
    """A scene without its operating points."""

    numbers: ModelNumbers  # a record
    tables: Tables
    balls: Records  # (Z,) of `state.BALL_STATE`, at rest
    creep: Creep | None  # of freely turning balls; None: they turn by rule
    temperature: float  # of the oil, K; 0 without

    def at(self, points: NDArray[np.intp]) -> "Model":
        """The model of some operating points: factors that are given belong to points."""
        factors = self.tables.factors
        return self if len(factors) < 2 else replace(self, tables=self.tables._replace(factors=factors[points]))

    def with_numbers(self, **changed: float) -> "Model":
        """The model with other fields of `ModelNumbers`."""
        numbers: Record = cast(Any, self.numbers).copy()
        for name, value in changed.items():
            setattr(numbers, name, value)
        return replace(self, numbers=numbers)


class Workspace(NamedTuple):
    """The state of one operating point after the other: what one leaves is the start of the next."""

    ring: Record  # of `state.RING_STATE`
    balls: Records  # (Z,) of `state.BALL_STATE`
    contacts: Records  # (Z, 2) of `free_ball.state.CONTACT_STATE`


def workspace(model: Model) -> Workspace:
    """A state for one thread."""
    return Workspace(ring_state(), model.balls.copy(), contact_states(len(model.balls)))


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
    effects = Counted(**{name: bool(counted.get(name, False)) for name in Counted._fields})
    bearing = scene.bearing
    ring = ring_numbers(bearing, scene.contact_angle)
    oil = NO_OIL if scene.lubricant is None else oil_numbers(scene.lubricant)
    forms, cubics = gap_forms(*_gap_laws(scene))
    numbers = ModelNumbers(
        ring=ring,
        arm=bearing.inner.bottom_radius + bearing.inner.groove_radius,
        counted=effects,
        farthest=farthest,
        oil=oil,
        warm=oil,
        has_oil=scene.lubricant is not None,
        resistance=resistance_of(scene, forms[:2], lambda name: getattr(effects, name), variation),
        spin_rule=RULES["balanced" if scene.spin_rule == "free" else scene.spin_rule],
        method=method,
        judges=judges,
        free=free_numbers(bearing, creep=creep or "none", inertia=(effects.centrifugal, effects.gyroscopic)),
        allowed=allowed,
        passes=passes,
        cold=cold,
        nearly=nearly,
        cage=NO_CAGE if scene.cage is None else _cage(scene, scene.cage, forms[2]),
        declared=float(declared_torque(scene.losses) or 0.0),
    )
    return Model(
        numbers=record_of(numbers),
        tables=Tables(
            fit=fit_record(),
            cubics=cubics,
            nodes=NODES,
            quadratures=quadratures_of(creep or "none"),
            factors=np.ones((0, 2, 4, 1)) if correction is None else factors_of(correction),
        ),
        balls=placed_balls(bearing, weight=weight_of_ball(bearing, scene.down if effects.weight else None)),
        creep=creep,
        temperature=0.0 if scene.lubricant is None else float(scene.lubricant.temperature),
    )


def _gap_laws(scene: Scene) -> list[GapLaw | None]:
    """Of the balls on inner race, outer race and cage pockets."""
    bearing, ball = scene.bearing, scene.bearing.ball_material
    others = [bearing.inner.material, bearing.outer.material]
    if scene.cage is not None and _pocket_friction(scene, scene.cage) is None:
        others.append(scene.cage.material)
    laws = [gap_law_of(scene, (ball, other)) for other in others]
    return [*laws, None][:3]


def _pocket_friction(scene: Scene, cage: Cage) -> float | None:
    """Friction coefficient of ball on pocket that the scene gives."""
    return scene.friction_coefficient if cage.friction_coefficient is None else cage.friction_coefficient


def _cage(scene: Scene, cage: Cage, gap: GapForm) -> CageNumbers:
    bearing, pocket = scene.bearing, pocket_contact(scene.bearing, cage, load=0.0)
    shape, gravity = pocket_shape_of(bearing, cage), float(np.linalg.norm(GRAVITY[cage.gravity]))
    given = _pocket_friction(scene, cage)
    if given is None and (scene.lubricant is None or scene.surface is None):
        raise InputError("the friction of ball on pocket is not known: add [cage] friction_coefficient = 0.1")
    return CageNumbers(
        mass=cage.mass,
        gravity=gravity,
        lies_along=cage.gravity == "along",
        drag=cage.drag,
        room=lead_room(
            half_clearance=shape.half_clearance,
            centre_offset=shape.centre_offset,
            land_half_clearance=np.inf if cage.land is None else cage.land.clearance / 2,
        ),
        coefficient=np.nan if given is None else float(given),
        curvature=1 / pocket.ball_radius - 1 / pocket.groove_radius,
        modulus=float(contact_modulus(pocket.ball_material, pocket.race_material)),
        largest_gap=pocket.groove_radius - pocket.ball_radius,
        gap=gap,
        boundary_friction=0.0 if given is not None or scene.surface is None else scene.surface.boundary_friction,
    )
