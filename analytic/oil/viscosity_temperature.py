"""Viscosity of an oil over the temperature at ambient pressure, and what follows from it by the kind of base oil.

The logarithm of the logarithm of the kinematic viscosity falls in a straight line over the logarithm of the
temperature [ASTMD341]; two viscosities give the line. The pressure-viscosity coefficient of a kind of oil is a power of
the kinematic viscosity, fitted to [Arana2019].
"""

from dataclasses import dataclass
from math import exp, log, log10

from analytic.errors import InputError, require_positive

MM2_PER_S = 1e-6  # m^2/s
LOWEST_VISCOSITY = 0.21e-6  # m^2/s: the double logarithm has no value a little below
# Of the distance between the two temperatures, on the cold and on the hot side. Through viscosities at 40 and 100 degC
# that is -40 to 140 degC.
COLDER, HOTTER = 4 / 3, 2 / 3
# Standard deviation of ln nu as far below the colder temperature as the other one is above it; it grows with the fourth
# power of the distance: a judgement. The line over Vogel's law of the same oil, FVA 3 of [Schwarz2023], is 0.90 at
# 0 degC, 0.67 at -20 and 0.24 at -40 degC, where that law is extrapolated too; over makers' values of four PAO at
# -40 degC, from memory, it is 1.5 to 2.2. At 140 degC the line and the law part by 0.5 %.
COLD_SPREAD = 0.26


@dataclass(frozen=True, kw_only=True)
class ViscosityLine:
    """The kinematic viscosity nu of an oil over the temperature, through two known points.

        log10 log10 Z = A - B log10 T,  Z = nu + 0.7 + exp(-1.47 - 1.84 nu - 0.51 nu^2),  nu in mm^2/s
    Source: [ASTMD341]; the exponential counts below 2 mm^2/s only.
    """

    intercept: float  # A
    slope: float  # B
    known: tuple[float, float]  # temperatures of the points, K, the colder one first

    @property
    def coldest(self) -> float:
        """K; the line is refused below."""
        return self.known[0] - COLDER * (self.known[1] - self.known[0])

    @property
    def hottest(self) -> float:
        """K; the line is refused above."""
        return self.known[1] + HOTTER * (self.known[1] - self.known[0])

    def deviation(self, temperature: float) -> float:
        """Standard deviation of ln nu by the line, 0.26 [(T_1 - T)/(T_2 - T_1)]^4 below the colder point; T : K."""
        return COLD_SPREAD * (max(self.known[0] - temperature, 0.0) / (self.known[1] - self.known[0])) ** 4

    def kinematic_viscosity(self, temperature: float) -> float:
        """nu, m^2/s; temperature : K. Raises InputError outside the range of the line."""
        return _viscosity(self._z(temperature)) * MM2_PER_S

    def temperature_slope(self, temperature: float) -> float:
        """-d ln(nu)/dT, 1/K; temperature : K. Raises InputError outside the range of the line."""
        z = self._z(temperature)
        nu = _viscosity(z)
        # From the double logarithm: dZ/dT = -B Z ln(Z)/T. From Z(nu): dZ/dnu = 1 - (1.84 + 1.02 nu) exp(...).
        return self.slope * z * log(z) / temperature / (1 - (1.84 + 1.02 * nu) * _correction(nu)) / nu

    def _z(self, temperature: float) -> float:
        require_positive(temperature=temperature)
        if not self.coldest <= temperature <= self.hottest:
            raise InputError(
                f"temperature must be {_celsius(self.coldest)} to {_celsius(self.hottest)} degC, where the viscosities "
                f"of this oil reach, got {_celsius(temperature)} degC; give a viscosity at that temperature"
            )
        return 10**10 ** (self.intercept - self.slope * log10(temperature))


def viscosity_line(*, temperatures: tuple[float, float], viscosities: tuple[float, float]) -> ViscosityLine:
    """The line through two points; temperatures : K, of either order;  viscosities : kinematic, m^2/s.

    Raises InputError unless the viscosity falls with the temperature and is at least 0.21 mm^2/s.
    """
    (cold, thick), (hot, thin) = sorted(zip(temperatures, viscosities, strict=True))
    require_positive(temperature=cold, viscosity=(thick, thin))
    if thin < LOWEST_VISCOSITY:
        raise InputError(f"viscosity must be at least 0.21 mm2/s, the lowest of ASTM D341, got {thin / MM2_PER_S:.3g}")
    if not (cold < hot and thick > thin):
        raise InputError(
            f"viscosity must fall with the temperature, got {thick / MM2_PER_S:.4g} mm2/s at {_celsius(cold)} degC and "
            f"{thin / MM2_PER_S:.4g} mm2/s at {_celsius(hot)} degC; give it at two different temperatures"
        )
    high, low = (_double_logarithm(nu / MM2_PER_S) for nu in (thick, thin))
    slope = (high - low) / log10(hot / cold)
    return ViscosityLine(intercept=high + slope * log10(cold), slope=slope, known=(cold, hot))


@dataclass(frozen=True, kw_only=True)
class PressureViscosityLaw:
    """alpha = s (nu/(1 mm^2/s))^t: the pressure-viscosity coefficient of one kind of oil at any temperature."""

    factor: float  # s, 1/Pa
    exponent: float  # t

    def coefficient(self, viscosity: float) -> float:
        """alpha, 1/Pa; viscosity : kinematic, m^2/s, > 0."""
        require_positive(viscosity=viscosity)
        return self.factor * (viscosity / MM2_PER_S) ** self.exponent


def _double_logarithm(nu: float) -> float:
    return log10(log10(nu + 0.7 + _correction(nu)))


def _correction(nu: float) -> float:
    return exp(-1.47 - 1.84 * nu - 0.51 * nu * nu)


def _viscosity(z: float) -> float:
    """nu in mm^2/s: Z = nu + 0.7 + exp(...) inverted. Each round takes a third of the error, or less."""
    nu = max(z - 0.7, 0.0)
    for _ in range(40):
        nu = z - 0.7 - _correction(nu)
    return nu


def _celsius(temperature: float) -> str:
    return f"{temperature - 273.15:.4g}"
