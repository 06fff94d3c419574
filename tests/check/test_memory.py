"""Peak memory of a function, checked with arrays of known size."""

import numpy as np
import pytest

from fembearing.check import memory
from fembearing.check.memory import peak_memory, peak_while
from tests.analytic.specimens import present

SIZE = 200_000_000  # bytes: far above other changes


def filled() -> float:
    return float(np.ones(SIZE // 8).sum())


@pytest.mark.skipif(not memory.RESET.exists(), reason="only Linux can reset the peak")
def test_the_peak_is_that_of_this_run_and_not_of_earlier_ones() -> None:
    total, large = peak_while(filled)
    _, small = peak_while(lambda: None)
    assert total == SIZE // 8
    assert large is not None
    assert large - present(small) > 0.9 * SIZE  # the process cannot return all pages
    largest = peak_memory()
    assert present(largest) >= large  # a reset does not lose the peak before it


def test_without_a_reset_the_peak_is_the_largest_so_far(monkeypatch: pytest.MonkeyPatch, tmp_path) -> None:
    monkeypatch.setattr(memory, "RESET", tmp_path / "missing" / "file")
    before = peak_memory()
    answer, peak = peak_while(lambda: "done")
    assert answer == "done"
    assert before is None or (peak is not None and peak >= before)
