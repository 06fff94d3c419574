"""A thousand damaged files are each read or refused in one line, and every kind of fault is detected."""

import importlib
import os
import subprocess
import warnings
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from analytic.errors import InputError

VALIDATION = Path(__file__).resolve().parents[2] / "validation"
FILES = 1000
pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="the time of one file is limited by a signal")


@pytest.fixture(scope="module")
def fuzz() -> Iterator[ModuleType]:
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(VALIDATION)
        yield importlib.import_module("fuzz")


def test_every_damaged_file_is_read_or_refused(fuzz: ModuleType) -> None:
    """Always the same files; validation/fuzz.py tries others. A fault shows its seed."""
    results = list(fuzz.fuzzed(range(FILES)))
    assert [outcome for _, outcome in results if isinstance(outcome, fuzz.Fault)] == []
    for kind in ("scene", "height map", "mesh"):
        outcomes = [outcome for known, outcome in results if known == kind]
        assert len(outcomes) >= FILES // 3
        assert 0.05 < np.mean([outcome == "read" for outcome in outcomes]) < 0.6, (
            kind
        )  # else one of the two is hardly tested


def hang(_: Path) -> None:
    while True:
        pass


def overflow(_: Path) -> None:
    warnings.warn("overflow", RuntimeWarning, stacklevel=1)


def hoard(_: Path) -> float:
    return float(np.ones(40_000_000).sum())


def ramble(_: Path) -> None:
    raise InputError("one line\nand another")


@pytest.mark.parametrize(
    ("read", "words"),
    [
        (lambda _: subprocess.run(["true"], check=True), "ForbiddenError: subprocess.Popen"),
        (lambda _: os.system("true"), "ForbiddenError: os.system"),
        (lambda path: path.with_suffix(".new").write_text("a"), "ForbiddenError: open"),
        (lambda _: 1 / 0, "ZeroDivisionError"),
        (hang, "TooSlowError"),
        (overflow, "RuntimeWarning: overflow"),
        (hoard, "bytes"),
        (ramble, "an unclear error"),
    ],
)
def test_every_kind_of_fault_is_detected(
    fuzz: ModuleType, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, read, words: str
) -> None:
    monkeypatch.setattr(fuzz, "SLOWEST", 0.2)
    monkeypatch.setattr(fuzz, "LARGEST", 1e8)
    if read is hoard:
        fuzz.outcome(tmp_path, lambda _: None)  # the peak counts from the memory held now
        monkeypatch.setattr(fuzz, "peak_memory", lambda: 0)
    assert words in fuzz.outcome(tmp_path / "file", read)
    assert fuzz.outcome(tmp_path / "file", lambda _: None) in ("read", "refused") or read is hoard
