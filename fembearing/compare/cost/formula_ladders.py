"""The ladders of the closed forms: Hertz's contact, the balls' loads, friction, roughness.

Each question raises InputError, with the reason, where a scene has nothing to compare.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from analytic.contact.hertz import HertzContact, contact_modulus, hertz_contact, relative_curvatures
from analytic.contact.hertz_fitted import fitted_error, hertz_contact_fitted
from analytic.effects.ledger import COMPUTED
from analytic.effects.loads import inertia_shares, points
from analytic.errors import InputError
from analytic.loads.balls import LoadedBalls, ring_balls, thrust_balls_at_speed
from analytic.loads.thrust import ThrustEquilibrium, free_angle, thrust_equilibrium, thrust_equilibrium_frozen
from analytic.scene import Array, Autocorrelation, Contact, Decision, Operation, Scene, Sliding
from analytic.surface.heightmap import FEWEST_POINTS, WIDEST, measure
from analytic.surface.moments import SpectralMoments
from analytic.surface.roughness import generated_surface, spectral_moments
from analytic.torque import friction_torque
from fembearing.compare.contact.scene_contact import contact_of
from fembearing.compare.cost.ladder import ROUND_OFF, Question, Way

HERTZ_FIELDS = ("semi_axis_x", "semi_axis_y", "peak_pressure", "approach")
# Change of the heaviest ball's load over the shares of centrifugal force and gyroscopic pull in it: a rising inner
# angle takes load off the inner race. Chosen on random scenes (validation/benchmarks/choices.py).
PER_CENTRIFUGAL, PER_PULL = 1.5, 1.5
HEAVIEST = 5.0  # times Fr/Z: the heaviest ball under a radial load, as Stribeck rounds his 4.37 up for some clearance
SETTLED = 1e-10  # of two iterations to the same equilibrium, each to its own last step
# The rungs of sliding; the nodes of a quadrature follow from the tolerance.
SLIDING: tuple[tuple[str, Sliding, float], ...] = (
    ("single coefficient", "single_coefficient", 1.0),
    ("along axis", "along_axis", 1.0),
    ("over ellipse, few nodes", "over_ellipse", 1.0),
    ("over ellipse", "over_ellipse", 1e-6),
)
LARGEST_MAP = 2048  # points each way of a generated surface: 0.2 GB while it is made
SEED = 20250  # of the generated surfaces: any will do, and the same every time
# Of one generated surface against its ensemble. The mean square of heights over a square of side L has the standard
# deviation sqrt(2 (integral of rho^2)/L^2) = sqrt(pi) B/L of itself, by either autocorrelation, and Sq half of that:
# a little more than two of those. Slopes and curvatures scatter less. Differences over a spacing d show a smooth
# surface's curvature low by 0.8 (d/B)^2 (analytic.surface.heightmap.measure).
SCATTER, LOW_BY = 2.0, 1.0


def hertz_question(scene: Scene) -> Question:
    """Fitted against exact Hertz, both races in one call."""
    return hertz_question_of((contact_of(scene, pair="inner"), contact_of(scene, pair="outer")))


def hertz_question_of(contacts: Sequence[Contact]) -> Question:
    """Fitted against exact Hertz, all contacts in one call."""
    curvature_x, curvature_y = np.transpose([relative_curvatures(contact) for contact in contacts])
    load = np.array([contact.load for contact in contacts])
    modulus = np.array([contact_modulus(contact.ball_material, contact.race_material) for contact in contacts])

    def compared(formula: Callable[..., HertzContact]) -> Array:
        found = formula(curvature_x=curvature_x, curvature_y=curvature_y, load=load, modulus=modulus)
        return np.array([getattr(found, field) for field in HERTZ_FIELDS])

    return Question(
        quantity="Hertz contact",
        reference=f"exact Hertz; worst of semi-axes, peak pressure and approach of {len(contacts)} contacts",
        ways=(
            Way(
                name="fitted",
                run=lambda: compared(hertz_contact_fitted),
                bound=lambda: float(np.max(fitted_error(curvature_x=curvature_x, curvature_y=curvature_y))),
            ),
            Way(name="exact", run=lambda: compared(hertz_contact), bound=lambda: ROUND_OFF, may_refer=True),
        ),
    )


def load_question(scene: Scene) -> Question:
    """Load of the heaviest ball on each race, worst over the operating points."""
    bearing, rule = scene.bearing, scene.contact_angle
    if rule.rule == "given":
        raise InputError('contact_angle.rule = "given" holds the angle, and thrust gives the loads in closed form')
    operation = points(scene)
    axial = operation.axial_load

    def of_thrust(solve: Callable[..., ThrustEquilibrium]) -> Array:
        return np.stack([solve(bearing, rule, axial_load=axial).ball_load] * 2)

    def unloaded() -> Array:
        return np.stack([axial / (bearing.ball_count * np.sin(_free_angle(scene)))] * 2)

    def with_inertia(solve: Callable[..., LoadedBalls], **sideways: Array | float) -> Array:
        speed = operation.inner_speed
        found = solve(bearing, rule, axial_load=axial, inner_speed=speed, centrifugal=True, gyroscopic=True, **sideways)
        return found.load.max(axis=2)

    def of_ring() -> Array:
        return with_inertia(ring_balls, radial_load=operation.radial_load, moment=operation.moment)

    def sideways() -> Array:
        return _of_alike(scene, operation)

    def beyond_thrust() -> float:
        return float(np.max(sideways() + _of_still(scene, operation))) + SETTLED

    return Question(
        quantity="load of the heaviest ball",
        reference=f"equilibrium of the ring, inertia included; worst of both races at {axial.size} operating points",
        ways=(
            Way(name="free angle", run=unloaded, bound=lambda: _of_free_angle(scene, axial) + beyond_thrust()),
            Way(
                name="thrust, frozen stiffness",
                run=lambda: of_thrust(thrust_equilibrium_frozen),
                bound=lambda: _of_frozen(scene, axial) + beyond_thrust(),
            ),
            Way(name="thrust, solved", run=lambda: of_thrust(thrust_equilibrium), bound=beyond_thrust),
            Way(
                name="thrust, at speed",
                run=lambda: with_inertia(thrust_balls_at_speed),
                bound=lambda: float(np.max(sideways())) + SETTLED,
            ),
            Way(name="equilibrium of the ring", run=of_ring, bound=lambda: ROUND_OFF, may_refer=True),
        ),
    )


def friction_question(scene: Scene) -> Question:
    """Torque of the races by the ways to integrate sliding, with the same effects and the same loads."""
    if not scene.has_friction:
        raise InputError("neither friction.coefficient nor both [lubricant] and [surface] are given")
    if scene.microslip == "as_printed":
        raise InputError('friction.microslip = "as_printed" has one way: the paper\'s moments')
    plain = replace(scene, effects={**scene.effects, "cage": "off"})  # whose motion has a ladder of its own
    decided = friction_torque(plain).effects
    effects: dict[str, Decision] = {each.name: each.decision for each in decided if each.name in COMPUTED}
    if "on" not in (effects.get("spin"), effects.get("conformity")):
        raise InputError("nothing slides: spin and conformity are off")
    asked = replace(scene, effects={**plain.effects, **effects})

    def way(name: str, rung: Sliding, tolerance: float) -> Way:
        of_rung = replace(asked, sliding=rung, tolerance=tolerance)
        return Way(
            name=name,
            run=lambda: friction_torque(of_rung).torque.race,
            bound=lambda: float(np.max(friction_torque(of_rung).numerical_uncertainty)),
            may_refer=name == SLIDING[-1][0],
        )

    return Question(
        quantity="friction torque",
        reference=f"sliding integrated over the ellipse; worst of {points(scene).axial_load.size} operating points",
        ways=tuple(way(*rung) for rung in SLIDING),
    )


def roughness_question(scene: Scene) -> Question:
    """Sq, slope and curvature of the declared surface, root mean squares: in closed form, and of generated surfaces."""
    surface = scene.surface
    if surface is None:
        raise InputError("the scene has no [surface]")
    correlation, rms = surface.autocorrelation, surface.rms_roughness
    if correlation is None or rms is None:
        raise InputError("the surface is measured: its height map is the one way to its moments")
    if rms == 0:
        raise InputError("surface.rms_roughness = 0: a smooth surface has no slopes to compare")

    def compared(moments: SpectralMoments) -> Array:
        return np.sqrt([moments.height, moments.slope, moments.curvature])

    def generated(size: int) -> Array:
        made = generated_surface(rms_roughness=rms, autocorrelation=correlation, points=size, seed=SEED)
        return compared(measure(made).moments)

    least = correlation.length / (WIDEST * correlation.spacing)
    first = int(2 ** np.ceil(np.log2(max(least * (1 - 1e-12), FEWEST_POINTS))))
    sizes = [size for size in (first, 2 * first, 4 * first) if size <= LARGEST_MAP] or [first]
    if correlation.spacing > WIDEST * correlation.length * (1 + 1e-12) or first > 2 * LARGEST_MAP:
        sizes = []  # no surface of it can be generated: too coarse, or too many points
    return Question(
        quantity="roughness",
        reference="closed forms, exact for the declared autocorrelation; worst of Sq, slope and curvature, rms",
        ways=(
            Way(
                name="closed-form moments",
                run=lambda: compared(spectral_moments(rms_roughness=rms, autocorrelation=correlation)),
                bound=lambda: ROUND_OFF,
                may_refer=True,
            ),
            *(
                Way(
                    name=f"generated, {size} x {size}",
                    run=partial(generated, size),
                    bound=partial(_of_generated, correlation, size),
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


def _of_free_angle(scene: Scene, axial_load: Array) -> float:
    """At the free angle the load is too large, and so is the angle that it opens: sin of that over sin al0, less 1."""
    free = _free_angle(scene)
    bearing, rule = scene.bearing, replace(scene.contact_angle, rule="given", value=free)
    opened = thrust_equilibrium(bearing, rule, axial_load=axial_load).approach / bearing.groove_centre_distance
    return float(np.max(np.sin(np.arccos(np.cos(free) / (1 + opened))) / np.sin(free) - 1))


def _of_frozen(scene: Scene, axial_load: Array) -> float:
    """By how much the approach of the contacts, held at the free angle, is off at the angle found.

    Q falls as sin al rises, and ln(tan al) moves by at most 3/2 of the approach's relative change at any angle.
    """
    bearing = scene.bearing
    found = thrust_equilibrium_frozen(bearing, scene.contact_angle, axial_load=axial_load)
    angle = found.contact_angle
    approaches = [
        thrust_equilibrium(bearing, replace(scene.contact_angle, rule="given", value=float(each)), axial_load=load)
        for each, load in zip(np.ravel(angle), np.ravel(axial_load), strict=True)
    ]
    true = np.array([float(each.approach) for each in approaches])
    return float(np.max(np.abs(found.approach / true - 1) * np.cos(angle) ** 2 * 3 / 2))


def _of_alike(scene: Scene, operation: Operation) -> Array:
    """(n,) what radial load and moment do to the heaviest ball of a thrust, of its true load."""
    bearing = scene.bearing
    thrust = thrust_equilibrium(bearing, scene.contact_angle, axial_load=operation.axial_load)
    sideways = np.abs(operation.radial_load) + np.abs(operation.moment) / bearing.pitch_diameter
    unequal = HEAVIEST * sideways / (bearing.ball_count * thrust.ball_load)
    return unequal / (1 + unequal)


def _of_still(scene: Scene, operation: Operation) -> Array:
    """(n,) what the inertia of the balls does to their load under thrust, of the true one."""
    bearing = scene.bearing
    thrust = thrust_equilibrium(bearing, scene.contact_angle, axial_load=operation.axial_load)
    centrifugal, pull = inertia_shares(
        bearing,
        inner_speed=operation.inner_speed,
        contact_angle=thrust.contact_angle,
        load=thrust.ball_load,
    )
    return PER_CENTRIFUGAL * centrifugal + PER_PULL * pull


def _of_generated(correlation: Autocorrelation, size: int) -> float:
    """By chance, as the map holds so many correlation lengths; and by differences where the surface is smooth."""
    scatter = SCATTER * correlation.length / (size * correlation.spacing)
    low = LOW_BY * (correlation.spacing / correlation.length) ** 2 if correlation.kind == "gaussian" else 0.0
    return scatter + low
