"""A ball in its cage pocket: two half-shells that join in a plane, the force of the ball on them, and its friction.

Frame of the pocket (frame p of the paper): x is the axis of the pocket, from one half-shell to the other. In a stamped
cage, whose halves are riveted together from both sides, x is the axis of the bearing; `Cage.pocket_axis` names it.
Shell s = +1 or -1 is half a sphere of radius D_p/2 on the side of s x. It is k deep, so its centre lies at
x = -s (D_p/2 - k). Offsets are from the centre of the pocket to that of the ball; forces act on the cage.
The ball slides inside nearly equal radii, where Hertz's K_pb is only an estimate; finite elements can replace it. The
sheet bends on its rim with a stiffness k, in series with the contact: delta = (N/K_pb)^(2/3) + N/k.
The forces of both shells are added: the ball touches both at once where |x| < D_p/2 - k, not only at x = 0.
Source: equations 13 to 17 of [Paper]; damping by [Hunt1975], with the loss of an impact derived here.

The friction coefficient is given, or that of mixed lubrication. The pocket stands still against the rotating ball, so
the rolling and entrainment speed is half of the sliding speed. This is far outside the range that film formulas were
fitted to. Between nearly equal radii and under the small forces of a cage the computed film is thicker than the
clearance, and it is limited to the clearance. Oil is then taken to shear in the contact of Hertz alone; its shear in
the rest of the pocket is not in the coefficient.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.geometry import pocket_contact
from analytic.contact.hertz import contact_modulus, loaded_hertz, unit_hertz
from analytic.contact.rolling_contact import ContactNumbers
from analytic.errors import ConvergenceError, InputError, require_non_negative, require_positive
from analytic.numerics.compilation import compiled
from analytic.numerics.elements import rows_of
from analytic.numerics.machine_code import entry
from analytic.numerics.records import dtype_of, record_of
from analytic.oil.film import Inflow, asymptotes_of
from analytic.oil.mixed import LAST_STEP, MOST_STEPS, mixed_contact
from analytic.oil.race_resistance import NO_OIL, SMOOTH_FORM, gap_law_of
from analytic.oil.traction import mean_force, mixed_traction
from analytic.oil.viscosity import OilNumbers, oil_numbers
from analytic.scene import Array, Cage, Scene
from analytic.surface.gap import SMOOTH_GAP, GapForm, GapNumbers, gap_forms

FAST = frozenset(("contract", "reassoc", "arcp", "nsz", "afn"))  # NaN and infinity keep their meaning
SATURATED = 20.0  # |v|/v0 from where tanh is 1 in double precision

LEAST_RESTITUTION = 0.05  # below, the damping force exceeds twenty times the elastic force
# (1 - e)/(1 + e) below which a series of four terms is used: its error is 4e-13, less than that of cancellation.
SMALL_LOSS = 0.03
NEWTON_OF_SHEET = 5  # from at most 1.33 times the root, on a convex function: the error is below 1e-12


def pocket_stiffness(*, ball_diameter: float, pocket_diameter: float, modulus: float) -> float:
    """K_pb = (4/3) E* sqrt(R), N/m^1.5: a ball in a spherical seat by Hertz.

    ball_diameter, pocket_diameter : D_b < D_p, m;  modulus : E*, Pa;  1/R = 2/D_b - 2/D_p
    Raises InputError for a pocket no wider than the ball.
    """
    _require_wider_pocket(ball_diameter, pocket_diameter)
    require_positive(modulus=modulus)
    radius = ball_diameter * pocket_diameter / (2 * (pocket_diameter - ball_diameter))
    return float(4 / 3 * modulus * np.sqrt(radius))


class PocketShape(NamedTuple):
    """Clearance of a ball in the two shells of its pocket."""

    half_clearance: float  # nabla = (D_p - D_b)/2, m
    centre_offset: float  # D_p/2 - k, from the middle of the pocket to the centre of each shell, m


def pocket_shape(*, ball_diameter: float, pocket_diameter: float, pocket_depth: float) -> PocketShape:
    """The shape of a pocket; ball_diameter : D_b, pocket_diameter : D_p, pocket_depth : k, m.

    Raises InputError unless D_b < D_p and D_b/2 < k <= D_p/2: a shell that is less deep than the ball's radius clamps
    the ball.
    """
    _require_wider_pocket(ball_diameter, pocket_diameter)
    require_positive(pocket_depth=pocket_depth)
    if not ball_diameter / 2 < pocket_depth <= pocket_diameter / 2:
        raise InputError(
            f"pocket_depth {pocket_depth!r} m must be above half of ball_diameter {ball_diameter!r} m, else the ball "
            f"is clamped, and at most half of pocket_diameter {pocket_diameter!r} m"
        )
    return PocketShape((pocket_diameter - ball_diameter) / 2, pocket_diameter / 2 - pocket_depth)


@compiled(fastmath=FAST, inline=True)
def elastic_force(stiffness, softness, depth):
    """N, N, of a contact in series with a sheet: depth = (N/K_pb)^(2/3) + N/k.

    stiffness : K_pb, N/m^1.5;  softness : 1/k, m/N, 0: a rigid sheet;  depth : delta, m, > 0
    """
    root = np.sqrt(depth)
    if softness == 0.0:
        return stiffness * depth * root
    share = stiffness * softness
    root = min(root, np.cbrt(depth / share))  # root of the depth of the contact alone, from above
    for _ in range(NEWTON_OF_SHEET):
        root -= (root * root * (1.0 + share * root) - depth) / (root * (2.0 + 3.0 * share * root))
    return stiffness * root * root * root


def impact_damping(restitution: float) -> float:
    """The damping factor l for which an impact ends with the share e of its initial speed; 0 for e = 1.

    restitution : e, LEAST_RESTITUTION to 1
    With y = delta'/v, m y dy = -K delta^1.5 (1 + l y) ddelta/v^2 takes y from 1 to -e over the same indentation:
        l (1 + e) = ln((1 + l)/(1 - l e)),  or  coth(h) - 1/h = (1 - e)/(1 + e)  with  h = l (1 + e)/2
    For small losses this is l = 1.5 (1 - e), the factor in common use. At e = 0.5 that factor would leave 0.6 of the
    speed.
    """
    if not LEAST_RESTITUTION <= restitution <= 1:
        raise InputError(
            f"restitution must be {LEAST_RESTITUTION:g} to 1, got {restitution!r}: the share of its speed that an "
            "impact keeps"
        )
    loss = (1 - restitution) / (1 + restitution)
    if loss < SMALL_LOSS:
        square = loss**2
        half = loss * (3 + square * (9 / 5 + square * (297 / 175 + square * 1539 / 875)))
    else:
        from scipy.optimize import brentq  # a quarter of a second to import

        # 1 - 1/h < coth(h) - 1/h < h/3
        half = brentq(lambda h: 1 / np.tanh(h) - 1 / h - loss, 3 * loss, 1 / (1 - loss), xtol=1e-15, rtol=1e-14)
    return float(2 * half / (1 + restitution))


class Impact(NamedTuple):
    """An impact without friction or loss."""

    indentation: float  # the largest, m
    force: float  # the largest, N
    duration: float  # of the contact, s


def impact(*, mass: float, speed: float, stiffness: float) -> Impact:
    """A mass m hits the spring K delta^1.5 with the speed v: d = (5 m v^2/(4 K))^0.4, F = K d^1.5, t = 2.943 d/v.

    mass : m, reduced, kg;  speed : v, m/s;  stiffness : K, N/m^1.5; all > 0
    The number is 2 int_0^1 dz/sqrt(1 - z^2.5) = 2 sqrt(pi) Gamma(1.4)/Gamma(0.9). The force is proportional to v^1.2.
    """
    require_positive(mass=mass, speed=speed, stiffness=stiffness)
    deepest = (1.25 * mass * speed**2 / stiffness) ** 0.4
    return Impact(deepest, stiffness * deepest**1.5, 2.943275184 * deepest / speed)


def _require_wider_pocket(ball_diameter: float, pocket_diameter: float) -> None:
    require_positive(ball_diameter=ball_diameter, pocket_diameter=pocket_diameter)
    if not pocket_diameter > ball_diameter:
        raise InputError(
            f"pocket_diameter {pocket_diameter!r} m must exceed ball_diameter {ball_diameter!r} m: the ball has no "
            "clearance; usual is 0.1 to 0.3 mm more"
        )


Vector = tuple[float, float, float]


class Body(NamedTuple):
    """The cage as its loads depend on it."""

    place: Vector
    velocity: Vector
    rotation: tuple[float, float, float, float, float, float, float, float, float]  # matrix by rows
    angular_velocity: Vector


class BallInPocket(NamedTuple):
    """A ball as its pocket feels it, in the fixed frame."""

    offset: Vector  # from the centre of the pocket to that of the ball
    axis: Vector  # through the centres of both shells
    centre: Vector  # from the centre of the cage to that of the ball
    velocity: Vector  # of its centre
    rotation: Vector


class Push(NamedTuple):
    """What a ball does to its pocket; powers in W, forces in N."""

    force: Vector
    moment: Vector  # about the centre of the cage
    slip: float  # power lost by friction
    damping: float  # in impacts
    work: float  # power of the ball on the cage
    normal: float  # sum of the normal forces on both shells
    largest: float  # of these forces
    deepest: float  # penetration, m


@compiled(fastmath=FAST, inline=True)
def is_clear(cage, offset, axis):
    """Whether a ball touches neither shell; offset, axis : as in BallInPocket."""
    ux, uy, uz = offset
    along = ux * axis[0] + uy * axis[1] + uz * axis[2]
    reach = cage.half_clearance * cage.half_clearance
    return ux * ux + uy * uy + uz * uz + cage.centre_offset * (2.0 * abs(along) + cage.centre_offset) <= reach


@compiled(fastmath=FAST, inline=True)
def rubbing(cage, normal, speed):
    """mu N tanh(|v|/v0)/|v|, N s/m: friction over the sliding speed, equation 16, smoothed to be defined at v = 0.

    cage : CAGE, with v0 = smoothing, m/s;  normal : N, N;  speed : |v|, m/s
    """
    per_speed = cage.friction * normal
    if speed < SATURATED * cage.smoothing:
        ratio = speed / cage.smoothing
        return per_speed * (np.tanh(ratio) / speed if ratio > 1e-8 else 1.0 / cage.smoothing)
    return per_speed / speed


@compiled(fastmath=FAST, inline=True)
def _pushed_on_shell(cage, ball, body, impact_speed, shell):
    """Push on the shell s = +1 (0) or -1 (1), by equation 13.

        u_s = u + s (D_p/2 - k) x,  delta_s = |u_s| - nabla where that is positive and s u_sx > 0
    The normal force is K delta^1.5 (1 + l delta'/v), at least 0: equation 14 with the loss of [Hunt1975], v the fastest
    closing speed of the contact, l of `impact_damping`.
    """
    ux, uy, uz = ball.offset
    ex, ey, ez = ball.axis
    cx, cy, cz = ball.centre
    bx, by, bz = ball.velocity
    tx, ty, tz = ball.rotation
    vx, vy, vz = body.velocity
    wx, wy, wz = body.angular_velocity
    radius = cage.ball_radius
    aside = cage.centre_offset if shell == 0 else -cage.centre_offset
    nx, ny, nz = ux + aside * ex, uy + aside * ey, uz + aside * ez
    distance = np.sqrt(nx * nx + ny * ny + nz * nz)
    depth = distance - cage.half_clearance
    # Each shell is a half sphere.
    facing = aside == 0.0 or aside * (ux * ex + uy * ey + uz * ez + aside) > 0.0
    if depth <= 0.0 or not facing:
        impact_speed[shell] = 0.0
        return Push((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    nx, ny, nz = nx / distance, ny / distance, nz / distance
    # Velocity of the ball's surface: that of its centre, and its own rotation.
    sx, sy, sz = (
        bx + radius * (ty * nz - tz * ny),
        by + radius * (tz * nx - tx * nz),
        bz + radius * (tx * ny - ty * nx),
    )
    px, py, pz = cx + radius * nx, cy + radius * ny, cz + radius * nz
    gx, gy, gz = sx - vx - wy * pz + wz * py, sy - vy - wz * px + wx * pz, sz - vz - wx * py + wy * px
    closing = gx * nx + gy * ny + gz * nz
    fastest = max(impact_speed[shell], closing, cage.least_impact)
    impact_speed[shell] = fastest
    elastic = elastic_force(cage.stiffness, cage.sheet_softness, depth)
    normal = max(elastic * (1.0 + cage.damping * closing / fastest), 0.0)
    gx, gy, gz = gx - closing * nx, gy - closing * ny, gz - closing * nz
    speed = np.sqrt(gx * gx + gy * gy + gz * gz)
    per_speed = rubbing(cage, normal, speed)
    qx, qy, qz = normal * nx + per_speed * gx, normal * ny + per_speed * gy, normal * nz + per_speed * gz
    return Push(
        (qx, qy, qz),
        (py * qz - pz * qy, pz * qx - px * qz, px * qy - py * qx),
        per_speed * speed * speed,
        (normal - elastic) * closing,
        qx * sx + qy * sy + qz * sz,
        normal,
        normal,
        depth,
    )


@compiled(fastmath=FAST, inline=True)
def pushed(cage, ball, body, impact_speed):
    """Push of a BallInPocket on both shells.

    cage : CAGE of `analytic.cage.motion`;  impact_speed : (2,) m/s of each shell: the fastest closing speed of its
    contact since that began, 0 without contact; it is updated
    """
    one = _pushed_on_shell(cage, ball, body, impact_speed, 0)
    if cage.centre_offset == 0.0:  # both shells are one sphere
        return one
    two = _pushed_on_shell(cage, ball, body, impact_speed, 1)
    return Push(
        (one.force[0] + two.force[0], one.force[1] + two.force[1], one.force[2] + two.force[2]),
        (one.moment[0] + two.moment[0], one.moment[1] + two.moment[1], one.moment[2] + two.moment[2]),
        one.slip + two.slip,
        one.damping + two.damping,
        one.work + two.work,
        one.normal + two.normal,
        max(one.largest, two.largest),
        max(one.deepest, two.deepest),
    )


class PocketNumbers(NamedTuple):
    """A ball on its pocket, in numbers for its friction."""

    coefficient: float  # mu; NaN: by oil and surface
    curvature: float  # of ball against pocket, 1/m, both ways
    modulus: float  # E*, Pa
    largest_gap: float  # m
    gap: GapForm
    boundary_friction: float


NO_POCKET = PocketNumbers(0.0, 1.0, 1.0, 1.0, SMOOTH_FORM, 0.0)


@dataclass(frozen=True, kw_only=True, eq=False)
class PocketFriction:
    """The friction coefficient at every operating point, where it comes from, and its warnings."""

    coefficient: Array  # (n,)
    source: str  # a key of the scene file, or the model
    warnings: tuple[str, ...] = ()


def pocket_gap(scene: Scene, cage: Cage) -> GapNumbers:
    """The gap law of ball and pocket; smooth too where their friction coefficient is given."""
    if cage.friction_coefficient is not None:
        return SMOOTH_GAP
    return gap_law_of(scene, (scene.bearing.ball_material, cage.material))


def pocket_numbers(scene: Scene, cage: Cage, gap: GapForm) -> PocketNumbers:
    """mu of ball on pocket is that of the cage, else that of the races, else by lubricant and surface.

    gap : of `pocket_gap`
    Raises InputError for a scene without any of these.
    """
    given = scene.friction_coefficient if cage.friction_coefficient is None else cage.friction_coefficient
    if given is None and (scene.lubricant is None or scene.surface is None):
        raise InputError("the friction of ball on pocket is not known: add [cage] friction_coefficient = 0.1")
    pocket = pocket_contact(scene.bearing, cage, load=0.0)
    return PocketNumbers(
        coefficient=np.nan if given is None else float(given),
        curvature=1 / pocket.ball_radius - 1 / pocket.groove_radius,
        modulus=float(contact_modulus(pocket.ball_material, pocket.race_material)),
        largest_gap=pocket.groove_radius - pocket.ball_radius,
        gap=gap,
        boundary_friction=0.0 if scene.surface is None else float(scene.surface.boundary_friction),
    )


@compiled
def pocket_coefficient(
    pocket: PocketNumbers, cubics: Array, oil: OilNumbers, load: float, surface_speed: float
) -> tuple[float, bool]:
    """mu, NaN where its film does not settle, and whether the film fills the clearance; load : of one ball, N, > 0.

    cubics : the splines of the gap law
    """
    if not np.isnan(pocket.coefficient):
        return pocket.coefficient, False
    curvature, modulus = pocket.curvature, pocket.modulus
    a = loaded_hertz(unit_hertz(curvature, curvature, modulus), load).semi_axis_x
    contact = ContactNumbers(load, a, a, curvature, curvature, modulus, np.nan, np.nan, np.nan)
    film = asymptotes_of(
        contact, Inflow(surface_speed / 2, oil.viscosity, oil.pressure_viscosity, oil.compressible, pocket.largest_gap)
    )
    gap = GapNumbers(pocket.gap.kind, cubics, pocket.gap.truncated, pocket.gap.elastic)
    mixed = mixed_contact(contact, film, gap, 1.0, 1.0, 0.0)
    law = mixed_traction(oil, pocket.boundary_friction, mixed, 1.0)
    return mean_force(law, contact, surface_speed) / load, mixed.capped


@entry(lambda: {"pocket": dtype_of(PocketNumbers), "cubics": 2, "oil": dtype_of(OilNumbers), "given": 2, "found": 2})
def put_pocket_coefficients(pocket: PocketNumbers, cubics: Array, oil: OilNumbers, given: Array, found: Array) -> None:
    """Write (2, n) of `pocket_coefficient`; given : (2, n) loads, N, and speeds, m/s"""
    for i in range(given.shape[1]):
        found[0, i], found[1, i] = pocket_coefficient(pocket, cubics, oil, given[0, i], given[1, i])


def friction_in_pocket(scene: Scene, *, load: ArrayLike, surface_speed: ArrayLike) -> PocketFriction:
    """mu of ball on pocket, see `pocket_numbers`.

    load : of one ball on the pocket, (n,), N, > 0;  surface_speed : w_b r, (n,), m/s, >= 0
    Raises InputError for a scene without a cage, or for one whose friction is not known; ConvergenceError if load and
    film do not settle.
    """
    if scene.cage is None:
        raise InputError("the scene has no [cage], so there is no pocket: add an empty table [cage] for the catalog's")
    require_positive(load=load)
    require_non_negative(surface_speed=surface_speed)
    if (given := scene.cage.friction_coefficient) is not None:
        everywhere = np.full(np.broadcast(load, surface_speed).shape, float(given))
        return PocketFriction(coefficient=everywhere, source="cage.friction_coefficient", warnings=())
    oil = NO_OIL if scene.lubricant is None else oil_numbers(scene.lubricant)
    (form,), cubics = gap_forms(pocket_gap(scene, scene.cage))
    pocket = record_of(pocket_numbers(scene, scene.cage, form))
    given, shape = rows_of(load, surface_speed)
    found = np.empty_like(given)
    put_pocket_coefficients(pocket, cubics, record_of(oil), given, found)
    coefficient, capped = found.reshape(2, *shape)
    if np.isnan(coefficient).any():
        raise ConvergenceError(
            iterations=MOST_STEPS,
            residual=np.nan,
            tolerance=LAST_STEP,
            unit="of ln(s/(1 - s))",
            problem="the load shared by film and asperities in the cage pockets",
            remedy="Check that load, speed, viscosity and roughness are of ordinary size.",
        )
    source = "mixed lubrication" if np.isnan(pocket.coefficient) else "friction.coefficient"
    warnings = ()
    if np.any(capped):
        warnings = (
            "the computed film in the cage pockets is thicker than their clearance: its formula does not hold between "
            "nearly equal radii, and oil that shears outside the contact is not counted; [cage] friction_coefficient "
            "replaces both",
        )
    return PocketFriction(coefficient=coefficient, source=source, warnings=warnings)
