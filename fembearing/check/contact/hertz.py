"""The production model of a contact: Hertz, and Hertz corrected for finite geometry, with the curves that figures show.

Pressure profiles: where the contact is symmetric a quarter of it is meshed, and positions run from the centre outwards.
Where one shoulder cuts it off a half is meshed, and transverse positions run from one side to the other.
"""

from collections.abc import Collection
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Literal

import numpy as np
from annotated_types import MinLen

from analytic.contact.finite_geometry import contact_shape, finite_geometry_factors
from analytic.contact.hertz import contact_modulus, hertz_contact, relative_curvatures
from analytic.rows import NotNegative, Positive
from analytic.scene import Array, Contact
from fembearing.check.comparison import Comparison, compared_with, verdict_on
from fembearing.fem.measure import Quantities
from fembearing.grid_convergence import Estimate

if TYPE_CHECKING:  # the solver takes a second to import, and nothing else here needs it
    from fembearing.fem.solution import MeshSolution


@dataclass(frozen=True, kw_only=True)
class CorrectedHertz:
    """The corrected quantities with the uncertainty of the fitted correction."""

    quantities: Quantities
    uncertainty: dict[str, float]  # keyed by quantity, relative half-width, 95 %


def hertz_quantities(contact: Contact) -> Quantities:
    """Hertz's semi-axes, peak pressure, approach and stiffness of a contact."""
    curvature_x, curvature_y = relative_curvatures(contact)
    ellipse = hertz_contact(
        curvature_x=curvature_x,
        curvature_y=curvature_y,
        load=contact.load,
        modulus=contact_modulus(contact.ball_material, contact.race_material),
    )
    return Quantities(
        semi_axis_rolling=float(ellipse.semi_axis_x),
        semi_axis_transverse=float(ellipse.semi_axis_y),
        peak_pressure=float(ellipse.peak_pressure),
        approach=float(ellipse.approach),
        stiffness=float(ellipse.stiffness),
    )


def beside_hertz(
    hertz: Quantities, estimates: dict[str, Estimate], *, tolerance: float, valid: bool, judged: Collection[str]
) -> dict[str, Comparison]:
    """Hertz beside the estimate of each quantity, with a verdict where it is judged.

    tolerance : relative;  valid : whether the contact ends before its shoulder
    judged : names of quantities; none of a sheet, which Hertz's half space does not describe
    """
    found = {}
    for name, part in estimates.items():
        formula = getattr(hertz, name)
        verdict = verdict_on(formula, part, tolerance=tolerance, valid=valid) if name in judged else "shown"
        found[name] = compared_with(part, formula, verdict=verdict)
    return found


def corrected_hertz(contact: Contact, *, hertz: Quantities) -> tuple[CorrectedHertz | None, tuple[str, ...]]:
    """The corrected contact, or None with the reasons why the contact is outside the range of the fit.

    hertz : the quantities to correct
    """
    correction = finite_geometry_factors(contact_shape(contact))
    if not correction.covered:
        return None, tuple(f"{contact.pair}: {warning}" for warning in correction.warnings)
    factors = {name: float(getattr(correction.factors, name)) for name in correction.uncertainty}
    values = {name: factor * getattr(hertz, name) for name, factor in factors.items()}
    uncertainty = {name: float(half_width) for name, half_width in correction.uncertainty.items()}
    return CorrectedHertz(
        quantities=Quantities(**values, stiffness=hertz.stiffness * factors["approach"] ** -1.5),
        uncertainty=uncertainty | {"stiffness": 1.5 * uncertainty["approach"]},  # K = Q/delta^1.5
    ), ()


POINTS = 25
LEAST, MOST = 0.05, 1.5  # of the curve, shares of the load that was solved


@dataclass(frozen=True, kw_only=True)
class ApproachCurve:
    """Approach over load; None outside the range of the correction's fit."""

    load: Annotated[tuple[Positive, ...], MinLen(1)]  # of the ball, N, ascending
    hertz: tuple[Positive, ...]  # m
    corrected: tuple[Positive | None, ...]  # m
    uncertainty: tuple[NotNegative | None, ...]  # of the corrected approach, relative half-width, 95 %


def approach_over_load(contact: Contact, *, hertz: Quantities, correctable: bool) -> ApproachCurve:
    """The curve from 0.05 to 1.5 times the contact's load.

    hertz : the contact under its own load
    correctable : whether the correction for finite geometry applies to this contact
    """
    times = np.linspace(LEAST, MOST, POINTS)
    approach = hertz.approach * times ** (2 / 3)
    corrected: tuple[float | None, ...] = (None,) * POINTS
    uncertainty = corrected
    if correctable:
        shape = contact_shape(contact)
        found = finite_geometry_factors(shape._replace(size=shape.size * np.cbrt(times)))
        corrected, uncertainty = (
            tuple(value if covered else None for value, covered in zip(each.tolist(), found.covered, strict=True))
            for each in (approach * found.factors.approach, found.uncertainty["approach"])
        )
    return ApproachCurve(
        load=tuple((contact.load * times).tolist()),
        hertz=tuple(approach.tolist()),
        corrected=corrected,
        uncertainty=uncertainty,
    )


Axis = Literal["rolling", "transverse"]
AXES: tuple[Axis, ...] = ("rolling", "transverse")
POSITIONS = 60  # on an axis at most
BEYOND = 1.2  # semi-axes: farther out there is no contact
ON_AXIS = 1e-9  # share of the mesh's extent: round-off


@dataclass(frozen=True, kw_only=True)
class PressureProfile:
    """Pressure along one axis."""

    position: Annotated[tuple[float, ...], MinLen(1)]  # m from the contact's centre, ascending
    pressure: tuple[float, ...]  # Pa


@dataclass(frozen=True, kw_only=True)
class BothProfiles:
    """The pressure along one axis at the nodes of the finest mesh, and by Hertz."""

    fe: PressureProfile
    hertz: PressureProfile


@dataclass(frozen=True, kw_only=True)
class Profiles:
    """The pressure along both axes through the centre."""

    rolling: BothProfiles
    transverse: BothProfiles


def nodal_profile(mesh: "MeshSolution", axis: Axis) -> PressureProfile:
    """Nodal values on an axis as solved. They scatter by some tenths of a per cent; peak pressure is a fit to many.

    More than `POSITIONS` nodes are thinned evenly, with both ends and the centre. A node without force has pressure 0.
    """
    along, across = (mesh.x, mesh.y) if axis == "rolling" else (mesh.y, mesh.x)
    semi_axis = mesh.semi_axes[AXES.index(axis)]
    on_axis = np.abs(across) <= ON_AXIS * np.abs(across).max()
    nodes = np.flatnonzero(on_axis & (np.abs(along) <= BEYOND * semi_axis))
    nodes = nodes[np.argsort(along[nodes])]
    centre = int(np.argmin(np.abs(along[nodes])))
    step = -(-nodes.size // (POSITIONS - 2))  # both ends are added
    chosen = np.unique([0, *range(centre % step, nodes.size, step), nodes.size - 1])
    nodes = nodes[chosen]
    return _profile(along[nodes], np.where(mesh.force[nodes] > 0, mesh.pressure[nodes], 0.0))


def hertz_profile(hertz: Quantities, axis: Axis) -> PressureProfile:
    """p0 sqrt(1 - (s/a)^2) from the centre to the edge, with denser positions near the edge."""
    angle = np.linspace(0, np.pi / 2, POSITIONS)
    semi_axis = hertz.semi_axis_rolling if axis == "rolling" else hertz.semi_axis_transverse
    pressure = hertz.peak_pressure * np.cos(angle)
    pressure[-1] = 0.0  # without round-off
    return _profile(semi_axis * np.sin(angle), pressure)


def profiles_of(mesh: "MeshSolution", hertz: Quantities) -> Profiles:
    """Both axes, by finite elements and by Hertz."""
    rolling, transverse = (
        BothProfiles(fe=nodal_profile(mesh, axis), hertz=hertz_profile(hertz, axis)) for axis in AXES
    )
    return Profiles(rolling=rolling, transverse=transverse)


def _profile(position: Array, pressure: Array) -> PressureProfile:
    return PressureProfile(position=tuple(position.tolist()), pressure=tuple(pressure.tolist()))
