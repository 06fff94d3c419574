"""The comparison with other solvers: a run reports its rows, and boundary elements agree with our finite elements."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

RUN = Path(__file__).resolve().parents[2] / "validation" / "peers" / "run.py"


def peers_json(folder: Path, *arguments: str) -> tuple[dict[str, Any], str]:
    """The content of peers.json after a run, and its printed text."""
    done = subprocess.run(
        [sys.executable, RUN, "--out", folder, *arguments], capture_output=True, check=True, text=True, timeout=300
    )
    return json.loads((folder / "peers.json").read_text("utf-8")), done.stdout


def test_a_run_measures_ours_and_skips_what_is_missing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    missing = tmp_path / "missing" / "tamaas.py"
    missing.parent.mkdir()
    missing.write_text("raise ModuleNotFoundError('no such module', name='tamaas')\n", "utf-8")
    monkeypatch.setenv("PYTHONPATH", str(missing.parent))  # comes before any installed one
    found, printed = peers_json(tmp_path / "out", "--steps", "1", "--cases", "sphere", "--peers", "tamaas", "ours")
    assert found["skipped"] == {"tamaas": "tamaas is not installed"}
    assert "tamaas skipped: tamaas is not installed" in printed
    (row,) = found["rows"]
    assert (row["peer"], row["case"], row["refinement"]) == ("ours", "sphere", 1)
    assert row["worst"] == pytest.approx(max(map(abs, row["errors"].values())))
    assert 1e-5 < row["worst"] < 0.01  # the coarsest mesh is 0.6 % off; not even a fine one is exact
    assert min(row["import_seconds"], row["solve_seconds"]) > 0
    assert row["process_seconds"] > row["solve_seconds"]
    assert row["memory"] > 2**24  # bytes: an interpreter with NumPy takes more
    assert (tmp_path / "out" / "peers.png").stat().st_size > 0


def test_a_peer_that_fails_is_listed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    broken = tmp_path / "broken" / "tamaas.py"
    broken.parent.mkdir()
    broken.write_text("raise RuntimeError('library of another world')\n", "utf-8")
    monkeypatch.setenv("PYTHONPATH", str(broken.parent))
    command = [sys.executable, RUN, "--out", tmp_path, "--steps", "1", "--cases", "sphere", "--peers", "tamaas"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    assert done.returncode == 1
    (row,) = json.loads((tmp_path / "peers.json").read_text("utf-8"))["rows"]
    assert "library of another world" in row["failed"]
    assert "tamaas, sphere, refinement 16 failed" in done.stdout.replace("\n", " ")


def test_boundary_elements_hertz_and_ours_agree_on_the_ellipse_of_the_6205(tmp_path: Path) -> None:
    pytest.importorskip("tamaas", reason="its wheels are for Linux on x86-64 only")
    found, _ = peers_json(tmp_path, "--cases", "ellipse", "--peers", "tamaas", "ours", "--steps", "3")
    errors = {(row["peer"], row["refinement"]): row["errors"] for row in found["rows"]}
    boundary, ours = errors["tamaas", 64], errors["ours", 3]
    assert max(map(abs, boundary.values())) < 5e-4  # 64 points along a side resolve the edge to 0.02 %
    assert max(map(abs, ours.values())) < 2e-3  # the third level of our recipe is 0.1 % off
    for name, error in boundary.items():  # compared directly, without Hertz
        assert ours[name] == pytest.approx(error, abs=2e-3), name
