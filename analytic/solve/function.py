"""The friction torque as a function for loops over time steps."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from analytic.brief import Brief
from analytic.effects.sliding import TURNING_FREELY
from analytic.effects.table import ENTRIES
from analytic.errors import FembearingError, InputError, real_numbers
from analytic.point.numbers import Counted, PointModel, Workspace, point_model, workspace
from analytic.point.torque import PointTorque, torques_of_points
from analytic.scene import OIL_TEMPERATURES, Array, Operation, Scene
from analytic.torque import friction_torque

Invalid = Literal["raise", "nan"]
GIVEN = "axial_load", "radial_load", "moment", "inner_speed", "temperature"
AT_REST = {"cage_dynamics": "off", "ball_dynamics": "off"}


@dataclass(frozen=True, kw_only=True, eq=False)
class TorqueFunction(Brief):
    """The torque of a scene at any load, speed and oil temperature; `torque_function` makes it.

    Not for two threads at once: all calls share their work arrays.
    """

    scene: Scene  # with every effect settled
    is_compiled: bool  # else each call is a `friction_torque`
    invalid: Invalid  # what a call gives for numbers without an answer
    model: PointModel | None
    work: Workspace
    points: Array  # (5, 1) of one call: N, N, N m, rad/s, K
    torques: Array  # (6, 1) of one call, N m

    def _facts(self) -> Iterator[str]:
        yield from (self.scene.name, "compiled" if self.is_compiled else "not compiled")

    def __call__(
        self,
        *,
        axial_load: float,
        inner_speed: float,
        radial_load: float = 0.0,
        moment: float = 0.0,
        temperature: float | None = None,
    ) -> float:
        """Torque about the bearing axis, a magnitude: it opposes inner_speed.

        Parameters
        ----------
        axial_load : float
            Along z, N.
        inner_speed : float
            In rad/s, of either sign.
        radial_load, moment : float
            Along x, N, and about y, N m.
        temperature : float, optional
            Of the oil at the inlets, K; None: the scene's.

        Returns
        -------
        float
            In N m.

        Raises
        ------
        InputError
            As `friction_torque`; NaN instead where `invalid` is "nan".
        ConvergenceError
            Likewise.
        """
        warm, points = self._temperature if temperature is None else temperature, self.points
        for place, given in enumerate((axial_load, radial_load, moment, inner_speed, warm)):
            points[place, 0] = given if isinstance(given, float) else _one_number(GIVEN[place], given)
        if self.model is not None and self._coldest <= points[4, 0] <= self._hottest:
            torques_of_points(self.model, points, self.work, self.torques)
            if self.torques[0, 0] == self.torques[0, 0]:
                return float(self.torques[0, 0])
        return self._slowly(points[:, 0])

    def series(
        self,
        *,
        axial_load: ArrayLike,
        inner_speed: ArrayLike,
        radial_load: ArrayLike = 0.0,
        moment: ArrayLike = 0.0,
        temperature: ArrayLike | None = None,
    ) -> Array:
        """The torque at many points; the arguments broadcast.

        Parameters
        ----------
        axial_load : array_like
            Along z, N.
        inner_speed : array_like
            In rad/s, of either sign.
        radial_load, moment : array_like
            Along x, N, and about y, N m.
        temperature : array_like, optional
            Of the oil at the inlets, K; None: the scene's.

        Returns
        -------
        ndarray
            N m, of the broadcast shape; it opposes inner_speed.

        Raises
        ------
        InputError
            As `friction_torque`; NaN instead where `invalid` is "nan".
        ConvergenceError
            Likewise.
        """
        warm = self._temperature if temperature is None else temperature
        named = zip(GIVEN, (axial_load, radial_load, moment, inner_speed, warm), strict=True)
        numbers = [real_numbers(name, values) for name, values in named]
        try:
            given = np.broadcast_arrays(*numbers)
        except ValueError as problem:
            raise InputError(f"{', '.join(GIVEN)} have shapes that do not fit: give equal lengths") from problem
        points = np.stack([each.ravel() for each in given])
        torques = np.full((len(PointTorque._fields), points.shape[1]), np.nan)
        if self.model is not None:
            torques_of_points(self.model, points, self.work, torques)
            torques[:, ~((points[4] >= self._coldest) & (points[4] <= self._hottest))] = np.nan
        for index in np.flatnonzero(np.isnan(torques[0])):
            torques[0, index] = self._slowly(points[:, index])
        return torques[0].reshape(given[0].shape)

    @cached_property
    def _temperature(self) -> float:
        return 0.0 if self.scene.lubricant is None else float(self.scene.lubricant.temperature)

    @cached_property
    def _coldest(self) -> float:
        return -np.inf if self.scene.lubricant is None else OIL_TEMPERATURES[0]

    @cached_property
    def _hottest(self) -> float:
        return np.inf if self.scene.lubricant is None else OIL_TEMPERATURES[1]

    def _slowly(self, point: Array) -> float:
        """By `friction_torque`, which has every closed form and every error."""
        axial, radial, moment, speed, temperature = (float(value) for value in point)
        try:
            if not self._coldest <= temperature <= self._hottest:
                raise InputError(
                    f"temperature must be {self._coldest:g} to {self._hottest:g} K, got {temperature:g}: give that of "
                    "the oil in K"
                )
            load = {"axial_load": axial, "radial_load": radial, "moment": moment, "inner_speed": speed}
            operation = Operation(**{name: np.array([value]) for name, value in load.items()})
            scene, oil = replace(self.scene, operation=operation), self.scene.lubricant
            if oil is not None and temperature != oil.temperature:
                scene = replace(scene, lubricant=replace(oil, temperature=temperature))
            return float(friction_torque(scene).torque.total[0])
        except FembearingError:
            if self.invalid == "nan":
                return np.nan
            raise


def torque_function(scene: Scene, *, invalid: Invalid = "raise") -> TorqueFunction:
    """The friction torque of a scene as a function of load, speed and temperature, for a loop over time steps.

    Parameters
    ----------
    scene : Scene
        Its own operating points settle how sliding is computed.
    invalid : {"raise", "nan"}
        What a call gives for numbers without an answer: an error, or NaN.

    Returns
    -------
    TorqueFunction
        A call takes N, N m, rad/s and K and returns N m; `series` takes arrays.

    Raises
    ------
    InputError
        A scene whose cage has to move, and as `friction_torque` does at the scene's points.

    Notes
    -----
    Every effect counts that the scene has the input for and does not rule out, whatever the load: nothing is decided
    from call to call. The cage rests on its balls.
    Calls take some hundredths to tenths of a millisecond. They are compiled where closed kinematics turn the balls: by
    friction.spin_rule, or under "free" where the scene's points need no creep. Else each call is a `friction_torque`
    (`is_compiled`).
    Sources: those of `friction_torque`, whose formulas are compiled.
    """
    if invalid not in ("raise", "nan"):
        raise InputError(f'invalid must be "raise" or "nan", got {invalid!r}')
    for name in AT_REST:
        if scene.effects.get(name) == "on":
            raise InputError(f'effects.{name} = "on": a moving cage has no torque at one instant; give "auto" or "off"')
    weight = {} if scene.down is not None else {"weight": "off"}  # its direction is not known
    still = replace(scene, effects={**scene.effects, **AT_REST, **weight})
    result = friction_torque(still)
    by_rule = replace(
        still,
        tolerance=0.0,  # every effect counts
        sliding=scene.sliding if result.sliding == "auto" else result.sliding,
        spin_rule="balanced" if scene.spin_rule == "free" else scene.spin_rule,
    )
    turns_freely = result.sliding in TURNING_FREELY
    closed = scene.arrangement is None and scene.microslip == "derived" and not turns_freely
    settled = result.settled(still) if turns_freely else by_rule
    return TorqueFunction(
        scene=settled,
        is_compiled=closed,
        invalid=invalid,
        model=point_model(settled, _counted(settled)) if closed else None,
        work=workspace(settled),
        points=np.zeros((5, 1)),
        torques=np.zeros((len(PointTorque._fields), 1)),
    )


def _counted(scene: Scene) -> Counted:
    """Every effect that the scene has the input for and does not rule out."""
    on = {
        name: scene.effects.get(name) != "off" and (name not in ENTRIES or ENTRIES[name].lacks(scene) is None)
        for name in Counted._fields
    }
    return Counted(**on | {"oil": scene.lubricant is not None, "weight": on["weight"] and scene.down is not None})


def _one_number(name: str, given: Any) -> float:
    """Raises InputError for anything but one real number."""
    number = real_numbers(name, given)
    if number.ndim:
        raise InputError(f"{name} must be one number, got {given!r:.80}; `series` takes arrays")
    return float(number)
