"""The balls of a bearing as their friction sees them: load, contact and motion of each on both races.

Under thrust alone all balls are alike and one stands for all; else each has its own column. Arrays that belong to both
races have an axis of two in front, inner and outer; n operating points and m balls follow.
"""

from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from analytic.brief import Brief
from analytic.contact.factors import ContactCorrection
from analytic.contact.geometry import RACES, race_curvatures
from analytic.contact.hertz import HertzContact, contact_modulus
from analytic.contact.rolling_contact import ContactNumbers, deformed_radius
from analytic.loads.kinematics import BallKinematics
from analytic.loads.ring import ring_equilibrium
from analytic.loads.thrust import thrust_at_speed, thrust_equilibrium
from analytic.loads.turning import RuledTurning
from analytic.scene import STANDARD_GRAVITY, Array, Bearing, ContactAngle, Operation


@dataclass(frozen=True, kw_only=True)
class LoadEffects:
    """Which effects on the loads of the balls are included."""

    load_distribution: bool = True  # by radial load and moment
    centrifugal: bool = True  # force of each ball
    gyroscopic: bool = True  # moment of each ball
    down: tuple[float, float, float] | None = None  # direction of the balls' weight, of length 1; None: left out

    @property
    def inertia(self) -> bool:
        return self.centrifugal or self.gyroscopic


@dataclass(frozen=True, kw_only=True, eq=False)
class LoadedBalls(Brief):
    """n operating points, m balls in columns."""

    method: Literal["thrust", "ring"]  # by which they were loaded
    alike: int  # balls that each column stands for
    ball_radius: float  # r, m
    load: Array  # (2, n, m) Q, N, >= 0
    contact_angle: Array  # (2, n, m) al, rad, >= 0 but where both angles are near 0
    side: Array  # (n, m) 1, or -1 where the ball is pressed the other way: its angles have the other sign
    contact: HertzContact  # (2, n, m)
    curvature_rolling: Array  # (2, n, m) 1/R_x, relative, 1/m
    curvature_transverse: Array  # (2, n, m) 1/R_y, 1/m
    modulus: Array  # (2, 1, 1) E*, Pa
    deformed_radius: Array  # (2, 1, 1) R, of the contact surface in the transverse direction, m
    motion: BallKinematics  # (n, m), per unit ring speed: the torque exists at standstill too

    @property
    def contacts(self) -> ContactNumbers:
        """The contacts on both races, (2, n, m) or broadcasting to it."""
        fields: dict[str, Any] = {
            "load": self.load,
            "semi_axis_rolling": self.contact.semi_axis_x,
            "semi_axis_transverse": self.contact.semi_axis_y,
            "curvature_rolling": self.curvature_rolling,
            "curvature_transverse": self.curvature_transverse,
            "modulus": self.modulus,
            "deformed_radius": self.deformed_radius,
            "rolling_rate": np.stack([self.motion.inner_rolling_rate, self.motion.outer_rolling_rate]),
        }
        return ContactNumbers(**fields)

    def total(self, of_contact: Array) -> Array:
        """(n,) sum over all balls, and over both races where there is an axis for them."""
        of_ball = of_contact.sum(axis=0) if of_contact.ndim == 3 else of_contact
        return self.alike * of_ball.sum(axis=-1)

    def at(self, points: NDArray[np.intp]) -> "LoadedBalls":
        """The balls at some operating points."""
        contact = {name: value[:, points] for name, value in vars(self.contact).items()}
        motion = {name: value[points] for name, value in vars(self.motion).items()}
        return replace(
            self,
            load=self.load[:, points],
            contact_angle=self.contact_angle[:, points],
            side=self.side[points],
            contact=HertzContact(**contact),
            curvature_rolling=self.curvature_rolling[:, points],
            curvature_transverse=self.curvature_transverse[:, points],
            motion=BallKinematics(**motion),
        )

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
    """The balls, which turn by closed kinematics, by the cheapest method that has the effects.

    operation : every array (n,);  correction : factors on Hertz's contacts, with a shape that the method takes:
    (n,) for thrust, (n, m) for the ring
    Raises InputError and ConvergenceError as the equilibrium does.
    """
    unequal = (effects.load_distribution and not operation.is_thrust) or effects.down is not None
    balls = ring_balls if unequal else thrust_balls
    return balls(bearing, contact_angle, operation, effects, correction=correction)


def thrust_balls(
    bearing: Bearing,
    contact_angle: ContactAngle,
    operation: Operation,
    effects: LoadEffects,
    *,
    correction: ContactCorrection | None = None,
) -> LoadedBalls:
    """All balls alike, one column for Z of them, whatever the radial load and the moment.

    Arguments and errors of thrust_equilibrium, or of thrust_at_speed where the balls' own forces are included.
    """
    turning = _ruled(bearing, operation, effects)
    if contact_angle.rule == "given" or not effects.inertia:
        still = thrust_equilibrium(bearing, contact_angle, axial_load=operation.axial_load, correction=correction)
        loads, angles, contacts = (still.ball_load,) * 2, (still.contact_angle,) * 2, (still.inner, still.outer)
    else:
        moving = thrust_at_speed(
            bearing,
            contact_angle,
            axial_load=operation.axial_load,
            inner_speed=operation.inner_speed,
            turning=turning,
            correction=correction,
        )
        loads, angles = (moving.inner_load, moving.outer_load), (moving.inner_angle, moving.outer_angle)
        contacts = moving.inner, moving.outer
    return balls_between(
        bearing,
        method="thrust",
        load=np.stack(loads)[..., None],
        angle=np.stack(angles)[..., None],
        contacts=contacts,
        motion=turning.motion(angles[0], angles[1]),
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
    turning, tilt = _ruled(bearing, operation, effects), operation.held_tilt if effects.load_distribution else 0.0
    weight = bearing.ball_mass * STANDARD_GRAVITY * np.array(effects.down or (0.0, 0.0, 0.0))
    ring = ring_equilibrium(
        bearing,
        contact_angle,
        axial_load=operation.axial_load,
        radial_load_x=operation.radial_load if effects.load_distribution else 0.0,
        moment_y=operation.moment if effects.load_distribution else 0.0,
        tilts=None if np.isnan(tilt) else (0.0, tilt),
        inner_speed=operation.inner_speed,
        turning=turning,
        ball_weight=(float(weight[0]), float(weight[1]), float(weight[2])),
        correction=correction,
    )
    return balls_between(
        bearing,
        method="ring",
        load=np.stack([ring.inner_load, ring.outer_load]),
        angle=np.stack([ring.inner_angle, ring.outer_angle]),
        contacts=(ring.inner, ring.outer),
        motion=turning.motion(ring.inner_angle, ring.outer_angle),
    )


def _ruled(bearing: Bearing, operation: Operation, effects: LoadEffects) -> RuledTurning:
    return RuledTurning(
        bearing=bearing,
        inner_speed=operation.inner_speed,
        centrifugal=effects.centrifugal,
        gyroscopic=effects.gyroscopic,
    )


def balls_between(
    bearing: Bearing,
    *,
    method: Literal["thrust", "ring"],
    load: Array,
    angle: Array,
    contacts: tuple[HertzContact, HertzContact],
    motion: BallKinematics,
) -> LoadedBalls:
    """Balls whose loads, angles and motion are known.

    load, angle : Q, al, (2, n, m), N and rad;  contacts : under these loads, of (n,) or (n, m)
    motion : per unit ring speed, likewise
    """
    shape = load.shape[1:]
    side = np.where(angle.sum(axis=0) < 0, -1.0, 1.0)
    angle = side * angle
    grooves = (bearing.inner, bearing.outer)
    curvatures = [
        race_curvatures(bearing, race, contact_angle=np.abs(of_race))
        for race, of_race in zip(RACES, angle, strict=True)
    ]
    return LoadedBalls(
        method=method,
        alike=bearing.ball_count if method == "thrust" else 1,
        ball_radius=bearing.ball_radius,
        load=load,
        contact_angle=angle,
        side=side,
        contact=HertzContact(
            **{
                name: np.stack([getattr(contact, name).reshape(shape) for contact in contacts])
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
        motion=BallKinematics(**{name: np.reshape(value, shape) for name, value in vars(motion).items()}),
    )
