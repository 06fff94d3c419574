"""The ring and its balls as a result: place and stiffness of the inner ring, load and angle of every ball.

They follow from the loads and contact angles of the balls alone, whatever method solved for these. Axes, signs and the
point that displacement and moment refer to are those of `analytic.loads.ring`.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from analytic.brief import Brief, span
from analytic.columns import FREEDOMS, OF_RING, Point, rows_of
from analytic.labelled import Column, Labelled, dataset_of
from analytic.loads.numbers import play_and_free_angle
from analytic.loads.ring_balance import groove_travel, stiffness_of_rings
from analytic.numerics.records import Records
from analytic.scene import Array, Bearing, ContactAngle, Operation

UNLOADED = 1e-9  # load over that of the heaviest ball, below which a ball says nothing of the ring's place
ROUND_OFF = 1e-9  # of the diagonal, below which an entry of the stiffness is what rounding leaves of 0


@dataclass(frozen=True, kw_only=True, eq=False)
class RingState(Brief):
    """The inner ring against the outer one at n operating points, with the Z balls between them."""

    bearing: Bearing
    angle: ContactAngle
    load: Array  # (n, 2, Z) Q on inner and outer race, N
    contact_angle: Array  # (n, 2, Z) rad, negative where the ball is pressed towards -z
    approach: Array  # (n, 2, Z) delta, m
    sideways: Array  # (n, 5) load on the ring that the balls' equilibrium leaves out, N and N m: 0 where it has all
    held_tilt: float  # about y, at which the ring is held, rad; NaN: it tilts freely
    held_by: Array  # (n,) moment about y that holds it, by the balls' equilibrium, N m; 0 for a free ring

    def _facts(self) -> Iterator[str]:
        points, _, balls = self.load.shape
        yield from (self.bearing.name, f"{points} point{'' if points == 1 else 's'}, {balls} balls")
        yield f"heaviest {span(self.load.max(axis=(1, 2)))} N"

    def at(self, points: NDArray[np.intp]) -> "RingState":
        """The state at some operating points.

        Parameters
        ----------
        points : ndarray, shape (k,)
            Numbers of the points, from 0.

        Returns
        -------
        RingState
            Of k points.
        """
        rows = {
            name: getattr(self, name)[points] for name in ("load", "contact_angle", "approach", "sideways", "held_by")
        }
        return replace(self, **rows)

    @property
    def azimuth(self) -> Array:
        """(Z,) of each ball, rad, from x towards y."""
        return groove_travel(self.bearing).azimuth

    @cached_property
    def displacement(self) -> Array | None:
        """(n, 5) along z, x and y, m; tilt about x and y, rad; from concentric rings with their grooves in line.

        In a thrust bearing it begins where the washers just touch the balls. A load that the effect load_distribution
        leaves out, because it hardly changes the balls, moves the ring by the inverse of the stiffness. Where the
        loaded balls leave a freedom, as where one ball alone carries load, it is the smallest displacement that fits.
        None for a contact angle that the scene gives, which no displacement belongs to.
        """
        bearing = self.bearing
        distance = bearing.groove_centre_distance
        if bearing.kind == "thrust":
            beyond = np.array([0.0, distance])
        elif self.angle.rule == "given":
            return None
        else:
            beyond = np.array([distance - play_and_free_angle(bearing, self.angle)[0], 0.0])
        geometry = groove_travel(bearing)
        # The way from the outer groove's centre by the ball's to the inner one's, less that of the rings in line.
        moved = (self._arms[..., None] * self._normal).sum(axis=1) - beyond  # (n, Z, 2)
        scale = np.array([1.0, 1.0, 1.0, geometry.arm, geometry.arm])
        place = np.zeros((len(moved), 5))
        loaded = np.min(self.load, axis=1) > UNLOADED * np.max(self.load, axis=(1, 2))[:, None]
        for row, balls in enumerate(loaded):
            if balls.any():
                travel = geometry.travel[balls].reshape(-1, 5)
                place[row] = np.linalg.lstsq(travel, moved[row, balls].ravel(), rcond=1e-12)[0]
        return place / scale + self._aside

    @property
    def is_loaded_alike(self) -> bool:
        """Whether all balls carry the same at every point, and nothing pushes the ring aside."""
        return not (np.any(self.sideways) or np.any(np.ptp(self.load, axis=-1)))

    @property
    def tilt(self) -> Array | None:
        """(n,) about y, rad; None as the displacement."""
        if not np.isnan(self.held_tilt):
            return np.full(len(self.load), self.held_tilt)
        return None if self.displacement is None else self.displacement[:, 4]

    @property
    def holding_moment(self) -> Array | None:
        """(n,) about y, that holds the ring at its tilt, N m; None for a ring that tilts freely."""
        if np.isnan(self.held_tilt):
            return None
        return self.held_by + (self.stiffness[:, 4] * self._aside).sum(axis=-1)

    @cached_property
    def _aside(self) -> Array:
        """(n, 5) displacement by what the balls' equilibrium leaves out, m and rad."""
        moving = 5 if np.isnan(self.held_tilt) else 3
        moved = np.zeros_like(self.sideways)
        softness = np.linalg.pinv(self.stiffness[:, :moving, :moving], hermitian=True)
        moved[:, :moving] = (softness @ self.sideways[:, :moving, None])[..., 0]
        return moved

    @cached_property
    def stiffness(self) -> Array:
        """(n, 5, 5) of force and moment by displacement and tilt, N/m, N and N m, with each contact's K held.

        Symmetric. The balls' own forces are held too. Fewer than three balls leave the freedoms but z a stiffness of 0.
        """
        geometry = groove_travel(self.bearing)
        pressed = self.load > 0
        along = np.divide(1.5 * self.load, self.approach, out=np.zeros_like(self.load), where=pressed)
        springs = np.stack([along, self.load / self._arms, *np.moveaxis(self._normal, -1, 0)])
        scale = np.array([1.0, 1.0, 1.0, geometry.arm, geometry.arm])
        found = stiffness_of_rings(springs, geometry.travel) * np.outer(scale, scale)
        size = np.sqrt(np.abs(np.diagonal(found, axis1=1, axis2=2)))
        return np.where(np.abs(found) > ROUND_OFF * size[:, :, None] * size[:, None, :], found, 0.0)

    @property
    def _arms(self) -> Array:
        """(n, 2, Z) from the centre of the ball to that of each groove, m."""
        lengths = [
            groove.groove_radius - self.bearing.ball_radius for groove in (self.bearing.inner, self.bearing.outer)
        ]
        return np.reshape(lengths, (2, 1)) + self.approach

    @property
    def _normal(self) -> Array:
        """(n, 2, Z, 2) of each contact: radial and axial."""
        return np.stack([np.cos(self.contact_angle), np.sin(self.contact_angle)], axis=-1)

    def columns(self) -> dict[str, Array]:
        """The values of OF_RING, (n,) or (n, ...), SI; NaN: not known, or the angle of an unloaded contact."""
        place = np.full((len(self.load), 5), np.nan) if self.displacement is None else self.displacement
        holding = np.full(len(self.load), np.nan) if self.holding_moment is None else self.holding_moment
        found = {f"displacement/{name}": place[:, number] for number, name in enumerate(FREEDOMS)}
        found |= {"stiffness": self.stiffness, "holding_moment": holding}
        found["balls/azimuth"] = np.broadcast_to(self.azimuth, self.load[:, 0].shape)
        for side, race in enumerate(("inner", "outer")):
            found[f"balls/{race}_load"] = self.load[:, side]
            found[f"balls/{race}_angle"] = self._loaded_angle[:, side]
        return {name: found[name] for name in OF_RING}

    @property
    def rows(self) -> tuple[Point, ...]:
        """A row for each operating point, by the names of `columns`."""
        return rows_of(self.columns())

    @property
    def _loaded_angle(self) -> Array:
        """(n, 2, Z) rad; NaN of an unloaded contact."""
        return np.where(self.load > 0, self.contact_angle, np.nan)

    def to_dataset(self) -> Any:
        """An xarray.Dataset over operating points, races, balls and freedoms, SI, with units and meanings."""
        rows, every, known = ("point",), ("point", "race", "ball"), self.columns()
        moved = {
            f"displacement_{name}": Labelled(rows, known[f"displacement/{name}"], OF_RING[f"displacement/{name}"])
            for name in FREEDOMS
        }
        return dataset_of(
            {
                "load": Labelled(every, self.load, Column("N", "load of the ball")),
                "contact_angle": Labelled(every, self._loaded_angle, Column("rad", "contact angle of a loaded ball")),
                **moved,
                "stiffness": Labelled(("point", "force", "freedom"), self.stiffness, OF_RING["stiffness"]),
            },
            coordinates={
                "race": Labelled(("race",), ["inner", "outer"], Column("", "race")),
                "azimuth": Labelled(("ball",), self.azimuth, OF_RING["balls/azimuth"]),
                "force": Labelled(("force",), list(FREEDOMS), Column("", "freedom of force or moment")),
                "freedom": Labelled(("freedom",), list(FREEDOMS), Column("", "freedom of displacement or tilt")),
            },
            attributes={"bearing": self.bearing.name},
        )


def state_of_ring(
    bearing: Bearing, angle: ContactAngle, balls: Records, operation: Operation, held_by: Array
) -> RingState:
    """The state of ring and balls; balls : (n, Z) with the fields of `analytic.solve.records.BALL`, or (n, 1)

    operation : every array (n,);  held_by : (n,) moment that holds the ring, by the balls' equilibrium, N m
    """
    count = (len(balls), 2, bearing.ball_count)
    each = (np.swapaxes(balls[name], 1, 2) for name in ("load", "angle", "approach"))
    load, contact_angle, approach = (np.broadcast_to(values, count) for values in each)
    sideways = np.zeros((len(balls), len(FREEDOMS)))
    if balls.shape[1] == 1:
        sideways[:, FREEDOMS.index("x")] = operation.radial_load
        sideways[:, FREEDOMS.index("tilt_y")] = operation.moment
    return RingState(
        bearing=bearing,
        angle=angle,
        load=load,
        contact_angle=contact_angle,
        approach=approach,
        sideways=sideways,
        held_tilt=operation.held_tilt,
        held_by=held_by,
    )
