"""The document of a check: it is written without a scene beside its own, and every plot is drawn from it."""

import json
from dataclasses import replace

import numpy as np
import pytest

from analytic.prediction.prediction import predict
from analytic.scenefile.read import parse_scene
from analytic.torque import friction_torque
from fembearing.check.cage_record import record_cage
from fembearing.check.validation import Validation
from fembearing.plain_types import plain
from fembearing.report.figures.page_plots import PLOTS
from fembearing.report.report import Report, report_of
from tests.analytic.scenefile.scene_texts import MOVING
from tests.analytic.specimens import present
from tests.report.test_measured import TWO


@pytest.fixture(scope="module")
def document(checked: Validation) -> Report:
    """With a cage that moved, an interval, and measured torques."""
    scene = parse_scene(MOVING, origin="here")
    record = present(record_cage(scene, friction_torque(scene), 0))
    prediction = predict(checked.scene, samples=64, workers=1)
    torque = replace(present(checked.torque), prediction=prediction, interval=np.array(prediction.total.ends))
    return report_of(replace(checked, cage_records=(record,), torque=torque, measured_torques=TWO))


def test_what_is_written_is_json_of_finite_numbers_with_the_scene_once(document: Report) -> None:
    content = json.loads(json.dumps(plain(document), allow_nan=False))
    assert content == plain(document)
    assert content["provenance"]["scene_content"]["bearing"]["name"] == document.scene.bearing.name
    assert "scene" not in content


def test_every_plot_is_drawn_from_the_document(document: Report) -> None:
    for plot in PLOTS:
        figure, caption = plot.draw(document)
        if plot.section == "inputs":
            assert (figure, caption) == (None, ""), "its surface is not measured"
            continue
        assert figure is not None
        assert caption.endswith(".")
