"""The record of a contact under many loads, as JSON holds it."""

from dataclasses import dataclass
from typing import Literal

from analytic.rows import Count, NotNegative, Positive
from analytic.scene import Pair
from analytic.verdicts import Verdict
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.check.contact.load_series import LoadPoint, LoadSeries
from fembearing.check.contact.stiffness_law import PocketLaw, StiffnessLaw
from fembearing.grid_convergence import Estimate
from fembearing.mesh.recipe import Geometry

KIND, FORMAT = "fembearing load series", 1  # the number rises when a key changes its name or meaning


@dataclass(frozen=True, kw_only=True)
class LoadRecord:
    """One load. Tables are by quantity: the approach, and all of them where the compliance of the pair gives them."""

    load: Positive  # N
    fe: dict[str, Positive]
    uncertainty: dict[str, NotNegative]  # relative, 95 %
    hertz: dict[str, Positive]
    discrepancy: dict[str, float]  # Hertz's over finite elements, less one
    convergence: dict[str, Estimate]
    tangent: Positive | None  # dF/d(approach) by finite elements, N/m; None for a single load
    tangent_uncertainty: NotNegative | None  # relative, 95 %; None without a third load
    hertz_tangent: Positive  # N/m
    verdict: Verdict  # on Hertz's approach


@dataclass(frozen=True, kw_only=True)
class SeriesRecord:
    """A contact under a series of loads, by Hertz and by finite elements; SI, in the order given."""

    kind: Literal["fembearing load series"] = KIND
    format: Literal[1] = FORMAT
    pair: Pair
    geometry: Geometry
    contact_angle: float
    tolerance: Positive
    loads: tuple[LoadRecord, ...]
    law: StiffnessLaw | None
    exponent_uncertainty: NotNegative | None  # of the law, absolute, 95 %
    pocket_law: PocketLaw | None
    hertz_stiffness: Positive  # K of F = K delta^1.5, N/m^1.5
    verdict: Verdict | Literal["shown"]
    meshes: Count  # number of meshes of one level that the loads share
    seconds: NotNegative
    peak_memory: Count | None  # of the process, bytes
    warnings: tuple[str, ...]


def series_record(series: LoadSeries) -> SeriesRecord:
    """The record of a solved series."""
    return SeriesRecord(
        pair=series.contact.pair,
        geometry=series.geometry,
        contact_angle=series.contact.contact_angle,
        tolerance=series.tolerance,
        loads=tuple(
            _load(point, vars(hertz_quantities(part.contact)))
            for point, part in zip(series.points, series.solutions, strict=True)
        ),
        law=series.law,
        exponent_uncertainty=series.law and series.law.exponent_uncertainty,
        pocket_law=series.pocket_law,
        hertz_stiffness=series.hertz_stiffness,
        verdict=series.verdict if series.judged else "shown",
        meshes=series.meshes,
        seconds=series.seconds,
        peak_memory=series.peak_memory,
        warnings=series.warnings,
    )


def _load(point: LoadPoint, hertz: dict[str, float]) -> LoadRecord:
    """The record of one load; hertz : all quantities under it by Hertz, SI."""
    estimates = {"approach": point.approach} | point.others
    return LoadRecord(
        load=point.load,
        fe={name: part.value for name, part in estimates.items()},
        uncertainty={name: part.total for name, part in estimates.items()},
        hertz={name: hertz[name] for name in estimates},
        discrepancy={name: hertz[name] / part.value - 1 for name, part in estimates.items()},
        convergence=estimates,
        tangent=point.tangent,
        tangent_uncertainty=point.tangent_uncertainty,
        hertz_tangent=point.hertz_tangent,
        verdict=point.verdict,
    )
