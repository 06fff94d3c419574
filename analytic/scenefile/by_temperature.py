"""A scene whose oil has another temperature than its file says: the oil is then read again.

An oil is known over the temperature by its name or by two viscosities; a single viscosity with a slope is not enough
for the tens of kelvins over which a bearing warms.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

from analytic.errors import InputError
from analytic.scene import Scene, Thermal
from analytic.scenefile.keys import Values
from analytic.scenefile.kinds import GivenViscosity
from analytic.scenefile.oil import lubricant_of

ZERO_CELSIUS = 273.15  # K


@dataclass(frozen=True, kw_only=True)
class SceneByTemperature:
    """A scene at any temperature of its oil."""

    scene: Scene  # with the oil at the temperature of its file
    origin: str  # names the file in messages
    values: Values | None = None  # of its keys; None: a Scene of Python
    thermal: Thermal | None = None  # None: the temperature of the oil is given

    @property
    def is_known_elsewhere(self) -> bool:
        """Whether the oil is known at other temperatures than that of the scene."""
        return self._oil is not None and not _is_known_at_one(self._oil)

    @property
    def _oil(self) -> Values | None:
        """The values of a scene with oil."""
        return self.values if self.values is not None and "lubricant" in self.values.said else None

    @property
    def fixed(self) -> Scene:
        """The scene at the temperature of its file. Raises InputError where friction settles the temperature."""
        if self.thermal is not None:
            raise InputError(
                f"{self.origin}: the scene has [thermal], so friction determines the oil temperature: leave the table "
                "out and give lubricant.temperature, or run fembearing torque (in Python analytic.steady_scene)"
            )
        return self.scene

    def at(self, temperature: float) -> Scene:
        """The scene with its oil at a temperature, K.

        Raises InputError for another temperature than the scene's without the table of an oil, with a viscosity that
        replaces that of a named oil at one temperature, and beyond the oil's data.
        """
        if self.scene.lubricant is not None and temperature == self.scene.lubricant.temperature:
            return self.scene
        oil = self._oil
        if oil is None:
            if self.scene.lubricant is None:
                raise InputError(f"{self.origin}: the scene has no [lubricant]; give the file of a scene with one")
            raise InputError(f"{self.origin}: a Scene holds its oil at one temperature; give the file of the scene")
        if _is_known_at_one(oil):
            text = oil["lubricant.viscosity"].text
            raise InputError(
                f"{self.origin}: oil at {temperature - ZERO_CELSIUS:.4g} degC: lubricant.viscosity = {text} beside "
                "lubricant.name holds at lubricant.temperature alone; give two "
                'viscosities, as ["46 cSt at 40 degC", "6.8 cSt at 100 degC"]'
            )
        try:
            warm = lubricant_of(oil.at(temperature), ball_radius=self.scene.bearing.ball_radius)
        except InputError as problem:
            raise InputError(f"{self.origin}: oil at {temperature - ZERO_CELSIUS:.4g} degC: {problem}") from problem
        return replace(self.scene, lubricant=warm)


def _is_known_at_one(oil: Values) -> bool:
    """Whether one viscosity replaces that of a named oil, which then has no law over the temperature."""
    viscosity: GivenViscosity | None = oil["lubricant.viscosity"]
    return oil["lubricant.name"] is not None and viscosity is not None and not viscosity.is_pair


def thermal_faults(v: Values) -> Iterator[tuple[str, str]]:
    """(key, problem) of a scene with [thermal] whose oil is not known at other temperatures."""
    viscosity: GivenViscosity | None = v["lubricant.viscosity"]
    if "thermal" not in v.said:
        return
    if "lubricant" not in v.said:
        yield "thermal", "warms the oil, and the scene has no [lubricant]; add one, or leave [thermal] out"
    elif viscosity is not None and not viscosity.is_pair:
        yield (
            "lubricant.viscosity",
            "is known at one temperature alone, and [thermal] changes the temperature; give two viscosities, as "
            '["46 cSt at 40 degC", "6.8 cSt at 100 degC"], or name = "ISO VG 46" in its place',
        )
