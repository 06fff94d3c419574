"""The contacts of balls with both races by Hertz, before any load is known."""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.factors import ContactCorrection, corrected_contact
from analytic.contact.geometry import race_curvatures
from analytic.contact.hertz import HertzContact, contact_modulus, hertz_contact
from analytic.scene import Bearing


def unit_contacts(
    bearing: Bearing, *, inner_angle: ArrayLike, outer_angle: ArrayLike, correction: ContactCorrection
) -> tuple[HertzContact, HertzContact]:
    """A ball on its inner and on its outer race under 1 N by Hertz, corrected; of the angles' shape, which is one.

    inner_angle, outer_angle : al_i, al_o, rad, in [0, pi/2]
    analytic.contact.hertz.loaded_contact gives the contacts under load. Raises InputError as race_curvatures does.
    """
    pairs = (
        race_curvatures(bearing, "inner", contact_angle=inner_angle),
        race_curvatures(bearing, "outer", contact_angle=outer_angle),
    )
    rolling, transverse = (np.array(curvatures) for curvatures in zip(*pairs, strict=True))
    moduli = [contact_modulus(bearing.ball_material, ring.material) for ring in (bearing.inner, bearing.outer)]
    # One call for both races: most callers have few balls, and the time goes with the calls.
    both = hertz_contact(
        curvature_x=rolling,
        curvature_y=transverse,
        load=1.0,
        modulus=np.reshape(moduli, (2,) + (1,) * (rolling.ndim - 1)),
    )
    inner, outer = (HertzContact(**{name: field[race] for name, field in vars(both).items()}) for race in (0, 1))
    return corrected_contact(inner, correction.inner), corrected_contact(outer, correction.outer)
