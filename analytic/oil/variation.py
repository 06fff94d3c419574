"""The formulas of oil and surfaces varied within what is known of their errors."""

from dataclasses import dataclass
from typing import Literal

from analytic.errors import require_positive

COVERAGE = 2.0  # standard uncertainties to a half-width of 95 %
# Standard deviation of ln p at the same gap, between generated surfaces of equal statistics: 0.06 to 0.09 at
# p/(E* slope) of 0.01 to 0.9 (validation/published/elastic_gap.csv). One contact scatters more, as it holds few
# summits, but a bearing turns over its whole track.
SURFACE_SPREAD = 0.08
# Standard deviation of ln(rolling resistance), a judgement: formulas differ by 0.6 to 1.4, and torques measured with
# three balls are 1.1 to 1.8 times the formula [Balan2015].
ROLLING_SPREAD = 0.25


@dataclass(frozen=True, kw_only=True)
class Variation:
    """Factors on what the formulas give, > 0, and another formula; the defaults are the model as it is.

    Raises InputError for a factor that is not positive.
    """

    film: float = 1.0  # factor on every film
    asperity_pressure: float = 1.0  # factor on the pressure of the asperities at any gap
    rolling: float = 1.0  # factor on the hydrodynamic resistance to rolling
    rolling_formula: Literal["biboulet", "houpert"] = "biboulet"  # see `analytic.oil.rolling`

    def __post_init__(self) -> None:
        require_positive(film=self.film, asperity_pressure=self.asperity_pressure, rolling=self.rolling)


NOMINAL = Variation()
