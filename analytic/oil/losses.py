"""Losses by oil outside the contacts: it flows through the bearing, is sheared at the cage, and holds the balls back.

Each is the power lost over the speed w of the inner ring. A force on balls or cage reaches the shaft by balance of
power. A force F against the orbit of a ball is held by F/2 on each race, as nothing else balances the ball's own
rotation; F/2 at the inner race, whose surface runs at twice the speed of the ball's centre, is a power of F times that
speed. The same holds for the cage, which the balls push. What the forces change in the slip of the balls is neglected.
Balls roll without slip at the unloaded contact angle al, with g = D cos(al)/d_m: w_c/w = (1 - g)/2 of balls and cage,
v = w_c d_m/2, and w_b/w = (d_m/D) (1 - g^2)/2 of a ball about its own axis, relative to the cage. The inner race runs
at 2 v. Source: derived here; the law of shear is Petroff's, the coefficient of drag from [White2006].
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import InputError, require_non_negative, require_positive
from analytic.loads.numbers import play_and_free_angle
from analytic.numerics.elements import share_in
from analytic.oil.viscosity import oil_numbers
from analytic.scene import Array, Bearing, Losses, Scene, ShearedLand, ShearedPockets

# What losses of the oil without their input are estimated by: share of oil between the rings, by supply, a judgement;
# clearance and thickness of a cage in its pockets over the ball diameter, those of the cage of [Paper]; rise of the
# temperature of oil that a jet sends through, K, a judgement; and its specific heat, J/(kg K).
USUAL_SHARE: dict[str, float] = {"oil_bath": 0.05, "oil_jet": 0.02}
USUAL_POCKETS = (0.025, 0.11)
JET_RISE, OIL_HEAT = 20.0, 2000.0


@dataclass(frozen=True, kw_only=True)
class StirredOil:
    """A bearing and the oil outside its contacts."""

    ball_count: int  # Z
    ball_diameter: float  # D, m
    pitch_diameter: float  # d_m, m
    contact_angle: float  # al, rad
    density: float  # of the oil, kg/m^3
    flow: float = 0.0  # through the bearing, m^3/s
    share: float = 0.0  # of the space between the rings that is oil; the rest is air, whose mass is neglected
    land: ShearedLand | None = None
    pockets: ShearedPockets | None = None

    @property
    def ball_rate(self) -> float:
        """v/w of the centres of the balls, m."""
        return (1 - self._share_of_ball) * self.pitch_diameter / 4

    @property
    def _share_of_ball(self) -> float:
        return self.ball_diameter * np.cos(self.contact_angle) / self.pitch_diameter

    def through_flow(self, speed: ArrayLike) -> Array:
        """mdot 2 v^2/w: the inner race at 2 v drives oil that leaves with the speed v of the cage.

        Parameters
        ----------
        speed : array_like
            Of the inner ring, rad/s, of either sign.

        Returns
        -------
        ndarray
            Torque on the inner ring, N m. It is half of this if the cage drives the oil, and twice of it if the oil
            leaves with the speed of the inner race.
        """
        return self.density * self.flow * 2 * self.ball_rate**2 * np.abs(speed)

    def cage_shear(self, speed: ArrayLike, viscosity: ArrayLike) -> Array:
        """Shear of the oil in the gaps of the cage by Petroff: full, concentric and laminar.

        Parameters
        ----------
        speed : array_like
            Of the inner ring, rad/s, of either sign.
        viscosity : array_like
            At ambient pressure, Pa s; broadcasts with the speed.

        Returns
        -------
        ndarray
            Torque on the inner ring, N m.

        Notes
        -----
        Land: eta 2 pi R B (R dw)^2/(c w) of radius R, width B and radial clearance c, with dw = w_c at the outer ring
        and w - w_c at the inner one. Pockets: Z eta pi r (r w_b)^2 (1 + sin^2 al) I/w, where I is the integral of 1/h
        over the thickness t with h = c + s^2/(2 r), so I = 2 sqrt(2 r/c) arctan(t/(2 sqrt(2 r c))).
        """
        per_viscosity, share = 0.0, self._share_of_ball
        if (land := self.land) is not None:
            rate = (1 + share) / 2 if land.ring == "inner" else (1 - share) / 2
            area = np.pi * land.diameter * land.width
            per_viscosity += area * (land.diameter / 2 * rate) ** 2 / (land.clearance / 2)
        if (pockets := self.pockets) is not None:
            radius, gap = self.ball_diameter / 2, pockets.clearance / 2
            surface = self.pitch_diameter * (1 - share**2) / 4  # r w_b/w
            reach = np.sqrt(2 * radius * gap)
            inverse_gap = 2 * reach / gap * np.arctan(pockets.thickness / (2 * reach))
            tilted = 1 + np.sin(self.contact_angle) ** 2
            per_viscosity += self.ball_count * np.pi * radius * surface**2 * tilted * inverse_gap
        return per_viscosity * np.asarray(viscosity) * np.abs(speed)

    def ball_drag(self, speed: ArrayLike, viscosity: ArrayLike) -> Array:
        """Z F v/w with F = C_d rho (pi D^2/4) v^2/2, rho of the mixture of oil and air.

        Parameters
        ----------
        speed : array_like
            Of the inner ring, rad/s, of either sign.
        viscosity : array_like
            Of the oil at ambient pressure, Pa s; broadcasts with the speed.

        Returns
        -------
        ndarray
            Torque on the inner ring, N m.

        Notes
        -----
        C_d = 24/Re + 6/(1 + sqrt(Re)) + 0.4 with Re = rho v D/eta holds for a single smooth sphere up to Re = 2e5.
        It is up to 30 % above the standard curve at Re = 300 to 3000, and within 10 % of it elsewhere.
        """
        density, velocity = self.density * self.share, self.ball_rate * np.abs(speed)
        if density == 0:
            return np.zeros(np.broadcast(velocity, viscosity).shape)
        root = np.sqrt(density * velocity * self.ball_diameter / np.asarray(viscosity))
        # 24/Re apart, as Re may be 0
        dynamic = 24 * np.asarray(viscosity) * velocity / self.ball_diameter
        dynamic = dynamic + (6 / (1 + root) + 0.4) * density * velocity**2
        return self.ball_count * dynamic * np.pi * self.ball_diameter**2 / 8 * self.ball_rate

    def torque(self, speed: ArrayLike, viscosity: ArrayLike) -> Array:
        """The sum of all three.

        Parameters
        ----------
        speed : array_like
            Of the inner ring, rad/s, of either sign.
        viscosity : array_like
            Of the oil at ambient pressure, Pa s; broadcasts with the speed.

        Returns
        -------
        ndarray
            Torque on the inner ring, N m.
        """
        return self.through_flow(speed) + self.cage_shear(speed, viscosity) + self.ball_drag(speed, viscosity)


def stirred_oil(scene: Scene, losses: Losses) -> StirredOil | None:
    """The oil of a scene with these losses; None: no loss of the oil follows from them.

    Raises InputError for numbers out of range, for losses that the scene counts in another way too, or without an oil.
    """
    if not losses.has_oil:
        return None
    _require_range(losses, scene.bearing)
    _require_once(scene, losses)
    oil, bearing, rule = scene.lubricant, scene.bearing, scene.contact_angle
    if oil is None:
        raise InputError("[losses] of flowing or sheared oil need its viscosity and density: add a table [lubricant]")
    angle = rule.value if rule.rule == "given" else play_and_free_angle(bearing, rule)[1]
    return StirredOil(
        ball_count=bearing.ball_count,
        ball_diameter=bearing.ball_diameter,
        pitch_diameter=bearing.pitch_diameter,
        contact_angle=angle or 0.0,
        density=oil.density,
        flow=losses.oil_flow or 0.0,
        share=losses.oil_share or 0.0,
        land=losses.land,
        pockets=losses.pockets,
    )


def _require_once(scene: Scene, losses: Losses) -> None:
    if losses.drag is not None and losses.oil_share is not None:
        raise InputError(
            f"losses.drag = {losses.drag:g} N m and losses.oil_share = {losses.oil_share:g} both give the drag of the "
            "oil; leave one of them out"
        )
    if scene.cage is not None and losses.pockets is not None:
        raise InputError("losses.pockets and [cage] both give the friction in the pockets; leave one of them out")
    if scene.cage is not None and scene.cage.drag > 0 and losses.land is not None:
        raise InputError(
            f"losses.land and cage.drag = {scene.cage.drag:g} N m s both brake the cage by oil; leave one of them out"
        )


def _require_range(losses: Losses, bearing: Bearing) -> None:
    given = {f"losses.{name}": getattr(losses, name) for name in ("oil_flow", "oil_share")}
    require_non_negative(**{name: value for name, value in given.items() if value is not None})
    if losses.oil_share is not None and losses.oil_share > 1:
        raise InputError(f"losses.oil_share = {losses.oil_share:g} is more than 1, all of the space; give 0 to 1")
    for name in ("land", "pockets"):
        part = getattr(losses, name)
        if part is not None:
            require_positive(**{f"losses.{name}.{key}": value for key, value in vars(part).items() if key != "ring"})
    if losses.land is not None:
        _require_on_ring(losses.land, bearing)


def _require_on_ring(land: ShearedLand, bearing: Bearing) -> None:
    """The shoulders of a radial bearing's rings are apart at the pitch diameter; washers lie beside each other."""
    low, high = ("the bore", bearing.bore_diameter), ("the outside diameter", bearing.outside_diameter)
    if bearing.kind == "radial":
        pitch = "the pitch diameter", bearing.pitch_diameter
        low, high = (low, pitch) if land.ring == "inner" else (pitch, high)
    if land.diameter <= (low[1] or 0.0) or land.diameter >= (high[1] or np.inf):
        ends = (f"{word} {name} {1e3 * at:.6g} mm" for word, (name, at) in (("above", low), ("below", high)) if at)
        raise InputError(
            f"losses.land.diameter = {1e3 * land.diameter:.6g} mm is not on the {land.ring} ring; "
            f"give one {' and '.join(ends)}"
        )


def oil_parts(scene: Scene, stirred: StirredOil, speed: Array, factor: float) -> dict[str, Array]:
    """(n,) N m of each of OIL_LOSSES."""
    assert scene.lubricant is not None
    viscosity = oil_numbers(scene.lubricant).viscosity
    return {
        "through_flow": factor * stirred.through_flow(speed),
        "cage_shear": factor * stirred.cage_shear(speed, viscosity),
        "ball_drag": factor * stirred.ball_drag(speed, viscosity),
    }


def estimated_loss(scene: Scene, name: str, speed: Array, total: Array) -> Array | None:
    """(n,) share of a loss of the oil that lacks its input, by usual values; None: not known, or counted elsewhere."""
    oil, ball, losses = scene.lubricant, scene.bearing.ball_diameter, scene.losses
    if oil is None or oil.supply not in USUAL_SHARE:
        return None
    if name == "cage_shear" and scene.cage is not None and not scene.cage.gives_way:
        return None
    if name == "ball_drag" and losses.drag is not None:
        return None
    pockets = ShearedPockets(clearance=USUAL_POCKETS[0] * ball, thickness=USUAL_POCKETS[1] * ball)
    usual = stirred_oil(replace(scene, cage=None), Losses(oil_share=USUAL_SHARE[oil.supply], pockets=pockets))
    assert usual is not None
    if name != "through_flow":
        return share_in(oil_parts(scene, usual, speed, 1.0)[name], total)
    if oil.supply != "oil_jet":
        return None
    accelerated = (2 * usual.ball_rate * speed) ** 2 / (OIL_HEAT * JET_RISE)
    return np.divide(accelerated, 1 - accelerated, out=np.full(total.shape, np.inf), where=accelerated < 1)
