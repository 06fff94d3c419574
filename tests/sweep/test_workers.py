"""Processes that are killed, here and on a Dask cluster: nothing is lost with them, and nothing left of them."""

import multiprocessing
import operator
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from analytic.errors import InputError
from fembearing.sweep import parts
from fembearing.sweep.grid import load_grid
from fembearing.sweep.run import run_sweep
from fembearing.sweep.workers import LostWorkerError, each_done, each_done_by_cluster

Write = Callable[..., Path]
SERIES = 'operation.axial_load = { from = "100 N", to = "900 N", count = 7, spacing = "log" }\n'
SCENES = "friction.coefficient = { from = 0.02, to = 0.13, count = 300 }\n"  # in pieces of 50: some seconds
PATIENCE = 60.0  # s, for what takes one


def wait_until(holds: Callable[[], bool]) -> None:
    end = time.monotonic() + PATIENCE
    while not holds():
        assert time.monotonic() < end
        time.sleep(0.02)


def test_a_task_that_ends_its_process_is_told_and_all_others_are_done() -> None:
    tasks = {number: (operator.neg, number) for number in range(7)} | {"deadly": (os._exit, 3)}
    found = dict(each_done(operator.call, tasks, workers=2))
    assert isinstance(found.pop("deadly"), LostWorkerError)
    assert found == {number: -number for number in range(7)}
    assert not multiprocessing.active_children()


def test_a_worker_killed_once_costs_nothing_but_time(grid_file: Write, tmp_path: Path) -> None:
    path, killed = grid_file(SERIES + SCENES), []

    def kill_one(share: float, _step: str) -> None:
        if 0 < share < 1 and not killed:
            killed.append(multiprocessing.active_children()[0])
            killed[0].kill()

    found = run_sweep(path, out=tmp_path / "out", workers=2, progress=kill_one)
    assert killed
    assert (found.computed, found.failed, found.lost) == (2100, 0, 0)
    data = found.dataset()["torque_total"].transpose("coefficient", "axial_load")
    assert bool((data.diff("coefficient") > 0).all())  # every part at its place: torque grows with friction


def test_points_of_a_worker_that_dies_are_tried_again_next_time(
    grid_file: Write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(parts, "MOST_SCENES", 1)
    path, out, deadly = grid_file(SERIES + "friction.coefficient = [0.03, 0.07, 0.09]"), tmp_path / "out", [7]

    def dying(function, tasks, **_):
        for piece, task in tasks.items():
            yield piece, LostWorkerError("killed") if piece.start in deadly else function(*task)

    monkeypatch.setattr("fembearing.sweep.run.each_done", dying)
    first = run_sweep(path, out=out)
    assert (first.computed, first.kept, first.lost, first.failed) == (14, 0, 7, 7)
    assert set(first.dataset()["failure"].sel(coefficient=0.07).values) == {"killed"}
    deadly.clear()
    second = run_sweep(path, out=out)
    assert (second.computed, second.kept, second.lost, second.failed) == (7, 14, 0, 0)


def test_a_process_killed_in_the_middle_goes_on_where_it_was(grid_file: Write, tmp_path: Path) -> None:
    path, out = grid_file(SERIES + SCENES), tmp_path / "out"
    command = [sys.executable, "-m", "fembearing.cli", "sweep", str(path), "--out", str(out), "--workers", "2"]

    def done() -> list[Path]:
        return list((out / "parts").glob("[0-9]*.npz"))

    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True) as first:
        wait_until(lambda: len(done()) >= 2)
        first.send_signal(signal.SIGSTOP)  # so that it is surely in the middle
        with pytest.raises(InputError, match="another sweep is at work there"):
            run_sweep(path, out=out)
        before = {file: file.stat().st_mtime_ns for file in done()}
        assert len(before) < 6
        group = os.getpgid(first.pid)
        first.kill()
        told, complaint = first.communicate()
        assert told == b""
        assert b"points" not in complaint  # no terminal, no progress

    def is_empty() -> bool:
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return True
        return False

    wait_until(is_empty)  # its workers end with it
    found = run_sweep(path, out=out, workers=1)
    assert (found.kept, found.computed) == (350 * len(before), 2100 - 350 * len(before))
    for file, moment in before.items():
        assert file.stat().st_mtime_ns == moment


def test_a_stop_by_hand_says_how_to_go_on(grid_file: Write, tmp_path: Path) -> None:
    path, out = grid_file(SERIES + SCENES), tmp_path / "out"
    command = [sys.executable, "-m", "fembearing.cli", "sweep", str(path), "--out", str(out), "--workers", "2"]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
    ) as process:
        wait_until(lambda: any((out / "parts").glob("[0-9]*.npz")))
        os.killpg(os.getpgid(process.pid), signal.SIGINT)  # as a terminal does: to the workers too
        told, complaint = process.communicate(timeout=PATIENCE)
    assert (process.returncode, told) == (130, "")
    assert complaint.split() == f"fembearing: stopped; what is done is kept in {out}: the same command goes on".split()


def test_a_dask_cluster_computes_the_same_and_survives_a_worker(grid_file: Write, tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed", exc_type=ImportError)
    path = grid_file(SERIES + "friction.coefficient = { from = 0.02, to = 0.13, count = 60 }\n")
    options = {"n_workers": 1, "threads_per_worker": 1, "dashboard_address": None, "silence_logs": "CRITICAL"}
    with distributed.LocalCluster(**options) as cluster:
        found = run_sweep(path, out=tmp_path / "cluster", scheduler=cluster.scheduler_address)
        tasks = {number: (operator.neg, number) for number in range(4)} | {"deadly": (os._exit, 3)}
        done = dict(each_done_by_cluster(operator.call, tasks, address=cluster.scheduler_address))
    assert isinstance(done.pop("deadly"), LostWorkerError)
    assert done == {number: -number for number in range(4)}
    whole = run_sweep(path, out=tmp_path / "here", workers=1).dataset()
    assert found.dataset().drop_attrs().identical(whole.drop_attrs())


def test_a_scheduler_that_is_not_there_is_one_line(
    grid_file: Write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("distributed", exc_type=ImportError)
    monkeypatch.setattr("fembearing.sweep.workers.PATIENCE", 0.3)
    with pytest.raises(InputError, match="no Dask cluster answers there; start one, or check it"):
        run_sweep(grid_file(SERIES), out=tmp_path / "out", scheduler="tcp://127.0.0.1:9")
    with pytest.raises(InputError, match="no Dask cluster answers there"):
        run_sweep(grid_file(SERIES), out=tmp_path / "out", scheduler="nonsense")
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(InputError, match=r"needs Dask, which is not installed: pip install 'fembearing\[cluster\]'"):
        run_sweep(grid_file(SERIES), out=tmp_path / "out", scheduler="tcp://127.0.0.1:9")
    assert load_grid(grid_file(SERIES)).size == 7
