"""The correction for finite geometry at the loads and angles of a bearing's balls.

Not iterated: corrected contacts change loads and angles by less than a hundredth. The factors, within 0.06 of 1, follow
the load's power 1/3 to 2/3, and so change by less than 1.5e-4 more.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.finite_geometry import RaceCorrections, race_geometry
from analytic.contact.geometry import RACES
from analytic.loads.balls import LoadedBalls
from analytic.loads.thrust import thrust_equilibrium
from analytic.scene import Array, Bearing, ContactAngle


def thrust_correction(bearing: Bearing, contact_angle: ContactAngle, *, axial_load: ArrayLike) -> RaceCorrections:
    """The correction of both races under thrust, at the ball loads and contact angles that Hertz's contacts give.

    Parameters
    ----------
    bearing : Bearing
        Rings and balls. Where a shoulder is not known, a typical height stands for it.
    contact_angle : ContactAngle
        Rule `given` or `solved`.
    axial_load : array_like, shape (n,)
        Fa, N, > 0.

    Returns
    -------
    RaceCorrections
        Dimensionless factors on Hertz's contacts and their uncertainties, (n,) for each race.

    Raises
    ------
    InputError
        As `thrust_equilibrium`.

    Notes
    -----
    Source: derived here, a fit to finite elements (`analytic.contact.finite_geometry`), and no second opinion on them.
    """
    balls = thrust_equilibrium(bearing, contact_angle, axial_load=axial_load)
    return _corrections(bearing, angles=(balls.contact_angle,) * 2, loads=(balls.ball_load,) * 2)


def corrections_of(bearing: Bearing, balls: LoadedBalls) -> RaceCorrections:
    """The correction of both races at the balls' loads and angles; (n,) under thrust, else (n, m).

    A contact without load has no place on its race, and its factors are 1.
    """
    each = (..., 0) if balls.method == "thrust" else ...  # an equilibrium takes one factor for each element of this
    inner_angle, outer_angle = np.where(balls.load > 0, balls.contact_angle, 0.0)
    inner_load, outer_load = balls.load
    return _corrections(
        bearing, angles=(inner_angle[each], outer_angle[each]), loads=(inner_load[each], outer_load[each])
    )


def _corrections(bearing: Bearing, *, angles: Sequence[Array], loads: Sequence[Array]) -> RaceCorrections:
    inner, outer = (
        race_geometry(bearing, race, contact_angle=angle, ball_load=load)
        for race, angle, load in zip(RACES, angles, loads, strict=True)
    )
    return RaceCorrections(inner=inner, outer=outer)
