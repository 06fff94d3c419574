"""The formulas of oil and surfaces varied within what is known of their errors."""

from dataclasses import dataclass

from analytic.errors import require_finite, require_positive

COVERAGE = 2.0  # standard uncertainties to a half-width of 95 %
# Standard deviation of ln p at the same gap, between generated surfaces of equal statistics: 0.06 to 0.09 at
# p/(E* slope) of 0.01 to 0.9 (validation/published/elastic_gap.csv). One contact scatters more, as it holds few
# summits, but a bearing turns over its whole track.
SURFACE_SPREAD = 0.08
# Standard deviation of ln(rolling resistance), a judgement: formulas differ by 0.6 to 1.4, and torques measured with
# three balls are 1.1 to 1.8 times the formula [Balan2015].
ROLLING_SPREAD = 0.25
# The same within the range of the numerical solutions, over it: 3 %. Left-out solutions are met
# within 0.8 % at 95 %, contacts on true circles within 4.6 %, and both forces of a solution differ by 2 to 6 %.
FIT_SHARE = 0.12
# Standard deviation of ln k, where the factors for heating of the inlets count by the power k: a judgement. Oil that
# thins under shear has the same effect, and no part of its own.
HEATING_SPREAD = 0.25
# Standard deviation of the step between two laws of elastic rolling: the other law is the end of the 95 % range.
ELASTIC_SPREAD = 1 / COVERAGE
# Likewise of the step between two laws of the load on asperities: nobody knows which of both is right in a bearing.
GAP_SPREAD = 1 / COVERAGE
# Standard deviation of ln(films measured with grease over flooded ones), a judgement: their three laws differ by up to
# 17 %, and explain 86 to 93 % of the variance.
GREASE_SPREAD = 0.15
# Standard deviation of ln(rolling of balls without load), a judgement. A ball of a 6205 that lies on a race, not in the
# middle of its clearance, rolls against 1.4 times the force; its slip and the heat of its oil are not computed.
UNLOADED_SPREAD = 0.25
# Standard deviation of the step from a starved inlet to a flooded one: a judgement. SKF's factor holds for a running
# bearing, and at a start the oil lies in the race. A sixth of all samples is flooded, so that the interval contains the
# flooded torque whatever else varies; another sixth starves by twice the constant, as the source's own two differ.
STARVATION_SPREAD = 1.0
# Factors on the losses by oil outside the contacts, the ends of their range. Oil that flows through is driven by the
# cage or by the inner race, which is twice as fast, and leaves with the speed of one of them. For shear and drag it is
# a judgement: gaps are partly filled and not concentric, and a ball runs in the wake of the next one.
OIL_LOSS_FACTORS = (0.5, 2.0)


@dataclass(frozen=True, kw_only=True)
class Variation:
    """Factors on what the formulas give, > 0, and steps between two of them; the defaults are the model as it is.

    Raises InputError for a factor that is not positive, or a step that is not finite.
    """

    film: float = 1.0  # factor on every film
    traction: float = 1.0  # factor on the shear stress of the oil, also at its limit
    asperity_pressure: float = 1.0  # factor on the pressure of the asperities at any gap
    # Step from the share of the load on asperities towards the measured one, see `mixed.stepped_share`: any number
    asperity_share: float = 0.0
    rolling: float = 1.0  # factor on the hydrodynamic resistance to rolling
    rolling_error: float = 1.0  # likewise for the closed formula; the numerical fit has the power FIT_SHARE of it
    heating: float = 1.0  # power of the factors for heating of the inlets
    # Step from the replenishment factor, 0, to a flooded inlet, 1, or to the square of the factor, -1; beyond, as there
    starvation: float = 0.0
    # Step from the law of elastic rolling towards the other one, see `rolling.elastic_rolling`: any number
    elastic_rolling: float = 0.0
    grease_film: float = 1.0  # factor on the films that are measured with grease
    unloaded_balls: float = 1.0  # factor on the rolling of balls without load
    oil_losses: float = 1.0  # factor on the losses by oil outside the contacts

    def __post_init__(self) -> None:
        steps = {name: getattr(self, name) for name in ("asperity_share", "elastic_rolling", "starvation")}
        require_finite(**steps)
        require_positive(**{name: value for name, value in vars(self).items() if name not in steps})


NOMINAL = Variation()
