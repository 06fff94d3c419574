"""The ladders of the closed forms: Hertz's contact, the balls' loads, friction, roughness.

Each function raises InputError, with the reason, for a scene that has nothing to compare.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from analytic.contact.hertz import HertzContact, contact_modulus, hertz_contact, relative_curvatures
from analytic.contact.hertz_fitted import fitted_error, hertz_contact_fitted
from analytic.effects import ruled
from analytic.errors import InputError
from analytic.free_ball.rotation import LEVELS as FREE_NODES
from analytic.loads.inertia import moment_of_turned_axis, outward_force
from analytic.loads.kinematics import BallMotion, ball_kinematics
from analytic.loads.numbers import free_angle
from analytic.loads.ring import ring_equilibrium
from analytic.loads.state import approaches
from analytic.loads.thrust import thrust_equilibrium, thrust_equilibrium_frozen
from analytic.numerics.elements import mapped
from analytic.numerics.records import Records
from analytic.scene import Array, Autocorrelation, Contact, Operation, Scene
from analytic.sliding.ball import LEVELS as ELLIPSE_NODES
from analytic.surface.heightmap import FEWEST_POINTS, WIDEST, measure
from analytic.surface.moments import SpectralMoments
from analytic.surface.roughness import generated_surface, spectral_moments
from analytic.torque import friction_torque
from fembearing.check.contact.scene_contact import contact_of
from fembearing.check.cost.ladder import ROUND_OFF, UntimedLadder, UntimedMethod

HERTZ_FIELDS = ("semi_axis_x", "semi_axis_y", "peak_pressure", "approach")
# Relative change of the heaviest ball's load per share of centrifugal force and of gyroscopic pull in it: a larger
# inner angle unloads the inner race. Chosen on random scenes (validation/benchmarks/choices.py).
PER_CENTRIFUGAL, PER_PULL = 1.5, 1.5
HEAVIEST = 5.0  # times Fr/Z: load of the heaviest ball under a radial load; Stribeck's 4.37, rounded up for clearance
SETTLED = 1e-10  # difference of two iterations to the same equilibrium
# Tolerances that begin with each level of nodes, from coarse to fine; a level that misses half of its tolerance is left
# for the next one
LEVELS = (0.05, 5e-3, 5e-4, 1e-6)
LARGEST_MAP = 2048  # points along a side of a generated surface: takes 0.2 GB
SEED = 20250  # of the generated surfaces: arbitrary, but the same every time
# Deviation of one generated surface from its ensemble. On a square of side L the mean square height has the relative
# standard deviation sqrt(2 (integral of rho^2)/L^2) = sqrt(pi) B/L, with either autocorrelation, and Sq half of that;
# SCATTER is a little more than two of these. Slopes and curvatures scatter less. Differences over a spacing d make a
# smooth surface's curvature too small by 0.8 (d/B)^2 (analytic.surface.heightmap.measure).
SCATTER, LOW_BY = 2.0, 1.0


def hertz_methods(scene: Scene) -> UntimedLadder:
    """Fitted and exact Hertz, both races in one call."""
    return hertz_methods_of((contact_of(scene, pair="inner"), contact_of(scene, pair="outer")))


def hertz_methods_of(contacts: Sequence[Contact]) -> UntimedLadder:
    """Fitted and exact Hertz, all contacts in one call."""
    curvature_x, curvature_y = np.transpose([relative_curvatures(contact) for contact in contacts])
    load = np.array([contact.load for contact in contacts])
    modulus = np.array([contact_modulus(contact.ball_material, contact.race_material) for contact in contacts])

    def compared(formula: Callable[..., HertzContact]) -> Array:
        ellipses = formula(curvature_x=curvature_x, curvature_y=curvature_y, load=load, modulus=modulus)
        return np.array([getattr(ellipses, field) for field in HERTZ_FIELDS])

    return UntimedLadder(
        quantity="Hertz contact",
        reference=f"exact Hertz; worst of semi-axes, peak pressure and approach of {len(contacts)} contacts",
        methods=(
            UntimedMethod(
                name="fitted",
                run=lambda: compared(hertz_contact_fitted),
                bound=lambda: float(np.max(fitted_error(curvature_x=curvature_x, curvature_y=curvature_y))),
            ),
            UntimedMethod(name="exact", run=lambda: compared(hertz_contact), bound=lambda: ROUND_OFF, may_refer=True),
        ),
    )


def load_methods(scene: Scene) -> UntimedLadder:
    """Load of the heaviest ball on each race at every operating point; by thrust alone where each point has thrust."""
    bearing, rule = scene.bearing, scene.contact_angle
    if rule.rule == "given":
        raise InputError('contact_angle.rule = "given" fixes the angle, and thrust gives the loads in closed form')
    operation = scene.operation.as_series()
    axial = operation.axial_load

    def of_thrust(solve: Callable[..., Records], **given: Any) -> Array:
        return solve(bearing, rule, axial_load=axial, **given)["load"].T

    def unloaded() -> Array:
        return np.stack([axial / (bearing.ball_count * np.sin(_free_angle(scene)))] * 2)

    def of_ring() -> Array:
        tilt, loads = operation.held_tilt, {"axial_load": axial, "radial_load_x": operation.radial_load}
        found = ring_equilibrium(
            bearing,
            rule,
            **loads,
            moment_y=operation.moment,
            tilts=None if np.isnan(tilt) else (0.0, tilt),
            inner_speed=operation.inner_speed,
        )
        return found.balls["load"].max(axis=1).T

    def unequal() -> Array:
        return _bound_without_radial_load(scene, operation)

    def beyond_thrust() -> float:
        return float(np.max(unequal() + _bound_without_inertia(scene, operation))) + SETTLED

    of_thrusts = (
        UntimedMethod(
            name="free angle", run=unloaded, bound=lambda: _bound_at_free_angle(scene, axial) + beyond_thrust()
        ),
        UntimedMethod(
            name="thrust, frozen stiffness",
            run=lambda: of_thrust(thrust_equilibrium_frozen),
            bound=lambda: _bound_of_frozen(scene, axial) + beyond_thrust(),
        ),
        UntimedMethod(name="thrust, solved", run=lambda: of_thrust(thrust_equilibrium), bound=beyond_thrust),
        UntimedMethod(
            name="thrust, at speed",
            run=lambda: of_thrust(thrust_equilibrium, inner_speed=operation.inner_speed),
            bound=lambda: float(np.max(unequal())) + SETTLED,
        ),
    )
    return UntimedLadder(
        quantity="load of the heaviest ball",
        reference=f"equilibrium of the ring, inertia included; worst of both races at {axial.size} operating points",
        methods=(
            *(of_thrusts if np.all(axial > 0) else ()),
            UntimedMethod(
                name="equilibrium of the ring",
                run=of_ring,
                bound=lambda: ROUND_OFF,
                may_refer=True,
            ),
        ),
    )


def friction_methods(scene: Scene) -> UntimedLadder:
    """Torque of the races by the nodes that integrate sliding over the ellipses, with closed kinematics."""
    _require_sliding(scene)
    rule = "balanced" if scene.spin_rule == "free" else scene.spin_rule
    points = scene.operation.as_series().axial_load.size
    return UntimedLadder(
        quantity="friction torque",
        reference=f"sliding integrated over the ellipses; worst of {points} operating points",
        methods=tuple(
            _method(f"over ellipses, from {n} by {m} nodes", replace(scene, spin_rule=rule, tolerance=tolerance))
            for (n, m), tolerance in zip(ELLIPSE_NODES, LEVELS, strict=True)
        ),
    )


def turning_methods(scene: Scene) -> UntimedLadder:
    """Torque of the races by how the balls turn: by rule, or freely with or without creep.

    Nothing bounds what a rule and rigid surfaces miss.
    """
    _require_sliding(scene)
    free = replace(scene, spin_rule="free")
    if reason := ruled(free):
        raise InputError(f"the balls do not turn freely: {reason}")
    points = scene.operation.as_series().axial_load.size
    rigid = replace(free, effects={**scene.effects, "creep": "off"})
    return UntimedLadder(
        quantity="how balls turn",
        reference=f"torque of free balls, creep marched through many nodes; worst of {points} operating points",
        methods=(
            _method("rule of balanced spin", replace(scene, spin_rule="balanced"), misses=np.inf),
            _method("free balls without creep", rigid, misses=np.inf),
            *(
                _method(f"with marched creep, from {n} by {m} nodes", replace(free, tolerance=tolerance))
                for (n, m), tolerance in zip(FREE_NODES, LEVELS, strict=True)
            ),
        ),
    )


def _method(name: str, scene: Scene, misses: float = 0.0) -> UntimedMethod:
    plain = replace(scene, effects={**scene.effects, "cage": "off"})
    return UntimedMethod(
        name=name,
        run=lambda: friction_torque(plain).settled().torque.race,
        bound=lambda: float(np.max(friction_torque(plain).numerical_uncertainty)) + misses,
        may_refer=scene.tolerance == LEVELS[-1],
    )


def _require_sliding(scene: Scene) -> None:
    if not scene.has_friction:
        raise InputError("neither friction.coefficient nor both [lubricant] and [surface] are given")
    if scene.microslip == "as_printed":
        raise InputError('friction.microslip = "as_printed" has one method: the paper\'s moments')
    if scene.effects.get("spin") == scene.effects.get("conformity") == "off":
        raise InputError("nothing slides: spin and conformity are off")


def roughness_methods(scene: Scene) -> UntimedLadder:
    """Rms height (Sq), slope and curvature of the declared surface: in closed form, and of generated surfaces."""
    surface = scene.surface
    if surface is None:
        raise InputError("the scene has no [surface]")
    correlation, rms = surface.autocorrelation, surface.rms_roughness
    if correlation is None or rms is None:
        raise InputError("the surface is measured: its height map is the only method for its moments")
    if rms == 0:
        raise InputError("surface.rms_roughness = 0: a smooth surface has no slopes to compare")

    def compared(moments: SpectralMoments) -> Array:
        return np.sqrt([moments.height, moments.slope, moments.curvature])

    def generated(size: int) -> Array:
        surface = generated_surface(rms_roughness=rms, autocorrelation=correlation, points=size, seed=SEED)
        return compared(measure(surface).moments)

    least = correlation.length / (WIDEST * correlation.spacing)
    first = int(2 ** np.ceil(np.log2(max(least * (1 - 1e-12), FEWEST_POINTS))))
    sizes = [size for size in (first, 2 * first, 4 * first) if size <= LARGEST_MAP] or [first]
    if correlation.spacing > WIDEST * correlation.length * (1 + 1e-12) or first > 2 * LARGEST_MAP:
        sizes = []  # none can be generated: the spacing is too coarse, or there are too many points
    return UntimedLadder(
        quantity="roughness",
        reference="closed forms, exact for the given autocorrelation; worst of Sq, slope and curvature, rms",
        methods=(
            UntimedMethod(
                name="closed-form moments",
                run=lambda: compared(spectral_moments(rms_roughness=rms, autocorrelation=correlation)),
                bound=lambda: ROUND_OFF,
                may_refer=True,
            ),
            *(
                UntimedMethod(
                    name=f"generated, {size} x {size}",
                    run=partial(generated, size),
                    bound=partial(_bound_of_generated, correlation, size),
                )
                for size in sizes
            ),
        ),
    )


def _free_angle(scene: Scene) -> float:
    rule = scene.contact_angle
    free = free_angle(scene.bearing) if rule.free is None else rule.free
    if free is None:
        raise InputError("a preloaded bearing has no free contact angle")
    if free == 0:
        raise InputError("at a free contact angle of 0 no ball carries thrust")
    return free


def _bound_at_free_angle(scene: Scene, axial_load: Array) -> float:
    """sin al/sin al0 - 1: at the free angle al0 the load is too large, and so is the angle al that it opens."""
    free = _free_angle(scene)
    bearing, rule = scene.bearing, replace(scene.contact_angle, rule="given", value=free)
    opened = approaches(thrust_equilibrium(bearing, rule, axial_load=axial_load)).sum(axis=-1)
    opened = opened / bearing.groove_centre_distance
    return float(np.max(np.sin(np.arccos(np.cos(free) / (1 + opened))) / np.sin(free) - 1))


def _bound_of_frozen(scene: Scene, axial_load: Array) -> float:
    """Bound from the error of the approach at the loaded angle, with the contacts' stiffness held at the free angle.

    Q falls as sin al rises, and ln(tan al) changes by at most 3/2 of the approach's relative change at any angle.
    """
    bearing = scene.bearing
    frozen = thrust_equilibrium_frozen(bearing, scene.contact_angle, axial_load=axial_load)
    angle, approach = frozen["angle"][..., 0], approaches(frozen).sum(axis=-1)
    balls = [
        thrust_equilibrium(bearing, replace(scene.contact_angle, rule="given", value=float(each)), axial_load=load)
        for each, load in zip(np.ravel(angle), np.ravel(axial_load), strict=True)
    ]
    true = np.array([float(approaches(each).sum()) for each in balls])
    return float(np.max(np.abs(approach / true - 1) * np.cos(angle) ** 2 * 3 / 2))


def _bound_without_radial_load(scene: Scene, operation: Operation) -> Array:
    """(n,) effect of radial load and moment on the load of the heaviest ball, relative to its true load."""
    bearing = scene.bearing
    thrust = thrust_equilibrium(bearing, scene.contact_angle, axial_load=operation.axial_load)
    sideways = np.abs(operation.radial_load) + np.abs(operation.moment) / bearing.pitch_diameter
    unequal = HEAVIEST * sideways / (bearing.ball_count * thrust["load"][..., 0])
    return unequal / (1 + unequal)


def _bound_without_inertia(scene: Scene, operation: Operation) -> Array:
    """(n,) effect of the balls' inertia on their load under thrust, relative to the true load."""
    bearing = scene.bearing
    thrust = thrust_equilibrium(bearing, scene.contact_angle, axial_load=operation.axial_load)
    angle, speed = thrust["angle"][..., 0], operation.inner_speed
    motion = BallMotion._make(
        mapped(ball_kinematics, speed, angle, angle, bearing.pitch_diameter, bearing.ball_diameter)
    )
    outward = outward_force(bearing.ball_mass, bearing.pitch_diameter, motion.cage_speed)
    upright = moment_of_turned_axis(
        bearing.ball_mass, bearing.ball_diameter, motion.ball_speed, motion.cage_speed, np.pi / 2
    )
    pull = upright * np.cos(angle) / bearing.ball_radius  # of the friction that holds the moment, along the axis
    return (PER_CENTRIFUGAL * outward + PER_PULL * pull) / thrust["load"][..., 0]


def _bound_of_generated(correlation: Autocorrelation, size: int) -> float:
    """Scatter, from the number of correlation lengths in the map, and on a smooth surface the error of differences."""
    scatter = SCATTER * correlation.length / (size * correlation.spacing)
    low = LOW_BY * (correlation.spacing / correlation.length) ** 2 if correlation.kind == "gaussian" else 0.0
    return scatter + low
