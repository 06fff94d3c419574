"""Losses of a scene: as declared, or the drag of the seals by SKF's formula, which seals that rub have by default."""

import math

from analytic.catalog.bearing_rows import CatalogBearing
from analytic.catalog.seals import seal_spread, seal_torque, seal_type
from analytic.declared import read_only
from analytic.errors import InputError
from analytic.scene import Bearing, Losses, Origin, ShearedLand, ShearedPockets
from analytic.scenefile.keys import Values

SHOULDER = 0.2  # height over the ball diameter, where the catalogue has none: usual


def losses_of(v: Values, bearing: Bearing, row: CatalogBearing | None) -> Losses:
    """The losses of [losses]; row : of the catalogue, whose designation names the seals.

    Raises InputError for an estimate of seals that nobody names.
    """
    seals = v["losses.seals"]
    oil = {
        **{key: v[f"losses.{key}"] for key in ("drag", "oil_flow", "oil_share")},
        "land": v.noun(ShearedLand, "losses.land"),
        "pockets": v.noun(ShearedPockets, "losses.pockets"),
    }
    if seals == "off":
        return Losses(seals=0.0, **oil)
    if isinstance(seals, float) or (seals is None and not bearing.seals_rub):
        return Losses(seals=seals, **oil)
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
