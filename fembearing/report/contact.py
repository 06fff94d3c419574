"""The record of a contact: by Hertz and by finite elements, with its meshes, curves and profiles, as JSON holds it."""

from dataclasses import dataclass
from typing import Annotated, Any, Generic, Literal

from annotated_types import MinLen

from analytic.rows import Count, NotNegative, Positive, T
from analytic.scene import Pair
from analytic.verdicts import Verdict
from fembearing.check.contact.bearings import OfPair
from fembearing.check.contact.hertz import ApproachCurve, Profiles
from fembearing.check.contact.meshed_region import RingStructure
from fembearing.check.contact.refinement import Refinement
from fembearing.check.contact.scene_contact import Shape
from fembearing.check.contact.solution import ContactSolution
from fembearing.grid_convergence import Estimate


@dataclass(frozen=True, kw_only=True)
class OfQuantities(Generic[T]):
    """One entry for each quantity of a contact that is compared."""

    approach: T
    semi_axis_rolling: T
    semi_axis_transverse: T
    peak_pressure: T
    stiffness: T

    def __getitem__(self, quantity: str) -> T:
        return getattr(self, quantity)

    @property
    def values(self) -> list[T]:
        """All entries."""
        return list(vars(self).values())


@dataclass(frozen=True, kw_only=True)
class Corrected:
    """Hertz corrected for finite geometry."""

    values: OfQuantities[Positive]
    uncertainty: OfQuantities[NotNegative]  # relative, 95 %
    interpolation_error: OfQuantities[float]  # over finite elements, less one


@dataclass(frozen=True, kw_only=True)
class AtShoulder:
    """A quantity at a shoulder, by finite elements."""

    fe: float
    uncertainty: NotNegative  # relative, 95 %
    values: tuple[float, ...]  # coarse to fine
    order: float | None


@dataclass(frozen=True, kw_only=True)
class Shoulder:
    """What a contact does at the shoulder that cuts it off."""

    sides: dict[Literal["above", "below"], float]  # distance of each shoulder from y = 0, m
    half: bool  # whether half of the contact is meshed, not a quarter
    peak_pressure_at: float  # y, m: what "fe" and "hertz" compare, not the largest, which is at the edge
    strip_width: float  # m
    hertz_line_load: Positive  # N/m
    centroid: AtShoulder  # m
    strip_share: AtShoulder
    strip_line_load: AtShoulder  # N/m

    def __post_init__(self) -> None:
        """Raises ValueError where no shoulder cuts the contact off."""
        if not self.sides:
            raise ValueError("has no shoulder")

    @property
    def cuts(self) -> list[float]:
        """y of each shoulder that cuts the contact off, the nearer one first."""
        return sorted((y if side == "above" else -y for side, y in self.sides.items()), key=abs)


@dataclass(frozen=True, kw_only=True)
class MeshCost:
    """One mesh of a contact."""

    level: int
    unknowns: Count
    seconds: NotNegative


@dataclass(frozen=True, kw_only=True)
class SolveCost:
    """What a contact cost to solve."""

    seconds: NotNegative
    unknowns: Count
    peak_memory: Count | None  # of the process, bytes


@dataclass(frozen=True, kw_only=True)
class ContactRecord:
    """One contact, by Hertz and by finite elements; SI, uncertainties and discrepancies relative."""

    pair: Pair
    geometry: Shape
    load: Positive
    contact_angle: float
    fe: OfQuantities[Positive]
    uncertainty: OfQuantities[NotNegative]
    hertz: OfQuantities[Positive]
    discrepancy: OfQuantities[float]  # Hertz's over finite elements, less one
    corrected: Corrected | None
    verdict: Verdict | Literal["shown"]
    judged: bool
    method: str
    refinement: Refinement
    meshes: Annotated[tuple[MeshCost, ...], MinLen(2)]
    ring: RingStructure | None
    convergence: OfQuantities[Estimate]
    formal_order: OfQuantities[float | None]
    pressure_profile: Profiles
    approach_curve: ApproachCurve
    shoulder: Shoulder | None
    cost: SolveCost
    warnings: tuple[str, ...]
    bearing: OfPair | None = None  # of a pair; None: there is one, or both have this contact

    def __post_init__(self) -> None:
        """Raises ValueError for a convergence study on other meshes than those listed."""
        for name, study in vars(self.convergence).items():
            if len(study.values) != len(self.meshes):
                raise ValueError(f"has {len(study.values)} values of {name} on {len(self.meshes)} meshes")


@dataclass(frozen=True, kw_only=True)
class SheetInSeries:
    """What the sheet of a pocket adds to the contact with a thick seat, as a spring in series."""

    stiffness: float  # k, N/m: load over the approach that the sheet adds
    uncertainty: float  # relative, 95 %


def sheet_in_series(seat: ContactRecord, sheet: ContactRecord) -> SheetInSeries | None:
    """From both models of a pocket under one load; None where the sheet adds no more than is uncertain."""
    added = sheet.fe.approach - seat.fe.approach
    off = sum(each.fe.approach * each.uncertainty.approach for each in (seat, sheet))
    return SheetInSeries(stiffness=seat.load / added, uncertainty=off / added) if added > off else None


def contact_record(solution: ContactSolution) -> ContactRecord:
    """The record of a solved contact."""
    finest, parts = solution.meshes[-1], solution.estimates
    corrected = solution.corrected and Corrected(
        values=_of(vars(solution.corrected.quantities)),
        uncertainty=_of(solution.corrected.uncertainty),
        interpolation_error=_of(solution.interpolation_error),
    )
    return ContactRecord(
        pair=solution.contact.pair,
        geometry=solution.geometry,
        load=solution.contact.load,
        contact_angle=solution.contact.contact_angle,
        fe=_of(vars(solution.reference)),
        uncertainty=_of({name: part.total for name, part in parts.items()}),
        hertz=_of(vars(solution.hertz)),
        discrepancy=_of(solution.discrepancy),
        corrected=corrected,
        verdict=solution.verdict if solution.judged else "shown",
        judged=solution.judged,
        method=solution.method,
        refinement=solution.refinement,
        meshes=tuple(
            MeshCost(level=mesh.level, unknowns=mesh.unknowns, seconds=mesh.seconds) for mesh in solution.meshes
        ),
        ring=solution.ring,
        convergence=_of(parts),
        formal_order=_of(solution.formal_orders),
        pressure_profile=solution.pressure_profile,
        approach_curve=solution.approach_curve,
        shoulder=_shoulder(solution),
        cost=SolveCost(seconds=solution.seconds, unknowns=finest.unknowns, peak_memory=solution.peak_memory),
        warnings=solution.warnings,
        bearing=solution.bearing,
    )


def _of(values: dict[str, Any]) -> OfQuantities[Any]:
    return OfQuantities(**values)


def _shoulder(solution: ContactSolution) -> Shoulder | None:
    """The contact at the nearer shoulder that cuts it off."""
    if not solution.shoulder:
        return None
    return Shoulder(
        sides={"above" if y > 0 else "below": abs(y) for y in solution.shoulders},
        half=solution.meshes[-1].pair.footprint.half,
        peak_pressure_at=0.0,
        strip_width=solution.strip_width,
        hertz_line_load=solution.hertz_line_load,
        **{
            name: AtShoulder(fe=part.value, uncertainty=part.total, values=part.values, order=part.order)
            for name, part in solution.shoulder.items()
        },
    )
