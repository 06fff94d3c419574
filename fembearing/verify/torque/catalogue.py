"""What bearing catalogues say of a scene's torque, or why they say nothing: shown with it, never as truth."""

from dataclasses import dataclass

import numpy as np

from analytic.brief import Brief
from analytic.errors import InputError
from analytic.scene import Scene
from fembearing.verify.torque.catalogue_models import CatalogueBand, bearing_series, scene_band


@dataclass(frozen=True, kw_only=True, eq=False)
class BesideCatalogue(Brief):
    """The band of the models, or the reason for which there is none."""

    band: CatalogueBand | None  # arrays (n,), N m
    note: str  # why there is no band, or what to know of it


def beside_catalogue(scene: Scene) -> BesideCatalogue:
    """The catalogue band of a scene."""
    if scene.arrangement is not None:
        return BesideCatalogue(
            band=None, note="no catalogue band: the models of catalogues hold for one bearing, not for a pair"
        )
    try:
        band = scene_band(scene)
    except InputError as problem:
        return BesideCatalogue(band=None, note=f"no catalogue band: {problem}")
    note = (
        f"catalogue band: {_models(band)} for an open bearing of series {bearing_series(scene.bearing)}; empirical "
        "fits, an order of magnitude, not a reference"
    )
    return BesideCatalogue(band=band, note=note)


def _models(band: CatalogueBand) -> str:
    """Whose models hold at one operating point at least."""
    if np.all(np.isnan(band.values.get("ISO 15312", np.nan))):
        return "models of SKF and Palmgren"
    return "models of SKF, Palmgren and ISO 15312 (under radial load)"
