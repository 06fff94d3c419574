"""The balls of a bearing as their friction sees them: load, contact and motion of each on both races.

Under thrust alone all balls are alike and one stands for all; else each has its own column. Arrays that belong to both
races have an axis of two in front, inner and outer; n operating points and m balls follow.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.factors import ContactCorrection
from analytic.contact.geometry import race_curvatures
from analytic.contact.hertz import HertzContact, contact_modulus
from analytic.contact.rolling_contact import RollingContact, deformed_radius
from analytic.loads.kinematics import BallKinematics, ball_kinematics
from analytic.loads.ring import ring_equilibrium
from analytic.loads.thrust import thrust_equilibrium
from analytic.loads.thrust_inertia import thrust_at_speed
from analytic.scene import Array, Bearing, ContactAngle


@dataclass(frozen=True, kw_only=True, eq=False)
class LoadedBalls:
    """n operating points, m balls in columns."""

    rung: Literal["thrust", "ring"]  # by which they were loaded
    alike: int  # balls that each column stands for
    ball_radius: float  # r, m
    load: Array  # (2, n, m) Q, N, >= 0
    contact_angle: Array  # (2, n, m) al, rad, >= 0 but where both angles are near 0
    contact: HertzContact  # (2, n, m)
    curvature_rolling: Array  # (2, n, m) 1/R_x, relative, 1/m
    curvature_transverse: Array  # (2, n, m) 1/R_y, 1/m
    modulus: Array  # (2, 1, 1) E*, Pa
    deformed_radius: Array  # (2, 1, 1) R, of the contact surface across rolling, m
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


def thrust_balls(
    bearing: Bearing,
    contact_angle: ContactAngle,
    *,
    axial_load: ArrayLike,
    correction: ContactCorrection | None = None,
) -> LoadedBalls:
    """All balls alike, one column for Z of them; the arguments and errors of thrust_equilibrium, axial_load (n,)."""
    found = thrust_equilibrium(bearing, contact_angle, axial_load=axial_load, correction=correction)
    angle = found.contact_angle[:, None]
    return _balls(
        bearing,
        rung="thrust",
        alike=bearing.ball_count,
        load=np.stack([found.ball_load[:, None]] * 2),
        angle=np.stack([angle, angle]),
        contacts=(found.inner, found.outer),
    )


def thrust_balls_at_speed(
    bearing: Bearing,
    contact_angle: ContactAngle,
    *,
    axial_load: ArrayLike,
    inner_speed: ArrayLike,
    centrifugal: bool,
    gyroscopic: bool,
    correction: ContactCorrection | None = None,
) -> LoadedBalls:
    """The same with the balls' inertia; the arguments and errors of thrust_at_speed, load and speed (n,)."""
    found = thrust_at_speed(
        bearing,
        contact_angle,
        axial_load=axial_load,
        inner_speed=inner_speed,
        centrifugal=centrifugal,
        gyroscopic=gyroscopic,
        correction=correction,
    )
    return _balls(
        bearing,
        rung="thrust",
        alike=bearing.ball_count,
        load=np.stack([found.inner_load, found.outer_load])[..., None],
        angle=np.stack([found.inner_angle, found.outer_angle])[..., None],
        contacts=(found.inner, found.outer),
    )


def ring_balls(
    bearing: Bearing,
    contact_angle: ContactAngle,
    *,
    axial_load: ArrayLike,
    radial_load: ArrayLike,
    moment: ArrayLike,
    inner_speed: ArrayLike,
    centrifugal: bool,
    gyroscopic: bool,
    correction: ContactCorrection | None = None,
) -> LoadedBalls:
    """Each ball in its own column; the arguments and errors of ring_equilibrium, loads and speed (n,).

    A ball that is pressed the other way spins the other way and loses the same: its angles are told as if it were not.
    """
    found = ring_equilibrium(
        bearing,
        contact_angle,
        axial_load=axial_load,
        radial_load_x=radial_load,
        moment_y=moment,
        inner_speed=inner_speed,
        centrifugal=centrifugal,
        gyroscopic=gyroscopic,
        correction=correction,
    )
    angle = np.stack([found.inner_angle, found.outer_angle])
    return _balls(
        bearing,
        rung="ring",
        alike=1,
        load=np.stack([found.inner_load, found.outer_load]),
        angle=np.where(angle.sum(axis=0) < 0, -angle, angle),
        contacts=(found.inner, found.outer),
    )


def _balls(
    bearing: Bearing,
    *,
    rung: Literal["thrust", "ring"],
    alike: int,
    load: Array,
    angle: Array,
    contacts: tuple[HertzContact, HertzContact],
) -> LoadedBalls:
    grooves = (bearing.inner, bearing.outer)
    curvatures = [
        race_curvatures(bearing, race, contact_angle=np.abs(of_race))
        for race, of_race in zip(("inner", "outer"), angle, strict=True)
    ]
    return LoadedBalls(
        rung=rung,
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
