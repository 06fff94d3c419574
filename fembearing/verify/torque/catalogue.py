"""What bearing catalogues say of a scene's torque, or why they say nothing: shown with it, never as truth."""

from dataclasses import dataclass

import numpy as np

from analytic.brief import Brief
from analytic.errors import InputError
from analytic.result import PairPart, TorqueParts
from analytic.scene import Array, Scene
from fembearing.verify.torque.catalogue_models import (
    ANGULAR,
    ANGULAR_SERIES,
    SKF_DEEP_GROOVE,
    THRUST_BALL,
    CatalogueBand,
    bearing_series,
    scene_band,
)

WITHOUT_LOSSES = "without seals and drag"
NO_BAND = "no catalogue band: "  # how the reason begins for which there is none


@dataclass(frozen=True, kw_only=True, eq=False)
class BesideCatalogue(Brief):
    """The band of the models, or the reason for which there is none."""

    band: CatalogueBand | None  # arrays (n,), N m
    note: str  # why there is no band, or what to know of it


def beside_catalogue(scene: Scene, pair: PairPart | None = None) -> BesideCatalogue:
    """The catalogue band of a scene; pair : the two bearings of its torque, where it has an arrangement."""
    try:
        band = scene_band(scene, None if pair is None else pair.equilibrium)
    except InputError as problem:
        return BesideCatalogue(band=None, note=f"{NO_BAND}{problem}")
    kind = bearing_series(scene.bearing)
    of = f"{kind} ball bearing" if kind in (ANGULAR, THRUST_BALL) else f"bearing of series {kind}"
    is_flat = scene.bearing.kind == "radial" and kind not in (*SKF_DEEP_GROOVE, *ANGULAR_SERIES)
    both = "" if pair is None else ", summed over both"
    constants = "; SKF's constants are of 40 deg and ordinary speeds" if is_flat else ""
    note = (
        f"catalogue band: {_models(band)} for an open {of}{both}{constants}; empirical fits, "
        "an order of magnitude, not a reference"
    )
    return BesideCatalogue(band=band, note=note)


def of_open_bearing(torque: TorqueParts[Array]) -> tuple[Array, str]:
    """The torque to compare with the band, N m, and what it is without, in words; empty: it is the total.

    No model has seals, and SKF's has no drag of the oil outside the contacts. Palmgren's and that of ISO 15312 have the
    drag of an oil bath in their viscous part.
    """
    losses = [part for part in (torque.declared, torque.oil) if part is not None]
    return torque.total - sum(losses), WITHOUT_LOSSES if losses else ""


def _models(band: CatalogueBand) -> str:
    """Whose models hold at one operating point at least."""
    if np.all(np.isnan(band.values.get("ISO 15312", np.nan))):
        return "models of SKF and Palmgren"
    return "models of SKF, Palmgren and ISO 15312 (under radial load)"
