"""Viscosities as a scene gives them: dynamic or kinematic, one, or two at two temperatures."""

from dataclasses import dataclass
from typing import Any, get_args

from analytic.quantity import Dimension
from analytic.scene import Temperature
from analytic.words import shown

KINEMATIC = Dimension(unit="m^2/s", low=1e-7, high=10, example='"46 cSt"')
_, TEMPERATURE = get_args(Temperature)


@dataclass(frozen=True, kw_only=True)
class ViscosityPoint:
    """One viscosity."""

    value: float  # Pa s, or m^2/s
    is_kinematic: bool
    temperature: float | None  # K; None: none is given with it


@dataclass(frozen=True, kw_only=True)
class GivenViscosity:
    """The viscosity of an oil: one, or two at two temperatures."""

    points: tuple[ViscosityPoint, ...]
    text: str  # as it was given, for messages

    @property
    def is_pair(self) -> bool:
        return len(self.points) == 2

    @property
    def temperature(self) -> float | None:
        """That of the only viscosity, K; None: none is given, or there are two viscosities."""
        return None if self.is_pair else self.points[0].temperature

    @property
    def is_kinematic(self) -> bool:
        return any(point.is_kinematic for point in self.points)


@dataclass(frozen=True)
class Viscosity:
    """What the viscosity of an oil accepts; `of` accepts only a dynamic one, as a sweep steps through them."""

    of: Dimension

    @property
    def accepted(self) -> str:
        """The end of every message."""
        return f'{self.of.accepted}, or two at two temperatures, ["46 cSt at 40 degC", "6.8 cSt at 100 degC"]'

    def read(self, given: object) -> GivenViscosity:
        """One or two viscosities. Raises ValueError that says what is wrong and what is accepted."""
        if not isinstance(given, list):
            points = (self._point(given),)
        elif len(given) == 2:
            points = tuple(self._point(each) for each in given)
            if any(point.temperature is None for point in points):
                raise ValueError(f"has no temperature; {self.accepted}")
        else:
            raise ValueError(f"is not one viscosity or two; {self.accepted}")
        return GivenViscosity(points=points, text=shown(given))

    def _point(self, given: object) -> ViscosityPoint:
        value, at, temperature = given.partition(" at ") if isinstance(given, str) else (given, "", "")
        kelvin = TEMPERATURE.read(temperature.strip()) if at else None
        kinematic = _kinematic(value)
        return ViscosityPoint(
            value=self.of.read(value) if kinematic is None else kinematic,
            is_kinematic=kinematic is not None,
            temperature=kelvin,
        )


def _kinematic(given: Any) -> float | None:
    """The kinematic viscosity in m^2/s; None for what is none."""
    if not isinstance(given, str):
        return None
    try:
        return KINEMATIC.read(given)
    except ValueError:
        return None
