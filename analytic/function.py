"""The friction torque as a function for loops over time steps."""

import os
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from threading import Lock
from typing import Any, Literal, Unpack

import numpy as np
from numpy.typing import ArrayLike

from analytic.any_scene import scene_by
from analytic.brief import Brief
from analytic.effects import ENTRIES, counted_effects, turns_freely
from analytic.errors import FembearingError, InputError, real_numbers
from analytic.given import SceneOptions
from analytic.numerics.records import Records
from analytic.oil.losses import StirredOil, stirred_oil
from analytic.oil.viscosity import roelands_viscosity
from analytic.scene import OIL_TEMPERATURES, Array, Scene
from analytic.solve.kernel import solve
from analytic.solve.model import Model, Workspace, model_of, workspace
from analytic.solve.records import BALL, POINT
from analytic.solve.solution import solved
from analytic.torque import friction_torque

Invalid = Literal["raise", "nan"]
GIVEN = "axial_load", "radial_load", "moment", "inner_speed", "temperature"
AT_REST = {"cage_dynamics": "off", "ball_dynamics": "off"}
NO_BALLS = np.zeros((0, 0), BALL)
# Steps of a central difference over the argument: the error of the difference goes with the square of the step, that by
# the accuracy of the torque, 1e-12 by rule and 3e-7 for free balls, with its inverse.
STEP, FREE_STEP = 1e-4, 1e-2


@dataclass(frozen=True, kw_only=True, eq=False)
class TorqueFunction(Brief):
    """The torque of a scene at any load, speed and oil temperature; `torque_function` makes it.

    Calls from several threads wait for each other: `copy` makes an instance for each thread.
    """

    scene: Scene  # whose cage rests
    invalid: Invalid  # what a call gives for numbers without an answer
    model: Model | None  # None: of a pair, and each call is a `friction_torque`
    work: Workspace | None  # of the kernel
    points: Array  # (1, 5) of one call: N, N, N m, rad/s, K
    out: Records  # (1,) `records.POINT` of one call
    stirred: StirredOil | None  # outside the contacts; None: the scene declares no loss of it
    lock: Lock = field(init=False, repr=False, default_factory=Lock)  # one call at a time writes balls and point

    def _facts(self) -> Iterator[str]:
        turning = "free balls" if self.model is not None and self.model.is_free else "closed kinematics"
        yield from (self.scene.name, "two bearings" if self.model is None else turning)

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items() if name not in ("lock", "_solve")}

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state, lock=Lock())

    def copy(self) -> "TorqueFunction":
        """Another instance, for another thread, which shares all that does not change."""
        work = None if self.model is None else workspace(self.model)
        model = None if self.model is None else self.model.with_numbers()
        return replace(self, model=model, work=work, points=self.points.copy(), out=self.out.copy())

    def __call__(
        self,
        *,
        inner_speed: float,
        axial_load: float = 0.0,
        radial_load: float = 0.0,
        moment: float = 0.0,
        temperature: float | None = None,
    ) -> float:
        """Torque about the bearing axis, a magnitude: it opposes inner_speed.

        Parameters
        ----------
        inner_speed : float
            In rad/s, of either sign.
        axial_load : float
            Along z, N.
        radial_load, moment : float
            Along x, N, and about y, N m; no moment where the scene holds the tilt of the ring.
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
        warm = self._temperature if temperature is None else temperature
        with self.lock:
            point = self.points[0]
            for place, given in enumerate((axial_load, radial_load, moment, inner_speed, warm)):
                point[place] = given if isinstance(given, float) else _one_number(GIVEN[place], given)
            if self.model is not None and self.work is not None and self._takes(point):
                self._solve()
                total = float(self.out["total"][0])
                if total == total:  # not NaN, as of a point that does not settle, or a cage that is squeezed
                    return total if self.stirred is None else total + float(self._stirring(point[3], point[4]))
            return self._slowly(point)

    def series(
        self,
        *,
        inner_speed: ArrayLike,
        axial_load: ArrayLike = 0.0,
        radial_load: ArrayLike = 0.0,
        moment: ArrayLike = 0.0,
        temperature: ArrayLike | None = None,
    ) -> Array:
        """The torque at many points, on all cores; the arguments broadcast.

        Parameters
        ----------
        inner_speed : array_like
            In rad/s, of either sign.
        axial_load : array_like
            Along z, N.
        radial_load, moment : array_like
            Along x, N, and about y, N m; no moment where the scene holds the tilt of the ring.
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
        points = np.stack([each.ravel() for each in given], axis=-1)
        torques = np.full(len(points), np.nan)
        if self.model is not None and len(points):
            torques = solved(self.model.with_numbers(), points, keeps_balls=False).points["total"].copy()
            taken = np.array([self._takes(point) for point in points])
            torques[~taken] = np.nan
            if self.stirred is not None:
                torques[taken] += self._stirring(points[taken, 3], points[taken, 4])
        for index in np.flatnonzero(np.isnan(torques)):
            torques[index] = self._slowly(points[index])
        return torques.reshape(given[0].shape)

    def gradient(
        self,
        *,
        inner_speed: float,
        axial_load: float = 0.0,
        radial_load: float = 0.0,
        moment: float = 0.0,
        temperature: float | None = None,
    ) -> dict[str, float]:
        """Derivatives of the torque by each argument, by central differences.

        Parameters
        ----------
        inner_speed : float
            In rad/s, of either sign.
        axial_load : float
            Along z, N.
        radial_load, moment : float
            Along x, N, and about y, N m.
        temperature : float, optional
            Of the oil at the inlets, K; None: the scene's.

        Returns
        -------
        dict of str to float
            By the names of the arguments: N m per N, N, N m, rad/s and K; temperature is missing without an oil, moment
            where the scene holds the tilt of the ring.

        Raises
        ------
        InputError
            As `friction_torque`; NaN instead where `invalid` is "nan".
        ConvergenceError
            Likewise.

        Notes
        -----
        Where the torque has a kink, at a speed of 0, it is the mean of both sides.
        """
        warm = self._temperature if temperature is None else temperature
        given = dict(zip(GIVEN, (axial_load, radial_load, moment, inner_speed, warm), strict=True))
        point = {name: _one_number(name, value) for name, value in given.items()}
        if self.scene.lubricant is None:
            point.pop("temperature")
        free = self.model is not None and self.model.is_free
        load = float(np.hypot(point["axial_load"], point["radial_load"]))
        scales = {
            "axial_load": load,
            "radial_load": load,
            "moment": max(abs(moment), load * self.scene.bearing.pitch_diameter / 2),
            "inner_speed": abs(point["inner_speed"]) or 1.0,
            "temperature": 100.0,  # K, over which viscosity changes by much
        }
        slopes, same = {}, self
        if self._is_held:
            point.pop("moment")
        if self.model is not None:  # both ends by the nodes of the middle, so that their error is common
            self(**point)
            same = replace(self, model=self.model.with_numbers(level=int(self.out["level"][0]), allowed=np.inf))
        for name, value in point.items():
            step = (FREE_STEP if free else STEP) * scales[name]
            low, high = value - step, value + step
            if name == "axial_load":
                low = max(low, 0.0)
            ends = [same(**{**point, name: end}) for end in (low, high)]
            slopes[name] = (ends[1] - ends[0]) / (high - low)
        return slopes

    def _stirring(self, speed: ArrayLike, temperature: ArrayLike) -> Array:
        """Torque of the oil outside the contacts, N m; speed : rad/s;  temperature : of the oil, K"""
        assert self.stirred is not None
        oil = self.scene.lubricant
        assert oil is not None
        names = ("viscosity", "pressure_viscosity", "reference_temperature", "viscosity_temperature")
        numbers = {name: getattr(oil, name) for name in names}
        return self.stirred.torque(speed, roelands_viscosity(pressure=0.0, temperature=temperature, **numbers))

    @cached_property
    def _temperature(self) -> float:
        return 0.0 if self.scene.lubricant is None else float(self.scene.lubricant.temperature)

    @cached_property
    def _solve(self) -> Callable[[], int]:
        """The kernel with what a call writes and reads."""
        assert self.model is not None
        assert self.work is not None
        model = self.model
        return solve.bound(model.numbers, model.tables, self.points, self.work, NO_BALLS, self.out, model.is_free)

    @cached_property
    def _is_held(self) -> bool:
        return not np.isnan(self.scene.operation.held_tilt)

    @cached_property
    def _temperatures(self) -> tuple[float, float]:
        return (-np.inf, np.inf) if self.scene.lubricant is None else OIL_TEMPERATURES

    def _takes(self, point: Array) -> bool:
        """Whether the kernel may answer: it refuses neither a thrust the wrong way, nor a moment beside a tilt."""
        coldest, hottest = self._temperatures
        known = point[0] >= 0.0 and coldest <= point[4] <= hottest and np.isfinite(point).all()
        known = known and not (point[2] and self._is_held)
        return bool(known and (self._distributes or not (point[1] or point[2])))

    @cached_property
    def _distributes(self) -> bool:
        return ENTRIES["load_distribution"].lacks(self.scene) is None

    def _slowly(self, point: Array) -> float:
        """By `friction_torque`, which has every closed form and every error."""
        axial, radial, moment, speed, temperature = (float(value) for value in point)
        coldest, hottest = self._temperatures
        try:
            if not coldest <= temperature <= hottest:
                raise InputError(
                    f"temperature must be {coldest:g} to {hottest:g} K, got {temperature:g}: give that of the oil in K"
                )
            load = {"axial_load": axial, "radial_load": radial, "moment": moment, "inner_speed": speed}
            arrays = {name: np.array([value]) for name, value in load.items()}
            operation = replace(self.scene.operation, **arrays)
            scene, oil = replace(self.scene, operation=operation), self.scene.lubricant
            if oil is not None and temperature != oil.temperature:
                scene = replace(scene, lubricant=replace(oil, temperature=temperature))
            return float(friction_torque(scene).settled().torque.total[0])
        except FembearingError:
            if self.invalid == "nan":
                return np.nan
            raise


def torque_function(
    scene: Scene | str | os.PathLike[str], *, invalid: Invalid = "raise", **given: Unpack[SceneOptions]
) -> TorqueFunction:
    """The friction torque of a scene as a function of load, speed and temperature, for a loop over time steps.

    Parameters
    ----------
    scene : Scene, str or path
        A moment in its operating points, or a tilt "free", lets the ring tilt freely in every call; else its tilt is
        held.
    invalid : {"raise", "nan"}
        What a call gives for numbers without an answer: an error, or NaN.
    **given : float, str, list or mapping
        With a name, the other arguments of `load_scene`: radial_load="3 kN", speed="3000 rpm", settings.

    Returns
    -------
    TorqueFunction
        A call takes N, N m, rad/s and K and returns N m; `series` takes arrays, and `gradient` gives derivatives.

    Raises
    ------
    InputError
        A scene whose cage has to move, and as `friction_torque` does at the scene's points.

    Notes
    -----
    Every call computes the same effects as `friction_torque`, and depends on no other call. The cage rests on its
    balls. Of a pair of bearings each call is a `friction_torque`; all others are compiled.
    Sources: those of `friction_torque`, whose formulas are compiled.
    """
    scene = scene_by(scene, given)
    if invalid not in ("raise", "nan"):
        raise InputError(f'invalid must be "raise" or "nan", got {invalid!r}')
    for name in AT_REST:
        if scene.effects.get(name) == "on":
            raise InputError(f'effects.{name} = "on": a moving cage has no torque at one instant; give "auto" or "off"')
    held = scene.operation.held_tilt  # once for all calls; a pair tilts as its loads have it
    is_free = scene.arrangement is not None or np.isnan(held)
    operation = replace(scene.operation, tilt="free" if is_free else held)
    still = replace(scene, effects={**scene.effects, **AT_REST}, operation=operation)
    friction_torque(still).settled()  # raises what is wrong with the scene
    counted, model = counted_effects(still), None
    if scene.arrangement is None:
        model = model_of(still, counted, free=turns_freely(still, counted))
    return TorqueFunction(
        scene=still,
        invalid=invalid,
        model=model,
        work=None if model is None else workspace(model),
        points=np.zeros((1, 5)),
        out=np.zeros(1, POINT),
        stirred=None if model is None else stirred_oil(still, still.losses),
    )


def _one_number(name: str, given: Any) -> float:
    """Raises InputError for anything but one real number."""
    number = real_numbers(name, given)
    if number.ndim:
        raise InputError(f"{name} must be one number, got {given!r:.80}; `series` takes arrays")
    return float(number)
