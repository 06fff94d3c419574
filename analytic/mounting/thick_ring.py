"""Rings that press on each other over a cylinder: thick rings in plane stress, by Lame's solution.

No axial force acts on a ring. Pressures are the same all around and across the width.
Source: [Timoshenko1970], stresses symmetric about an axis.
"""

from dataclasses import dataclass

from analytic.errors import InputError
from analytic.scene import Material
from analytic.words import length_of


@dataclass(frozen=True, kw_only=True)
class ThickRing:
    """A ring of one material; an inner radius of 0 is a solid disc, an infinite outer radius a plate without end."""

    inner_radius: float  # a, m, >= 0
    outer_radius: float  # b, m, > a
    material: Material

    def displacement(self, radius: float, *, inside: float = 0.0, outside: float = 0.0) -> float:
        """Outward displacement at a radius from a to b, m.

        inside, outside : pressures on the inner and the outer face, Pa; a disc has no inner face, a plate no outer one
            u(r) = (((1 - nu)(q p_i - p_o) r + (1 + nu)(p_i - p_o) a^2/r)/(E (1 - q)),  q = (a/b)^2
        """
        share = (self.inner_radius / self.outer_radius) ** 2
        uniform = (1 - self.material.poisson_ratio) * (share * inside - outside) * radius
        shearing = (1 + self.material.poisson_ratio) * (inside - outside) * self.inner_radius**2 / radius
        return (uniform + shearing) / (self.material.youngs_modulus * (1 - share))


def fit_pressure(inner: ThickRing, outer: ThickRing, *, interference: float) -> float:
    """Pressure between two rings, of which one sits inside the other, Pa; 0 where they do not touch.

    interference : by which the inner ring's outside diameter exceeds the outer ring's bore, m; any sign
    The two faces move together: half the interference is what both displacements under 1 Pa give, times the pressure.
    Raises InputError for radii that do not rise, or rings that do not meet at one radius.
    """
    radius = inner.outer_radius
    if not 0 <= inner.inner_radius < radius == outer.inner_radius < outer.outer_radius:
        raise InputError(
            f"rings from {length_of(inner.inner_radius, '.6g')} to {length_of(radius, '.6g')} and from "
            f"{length_of(outer.inner_radius, '.6g')} to {length_of(outer.outer_radius, '.6g')} do not fit into each "
            "other: the radii rise, and the middle ones are equal"
        )
    per_pressure = outer.displacement(radius, inside=1.0) - inner.displacement(radius, outside=1.0)
    return max(interference, 0.0) / 2 / per_pressure
