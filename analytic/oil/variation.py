"""The formulas of oil and surfaces varied within what is known of their errors."""

from dataclasses import dataclass
from typing import Literal

from analytic.errors import require_positive

COVERAGE = 2.0  # standard uncertainties to a half-width of 95 %
# Standard deviation of ln p at the same gap, between generated surfaces of equal statistics
# (`validation/elastic_gap.py`)
SURFACE_SPREAD = 0.08


@dataclass(frozen=True, kw_only=True)
class Variation:
    """Factors on what the formulas give, > 0, and another formula; the defaults are the model as it is.

    Raises InputError for a factor that is not positive.
    """

    film: float = 1.0  # on every film
    asperity_pressure: float = 1.0  # on the pressure of the asperities at any gap
    rolling: Literal["biboulet", "houpert"] = "biboulet"

    def __post_init__(self) -> None:
        require_positive(film=self.film, asperity_pressure=self.asperity_pressure)
