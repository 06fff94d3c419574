"""Mixed lubrication: oil film and asperities share the load of a rough contact.

The asperities carry the share s of the load and leave a mean gap between the surfaces, which the oil fills. The oil
carries 1 - s, as a smooth film under the load F (1 - s) between bodies of the modulus E* (1 - s). A film of about a
molecule lubricates no more: it leaves boundary friction.
Source: the shared load of [Johnson1972]; that the oil fills the mean gap follows from the flow, u times this gap.
"""

from dataclasses import dataclass, fields, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import expit

from analytic.contact.rolling_contact import EllipticContact
from analytic.errors import InputError, require_non_negative, require_positive
from analytic.numerics.root import Sought, bracketed_root
from analytic.oil.film import FilmAsymptotes
from analytic.scene import Array
from analytic.surface.gap import GapLaw

# Thickness over which a film turns into a layer of molecules that shears like a boundary film, a choice of this model:
# measured films follow the formula for films down to about 1 nm [Johnston1991].
MOLECULAR_FILM = 1e-9  # h_m, m
LAST_STEP = 1e-9  # of ln(s/(1 - s)); Newton's quadratic steps leave far less
NO_SHARE = -40.0  # ln(s/(1 - s)): asperities carry less than round-off of the load
NEARLY_ALL = 40.0  # s is 1 in double precision
BLOCK = 4096  # contacts at a time: the arrays stay in the processor's cache


@dataclass(frozen=True, kw_only=True, eq=False)
class MixedContact:
    """One or many lubricated rough contacts; every field has the broadcast shape of the arguments."""

    asperity_share: Array  # s, of the load, 0 to 1
    boundary_share: Array  # s_b = s + (1 - s) exp(-h/h_m), of the load, 0 to 1
    film_thickness: Array  # h, mean gap that the oil fills, m, >= 0
    area_fraction: Array  # A_a/A_H, of the contact's area that asperities touch, 0 to 1
    capped: NDArray[np.bool_]  # the film fills the clearance
    outside_range: NDArray[np.bool_]  # the film formula is extrapolated in ellipticity
    without_film: NDArray[np.bool_]  # standstill

    @property
    def oil_area(self) -> Array:
        """Share of the contact's area where oil shears: neither touched by asperities nor only a molecule thick."""
        return (1 - self.area_fraction) * -np.expm1(-self.film_thickness / MOLECULAR_FILM) * ~self.without_film

    @property
    def oil_thickness(self) -> Array:
        """Thickness of the oil beside the touching area, m: h/(1 - A_a/A_H)."""
        beside = 1 - self.area_fraction
        return np.divide(self.film_thickness, beside, out=np.zeros_like(beside), where=beside > 0)

    def race(self, race: int) -> "MixedContact":
        """The contacts of one race, where the first axis counts races."""
        return MixedContact(**{name: values[race] for name, values in vars(self).items()})


def mixed_contact(
    contact: EllipticContact,
    film: FilmAsymptotes,
    *,
    gap: GapLaw | None,
    film_factor: ArrayLike = 1.0,
    pressure_factor: float = 1.0,
) -> MixedContact:
    """The share of the load that asperities carry, and the film thickness; fields and arguments broadcast.

    contact : smooth, with the area A_H = pi a b of its semi-axes
    film : film_asymptotes of this contact
    gap : of both surfaces together, one law for all contacts; None: smooth
    film_factor : on the film, >= 0, for a heated or starved inlet and for the uncertainty of the film
    pressure_factor : on the asperities' pressure at any gap, > 0, for the uncertainty of the surfaces
    s in [0, 1] solves
        gap(s F/A_H) = film_factor * film(F (1 - s), E* (1 - s))
    As s grows, the film grows and the gap falls, so there is one solution. As the speed falls to 0 so does the film,
    while asperities that carry all leave a gap: s grows to 1, its value at standstill. Asperities also carry all where
    they do so at the largest gap that bodies and surroundings allow. Without load there is no share. A smooth contact
    has a share only without speed, where h = 0 and s = 1.
    The boundary share counts the oil's part too as far as its film is only a molecule thick: h_m = 1 nm.
    Raises InputError if a factor has the wrong sign, if shapes do not broadcast, or if a semi-axis is 0 under load.
    """
    require_non_negative(film_factor=film_factor)
    require_positive(pressure_factor=pressure_factor)
    force, area = np.asarray(contact.load, dtype=np.float64), contact.area
    try:
        with np.errstate(divide="ignore", invalid="ignore"):  # without load the softness is not used
            log_factor, log_softness = np.log(film_factor), np.log(area * pressure_factor) - np.log(force)
            thinned = {
                name: np.where(log_factor == -np.inf, -np.inf, log_factor + getattr(film, name))
                for name in ("rigid", "elastic", "unloaded", "piezoviscous")
            }
        parts = (*vars(replace(film, **thinned)).values(), log_softness, force)
        shape = np.broadcast(*parts).shape
        numbers = np.empty((len(parts), *shape))
        for row, part in enumerate(parts):
            numbers[row] = part
    except ValueError as problem:
        raise InputError(
            "the arguments of a mixed contact have shapes that do not fit together: give equal lengths"
        ) from problem
    if np.any(np.isneginf(numbers[-2])):  # ln 0 less the ln of a load
        raise InputError(
            "semi_axis_rolling or semi_axis_transverse is 0 under load: give the semi-axes of the smooth contact"
        )
    flat = numbers.reshape(len(parts), -1)
    blocks = [_shared(flat[:, start : start + BLOCK], gap) for start in range(0, max(flat.shape[1], 1), BLOCK)]
    share, height, touched = (np.concatenate(rows).reshape(shape) for rows in zip(*blocks, strict=True))
    film, *_ = _unpacked(numbers)
    without_film = np.isneginf(film.rigid)
    return MixedContact(
        asperity_share=share,
        boundary_share=share + (1 - share) * np.exp(-height / MOLECULAR_FILM),
        film_thickness=height,
        area_fraction=touched,
        capped=~without_film & (height >= np.exp(film.clearance)),
        outside_range=film.outside_range,
        without_film=without_film,
    )


def _shared(numbers: Array, gap: GapLaw | None) -> tuple[Array, Array, Array]:
    """Share, film thickness and area fraction of the contacts in the columns of numbers."""
    film, log_softness, load = _unpacked(numbers)
    log_film, loaded = film.log_film(0.0)[0], load > 0
    dry = np.isneginf(log_film)
    if gap is None:
        return np.where(dry & loaded, 1.0, 0.0), np.exp(log_film), np.where(dry, 1.0, 0.0)
    share, touched, log_height = np.zeros(load.shape), np.zeros(load.shape), log_film.copy()
    log_pressure = -np.where(loaded, log_softness, 0.0)  # if asperities carry all
    log_dry = gap.log_gap(log_pressure)[0]
    carried = loaded & (dry | (log_dry >= film.clearance))
    share[carried], log_height[carried] = 1.0, log_dry[carried]
    touched[carried] = gap.area_fraction(log_pressure[carried])
    sharing = loaded & ~carried
    sharing[sharing] = log_film[sharing] < gap.log_gap(NO_SHARE + log_pressure[sharing])[0]
    if sharing.any():
        share[sharing], log_height[sharing], touched[sharing] = _balanced(numbers[:, sharing], gap)
    return share, np.exp(log_height), touched


def _unpacked(numbers: Array) -> tuple[FilmAsymptotes, Array, Array]:
    """The film, ln(A_H/F) and F from the rows of numbers."""
    *film, log_softness, load = numbers
    names = (field.name for field in fields(FilmAsymptotes))
    return FilmAsymptotes(**dict(zip(names, film, strict=True))), log_softness, load


def _balanced(numbers: Array, gap: GapLaw) -> tuple[Array, Array, Array]:
    """s, ln h and the touching area where both carry: the film is as thick as the gap that asperities leave.

    The unknown is z = ln(s/(1 - s)), which keeps the digits of s and 1 - s. For z > 0 the film is at least that of
    rigid bodies, h_RI (1 - s)^-2, and the gap at most that of s = 1/2, which bounds z.
    """
    film, log_softness, _ = _unpacked(numbers)

    def excess(z: Array) -> tuple[Array, Array]:
        log_share, log_remaining = -np.logaddexp(0.0, -z), -np.logaddexp(0.0, z)
        log_film, thicker = film.log_film(log_remaining)
        log_gap, narrower = gap.log_gap(log_share - log_softness)
        return log_film - log_gap, -np.exp(log_share) * thicker - np.exp(log_remaining) * narrower

    half = gap.log_gap(-np.log(2) - log_softness)[0]
    z = bracketed_root(
        excess,
        start=np.zeros(half.shape),
        low=np.full(half.shape, NO_SHARE),
        high=np.maximum((half - film.rigid) / 2, 0.0) + NEARLY_ALL,
        relative=1e-12,
        absolute=LAST_STEP,
        sought=Sought(
            unit="of ln(s/(1 - s))",
            problem="the load shared by film and asperities",
            remedy="Check that load, speed, viscosity and roughness are of ordinary size.",
        ),
    )
    log_pressure = -np.logaddexp(0.0, -z) - log_softness
    return expit(z), film.log_film(-np.logaddexp(0.0, z))[0], gap.area_fraction(log_pressure)
