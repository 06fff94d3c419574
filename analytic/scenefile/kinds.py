"""What keys of a scene take beside words, numbers and quantities: bearings, materials, viscosities and others."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Literal, NamedTuple, get_args

from analytic import catalog
from analytic.catalog.bearing_rows import find_bearing
from analytic.declared import Table, nothing
from analytic.errors import InputError
from analytic.quantity import SI, Dimension
from analytic.scene import Temperature
from analytic.scenefile.law_packages import BUILT_IN, GROUP, installed_laws
from analytic.words import shown

EXTENT = Dimension(unit="m", low=1e-7, high=1.0, example='"3 mm"')
LARGEST_SHARE = 3.0  # of a value: a standard deviation beyond it says that the value is not known
SHARE = Dimension(unit="", low=0, high=LARGEST_SHARE, example='"10 %"')
KINEMATIC = Dimension(unit="m^2/s", low=1e-7, high=10, example='"46 cSt"')
_, TEMPERATURE = get_args(Temperature)
NOTHING = nothing()
NEEDED = {"youngs_modulus": '"206 GPa"', "poisson_ratio": "0.29", "density": '"7850 kg/m^3"'}  # and examples


@dataclass(frozen=True)
class Designation:
    """A bearing of the catalogue."""

    accepted: str = 'give a designation, for example "6206"'
    is_text: ClassVar = True

    def read(self, given: object) -> Any:
        """The designation. Raises ValueError for one that the catalogue does not have."""
        if not isinstance(given, str):
            raise ValueError('is no designation; give it in quotes, for example "6206"')
        if given not in catalog.names("bearings"):
            try:
                find_bearing(given)
            except InputError as problem:
                raise ValueError(str(problem).removeprefix(f"bearing {shown(given)} ")) from None
        return given


@dataclass(frozen=True)
class RowOf:
    """The name of a row of a table of the catalog."""

    table: Literal["base_oils", "finishes"]
    thing: str
    is_text: ClassVar = True

    @property
    def words(self) -> tuple[str, ...]:
        """The names."""
        return tuple(catalog.rows(self.table))

    @property
    def accepted(self) -> str:
        """The end of a message."""
        return f"give one of {', '.join(self.words)}"

    def read(self, given: object) -> Any:
        """The name. Raises ValueError for another one."""
        if given not in self.words:
            raise ValueError(f"is not a {self.thing}; {self.accepted}")
        return given


@dataclass(frozen=True)
class Law:
    """The name of a law of traction, built in or installed; the package is not imported yet."""

    accepted: str = 'give "eyring_sinh", "eyring_constant" or the name of an installed law'
    is_text: ClassVar = True

    def read(self, given: object) -> Any:
        """The name. Raises ValueError for another one."""
        known = (*BUILT_IN, *installed_laws())
        if given not in known:
            remedy = f"give one of {', '.join(known)}, or install a package that has it as {GROUP}"
            raise ValueError(f"is not a law of traction; {remedy}")
        return given


@dataclass(frozen=True)
class Solid:
    """A material: a name of the catalog, or a table."""

    inside: Table
    accepted: str = 'give a material, for example "steel"'
    is_text: ClassVar = True

    def read(self, given: object) -> Any:
        """The name. Raises ValueError for what is none."""
        material_entry(given)
        return given


@dataclass(frozen=True)
class Direction:
    """Where gravity points."""

    accepted: str = "give three numbers, for example [1, 0, 0]"

    def read(self, given: object) -> Any:
        """The unit vector. Raises ValueError for what has no direction."""
        given = [*given] if isinstance(given, tuple) else given
        numbers = isinstance(given, list) and all(isinstance(each, int | float) for each in given)
        length = math.hypot(*given) if isinstance(given, list) and numbers and len(given) == 3 else 0.0
        if not isinstance(given, list) or not 0 < length < math.inf:
            raise ValueError(
                "is no direction; give where gravity points as [x, y, z] of any length, with x towards the radial load "
                "and z along the thrust, for example [1, 0, 0]"
            )
        return tuple(float(each) / length for each in given)


@dataclass(frozen=True, kw_only=True)
class Extent(Dimension):
    """A share of the ball's radius, or a length."""

    @property
    def accepted(self) -> str:
        """The end of every message."""
        return f"{super().accepted} of the ball's radius, or a length, {EXTENT.example}"

    def read(self, given: object) -> Any:
        """The share, or the length. Raises ValueError as `Dimension.read`."""
        if isinstance(given, str) and not given.rstrip().endswith("%"):
            return SI(EXTENT.read(given), "m")
        return super().read(given)


class GivenSpread(NamedTuple):
    """A standard deviation as a scene gives it."""

    value: float
    is_share: bool  # of the input's value; else in its unit, SI


@dataclass(frozen=True, kw_only=True)
class Spread:
    """What a standard deviation accepts; `of` accepts only one in the unit of the input, as a sweep steps through."""

    of: Dimension
    takes_share: bool

    @property
    def accepted(self) -> str:
        """The end of every message."""
        return f'{self.of.accepted}, or "5 %"' if self.takes_share and self.of.unit else self.of.accepted

    def read(self, given: object) -> GivenSpread:
        """The deviation, or the share of the value. Raises ValueError that says what is wrong and what is accepted."""
        if isinstance(given, str) and given.rstrip().endswith("%"):
            if not self.takes_share:
                raise ValueError(f"is a share, but this input needs the standard deviation itself; {self.accepted}")
            return GivenSpread(value=SHARE.read(given), is_share=True)
        return GivenSpread(value=self.of.read(given), is_share=False)


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


def material_entry(given: object, overrides: Mapping[str, Any] = NOTHING) -> dict[str, Any]:
    """The table of a material that a scene names or gives; what a table with a catalog's name leaves out is filled in.

    overrides : keys that take precedence, of a name
    Raises ValueError for an unknown name, and for a name whose entry lacks what a material needs.
    """
    is_table = isinstance(given, dict)
    name, own = (given.get("name"), given) if is_table else (given, overrides)
    found = catalog.find("materials", name) if isinstance(name, str) else None
    if found is None and is_table:
        return given
    if found is None:
        known = ", ".join(catalog.names("materials"))
        raise ValueError(f"is not a material; give one of {known}, or a table with youngs_modulus and so on")
    entry = catalog.entry("materials", found)
    entry.pop("also", None)
    if changed := [key for key in own if key not in ("name", "source")]:
        entry["source"] = f"{entry['source']}; given: {', '.join(changed)}"
    entry |= own
    missing = [key for key in NEEDED if key not in entry and not is_table]
    if missing:
        rest = ", ".join(f"{key} = {NEEDED[key]}" for key in missing)
        raise ValueError(
            f"has no sourced {' and no '.join(missing)}; give it with the name, for example "
            f'{{ name = "{name}", {rest} }}'
        )
    return entry
