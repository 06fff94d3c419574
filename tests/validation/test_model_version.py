"""No torque of a shipped scene changes unnoticed. The stored numbers are our own: they detect a change, no error."""

import re
from pathlib import Path

import pytest

from analytic.torque import MODEL_VERSION
from validation import model_version as table

ROOT = Path(__file__).parents[2]
# Relative: iterations of the balls' equilibrium end at 1e-8 and below, and machines differ by rounding; a formula that
# changes a torque by less is no change that a reader of the changelog asks for.
SAME = 1e-5
REMEDY = "raise MODEL_VERSION in analytic/torque.py, write old and new into CHANGELOG.md: validation/model_version.py"


def test_the_torques_of_the_shipped_scenes_are_those_of_this_model_version() -> None:
    stored, computed = table.stored(), list(table.computed())
    assert {row.version for row in stored} == {MODEL_VERSION}, REMEDY
    assert [row[1:3] for row in stored] == [row[1:3] for row in computed], REMEDY
    assert [row.total for row in computed] == pytest.approx([row.total for row in stored], rel=SAME), REMEDY


def test_the_changelog_knows_the_model_version() -> None:
    assert re.search(rf"\bmodel version {MODEL_VERSION}\b", (ROOT / "CHANGELOG.md").read_text("utf-8"), re.IGNORECASE)
