"""Losses of a scene: as declared, or the drag of the seals by SKF's formula, which seals that rub have by default."""

import math

from analytic.catalog.bearing_rows import CatalogBearing
from analytic.catalog.seals import seal_spread, seal_torque, seal_type
from analytic.errors import InputError
from analytic.noun import read_only
from analytic.scene import Bearing, Losses, Origin, ShearedLand, ShearedPockets
from analytic.scenefile.tables import LossesTable

SHOULDER = 0.2  # height over the ball diameter, where the catalogue has none: usual


def losses_of(given: LossesTable, bearing: Bearing, row: CatalogBearing | None) -> Losses:
    """The losses of the table; row : of the catalogue, whose designation names the seals.

    Raises InputError for an estimate of seals that nobody names.
    """
    oil = {
        "drag": given.drag,
        "oil_flow": given.oil_flow,
        "oil_share": given.oil_share,
        "land": given.land and ShearedLand(**given.land.model_dump()),
        "pockets": given.pockets and ShearedPockets(**given.pockets.model_dump()),
    }
    if given.seals == "off":
        return Losses(seals=0.0, **oil)
    if isinstance(given.seals, float) or (given.seals is None and not bearing.seals_rub):
        return Losses(seals=given.seals, **oil)
    if row is None:
        raise InputError('it needs seals by a designation of the catalogue, for example catalog = "6205-2RS1"')
    inner = bearing.inner
    height = SHOULDER * bearing.ball_diameter
    if inner.shoulder_half_width is not None:
        height = inner.groove_radius - math.sqrt(inner.groove_radius**2 - inner.shoulder_half_width**2)
    counterface = 2 * (inner.bottom_radius + height)
    drag = seal_torque(row, counterface=counterface)
    kinds = sorted({kind for seals in row.seal_suffixes if (kind := seal_type(seals)) is not None})
    if not kinds:
        return Losses(seals=drag, **oil)
    words = f"SKF's formula for {' and '.join(kinds)} seals [SKFSeals], on a diameter of {1e3 * counterface:.4g} mm"
    origin = Origin(status="assumed", uncertainty=seal_spread(row) * drag, source=words)
    return Losses(seals=drag, origins=read_only({"seals": origin}), **oil)
