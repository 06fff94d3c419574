"""What a lubricated contact is made of, and the numbers that it depends on."""

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np

from analytic.errors import InputError, require_positive
from analytic.scene import Array
from analytic.words import length_of
from fembearing.ehl.oil import Oil
from fembearing.fem.half_space import hertz_ellipse

LEAST_REACH = 1.25  # semi-axes of Hertz's ellipse: with less oil the inlet lies in the contact
MOST_PRESSURE = (
    5e9  # Pa, Hertz's: Roelands's law is extrapolated above 1 GPa, and has no sense where nothing is elastic
)


class Shape(Protocol):
    """The gap of the undeformed bodies, even in x and y."""

    @property
    def radii(self) -> tuple[float, float]:
        """R_x and R_y at the point of contact, m."""
        ...

    @property
    def outline(self) -> tuple[float, float]:
        """How far the bodies reach along x and y, m."""
        ...

    def gap(self, x: Array, y: Array) -> Array:
        """The gap, m, at x and y, m, which broadcast."""
        ...

    def slope(self, x: Array, y: Array) -> Array:
        """d gap/dx at x and y, m, which broadcast."""
        ...


class AddedCompliance(Protocol):
    """What the true shapes of both bodies add to the displacement of two half spaces."""

    def normal_influence(self, place: tuple[Array, Array], loaded: tuple[Array, Array]) -> Array:
        """Displacement of the surfaces from each other by unit normal forces on them.

        place, loaded : x and y, (m,) and (n,), of the displacement and of the forces, m, from the contact's centre
        The displacement is (m, n), m/N, symmetric in y: mirrored places and forces have the same.
        """
        ...


@dataclass(frozen=True, kw_only=True)
class Reach:
    """Where the oil ends, as distances from the centre of the contact; the pressure there is ambient."""

    ahead: float  # m, in the inlet
    behind: float  # m, in the outlet
    side: float  # m, to either side, for a race the half width of its groove

    def __post_init__(self) -> None:
        require_positive(ahead=self.ahead, behind=self.behind, side=self.side)


@dataclass(frozen=True, kw_only=True)
class LubricatedContact:
    """Two elastic bodies that roll on each other without sliding, with oil between them: half spaces, or true shapes.

    Raises InputError if there is no load or no motion, if the contact is longer in rolling than across, if the oil ends
    within the contact or the bodies before the oil, or if Hertz's pressure exceeds 5 GPa.
    """

    load: float  # Q, N
    modulus: float  # E*, Pa: 1/E* is the sum of (1 - nu^2)/E
    shape: Shape
    speed: float  # u, mean of both surfaces, towards +x, m/s
    oil: Oil
    reach: Reach
    added: AddedCompliance | None = None  # None: half spaces

    def __post_init__(self) -> None:
        require_positive(modulus=self.modulus)
        if not 0 < self.load < np.inf:
            raise InputError(f"load must be positive, got {self.load:g} N: without load there is no contact to solve")
        if not 0 < self.speed < np.inf:
            raise InputError(
                f"speed must be positive, got {self.speed:g} m/s: at standstill there is no film, and x points ahead"
            )
        rolling, across = self.shape.radii
        if rolling > across * (1 + 1e-9):
            raise InputError(
                f"the contact is longer in rolling than across: R_x {length_of(rolling)} exceeds R_y "
                f"{length_of(across)}; the numerical film covers R_x up to R_y"
            )
        if self.peak_pressure > MOST_PRESSURE:
            raise InputError(
                f"Hertz's pressure of {self.peak_pressure / 1e9:.3g} GPa exceeds {MOST_PRESSURE / 1e9:g} GPa, where "
                "Roelands's viscosity has no meaning: lower the load"
            )
        for name, size, outline in zip(
            ("ahead", "behind", "side"),
            (self.semi_axes[0], self.semi_axes[0], self.semi_axes[1]),
            (self.shape.outline[0], self.shape.outline[0], self.shape.outline[1]),
            strict=True,
        ):
            reach = getattr(self.reach, name)
            if name == "side" and reach < LEAST_REACH * size:
                raise InputError(
                    f"the contact extends {length_of(size)} to either side, and the oil ends at {length_of(reach)}, "
                    f"between a race's shoulders; the numerical film needs {length_of(LEAST_REACH * size)}: lower the "
                    "load or raise shoulder_half_width"
                )
            if reach < LEAST_REACH * size:
                raise InputError(
                    f"the oil's reach {name} of {length_of(reach)} is shorter than the contact: give at least "
                    f"{length_of(LEAST_REACH * size)}, {LEAST_REACH:g} times its semi-axis"
                )
            if reach > outline:
                raise InputError(
                    f"the oil's reach {name} of {length_of(reach)} is beyond the bodies, which end at "
                    f"{length_of(outline)}"
                )

    @cached_property
    def semi_axes(self) -> tuple[float, float]:
        """Of Hertz's ellipse, a along rolling and b across, m."""
        rolling, across = self.shape.radii
        return hertz_ellipse((1 / rolling, 1 / across), load=self.load, modulus=self.modulus)

    @property
    def peak_pressure(self) -> float:
        """Hertz's, Pa."""
        return 1.5 * self.load / (np.pi * self.semi_axes[0] * self.semi_axes[1])

    @property
    def relative_speed(self) -> float:
        """U = 2 eta_0 u/(E' R_x), with E' = 2 E*."""
        return self.oil.viscosity * self.speed / (self.modulus * self.shape.radii[0])

    @property
    def loading(self) -> float:
        """Moes's M = Q/(E' R_x^2) U^(-3/4)."""
        return self.load / (2 * self.modulus * self.shape.radii[0] ** 2) * self.relative_speed**-0.75

    @property
    def thickening(self) -> float:
        """Moes's L = alpha E' U^(1/4)."""
        return self.oil.pressure_viscosity * 2 * self.modulus * self.relative_speed**0.25

    @property
    def ellipticity(self) -> float:
        """lambda = R_x/R_y."""
        rolling, across = self.shape.radii
        return rolling / across

    @property
    def film_scale(self) -> float:
        """R_x U^(1/2), m: the film over it is Moes's H."""
        return self.shape.radii[0] * self.relative_speed**0.5

    @property
    def force_scale(self) -> float:
        """E' R_x^2 U = 2 eta_0 u R_x, N: the rolling force over it is F^."""
        return 2 * self.oil.viscosity * self.speed * self.shape.radii[0]
