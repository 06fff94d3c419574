"""The interval of a torque in the document: what follows from its numbers."""

from fembearing.report.document.prediction import Prediction
from tests.report.figures.test_prediction import content


def test_inputs_are_ranked_by_their_largest_index_at_either_end() -> None:
    assert Prediction.model_validate(content()).ranked == [1, 0, 2]  # 0.61, 0.44 and 0.001
