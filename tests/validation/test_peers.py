"""The comparison with other solvers: the record of a run, and agreement of boundary elements with our meshes."""

import json
from pathlib import Path
from typing import Any

import pytest


def peers_json(folder: Path) -> dict[str, Any]:
    return json.loads((folder / "peers.json").read_text("utf-8"))


@pytest.mark.nightly
def test_boundary_elements_hertz_and_ours_agree_on_the_ellipse_of_the_6205(run_script, tmp_path: Path) -> None:
    pytest.importorskip("tamaas", reason="its wheels are for Linux on x86-64 only")
    chosen = ("--workflows", "same mesh", "--cases", "ellipse", "--peers", "tamaas", "ours")
    run_script("peers/run.py", "--out", tmp_path, "--steps", "3", *chosen)
    errors = {(row["peer"], row["refinement"]): row["errors"] for row in peers_json(tmp_path)["rows"]}
    boundary, ours = errors["tamaas", 64], errors["ours", 3]
    assert max(map(abs, boundary.values())) < 5e-4  # 64 points along a side resolve the edge to 0.02 %
    assert max(map(abs, ours.values())) < 2e-3  # the third level of our recipe is 0.1 % off
    for name, error in boundary.items():  # and with each other
        assert ours[name] == pytest.approx(error, abs=2e-3), name


@pytest.mark.slow
def test_in_its_ordinary_workflow_the_periodic_peer_lacks_what_its_neighbours_take(run_script, tmp_path: Path) -> None:
    pytest.importorskip("tamaas", reason="its wheels are for Linux on x86-64 only")
    chosen = ("--workflows", "ordinary", "--cases", "sphere", "--peers", "tamaas")
    printed = run_script("peers/run.py", "--out", tmp_path, "--steps", "1", *chosen)
    (row,) = peers_json(tmp_path)["rows"]
    assert row["workflow"] == "ordinary"
    assert "51 N: ordinary" in printed
    # The neighbours of a square lattice of point loads on a uniform tension lower the surface by 3.9003 F / (pi E* L)
    # (the lattice sum of 1/r); with F = 4/3 E* a d of a sphere that is 1.655 a / L of its approach d.
    errors = row["errors"]
    assert errors["approach"] == pytest.approx(-1.655 / 20, abs=0.002)  # the coarsest grid has 0.1 %
    assert max(abs(errors[name]) for name in ("semi_axis_x", "semi_axis_y", "peak_pressure")) < 0.005  # six cells to a
