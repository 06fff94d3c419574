"""The oil that a bearing of the catalogue is taken to have where nobody gives one: an ISO VG class of mineral oil.

It is the class whose viscosity at the oil's temperature is nearest, in the logarithm, to twice the reference viscosity
of [ISO281], kappa = 2: a full film, as designers choose it. Very slow bearings end at VG 460, very fast ones at VG 10,
and cold or hot oil at the ends of the classes' data.
"""

import numpy as np

from analytic.scenefile.keys import scene_key
from analytic.scenefile.known_oil import named_oil
from analytic.scenefile.quantity import range_of
from analytic.words import MILLIMETRE, RPM

CLASSES = (10, 15, 22, 32, 46, 68, 100, 150, 220, 320, 460)  # of ISO 3448
RATIO = 2.0  # kappa, viscosity over nu_1
THICKEST = 1.0  # m^2/s: at standstill nu_1 is infinite
WITHOUT_SPEED = "ISO VG 68"  # beside a speed or a temperature that the scene will refuse


def reference_viscosity(*, ring_speed: float, mean_diameter: float) -> float:
    """nu_1 of [ISO281], m^2/s: 45000 n^-0.83 d_m^-0.5 mm^2/s below n = 1000 rev/min, from there 4500 (n d_m)^-0.5.

    ring_speed : rad/s, of either sign; infinite viscosity at 0;  mean_diameter : d_m, of the ball centres, m
    """
    speed, diameter = RPM.number(abs(ring_speed)), MILLIMETRE.number(mean_diameter)
    if speed == 0.0:
        return np.inf
    slow = 45000 * speed**-0.83 / np.sqrt(diameter)
    return 1e-6 * (slow if speed < 1000 else 4500 / np.sqrt(speed * diameter))


def suited_oil(*, mean_diameter: float, speed: object, temperature: object) -> str:
    """The name of the oil.

    mean_diameter : of the ball centres, m
    speed, temperature : of inner ring and oil, as a scene file has them; of a series the largest speed counts
    """
    try:
        parts = range_of(speed) if isinstance(speed, str) else None
        series = speed if isinstance(speed, list) else [speed] if parts is None else [parts.first, parts.last]
        speeds = [abs(_read("operation.inner_speed", each)) for each in series]
        wanted = RATIO * reference_viscosity(ring_speed=max(speeds), mean_diameter=mean_diameter)
        kelvin = _read("lubricant.temperature", temperature)
    except ValueError:
        return WITHOUT_SPEED
    return min((f"ISO VG {grade}" for grade in CLASSES), key=lambda name: _distance(name, kelvin, wanted))


def _read(path: str, given: object) -> float:
    """SI. Raises ValueError for what the key does not take."""
    dimension = scene_key(path).dimension
    assert dimension is not None
    return dimension.read(given)


def _distance(name: str, temperature: float, wanted: float) -> float:
    """In the logarithm of the viscosity; K, m^2/s."""
    line = named_oil(name).line
    assert line is not None
    viscosity = line.kinematic_viscosity(min(max(temperature, line.coldest), line.hottest))
    return abs(np.log(viscosity / min(wanted, THICKEST)))
