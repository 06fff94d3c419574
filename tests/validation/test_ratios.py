"""The benchmark over curvature ratios: it writes what it prints, with errors against Hertz's exact solution."""

import json
from pathlib import Path

import pytest


@pytest.mark.slow
def test_the_file_holds_what_is_printed(run_script, tmp_path: Path) -> None:
    printed = run_script("benchmarks/ratios.py", "--ratios", "2.3", "--methods", "mesh", "--out", tmp_path)
    rows = json.loads((tmp_path / "ratios.json").read_text("utf-8"))["rows"]
    assert [(row["ratio"], row["accuracy"]) for row in rows] == [(2.3, 1e-3), (2.3, 5e-4)]
    for row, line in zip(rows, printed.splitlines()[1:], strict=True):
        assert 1e-6 < row["worst"] == max(map(abs, row["errors"].values())) <= row["accuracy"]
        assert row["memory"] > 2**24  # bytes: an interpreter with NumPy takes more
        assert row["seconds"] > 0
        assert f"{100 * row['errors']['approach']:+.4f}%" in line
    errors = rows[0]["errors"]  # on a circle both would be equal
    assert abs(errors["semi_axis_rolling"] - errors["semi_axis_transverse"]) > 1e-4
