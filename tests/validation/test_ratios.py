"""The benchmark over curvature ratios: a run writes its rows, with errors against Hertz's exact answer."""

import json
import subprocess
import sys
from pathlib import Path

RATIOS = Path(__file__).resolve().parents[2] / "validation" / "benchmarks" / "ratios.py"


def test_a_run_writes_what_it_prints(tmp_path: Path) -> None:
    command = [sys.executable, RATIOS, "--ratios", "2.3", "--methods", "mesh", "--out", tmp_path]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=300)
    rows = json.loads((tmp_path / "ratios.json").read_text("utf-8"))["rows"]
    assert [(row["ratio"], row["accuracy"]) for row in rows] == [(2.3, 1e-3), (2.3, 5e-4)]
    for row, printed in zip(rows, done.stdout.splitlines()[1:], strict=True):
        assert 1e-6 < row["worst"] == max(map(abs, row["errors"].values())) <= row["accuracy"]
        assert row["memory"] > 2**24  # bytes: an interpreter with NumPy takes more
        assert row["seconds"] > 0
        assert f"{100 * row['errors']['approach']:+.4f}%" in printed
    errors = rows[0]["errors"]  # on a circle those of both axes would be equal
    assert abs(errors["semi_axis_rolling"] - errors["semi_axis_transverse"]) > 1e-4
