"""The sentences that page and terminal share."""

from analytic.verdicts import NumericalCheck
from fembearing.report.phrases import numerical_words


def test_an_uncertainty_has_its_number_or_the_reason_why_it_is_not_known() -> None:
    unknown = numerical_words(NumericalCheck(uncertainty=None, tolerance=0.04, reason="the cage came apart"))
    assert "not known: the cage came apart" in unknown
    assert "%" not in unknown
    for uncertainty, side in ((0.013, "within"), (0.067, "beyond")):
        words = numerical_words(NumericalCheck(uncertainty=uncertainty, tolerance=0.04, reason=""))
        assert f"{100 * uncertainty:g} %, {side} the tolerance 4 %" in words
        assert "not known" not in words
