"""The correction for finite geometry at the loads and angles of a bearing's balls.

Not iterated: corrected contacts change loads and angles by less than a hundredth. The factors, within 0.06 of 1, follow
the load's power 1/3 to 2/3, and so change by less than 1.5e-4 more.
"""

import numpy as np

from analytic.contact.finite_geometry import RaceCorrections, race_geometry
from analytic.contact.geometry import RACES
from analytic.numerics.records import Records
from analytic.scene import Bearing


def corrections_of(bearing: Bearing, balls: Records) -> RaceCorrections:
    """The correction of both races at the balls' loads and angles.

    balls : (...), or (n, 1) of balls that are alike, which have factors (n,); of `state.BALL_STATE` or
        `analytic.solve.records.BALL`
    A contact without load has no place on its race, and its factors are 1. Where a shoulder is not known, a typical
    height stands for it. Source: derived here, a fit to finite elements (`analytic.contact.finite_geometry`).
    """
    each = balls[:, 0] if balls.ndim == 2 and balls.shape[1] == 1 else balls
    load = each["load"]
    angle = np.where(load > 0, np.abs(each["angle"]), 0.0)
    inner, outer = (
        race_geometry(bearing, race, contact_angle=angle[..., side], ball_load=load[..., side])
        for side, race in enumerate(RACES)
    )
    return RaceCorrections(inner=inner, outer=outer)
