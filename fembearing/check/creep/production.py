"""The friction of the balls of a scene at one operating point, by production: the formula, and marched creep.

The formula is that of a long ellipse that slides everywhere, equations 2 to 7 of [Paper], with closed kinematics. The
torque takes marched creep. Both see Hertz's contacts without finite geometry, and balls without weight.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from analytic.contact.geometry import RACES, race_curvatures, race_numbers
from analytic.contact.rolling_contact import ContactNumbers, elliptic_contact
from analytic.effects import counted_effects
from analytic.errors import InputError
from analytic.free_ball.state import PITCH, ROWS
from analytic.free_ball.strips import (
    LATERAL,
    SLIDE,
    SPIN,
    STRESS,
    hold_flows,
    march_strips,
    marched_strip,
    peak_pressure,
    shear_at,
)
from analytic.free_ball.turning import outer_groove_centres
from analytic.loads.numbers import bearing_numbers
from analytic.numerics.records import Record, Records, as_record, copied
from analytic.oil.traction import PointLaw
from analytic.scene import Scene
from analytic.sliding.long_ellipse import MicroslipTorque, microslip_torque, pure_rolling_lines
from analytic.solve.failures import require_settled
from analytic.solve.model import Model, model_of, workspace
from analytic.solve.solution import points_of, solved
from fembearing.creep.ball import TurningBall, race_motions
from fembearing.creep.kinematics import RigidSlip, rigid_slip
from fembearing.creep.place import HeldBall, free_lengths, unit_under
from fembearing.creep.reference import RaceFriction

LEVEL = 2  # of the nodes of free balls: 64 strips of 47
ALIKE = 1e-6  # relative, of the loads of two balls that are each other's mirror images
SLIDES = 1e-9  # relative to the limit of friction, below which a node sticks


class ProducedBall(NamedTuple):
    """A ball by both methods, and the same ball for the reference."""

    load: float  # larger one of both, N
    number: int  # of balls that are alike
    torque: float  # by sliding with marched creep, of one, N m
    turning: TurningBall
    mirrored: bool  # the reference presses it towards +z
    state: Record  # of the ball
    contacts: Records  # (2,) of its contacts


@dataclass(frozen=True, kw_only=True, eq=False)
class Production:
    """All balls of an operating point."""

    scene: Scene
    balls: tuple[ProducedBall, ...]  # those that differ and touch both races, the heaviest first
    formula: float  # torque by sliding of all balls, N m
    torque: float  # likewise with marched creep
    quadrature: Record
    heaviest: Records  # (1,) the heaviest ball by the formula


def produced(scene: Scene) -> Production:
    """Both methods at the only operating point of a scene.

    Raises InputError and ConvergenceError as the torque does, and InputError where slip is left out.
    """
    ruled, free = models_of(scene)
    points, work = points_of(scene.operation, free.temperature), workspace(free)
    by_rule, found = solved(ruled, points), solved(free, points, work=work)
    for model, each in ((ruled, by_rule), (free, found)):
        require_settled(scene, model, points, each)
    heaviest = by_rule.balls[0][[int(by_rule.balls[0]["load"].max(axis=1).argmax())]]
    speed, inertia = float(points[0, 3]), bool(free.numbers.counted.gyroscopic)
    return Production(
        scene=scene,
        balls=_distinct(scene, work.balls[: found.balls.shape[1]], work.contacts, speed, inertia=inertia),
        formula=float(by_rule.sliding_torque[0]),
        torque=float(found.sliding_torque[0]),
        quadrature=free.tables.quadratures[1 + 2 * LEVEL],
        heaviest=heaviest,
    )


def models_of(scene: Scene) -> tuple[Model, Model]:
    """Of the formula and of marched creep. Raises InputError where slip is left out."""
    if off := [name for name in ("spin", "conformity") if scene.effects.get(name) == "off"]:
        raise InputError(f'effects.{off[0]} = "off" neglects a part of the slip: use "auto"')
    can = counted_effects(scene)
    inertia = can["gyroscopic"] and (can["centrifugal"] or scene.bearing.kind == "thrust")
    counted = can | {"weight": False, "finite_geometry": False, "spin": True, "conformity": True}
    counted |= {"gyroscopic": inertia, "centrifugal": inertia and can["centrifugal"]}
    counted["cage"] = False
    fine = model_of(scene, counted, free=True).with_numbers(level=LEVEL, allowed=np.inf)
    return model_of(scene, counted, free=False), fine


def _distinct(
    scene: Scene, states: Records, contacts: Records, speed: float, *, inertia: bool
) -> tuple[ProducedBall, ...]:
    """Balls that differ; mirror images of each other stand for one."""
    alone = len(states) == 1
    found: list[ProducedBall] = []
    for j in np.argsort(-states["load"].max(axis=1)).tolist():
        state, both = states[j], contacts[j]
        if not min(state["load"]) > 0:
            continue
        if found and np.allclose(state["load"], found[-1].state["load"], rtol=ALIKE):
            found[-1] = found[-1]._replace(number=found[-1].number + 1)
            continue
        held, mirrored = _held(scene, state, alone=alone)
        laws = tuple(_law(contact, speed) for contact in both)
        found.append(
            ProducedBall(
                load=float(max(state["load"])),
                number=scene.bearing.ball_count if alone else 1,
                torque=float(sum(contact["power"] for contact in both)),
                turning=TurningBall(held=held, laws=(laws[0], laws[1]), speed=abs(speed), inertia=inertia),
                mirrored=mirrored,
                state=state,
                contacts=both,
            )
        )
    if not found:
        raise InputError("no ball touches both races: give a larger load, or less speed")
    return tuple(found)


def _held(scene: Scene, state: Record, *, alone: bool) -> tuple[HeldBall, bool]:
    """What holds a ball, and whether it is mirrored. Under thrust alone the ring is free along the axis."""
    bearing, operation = scene.bearing, scene.operation
    thrust = float(np.asarray(operation.axial_load)[0]) / bearing.ball_count
    centre = outer_groove_centres(bearing, bearing_numbers(bearing, scene.contact_angle))
    if bearing.kind == "thrust":
        return HeldBall(bearing=bearing, centre=centre, thrust=thrust, angle=np.pi / 2), False
    if scene.contact_angle.rule == "given":
        angle = float(abs(state["angle"][0]))
        return HeldBall(bearing=bearing, centre=centre, thrust=thrust, angle=angle), False
    reach = np.zeros(2)
    for race, length, angle, load in zip(RACES, free_lengths(bearing), state["angle"], state["load"], strict=True):
        whole = length + unit_under(bearing, race, abs(float(angle))).approach * load ** (2 / 3)
        reach += whole * np.array([np.cos(angle), np.sin(angle)])
    axial = None if alone else float(abs(reach[1]))
    held = HeldBall(bearing=bearing, centre=centre, thrust=thrust, radial=float(reach[0]), axial=axial)
    return held, bool(reach[1] < 0)


def _law(contact: Record, speed: float) -> PointLaw:
    """The law of traction of a contact, which the kernel holds per unit ring speed."""
    law = PointLaw(*(float(contact[name]) for name in PointLaw._fields))
    return law._replace(fluidity=law.fluidity / abs(speed))


def by_formula(production: Production) -> tuple[RaceFriction[float], RaceFriction[float]]:
    """The heaviest ball by the formula."""
    scene, ball = production.scene, production.heaviest[0]
    rates = [float(ball["motion"][f"{race}_rolling_rate"]) for race in RACES]
    contacts = [
        _contact(scene, k, float(abs(ball["angle"][k])), float(ball["load"][k]), rates[k]) for k in range(len(RACES))
    ]
    forces = [float(ball["friction_coefficient"][k] * ball["load"][k]) for k in range(len(RACES))]
    slip = microslip_torque(
        (contacts[0], contacts[1]),
        friction_force=(forces[0], forces[1]),
        spin_difference=abs(float(ball["motion"]["spin_difference"])),
        spin_rule="balanced" if scene.spin_rule == "free" else scene.spin_rule,
    )
    speeds = [float(abs(ball["motion"][f"{race}_entrainment"])) for race in RACES]
    inner, outer = (_of_line(k, contacts[k], slip, speeds[k]) for k in range(len(RACES)))
    return inner, outer


def _contact(scene: Scene, k: int, angle: float, load: float, rate: float) -> ContactNumbers:
    numbers = race_numbers(scene.bearing, RACES[k])
    along, across = race_curvatures(scene.bearing, RACES[k], contact_angle=angle)
    contact = elliptic_contact(along, across, load, numbers.modulus)
    return contact._replace(deformed_radius=numbers.deformed_radius, rolling_rate=rate)


def _of_line(k: int, contact: ContactNumbers, slip: MicroslipTorque, speed: float) -> RaceFriction[float]:
    """One race; speed : V over the ring's speed, m"""
    race = RACES[k]
    spin, moment, rolling = (
        abs(float(getattr(slip, f"{race}_{name}"))) for name in ("spin_rate", "spin_moment", "rolling_moment")
    )
    rate, radius, b = (
        float(value) for value in (contact.rolling_rate, contact.deformed_radius, contact.semi_axis_transverse)
    )
    lines = pure_rolling_lines(spin / rate * radius / b)
    return RaceFriction(
        creepage_along=rate / (2 * radius * speed) * b**2 * float(lines[0] * lines[1]),
        creepage_across=0.0,
        spin_creepage=spin / speed,
        spin_moment=moment,
        rolling_moment=rolling,
        transverse_force=0.0,
        slip_share=1.0,
        torque=moment * spin + rolling * rate,
    )


def by_march(production: Production) -> tuple[RaceFriction[float], RaceFriction[float]]:
    """The heaviest ball with marched creep, from the state in which the kernel leaves it."""
    ball = production.balls[0]
    motions = race_motions(ball.turning.held.bearing)
    inner, outer = (
        _marched(
            as_record(ball.contacts[k]),
            rigid_slip(
                motion,
                float(ball.state["angle"][k]),
                float(ball.state["orbit_radius"]),
                np.array(ball.state["velocity"]),
            ),
            production.quadrature,
        )
        for k, motion in enumerate(motions)
    )
    return inner, outer


def _marched(contact: Record, slip: RigidSlip, quadrature: Record) -> RaceFriction[float]:
    given, speed, b = slip.creepages, slip.rolling_speed, float(contact.semi_axis_transverse)
    nodes, count = int(quadrature["nodes"]), int(quadrature["strips"])
    sines, cosines, weights = quadrature["across"][:, :count]
    y, width = b * sines, weights * b * cosines
    slide = slip.side * speed * (given.along + given.along_bend * y**2 - given.spin * y)
    spin = slip.side * speed * (given.spin - 2 * given.along_bend * y)
    # Flow and leading edge: x of the reference points against the surfaces' velocity through the contact.
    length = float(contact.flexibility) * speed * float(contact.semi_axis_rolling)
    flow = (-slip.side, length, float(contact.lean))
    flows = np.empty((nodes, 3, count))
    hold_flows(contact, as_record(quadrature), flows)
    areas, slips, state = np.zeros((count, nodes)), np.zeros((count, nodes), dtype=bool), np.zeros(ROWS * PITCH)
    for k in range(nodes):
        part = copied(quadrature)
        part["nodes"] = k + 1
        state[:] = 0.0
        state[SLIDE : SLIDE + count], state[SPIN : SPIN + count] = slide, spin
        state[LATERAL : LATERAL + count] = speed * given.across
        march_strips(contact, flow, as_record(part[0]), flows, state)
        _, cosine, weight = quadrature["along"][:, k]
        areas[:, k] = width * float(contact.semi_axis_rolling) * cosines * weight * cosine
        shear = shear_at(contact, peak_pressure(contact) * cosines * cosine, *flows[k])
        least = shear.steady + np.where(shear.most == 0.0, shear.limit, 0.0)
        slips[:, k] = state[STRESS : STRESS + count] >= (1 - SLIDES) * least
    forces = np.array([marched_strip(state, j)[0] for j in range(count)]).T * width
    return RaceFriction(
        creepage_along=given.along,
        creepage_across=given.across,
        spin_creepage=abs(given.spin),
        spin_moment=float(np.sum(forces[2] - forces[0] * y)) * slip.side * float(np.sign(given.spin)),
        rolling_moment=slip.side * float(np.sum(forces[0] * y**2 / 2 - forces[2] * y)) / float(contact.radius),
        transverse_force=-float(np.sum(forces[1])),
        slip_share=float(np.sum(areas[slips]) / np.sum(areas)),
        torque=float(contact.power),
    )
