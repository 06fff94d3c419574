"""Processes that are killed, here and on a cluster: no result is lost, no process remains, and no port is open."""

import asyncio
import gc
import operator
import os
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import closing, suppress
from functools import partial
from importlib import import_module
from pathlib import Path
from threading import Thread
from typing import Any

import dask.config
import distributed
import psutil
import pytest
from distributed import Security

from analytic.errors import InputError, ResourceError
from fembearing.sweep import cluster, parts
from fembearing.sweep.cluster import each_done
from fembearing.sweep.grid import load_grid
from fembearing.sweep.parts import Piece
from fembearing.sweep.processes import LostWorkerError
from fembearing.sweep.run import run_sweep
from tests.refusals import refused
from tests.sweep.conftest import one_by_one

Write = Callable[..., Path]
SERIES = 'operation.axial_load = { from = "100 N", to = "900 N", count = 7, spacing = "log" }\n'
SCENES = "friction.coefficient = { from = 0.02, to = 0.13, count = 64 }\n"
EACH = 8  # scenes in a piece, so that there are 8
PATIENCE = 300.0  # s, for what takes a few; only a test that fails waits so long
ONE_TRY = ("distributed.scheduler.allowed-failures", 0)  # before a task runs alone: fewer processes to start
DEADLY = partial(os._exit, 3)


def children(of: int | None = None) -> list[psutil.Process]:
    """The processes that compute for one, by default for this one."""
    return [each for each in psutil.Process(of).children() if "fembearing.sweep.processes" in each.cmdline()]


def all_end(processes: list[psutil.Process]) -> bool:
    """Whether they end in time; one that nobody waits for stays in the system's list."""
    end = time.monotonic() + PATIENCE
    for each in processes:
        with suppress(psutil.NoSuchProcess):
            while each.status() != psutil.STATUS_ZOMBIE and time.monotonic() < end:
                time.sleep(0.02)
    return time.monotonic() < end


def test_a_task_that_ends_its_process_is_reported_and_all_others_are_done(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OMP_NUM_THREADS", "3")
    monkeypatch.delenv("MKL_NUM_THREADS", raising=False)
    before = dict(os.environ)
    numbers = [partial(operator.neg, number) for number in range(40)]
    names = [partial(os.getenv, name) for name in ("OMP_NUM_THREADS", "MKL_NUM_THREADS")]
    found = dict(each_done(operator.call, [*numbers, *names, DEADLY], workers=2))
    assert [found.pop(name) for name in names] == ["3", "1"]  # the first as the user has set it
    assert dict(os.environ) == before
    assert isinstance(found.pop(DEADLY), LostWorkerError)
    assert [found[task] for task in numbers] == [-number for number in range(40)]
    assert children() == []


def test_what_a_task_prints_is_no_result_and_what_it_raises_is_raised(capfd: pytest.CaptureFixture[str]) -> None:
    tasks = [partial(print, "aside"), partial(operator.truediv, 5, 0)]
    results = each_done(operator.call, tasks, workers=1)
    assert next(results) == (tasks[0], None)
    with pytest.raises(ZeroDivisionError):
        next(results)
    assert capfd.readouterr() == ("", "aside\n")
    assert children() == []


@pytest.mark.parametrize(("workers", "expected"), [(None, 2), (3, 3), (40, 4)])
def test_there_is_a_process_for_each_core_unless_a_number_is_given(
    monkeypatch: pytest.MonkeyPatch, workers: int | None, expected: int
) -> None:
    """And never more of them than tasks."""
    monkeypatch.setattr(cluster, "cores", lambda: 2)
    tasks = [partial(os.getpid) for _ in range(4)]
    assert len({number for _, number in each_done(operator.call, tasks, workers=workers)}) == expected


def test_no_port_is_open_while_tasks_are_computed() -> None:
    before = psutil.Process().net_connections("all")
    with closing(each_done(operator.call, [partial(os.getpid), partial(time.sleep, PATIENCE)], workers=2)) as results:
        _, first = next(results)
        assert first in [each.pid for each in children()]
        assert [each.net_connections("all") for each in children()] == [[], []]
        assert psutil.Process().net_connections("all") == before


def test_processes_that_cannot_start_are_one_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "numpy.py").write_text("raise SystemExit(1)", "utf-8")
    monkeypatch.syspath_prepend(str(tmp_path))
    with pytest.raises(ResourceError, match="end as soon as they start; free some memory: finished points are kept"):
        next(each_done(operator.neg, [7], workers=1))


def test_a_worker_killed_once_costs_only_time_and_no_number(
    grid_file: Write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The only one, so that for a while there is none."""
    monkeypatch.setattr(parts, "MOST_SCENES", EACH)
    path, killed = grid_file(SERIES + SCENES), []

    def kill_one(share: float, _step: str) -> None:
        if 0 < share < 1 and not killed:
            killed.extend(children())
            killed[0].kill()

    found = run_sweep(path, out=tmp_path / "out", workers=1, progress=kill_one)
    assert killed
    assert (found.computed, found.failed, found.lost) == (448, 0, 0)
    monkeypatch.setattr("fembearing.sweep.run.each_done", one_by_one)
    here = run_sweep(path, out=tmp_path / "here").to_dataset()
    assert found.to_dataset().drop_attrs().identical(here.drop_attrs())


def test_points_of_a_worker_that_dies_are_tried_again_next_time(
    grid_file: Write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(parts, "MOST_SCENES", 1)
    path, out, deadly = grid_file(SERIES + "friction.coefficient = [0.03, 0.07, 0.09]"), tmp_path / "out", [7]

    def dying(function, tasks, **_):
        for piece in tasks:
            yield piece, LostWorkerError() if piece.start in deadly else function(piece)

    monkeypatch.setattr("fembearing.sweep.run.each_done", dying)
    first = run_sweep(path, out=out)
    assert (first.computed, first.kept, first.lost, first.failed) == (14, 0, 7, 7)
    assert set(first.to_dataset()["failure"].sel(coefficient=0.07).values) == {str(LostWorkerError())}
    deadly.clear()

    def stop(_share: float, step: str) -> None:
        if step == "gathering":
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_sweep(path, out=out, progress=stop)
    third = run_sweep(path, out=out)
    assert (third.computed, third.kept, third.lost, third.failed) == (0, 21, 0, 0)
    assert bool(third.to_dataset()["torque_total"].notnull().all())  # not the dataset of the first run


# A sweep that keeps `HELD` pieces, says so and then waits: the signal always meets it in the middle of its work.
# It waits in short sleeps, since a signal that arrives just before a long one would not end it.
HELD = 2
HOLDING = f"""
import signal, time
from fembearing import cli
from fembearing.sweep import parts
from fembearing.sweep.store import Store

parts.MOST_SCENES = {EACH}
save, saved = Store.save, []

def save_and_hold(store, piece, part):
    save(store, piece, part)
    saved.append(piece)
    if len(saved) == {HELD}:
        print("holding", flush=True)
        for _ in range(100 * {int(PATIENCE)}):
            time.sleep(0.01)

Store.save = save_and_hold
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's command in the background ignores it
cli.main()
"""


def test_a_sweep_stopped_or_killed_in_the_middle_continues(
    grid_file: Write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, in_process: list[Piece]
) -> None:
    path, out = grid_file(SERIES + SCENES), tmp_path / "out"
    command = [sys.executable, "-c", HOLDING, "sweep", str(path), "--out", str(out), "--workers", "1"]
    before: dict[Path, int] = {}
    stops = {signal.SIGINT: 130, signal.SIGTERM: 143, signal.SIGKILL: -signal.SIGKILL}
    for count, (stop, status) in enumerate(stops.items(), start=1):
        with subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
        ) as process:
            assert process.stdout is not None
            assert process.stdout.readline() == "holding\n"
            with pytest.raises(InputError, match="another sweep is at work there"):
                run_sweep(path, out=out)
            at_work = children(process.pid)
            assert len(at_work) == 1
            os.killpg(process.pid, stop)  # as a terminal does
            output, complaint = process.communicate(timeout=PATIENCE)
        assert (process.returncode, output) == (status, "")
        words = f"fembearing: stopped; finished points are in {out}; the same command continues"
        # And no progress where there is no terminal
        assert complaint.split() == (words.split() if stop is signal.SIGINT else [])
        assert all_end(at_work)
        assert all(file.stat().st_mtime_ns == moment for file, moment in before.items())
        before = {file: file.stat().st_mtime_ns for file in (out / "parts").glob("[0-9]*")}
        assert len(before) == count * HELD

    monkeypatch.setattr(parts, "MOST_SCENES", EACH)
    result = run_sweep(path, out=out)
    assert (result.kept, result.computed) == (56 * 3 * HELD, 448 - 56 * 3 * HELD)
    assert len(in_process) == 8 - 3 * HELD
    assert all(file.stat().st_mtime_ns == moment for file, moment in before.items())


BUSY = """
import operator, signal, time
from functools import partial
from fembearing.sweep.cluster import each_done

signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell has its background ignore it
for task, _ in each_done(operator.call, [partial(time.sleep, 0), partial(time.sleep, 900)], workers=2):
    print("busy", flush=True)
"""


@pytest.mark.parametrize("stop", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_a_process_ends_in_the_middle_of_its_work_with_the_one_that_started_it(stop: signal.Signals) -> None:
    with subprocess.Popen([sys.executable, "-c", BUSY], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == b"busy\n"
        at_work = children(process.pid)
        assert len(at_work) == 2
        process.send_signal(stop)
        try:
            process.communicate(timeout=PATIENCE)
        finally:
            process.kill()  # else the block waits for what did not end
        assert all_end(at_work)


class Unreadable:
    """An object that a cluster cannot read."""

    def __reduce__(self) -> tuple[Any, ...]:
        return import_module, ("nowhere",)


@pytest.fixture
def certified(tmp_path: Path) -> Iterator[None]:
    """Dask configured with a certificate, the same for all."""
    if (openssl := shutil.which("openssl")) is None:
        pytest.skip("openssl makes the certificate")
    files = {"cert": str(tmp_path / "cert.pem"), "key": str(tmp_path / "key.pem")}
    made = ["-newkey", "rsa:2048", "-subj", "/CN=any", "-keyout", files["key"], "-out", files["cert"]]
    subprocess.run([openssl, "req", "-x509", "-nodes", "-days", "2", *made], check=True, capture_output=True)
    places = {f"{who}.{kind}": file for who in ("scheduler", "worker", "client") for kind, file in files.items()}
    tls = {f"distributed.comm.tls.{key}": file for key, file in {"ca-file": files["cert"], **places}.items()}
    with dask.config.set(tls):
        yield


@pytest.mark.nightly
@pytest.mark.usefixtures("certified")
def test_a_cluster_elsewhere_computes_the_same_and_survives_a_worker(
    grid_file: Write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, in_process: list[Piece]
) -> None:
    path = grid_file(SERIES + "friction.coefficient = { from = 0.02, to = 0.13, count = 60 }\n")
    whole = run_sweep(path, out=tmp_path / "here").to_dataset()
    assert len(in_process) == 2
    options = {"n_workers": 1, "threads_per_worker": 1, "dashboard_address": "127.0.0.1:0", "silence_logs": "CRITICAL"}
    start: Any = distributed.LocalCluster
    with dask.config.set(dict([ONE_TRY])), start(**options, protocol="tls", security=Security()) as elsewhere:
        address = elsewhere.scheduler_address
        with dask.config.set({"distributed.comm.tls.ca-file": None, "distributed.comm.tls.client.cert": None}):
            refused(lambda: next(each_done(operator.neg, [7], scheduler=address)), "tls:// takes the certificates")
        with dask.config.set({"distributed.comm.require-encryption": True}):
            plain = address.replace("tls:", "tcp:")
            refused(lambda: next(each_done(operator.neg, [7], scheduler=plain)), "tls:// takes the certificates")
        monkeypatch.setattr("fembearing.sweep.run.each_done", each_done)
        found = run_sweep(path, out=tmp_path / "cluster", scheduler=address)
        tasks = [*(partial(operator.neg, number) for number in range(4)), DEADLY]
        with monkeypatch.context() as patch:
            own = os.getpid()
            versions = lambda _name: "0.0.7" if os.getpid() == own else "0.0.6"  # noqa: E731, to be sent by value
            patch.setattr(cluster, "version", versions)
            with pytest.raises(InputError, match=r"a worker has not fembearing 0\.0\.7 as here \(0\.0\.6\); install"):
                list(each_done(operator.call, tasks, scheduler=address))
        with pytest.raises(InputError, match="cannot read what it is sent; its scheduler needs fembearing"):
            list(each_done(operator.neg, [Unreadable()], scheduler=address))

        async def in_a_notebook() -> dict[Any, Any]:
            return dict(each_done(operator.call, tasks, scheduler=address))

        done = asyncio.run(in_a_notebook())
        going = each_done(operator.call, [tasks[3], partial(time.sleep, 60)], scheduler=address)
        assert next(going) == (tasks[3], -3)
        elsewhere.close()
        with pytest.raises(InputError, match="the cluster went away; finished points are kept"):
            next(going)
    assert isinstance(done.pop(DEADLY), LostWorkerError)
    assert sorted(done.values()) == [-3, -2, -1, 0]
    assert found.to_dataset().drop_attrs().identical(whole.drop_attrs())


def test_a_scheduler_that_is_not_there_is_one_line(
    grid_file: Write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(cluster, "PATIENCE", 0.3)
    with pytest.raises(InputError, match="no Dask cluster answers there; start one, or check it"):
        run_sweep(grid_file(SERIES), out=tmp_path / "out", scheduler="tcp://127.0.0.1:9")
    (tmp_path / "made").mkdir()
    with pytest.raises(InputError, match="no Dask cluster answers there"):
        run_sweep(grid_file(SERIES), out=tmp_path / "made", scheduler="nonsense")
    assert not (tmp_path / "out").exists()
    assert list((tmp_path / "made").iterdir()) == []
    assert load_grid(grid_file(SERIES)).size == 7


@pytest.mark.parametrize(
    "says",
    [
        pytest.param(b"", id="nothing", marks=pytest.mark.nightly),  # it waits for an answer
        pytest.param(b"HTTP/1.1 400 Bad Request\r\n\r\n", id="what no Dask says"),
    ],
)
def test_what_listens_and_is_no_scheduler_is_one_line(says: bytes, capfd: pytest.CaptureFixture[str]) -> None:
    """Dask would read sizes out of what it is answered, or wait for ever."""
    with socket.create_server(("127.0.0.1", 0)) as server:

        def answer() -> None:
            with suppress(OSError):  # the test is over
                while True:
                    there, _ = server.accept()
                    held.append(there)
                    there.sendall(says)

        held: list[socket.socket] = []
        Thread(target=answer, daemon=True).start()
        place = f"tcp://127.0.0.1:{server.getsockname()[1]}"
        with pytest.raises(InputError, match="no Dask cluster answers there"):
            list(each_done(operator.neg, [7], scheduler=place))
        for there in held:
            there.close()
    gc.collect()  # a client that was given up would complain here
    assert capfd.readouterr().err == ""
