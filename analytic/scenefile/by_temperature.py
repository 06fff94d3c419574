"""A scene whose oil has another temperature than its file says: the oil is then read again.

An oil is known over the temperature by its name or by two viscosities; a single viscosity with a slope is not enough
for the tens of kelvins over which a bearing warms.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

from analytic.errors import InputError
from analytic.scene import Scene
from analytic.scenefile.oil import lubricant_of
from analytic.scenefile.tables import LubricantTable, SceneTable, ThermalTable

ZERO_CELSIUS = 273.15  # K


@dataclass(frozen=True, kw_only=True)
class SceneByTemperature:
    """A scene at any temperature of its oil."""

    scene: Scene  # with the oil at the temperature of its file
    origin: str  # names the file in messages
    oil: LubricantTable | None  # None: the scene has none
    thermal: ThermalTable | None  # None: the temperature of the oil is given

    @property
    def is_known_elsewhere(self) -> bool:
        """Whether the oil is known at other temperatures than that of the scene."""
        return self.oil is not None and not _is_known_at_one(self.oil)

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
        if self.oil is None:
            if self.scene.lubricant is None:
                raise InputError(f"{self.origin}: the scene has no [lubricant]; give the file of a scene with one")
            raise InputError(f"{self.origin}: a Scene holds its oil at one temperature; give the file of the scene")
        if _is_known_at_one(self.oil):
            assert self.oil.viscosity is not None
            raise InputError(
                f"{self.origin}: oil at {temperature - ZERO_CELSIUS:.4g} degC: lubricant.viscosity = "
                f"{self.oil.viscosity.text} beside lubricant.name holds at lubricant.temperature alone; give two "
                'viscosities, as ["46 cSt at 40 degC", "6.8 cSt at 100 degC"]'
            )
        table = self.oil.model_copy(update={"temperature": temperature})
        try:
            oil = lubricant_of(table, ball_radius=self.scene.bearing.ball_radius)
        except InputError as problem:
            raise InputError(f"{self.origin}: oil at {temperature - ZERO_CELSIUS:.4g} degC: {problem}") from problem
        return replace(self.scene, lubricant=oil)


def _is_known_at_one(oil: LubricantTable) -> bool:
    """Whether one viscosity replaces that of a named oil, which then has no law over the temperature."""
    return oil.name is not None and oil.viscosity is not None and not oil.viscosity.is_pair


def thermal_faults(table: SceneTable) -> Iterator[tuple[str, str]]:
    """(key, problem) of a scene with [thermal] whose oil is not known at other temperatures."""
    if table.thermal is None:
        return
    if table.lubricant is None:
        yield "thermal", "warms the oil, and the scene has no [lubricant]; add one, or leave [thermal] out"
    elif table.lubricant.viscosity is not None and not table.lubricant.viscosity.is_pair:
        yield (
            "lubricant.viscosity",
            "is known at one temperature alone, and [thermal] changes the temperature; give two viscosities, as "
            '["46 cSt at 40 degC", "6.8 cSt at 100 degC"], or name = "ISO VG 46" in its place',
        )
