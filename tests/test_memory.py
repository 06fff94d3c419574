"""Memory while one thing runs, by arrays of known size."""

import numpy as np
import pytest

from fembearing import memory
from fembearing.memory import peak_memory, peak_while

SIZE = 200_000_000  # bytes: far above what else moves


def filled() -> float:
    return float(np.ones(SIZE // 8).sum())


@pytest.mark.skipif(not memory.FORGET.exists(), reason="only Linux counts a peak anew")
def test_a_peak_is_that_of_the_run_and_not_of_those_before() -> None:
    total, large = peak_while(filled)
    _, small = peak_while(lambda: None)
    assert total == SIZE // 8
    assert large is not None
    assert small is not None
    assert large - small > 0.9 * SIZE  # a page or so is not the process's to give back
    largest = peak_memory()
    assert largest is not None
    assert largest >= large  # what was counted anew is not forgotten


def test_where_no_peak_is_counted_anew_it_is_the_largest_so_far(monkeypatch: pytest.MonkeyPatch, tmp_path) -> None:
    monkeypatch.setattr(memory, "FORGET", tmp_path / "missing" / "file")
    before = peak_memory()
    found, peak = peak_while(lambda: "done")
    assert found == "done"
    assert before is None or (peak is not None and peak >= before)
