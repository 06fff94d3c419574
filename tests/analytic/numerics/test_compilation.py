"""Compiled functions and their cache."""

import subprocess
import sys
from pathlib import Path

import numpy as np

from analytic.numerics.compilation import rows_of

BELOW = """
from analytic.numerics.compilation import compiled
OFFSET = {offset}
@compiled
def below(x):
    return {factor} * x
"""
ABOVE = """
from analytic.numerics.compilation import compiled
from below import OFFSET, below
@compiled
def above(x):
    return below(x) + OFFSET
print(above(7.0), *above.stats.cache_hits.values())
"""


def test_a_change_of_what_a_function_calls_compiles_it_anew(tmp_path: Path) -> None:
    """The file of the caller is the same in all runs: numba alone would take what it has in the cache."""

    def run(factor: float, offset: float) -> list[str]:
        (tmp_path / "below.py").write_text(BELOW.format(factor=factor, offset=offset), "utf-8")
        command = [sys.executable, "-B", str(tmp_path / "above.py")]
        return subprocess.run(command, capture_output=True, check=True, text=True).stdout.split()

    (tmp_path / "above.py").write_text(ABOVE, "utf-8")
    assert run(3.0, 0.5) == ["21.5"]
    assert run(3.0, 0.5) == ["21.5", "1"]  # from the cache
    assert run(13.0, 0.25) == ["91.25"]  # as long as 3.0, 0.5 in no digit: the size of the file changes too


def test_rows_are_what_broadcasts() -> None:
    rows, shape = rows_of(np.array([[2.0], [3.0]]), 5, np.array([7.0, 11.0, 13.0]))
    assert shape == (2, 3)
    np.testing.assert_array_equal(rows, [[2, 2, 2, 3, 3, 3], [5] * 6, [7, 11, 13, 7, 11, 13]])
    assert rows.flags.c_contiguous
    assert rows.flags.writeable  # else a loop would be compiled once more
