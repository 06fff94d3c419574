"""The steady temperature of the oil: friction warms it until all its power leaves by the thermal resistance.

    T = T_ambient + R P(T)

A thin film or thick asperities may give several such temperatures. A bearing that starts at the ambient temperature
warms to the lowest of them, at which R P(T) - (T - T_ambient) first falls to 0: this is the one that is found.
"""

import os
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from typing import Unpack

from analytic.declared import read_only
from analytic.errors import InputError, SingularError
from analytic.given import SceneOptions
from analytic.scene import Origin, Scene, Thermal
from analytic.scenefile.read import ZERO_CELSIUS, SceneByTemperature, load_by_temperature
from analytic.torque import friction_torque

STEP = 10.0  # K: two steady temperatures that lie nearer to each other than this may be missed together
FINEST = 0.1  # K: how near to the end of the oil's data is searched
ACCURACY = 1e-4  # K, of the temperature for a power without jumps


@dataclass(frozen=True, kw_only=True)
class SteadyTemperature:
    """The oil of a bearing that gives as much heat away as friction makes."""

    temperature: float  # of the oil, K
    power: float  # of friction, W
    ambient: float  # temperature of the surroundings, K
    resistance: float  # thermal, from the oil to the surroundings, K/W

    @property
    def words(self) -> str:
        """Where the temperature comes from."""
        return (
            f"steady: {self.ambient - ZERO_CELSIUS:.4g} degC of the surroundings and {self.resistance:g} K/W times "
            f"{self.power:.4g} W of friction"
        )


def steady_scene(scene: str | os.PathLike[str] | Scene | SceneByTemperature, **given: Unpack[SceneOptions]) -> Scene:
    """The scene of a file, with its oil at the steady temperature where the file has [thermal].

    Parameters
    ----------
    scene : str or path
        What `load_scene` reads: a file, a built-in scene or a designation as "6308"; or what was read of one.
    **given : float, str, list or mapping
        The other arguments of `load_scene`, as settings={"thermal.resistance": 0.5, "thermal.ambient": 293.15}, K/W, K.

    Returns
    -------
    Scene
        Its `lubricant.temperature`, K, is steady, and `lubricant.origins` says so; without [thermal] as `load_scene`.

    Raises
    ------
    InputError
        As `load_scene` and `friction_torque`; several operating points, each of which has another temperature.
    ConvergenceError
        No steady temperature within the data of the oil: friction warms it further.

    Notes
    -----
    The temperature takes the place of the scene's own. Those of rings and balls in [mounting] stay. The thermal
    resistance is that of the whole bearing in its place, and no formula here gives it.
    Source: the balance of heat.
    """
    return at_steady_temperature(load_by_temperature(scene, **given))


def at_steady_temperature(found: SceneByTemperature) -> Scene:
    """What `steady_scene` returns, of a scene that is read."""
    if found.thermal is None:
        return found.scene
    points = found.scene.operation.as_series().inner_speed.size
    if points > 1:
        raise InputError(
            f"{found.origin}: [thermal] with {points} operating points, each with its own oil temperature; give one "
            "point, or the points as a cycle to fembearing duty"
        )

    def power(temperature: float) -> float:
        result = friction_torque(found.at(temperature))
        return float(result.torque.total[0] * abs(result.inner_speed[0]))

    return with_steady_oil(found, steady_temperature(power, found.thermal, tolerance=found.scene.tolerance))


def with_steady_oil(found: SceneByTemperature, steady: SteadyTemperature) -> Scene:
    """The scene with its oil at that temperature, and where it comes from."""
    warm = found.at(steady.temperature)
    assert warm.lubricant is not None  # its temperature was found
    origin = Origin(status="derived", uncertainty=None, source=steady.words)
    origins = read_only({**warm.lubricant.origins, "temperature": origin})
    told = {key: value for key, value in warm.usual.items() if key != "lubricant.temperature"}
    return replace(warm, lubricant=replace(warm.lubricant, origins=origins), usual=read_only(told))


def steady_temperature(power: Callable[[float], float], thermal: Thermal, *, tolerance: float) -> SteadyTemperature:
    """The lowest temperature at which heat in and heat out are equal.

    Parameters
    ----------
    power : callable
        Of friction, W, at a temperature of the oil, K; it raises InputError where the oil is not known.
    thermal : Thermal
        Resistance, K/W, and ambient temperature, K.
    tolerance : float
        Of the power, relative (dimensionless): by so much it may jump where effects begin to count.

    Returns
    -------
    SteadyTemperature
        To 1e-4 K, or where the power jumps to the jump.

    Raises
    ------
    InputError
        As power at the ambient temperature.
    ConvergenceError
        None within the data of the oil, or a jump of the power that is larger than the tolerance.

    Notes
    -----
    Steps of 10 K up from the ambient temperature give a bracket, in which Brent's method finds the root.
    """
    from scipy.optimize import brentq  # slow to import

    watts = cache(power)

    def excess(temperature: float) -> float:
        return temperature - thermal.ambient - thermal.resistance * watts(temperature)

    low, step = thermal.ambient, STEP
    found, high = low, low
    if excess(low) < 0:
        while excess(high) < 0:
            low, high = high, high + step
            try:
                excess(high)
            except InputError as problem:
                high, step = low, step / 2
                if step < FINEST:
                    raise _none(watts(low), low, thermal, problem) from problem
        found = brentq(excess, low, high, xtol=ACCURACY)
    balance = abs(excess(found))
    if balance > tolerance * thermal.resistance * watts(found) + 2 * ACCURACY:
        raise SingularError(
            problem=f"the oil has no steady temperature: at {found - ZERO_CELSIUS:.4g} degC the power of friction "
            f"jumps by {balance / thermal.resistance:.3g} W",
            remedy="Give lubricant.temperature in place of [thermal].",
        )
    return SteadyTemperature(
        temperature=found, power=watts(found), ambient=thermal.ambient, resistance=thermal.resistance
    )


def _none(power: float, temperature: float, thermal: Thermal, problem: InputError) -> SingularError:
    """No steady temperature up to the one where the oil's data end."""
    balanced = thermal.ambient + thermal.resistance * power
    return SingularError(
        problem=f"the oil has no steady temperature within its data: at {temperature - ZERO_CELSIUS:.4g} degC "
        f"friction of {power:.4g} W with thermal.resistance = {thermal.resistance:g} K/W warms it towards "
        f"{balanced - ZERO_CELSIUS:.4g} degC, and above: {problem}",
        remedy="Cool the bearing better: give a lower thermal.resistance.",
    )
