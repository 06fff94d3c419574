"""Films of greased deep groove bearings after churning, over flooded films of the base oil: laws of measured ones.

With eta_0 in Pa s, b, the semi-axis across rolling, in m, u in m/s and the surface tension sigma in N/m:
    axial load   f = min(1, 0.054 (eta_0 b u)^-0.29)     R^2 0.86, 6204, 6206 and 6209
    radial load  f = min(1, 1.8 (eta_0 u/sigma)^-0.31)   R^2 0.93, 6209
Measured with two lithium greases of 100 and 460 mm2/s at 61 degC, up to 6000 and 4000 1/min, after 100 h at 4000 1/min.
For both loads together the paper has one law with a length that it prints for its own bearings alone. Here the
logarithms of both laws are weighted by the axial share of the load; that is 12 to 19 % below the paper's law.
Source: [Shetty2024].
"""

import numpy as np

from analytic.numerics.compilation import compiled

LOG_AXIAL, LOG_RADIAL = float(np.log(0.054)), float(np.log(1.8))
MEASURED_SIZES = (33e-3, 66e-3)  # pitch diameters of the measured bearings, 6204 to 6209, with a millimetre beside, m


@compiled
def log_greased_film(shear: float, width: float, surface_tension: float, axial_share: float) -> float:
    """ln f without its limit of 0; shear : eta_0 u, N/m, > 0;  width : b, m;  axial_share : of the load, 0 to 1."""
    axial = LOG_AXIAL - 0.29 * np.log(shear * width)
    radial = LOG_RADIAL - 0.31 * np.log(shear / surface_tension)
    return axial_share * axial + (1 - axial_share) * radial


@compiled
def axial_share_of(axial: float, radial: float, moment: float, pitch_diameter: float) -> float:
    """Share of the axial load in all load; a moment counts as the force on the pitch diameter. 1 without load."""
    sideways = abs(radial) + 2 * abs(moment) / pitch_diameter
    whole = abs(axial) + sideways
    return abs(axial) / whole if whole > 0.0 else 1.0
