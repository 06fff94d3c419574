"""The comparison with other solvers: the record of a run, and agreement of boundary elements with our meshes."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

RUN = Path(__file__).resolve().parents[2] / "validation" / "peers" / "run.py"


def peers_json(folder: Path) -> dict[str, Any]:
    return json.loads((folder / "peers.json").read_text("utf-8"))


@pytest.mark.slow
def test_a_run_measures_ours_and_skips_a_missing_solver(
    run_script, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    missing = tmp_path / "missing" / "tamaas.py"
    missing.parent.mkdir()
    missing.write_text("raise ModuleNotFoundError('no such module', name='tamaas')\n", "utf-8")
    monkeypatch.setenv("PYTHONPATH", str(missing.parent))  # comes before an installed one
    out = tmp_path / "out"
    printed = run_script("peers/run.py", "--out", out, "--steps", "1", "--cases", "sphere", "--peers", "tamaas", "ours")
    found = peers_json(out)
    assert found["skipped"] == {"tamaas": "tamaas is not installed"}
    assert "tamaas skipped: tamaas is not installed" in printed
    (row,) = found["rows"]
    assert (row["peer"], row["case"], row["refinement"]) == ("ours", "sphere", 1)
    assert row["worst"] == pytest.approx(max(map(abs, row["errors"].values())))
    assert 1e-5 < row["worst"] < 0.01  # the coarsest mesh is 0.6 % off; not even a fine one is exact
    assert min(row["import_seconds"], row["solve_seconds"]) > 0
    assert row["process_seconds"] > row["solve_seconds"]
    assert row["memory"] > 2**24  # bytes: an interpreter with NumPy takes more
    assert (out / "peers.png").stat().st_size > 0


@pytest.mark.slow
def test_a_peer_that_fails_is_listed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    broken = tmp_path / "broken" / "tamaas.py"
    broken.parent.mkdir()
    broken.write_text("raise RuntimeError('library of another world')\n", "utf-8")
    monkeypatch.setenv("PYTHONPATH", str(broken.parent))
    command = [sys.executable, RUN, "--out", tmp_path, "--steps", "1", "--cases", "sphere", "--peers", "tamaas"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    assert done.returncode == 1
    (row,) = peers_json(tmp_path)["rows"]
    assert "library of another world" in row["failed"]
    assert "tamaas, sphere, refinement 16 failed" in done.stdout.replace("\n", " ")


@pytest.mark.slow
def test_boundary_elements_hertz_and_ours_agree_on_the_ellipse_of_the_6205(run_script, tmp_path: Path) -> None:
    pytest.importorskip("tamaas", reason="its wheels are for Linux on x86-64 only")
    run_script("peers/run.py", "--out", tmp_path, "--cases", "ellipse", "--peers", "tamaas", "ours", "--steps", "3")
    errors = {(row["peer"], row["refinement"]): row["errors"] for row in peers_json(tmp_path)["rows"]}
    boundary, ours = errors["tamaas", 64], errors["ours", 3]
    assert max(map(abs, boundary.values())) < 5e-4  # 64 points along a side resolve the edge to 0.02 %
    assert max(map(abs, ours.values())) < 2e-3  # the third level of our recipe is 0.1 % off
    for name, error in boundary.items():  # and with each other
        assert ours[name] == pytest.approx(error, abs=2e-3), name
