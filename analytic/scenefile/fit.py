"""Whether the parts of a bearing fit together: rings, balls, shoulders and cage.

Every check is geometry of the unloaded bearing. A preload that elastic contacts can carry is accepted.
"""

from collections.abc import Container, Iterator

import numpy as np

from analytic.loads.numbers import play_and_free_angle
from analytic.scene import Arrangement, Bearing, Cage, ContactAngle, Surface
from analytic.words import MILLIMETRE, angle_of

# Interference on the diameter over the ball diameter: several times that at which a steel race yields (about 0.8 %), so
# that plastic balls are accepted.
LARGEST_PRELOAD = 0.05
BOTTOM = "bearing.outer.bottom_radius"
LARGEST_MASS_ERROR = 0.05  # of the mass of a solid ball, without a warning; rounding in tables gives 1 %


def bearing_misfits(bearing: Bearing, *, gap_key: str = BOTTOM, own: Container[str] = ()) -> Iterator[tuple[str, str]]:
    """(path of the key, problem) for each impossible dimension of the bearing.

    gap_key : path of the key that says how far the rings are apart
    own : keys of [bearing] that the scene gives itself; the others come from the catalogue
    """
    ball, bore, outside = bearing.ball_diameter, bearing.bore_diameter, bearing.outside_diameter
    if bore is not None and outside is not None and not bore < outside:
        both = "bore_diameter" in own and "outside_diameter" in own
        if "outside_diameter" in own and not both:
            yield "bearing.outside_diameter", f"must exceed bore_diameter {_mm(bore)}"
        else:
            remedy = ": exchange them" if both else ""
            yield "bearing.bore_diameter", f"must be below outside_diameter {_mm(outside)}{remedy}"
        return
    if "ball_diameter" in own and (room := _room(bearing, own)) <= ball:
        yield "bearing.ball_diameter", f"does not fit: rings and neighbouring balls leave {_mm(room)}"
        return
    possible = True
    for name, ring in (("inner", bearing.inner), ("outer", bearing.outer)):
        if not ring.groove_radius > ball / 2:
            possible = False
            yield (
                f"bearing.{name}.groove_radius",
                f"must exceed the ball radius {_mm(ball / 2)} (equal radii are a line contact); "
                f"usual are {_mm(0.51 * ball)} to {_mm(0.54 * ball)}",
            )
        for key in ("shoulder_half_width", "far_shoulder_half_width"):
            half_width = getattr(ring, key)
            if half_width is not None and not half_width < ring.groove_radius:
                possible = False
                yield f"bearing.{name}.{key}", f"must be below groove_radius {_mm(ring.groove_radius)}"
    if not possible:
        return
    if bearing.kind == "thrust":
        yield from _washer_misfits(bearing)
    else:
        if not bearing.outer.groove_radius < bearing.outer.bottom_radius:
            yield "bearing.outer.groove_radius", f"must be below bottom_radius {_mm(bearing.outer.bottom_radius)}"
        yield from _ring_misfits(bearing, gap_key)
        yield from _boundary_misfits(bearing, own)
    if crowded := crowding(bearing):
        yield "bearing.ball_count", crowded


def crowding(bearing: Bearing) -> str | None:
    """Why so many balls do not fit side by side; None: they do."""
    ball = bearing.ball_diameter
    if bearing.ball_count <= 1 or pitch_chord(bearing) >= ball:
        return None
    half_angle = np.arcsin(min(1.0, ball / bearing.pitch_diameter))
    return (
        f"leaves {_mm(pitch_chord(bearing))} from ball to ball, less than ball_diameter {_mm(ball)}; "
        f"at most {int(np.pi / half_angle + 1e-9)} fit"
    )


def angle_misfits(bearing: Bearing, angle: ContactAngle) -> Iterator[tuple[str, str]]:
    """The same for a contact angle beyond a shoulder."""
    shoulder = _shoulder_angle(bearing)
    for name, value in (("value", angle.value), ("free", angle.free)):
        if value is not None and not value < shoulder:
            yield f"bearing.contact_angle.{name}", f"must be below the shoulder's angle, {angle_of(shoulder)}"


def arrangement_misfits(bearing: Bearing, angle: ContactAngle, arrangement: Arrangement) -> Iterator[tuple[str, str]]:
    """The same for an offset that presses balls onto their shoulders, or further than elastic contacts can carry."""
    if arrangement.offset is None:
        return
    play, _ = play_and_free_angle(bearing, angle)
    distance = bearing.groove_centre_distance
    across = distance - play
    # Along the axis, from grooves in line to where a ball touches both, is pressed that far, and is at its shoulder.
    touching = np.sqrt(max(play, 0.0) * (2 * distance - play))
    pressed = np.sqrt((distance + LARGEST_PRELOAD * bearing.ball_diameter / 2) ** 2 - across**2)
    shoulder = across * np.tan(min(_shoulder_angle(bearing), 1.57))
    limit = 2 * max(min(pressed, shoulder) - touching, 0.0)
    if arrangement.offset > limit:
        why = "there the balls reach a shoulder" if shoulder < pressed else "elastic contacts do not carry more"
        yield "arrangement.offset", f"must be at most {limit * 1e6:.4g} um: {why}"


def cage_misfits(bearing: Bearing, cage: Cage, *, pocket: str, pockets_may_overlap: bool) -> Iterator[tuple[str, str]]:
    """The same for the cage; pocket : the key that gives the diameter of the pocket."""
    diameter, chord = cage.pocket_diameter, pitch_chord(bearing)
    if not diameter > bearing.ball_diameter:
        yield f"cage.{pocket}", f"must exceed ball_diameter {_mm(bearing.ball_diameter)}; usual is 0.1 to 0.3 mm more"
    if not cage.pocket_depth <= diameter / 2:
        yield "cage.pocket_depth", f"must be at most half of the pocket diameter, {_mm(diameter / 2)}"
    elif not cage.pocket_depth > bearing.ball_radius and diameter > bearing.ball_diameter:
        yield (
            "cage.pocket_depth",
            f"must exceed the ball radius {_mm(bearing.ball_radius)}, else its halves clamp the ball",
        )
    if not cage.wall_thickness < cage.pocket_depth:
        yield "cage.wall_thickness", f"must be below the pocket depth {_mm(cage.pocket_depth)}"
    if bearing.ball_count > 1 and not pockets_may_overlap:
        if not diameter < chord:
            yield (
                f"cage.{pocket}",
                f"makes neighbouring pockets overlap: their diameter {_mm(diameter)} must be below the pitch chord "
                f"d_m sin(pi/Z) = {_mm(chord)}",
            )
        elif not cage.wall_thickness <= chord - diameter:
            yield "cage.wall_thickness", f"must be at most the web between pockets, {_mm(chord - diameter)}"


def surface_misfits(
    surface: Surface | None, bearing: Bearing, cage: Cage | None, *, is_lubricated: bool
) -> Iterator[tuple[str, str]]:
    """The same for summits that yield in a body of unknown hardness."""
    if surface is None or surface.hardness is not None or not is_lubricated:
        return
    if surface.gap == "elastic" or surface.asperities == "greenwood_williamson":  # these never yield
        return
    bodies = [bearing.ball_material, bearing.inner.material, bearing.outer.material]
    if cage is not None and cage.friction_coefficient is None:
        bodies.append(cage.material)
    for body in bodies:
        if body.hardness is None:
            yield "surface.hardness", f"is missing, and {body.name} has none: give one, for bearing steel about 7.8 GPa"
            return


def warnings(bearing: Bearing, cage: Cage | None) -> Iterator[str]:
    """What is possible and yet probably a mistake."""
    expected = bearing.ball_material.density * np.pi / 6 * bearing.ball_diameter**3
    if abs(bearing.ball_mass - expected) > LARGEST_MASS_ERROR * expected:
        yield (
            f"bearing.ball_mass {bearing.ball_mass * 1e3:.4g} g is not that of a solid ball of "
            f"{bearing.ball_material.name}, {expected * 1e3:.4g} g: was it left behind when the ball was changed?"
        )
    if cage is not None and bearing.ball_count > 1 and not cage.pocket_diameter < pitch_chord(bearing):
        yield (
            f"cage.pocket_diameter {_mm(cage.pocket_diameter)} is not below the pitch chord "
            f"{_mm(pitch_chord(bearing))}: neighbouring pockets overlap, no such cage can be made"
        )


def pitch_chord(bearing: Bearing) -> float:
    """d_m sin(pi/Z): distance between the centres of neighbouring balls, m; 0 for one ball."""
    return bearing.pitch_diameter * float(np.sin(np.pi / bearing.ball_count))


def _room(bearing: Bearing, own: Container[str]) -> float:
    """What a ball may fill, m: between bore and outside diameter, and to the next ball if the count is not own."""
    room = np.inf
    if bearing.kind == "radial" and bearing.bore_diameter is not None and bearing.outside_diameter is not None:
        room = (bearing.outside_diameter - bearing.bore_diameter) / 2
    return min(room, pitch_chord(bearing)) if bearing.ball_count > 1 and "ball_count" not in own else room


def _shoulder_angle(bearing: Bearing) -> float:
    """The contact angle at the lower of the shoulders that thrust loads, rad; infinite where none is known."""
    grooves = ((ring.shoulder_half_width, ring.groove_radius) for ring in (bearing.inner, bearing.outer))
    return min((float(np.arcsin(width / radius)) for width, radius in grooves if width is not None), default=np.inf)


def _washer_misfits(bearing: Bearing) -> Iterator[tuple[str, str]]:
    """Problems of a thrust bearing: washers that touch each other, grooves that leave no washer."""
    ball, middle = bearing.ball_diameter, bearing.pitch_diameter / 2
    if not ball < 2 * middle:
        yield "bearing.pitch_diameter", f"must exceed ball_diameter {_mm(ball)}"
    inside, outside = bearing.bore_diameter, bearing.outside_diameter
    if inside is not None and not inside < 2 * middle:
        yield "bearing.bore_diameter", f"must be below pitch_diameter {_mm(2 * middle)}"
    if outside is not None and not outside > 2 * middle:
        yield "bearing.outside_diameter", f"must exceed pitch_diameter {_mm(2 * middle)}"
    if rises := _touching_shoulders(bearing):
        yield (
            "bearing.inner.shoulder_half_width",
            f"and that of the outer ring raise the shoulders by {_mm(rises[0])} and {_mm(rises[1])}, together more "
            f"than ball_diameter {_mm(ball)}: the washers touch",
        )


def _ring_misfits(bearing: Bearing, gap_key: str) -> Iterator[tuple[str, str]]:
    clearance, distance = bearing.diametral_clearance, bearing.groove_centre_distance
    lowest = -LARGEST_PRELOAD * bearing.ball_diameter
    if clearance < lowest:
        yield (
            gap_key,
            f"leaves {_mm(bearing.outer.bottom_radius - bearing.inner.bottom_radius)} between the grooves "
            f"for a ball of {_mm(bearing.ball_diameter)}: the clearance must be at least {_mm(lowest)}, a preload of "
            f"{LARGEST_PRELOAD:.0%} of the ball",
        )
    if not clearance < 2 * distance:
        yield (
            gap_key,
            f"leaves a diametral clearance of {_mm(clearance)}, which must be below 2 (r_gi + r_go - D) = "
            f"{_mm(2 * distance)}: no contact angle closes it",
        )
    if rises := _touching_shoulders(bearing):
        lands = bearing.inner.bottom_radius + rises[0], bearing.outer.bottom_radius - rises[1]
        yield (
            "bearing.inner.shoulder_half_width",
            f"and that of the outer ring raise the shoulders to radii {_mm(lands[0])} and {_mm(lands[1])}: "
            "the rings touch",
        )


def _boundary_misfits(bearing: Bearing, own: Container[str]) -> Iterator[tuple[str, str]]:
    """Problems of the seats and the width, where they are given."""
    moved = "pitch_diameter" in own
    bore, outside, width = bearing.bore_diameter, bearing.outside_diameter, bearing.width
    if bore is not None and not bore < 2 * bearing.inner.bottom_radius:
        limit = _mm(2 * bearing.inner.bottom_radius)
        if moved and "bore_diameter" not in own:
            yield "bearing.pitch_diameter", f"puts the inner groove's bottom at {limit}, within the bore of {_mm(bore)}"
        else:
            yield "bearing.bore_diameter", f"must be below the inner groove's bottom, {limit} in diameter"
    if outside is not None and not outside > 2 * bearing.outer.bottom_radius:
        limit = _mm(2 * bearing.outer.bottom_radius)
        if moved and "outside_diameter" not in own:
            problem = f"puts the outer groove's bottom at {limit}, beyond the outside diameter of {_mm(outside)}"
            yield "bearing.pitch_diameter", problem
        else:
            yield "bearing.outside_diameter", f"must exceed the outer groove's bottom, {limit} in diameter"
    known = (each for ring in (bearing.inner, bearing.outer) for each in ring.half_widths if each is not None)
    widest = 2 * max(known, default=0.0)
    if width is not None and not width > widest:
        yield "bearing.width", f"must exceed the wider groove, {_mm(widest)} from shoulder to shoulder"


def _touching_shoulders(bearing: Bearing) -> tuple[float, float] | None:
    """Heights over the bottom of the grooves of the first shoulders of both rings that touch, m; None: none do.

    The near shoulders, which thrust loads, face each other on washers. On rings they lie on opposite sides of the ball,
    and each faces the other ring's far one.
    """
    is_thrust = bearing.kind == "thrust"
    room = bearing.ball_diameter if is_thrust else bearing.outer.bottom_radius - bearing.inner.bottom_radius
    facing = bearing.outer.half_widths if is_thrust else bearing.outer.half_widths[::-1]
    for widths in zip(bearing.inner.half_widths, facing, strict=True):
        inner, outer = (
            None if width is None else ring.groove_radius - float(np.sqrt(ring.groove_radius**2 - width**2))
            for ring, width in zip((bearing.inner, bearing.outer), widths, strict=True)
        )
        if inner is not None and outer is not None and not inner + outer < room:
            return inner, outer
    return None


def _mm(length: float) -> str:
    return MILLIMETRE.written(length, ".6g")
