"""How uncertain the inputs of a scene are: what the scene says, else where the input comes from, else a default."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np

from analytic.errors import InputError
from analytic.oil.film import FORMULA_UNCERTAINTY
from analytic.oil.variation import (
    ELASTIC_SPREAD,
    GAP_SPREAD,
    GREASE_SPREAD,
    HEATING_SPREAD,
    OIL_LOSS_FACTORS,
    ROLLING_SPREAD,
    STARVATION_SPREAD,
    SURFACE_SPREAD,
    UNLOADED_SPREAD,
)
from analytic.rows import Positive
from analytic.scene import LOSS_SPREAD, Array, Origin, Scene
from analytic.scenefile.inputs import LARGEST, checked_deviation, uncertain_value, unit_of
from analytic.scenefile.keys import UNCERTAIN


class Default(NamedTuple):
    """A standard deviation where neither the scene nor the catalogue has one."""

    deviation: float
    is_share: bool  # of the value (of the logarithm); else in its unit, SI
    source: str


# The standard deviation of a range a to b over which a value lies evenly is (b - a)/sqrt(12).
DEFAULTS: dict[str, Default] = {
    "bearing.clearance": Default(2.5e-6, False, "judgement: a clearance is known to 5 um in 95 % of all cases"),
    **dict.fromkeys(
        ("bearing.inner.conformity", "bearing.outer.conformity"),
        Default(0.0006 / 3**0.5, False, "judgement: a given groove radius is rounded to 0.01 mm for 8 mm balls"),
    ),
    **dict.fromkeys(
        ("bearing.contact_angle.free", "bearing.contact_angle.value"),
        Default(0.03, False, "judgement: clearance and groove radii, which the angle follows from, are rounded"),
    ),
    **dict.fromkeys(
        ("arrangement.preload", "arrangement.offset"), Default(0.10, True, "judgement: how well a preload is set")
    ),
    **dict.fromkeys(
        ("operation.axial_load", "operation.radial_load", "operation.moment"),
        Default(0.01, True, "judgement: how well a load is known on a test rig"),
    ),
    "lubricant.viscosity": Default(0.06, True, "evenly within 10 %, as a class of [ISO3448] is wide"),
    "lubricant.temperature": Default(2.0, False, "judgement: how well the temperature at the inlet is known"),
    "lubricant.pressure_viscosity": Default(0.10, True, "judgement: two laboratories differ by 8 %"),
    "lubricant.limiting_shear": Default(0.13, True, "judgement: 0.05 to 0.08 are usual"),
    "lubricant.surface_tension": Default(0.125, True, "0.017 to 0.028 N/m of two greases [Shetty2024]"),
    "lubricant.reach.ahead": Default(0.2, True, "judgement: oil in a bath reaches 0.6 radii of the ball or more ahead"),
    "surface.rms_roughness": Default(0.10, True, "judgement: how far a finish is repeated"),
    "surface.autocorrelation.length": Default(0.35, True, "judgement: it is seldom measured"),
    "surface.boundary_friction": Default(0.14, True, "judgement: 0.09 to 0.15 are usual"),
    "surface.hardness": Default(0.05, True, "judgement: 60 to 64 HRC"),
    "friction.coefficient": Default(0.20, True, "judgement"),
    "friction.hysteresis_loss": Default(LOSS_SPREAD, True, "judgement: sources have 0.003 to 0.025"),
    "losses.seals": Default(0.30, True, "judgement: seals differ and run in"),
    "losses.drag": Default(0.30, True, "judgement"),
    "losses.oil_flow": Default(0.05, True, "judgement: how well a flow is known on a test rig"),
    "losses.oil_share": Default(0.50, True, "judgement: it is hardly ever measured"),
    "cage.friction_coefficient": Default(0.30, True, "judgement: as for the boundary friction of other surfaces"),
    "model.film": Default(FORMULA_UNCERTAINTY, True, "measured films about the formula [Wittek]"),
    "model.gap": Default(GAP_SPREAD, False, "the distance of two laws, shared load and measured friction [Taylor2026]"),
    "model.surfaces": Default(SURFACE_SPREAD, True, "computed: generated surfaces of equal statistics differ so"),
    "model.rolling": Default(ROLLING_SPREAD, True, "judgement: formulas, and torques of three balls [Balan2015]"),
    "model.heating": Default(HEATING_SPREAD, True, "judgement: laws of heating and of thinning by shear"),
    "model.starvation": Default(STARVATION_SPREAD, False, "judgement: at a start the oil lies in the race"),
    "model.grease_film": Default(GREASE_SPREAD, True, "judgement: laws of films measured with grease [Shetty2024]"),
    "model.unloaded_balls": Default(UNLOADED_SPREAD, True, "judgement: where a ball lies in its clearance"),
    "model.oil_losses": Default(
        np.log(OIL_LOSS_FACTORS[1]) / 3**0.5, True, "evenly within a factor of 2, as cage and inner race bound the flow"
    ),
    "model.elastic_rolling": Default(ELASTIC_SPREAD, False, "the distance of two laws, hysteresis and [Houpert2002]"),
}
NUMERICAL = "numerical"


@dataclass(frozen=True, kw_only=True)
class UncertainInput:
    """One input that a prediction varies, SI."""

    key: str  # of `analytic.scenefile.keys.UNCERTAIN`; "numerical" of the numerical uncertainty
    kind: Literal["numerical", "input", "model"]  # which of the three parts of the interval it belongs to
    value: float  # nominal, SI
    unit: str  # "" for a pure number
    deviation: Positive  # standard deviation, in the unit of the value
    source: str  # of the deviation
    floor: float | None = 0.0  # in the unit of the value; the logarithm of what is above it is normal, None: the value

    def at(self, score: Array) -> Array:
        """The values of the input at some scores.

        Parameters
        ----------
        score : ndarray, any shape
            Normal, with mean 0 and standard deviation 1, dimensionless.

        Returns
        -------
        ndarray
            Of the shape of score, in the unit of the input, SI; at most the largest value that the input can have.
        """
        if self.floor is None:
            return self.value + self.deviation * score
        above = self.value - self.floor
        values = self.floor + above * np.exp(self.deviation / above * score)
        return np.minimum(values, LARGEST.get(self.key, np.inf))


def uncertain_inputs(scene: Scene) -> tuple[UncertainInput, ...]:
    """The inputs of a scene that are uncertain, in the order of `analytic.scenefile.keys.UNCERTAIN`.

    Raises InputError for a standard deviation that is negative, too large, or of an input that the scene does not have.
    """
    for key in scene.uncertainty:
        if key not in UNCERTAIN:
            raise InputError(f"uncertainty.{key} is of no input that varies; known: {', '.join(UNCERTAIN)}")
        if uncertain_value(scene, key) is None:
            raise InputError(f"uncertainty.{key} is of an input that this scene does not have; leave it out")
    return tuple(_varying(scene))


def _varying(scene: Scene) -> Iterator[UncertainInput]:
    for key, floor in UNCERTAIN.items():
        value = uncertain_value(scene, key)
        if value is None:
            continue
        deviation, source = _spread_of(scene, key, value)
        if deviation > 0:
            checked_deviation(key, value, deviation)
            yield UncertainInput(
                key=key,
                kind="model" if key.startswith("model.") else "input",
                value=value,
                unit="" if unit_of(key) == "1" else unit_of(key),
                deviation=deviation,
                source=source,
                floor=floor,
            )


def _spread_of(scene: Scene, key: str, value: float) -> tuple[float, str]:
    """Standard deviation and source; 0 for an input that is known."""
    if key in scene.uncertainty:
        return checked_deviation(key, value, scene.uncertainty[key]), "the scene"
    table, _, rest = key.partition(".")
    part = getattr(scene, table) if table in ("bearing", "cage", "lubricant", "surface", "losses") else None
    origin: Origin | None = None if part is None else part.origins.get(rest)
    if origin is not None and origin.uncertainty is not None:
        return origin.uncertainty, f"{origin.status}: {origin.source}"
    if key == "model.traction" and scene.lubricant is not None:
        return scene.lubricant.traction_spread, "law and measured traction, by the kind of oil"
    if key not in DEFAULTS:
        return 0.0, ""
    default = DEFAULTS[key]
    return default.deviation * (value if default.is_share else 1.0), default.source
