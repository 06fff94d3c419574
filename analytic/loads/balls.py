"""The balls of a bearing as their friction sees them: load, contact and motion of each on both races.

Under thrust alone all balls are alike and one stands for all; else each has its own column. Arrays that belong to both
races have an axis of two in front, inner and outer; n operating points and m balls follow.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from analytic.contact.factors import ContactCorrection
from analytic.contact.geometry import RACES, race_curvatures
from analytic.contact.hertz import HertzContact, contact_modulus
from analytic.contact.rolling_contact import RollingContact, deformed_radius
from analytic.loads.kinematics import BallKinematics, ball_kinematics
from analytic.loads.ring import ring_equilibrium
from analytic.loads.thrust import thrust_at_speed, thrust_equilibrium
from analytic.scene import Array, Bearing, ContactAngle, Operation


@dataclass(frozen=True, kw_only=True)
class LoadEffects:
    """Which effects on the loads of the balls are included."""

    load_distribution: bool = True  # by radial load and moment
    centrifugal: bool = True  # force of each ball
    gyroscopic: bool = True  # moment of each ball


@dataclass(frozen=True, kw_only=True, eq=False)
class LoadedBalls:
    """n operating points, m balls in columns."""

    method: Literal["thrust", "ring"]  # by which they were loaded
    alike: int  # balls that each column stands for
    ball_radius: float  # r, m
    load: Array  # (2, n, m) Q, N, >= 0
    contact_angle: Array  # (2, n, m) al, rad, >= 0 but where both angles are near 0
    contact: HertzContact  # (2, n, m)
    curvature_rolling: Array  # (2, n, m) 1/R_x, relative, 1/m
    curvature_transverse: Array  # (2, n, m) 1/R_y, 1/m
    modulus: Array  # (2, 1, 1) E*, Pa
    deformed_radius: Array  # (2, 1, 1) R, of the contact surface in the transverse direction, m
    motion: BallKinematics  # (n, m), per unit ring speed: the torque exists at standstill too

    @cached_property
    def contacts(self) -> RollingContact:
        """The contacts on both races, (2, n, m) or broadcasting to it: the only place where they are made."""
        return RollingContact(
            load=self.load,
            semi_axis_rolling=self.contact.semi_axis_x,
            semi_axis_transverse=self.contact.semi_axis_y,
            curvature_rolling=self.curvature_rolling,
            curvature_transverse=self.curvature_transverse,
            modulus=self.modulus,
            deformed_radius=self.deformed_radius,
            rolling_rate=np.stack([self.motion.inner_rolling_rate, self.motion.outer_rolling_rate]),
        )

    def race(self, index: int) -> RollingContact:
        """The contacts on the inner (0) or the outer race (1), (n, m) or broadcasting to it."""
        return RollingContact(**{name: value[index] for name, value in vars(self.contacts).items()})

    def total(self, of_contact: Array) -> Array:
        """(n,) sum over all balls, and over both races where there is an axis for them."""
        of_ball = of_contact.sum(axis=0) if of_contact.ndim == 3 else of_contact
        return self.alike * of_ball.sum(axis=-1)

    @property
    def heaviest(self) -> tuple[Array, Array]:
        """(row, column), each (n,): of the ball that presses hardest on a race at each operating point."""
        return np.arange(self.load.shape[1]), np.max(self.load, axis=0).argmax(axis=1)


def loaded_balls(
    bearing: Bearing,
    contact_angle: ContactAngle,
    operation: Operation,
    effects: LoadEffects,
    *,
    correction: ContactCorrection | None = None,
) -> LoadedBalls:
    """The balls by the cheapest method that has the effects.

    operation : every array (n,);  correction : factors on Hertz's contacts, with a shape that the method takes:
    (n,) for thrust, (n, m) for the ring
    Raises InputError and ConvergenceError as the equilibrium does.
    """
    method = ring_balls if effects.load_distribution and not operation.is_thrust else thrust_balls
    return method(bearing, contact_angle, operation, effects, correction=correction)


def thrust_balls(
    bearing: Bearing,
    contact_angle: ContactAngle,
    operation: Operation,
    effects: LoadEffects,
    *,
    correction: ContactCorrection | None = None,
) -> LoadedBalls:
    """All balls alike, one column for Z of them, whatever the radial load and the moment.

    Arguments and errors of thrust_equilibrium, or of thrust_at_speed where the effects include inertia.
    """
    if effects.centrifugal or effects.gyroscopic:
        turning = thrust_at_speed(
            bearing,
            contact_angle,
            axial_load=operation.axial_load,
            inner_speed=operation.inner_speed,
            centrifugal=effects.centrifugal,
            gyroscopic=effects.gyroscopic,
            correction=correction,
        )
        loads, angles = (turning.inner_load, turning.outer_load), (turning.inner_angle, turning.outer_angle)
        contacts = turning.inner, turning.outer
    else:
        still = thrust_equilibrium(bearing, contact_angle, axial_load=operation.axial_load, correction=correction)
        loads, angles, contacts = (still.ball_load,) * 2, (still.contact_angle,) * 2, (still.inner, still.outer)
    return _balls(
        bearing,
        method="thrust",
        alike=bearing.ball_count,
        load=np.stack(loads)[..., None],
        angle=np.stack(angles)[..., None],
        contacts=contacts,
    )


def ring_balls(
    bearing: Bearing,
    contact_angle: ContactAngle,
    operation: Operation,
    effects: LoadEffects,
    *,
    correction: ContactCorrection | None = None,
) -> LoadedBalls:
    """Each ball in its own column; errors of ring_equilibrium.

    A ball that is pressed the other way spins the other way and has the same losses: its angles are given as if it
    were not.
    """
    ring = ring_equilibrium(
        bearing,
        contact_angle,
        axial_load=operation.axial_load,
        radial_load_x=operation.radial_load,
        moment_y=operation.moment,
        inner_speed=operation.inner_speed,
        centrifugal=effects.centrifugal,
        gyroscopic=effects.gyroscopic,
        correction=correction,
    )
    angle = np.stack([ring.inner_angle, ring.outer_angle])
    return _balls(
        bearing,
        method="ring",
        alike=1,
        load=np.stack([ring.inner_load, ring.outer_load]),
        angle=np.where(angle.sum(axis=0) < 0, -angle, angle),
        contacts=(ring.inner, ring.outer),
    )


def _balls(
    bearing: Bearing,
    *,
    method: Literal["thrust", "ring"],
    alike: int,
    load: Array,
    angle: Array,
    contacts: tuple[HertzContact, HertzContact],
) -> LoadedBalls:
    grooves = (bearing.inner, bearing.outer)
    curvatures = [
        race_curvatures(bearing, race, contact_angle=np.abs(of_race))
        for race, of_race in zip(RACES, angle, strict=True)
    ]
    return LoadedBalls(
        method=method,
        alike=alike,
        ball_radius=bearing.ball_radius,
        load=load,
        contact_angle=angle,
        contact=HertzContact(
            **{
                name: np.stack([getattr(contact, name).reshape(load.shape[1:]) for contact in contacts])
                for name in vars(contacts[0])
            }
        ),
        curvature_rolling=np.stack([rolling for rolling, _ in curvatures]),
        curvature_transverse=np.stack([transverse for _, transverse in curvatures]),
        modulus=np.reshape([contact_modulus(bearing.ball_material, groove.material) for groove in grooves], (2, 1, 1)),
        deformed_radius=deformed_radius(
            groove_radius=np.reshape([groove.groove_radius for groove in grooves], (2, 1, 1)),
            ball_diameter=bearing.ball_diameter,
        ),
        motion=ball_kinematics(
            inner_speed=1.0,
            inner_angle=angle[0],
            outer_angle=angle[1],
            pitch_diameter=bearing.pitch_diameter,
            ball_diameter=bearing.ball_diameter,
        ),
    )
