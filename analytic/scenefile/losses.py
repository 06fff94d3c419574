"""Losses of a scene: as declared, or the drag of the seals by SKF's formula."""

from analytic.catalog.bearing_rows import CatalogBearing
from analytic.catalog.seals import seal_torque, seal_type
from analytic.errors import InputError
from analytic.scene import Bearing, Losses, ShearedLand, ShearedPockets
from analytic.scenefile.tables import LossesTable


def losses_of(given: LossesTable, bearing: Bearing, row: CatalogBearing | None) -> tuple[Losses, tuple[str, ...]]:
    """(losses, warnings) of the table; row : of the catalogue, whose designation names the seals.

    Raises InputError for an estimate of seals that nobody names, that SKF has no constants for, or without the diameter
    that they touch.
    """
    oil = {
        "drag": given.drag,
        "oil_flow": given.oil_flow,
        "oil_share": given.oil_share,
        "land": given.land and ShearedLand(**given.land.model_dump()),
        "pockets": given.pockets and ShearedPockets(**given.pockets.model_dump()),
    }
    if given.seals != "estimate":
        return Losses(seals=given.seals, **oil), ()
    if row is None:
        raise InputError('it needs seals by a designation of the catalogue, for example catalog = "6205-2RS1"')
    inner = bearing.inner
    if inner.shoulder_half_width is None:
        raise InputError("it needs the diameter that the seals touch: give bearing.inner.shoulder_diameter")
    height = inner.groove_radius - (inner.groove_radius**2 - inner.shoulder_half_width**2) ** 0.5
    counterface = 2 * (inner.bottom_radius + height)
    drag = seal_torque(row, counterface=counterface)
    losses = Losses(seals=drag, seals_are_estimated=True, **oil)
    kinds = sorted({kind for seals in row.seal_suffixes if (kind := seal_type(seals)) is not None})
    if not kinds:
        return losses, ()
    return losses, (
        f"the drag of the seals, {1e3 * drag:.3g} N mm, is SKF's formula for {' and '.join(kinds)} seals on the inner "
        f"shoulder of {1e3 * counterface:.4g} mm: an estimate, to be replaced by a measured torque",
    )
