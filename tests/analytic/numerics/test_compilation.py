"""Loops against the same functions in Python, and what is kept of them between processes."""

import os
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from analytic.numerics.compilation import FIRST_TIME, Block, Line, Loop, Table, compiled, part
from analytic.numerics.machine_code import FOLDER

POWERS = np.array([0.3, 1.7, 2.9])
EXTRA = 0.25


class Law(NamedTuple):
    """What a loop is given by name."""

    doubled: bool
    factor: float
    shift: tuple[int, float]


@part()
def powers_of(base):
    found = np.zeros(3)
    for index in range(3):
        found[index] = base ** POWERS[index]
    return found


@part(inline=True)
def both(base, law):
    total = powers_of(base).sum() * law.factor
    return total, total + law.shift[0] * law.shift[1] + EXTRA


@compiled()
def fill(bases: Line, out: Table, block: Block, count: int, law: Law) -> float:
    total = 0.0
    for index in range(count):
        first, second = both(bases[index], law)
        out[index, 0], out[index, 1] = first, np.sinh(second) / bases[index]
        block[index, 1, 0] = np.arcsinh(first)
        total += 2.0 * second if law.doubled else second
    return total


@compiled()
def complain(values: Line) -> None:
    if values[0] > 0.0:
        raise ValueError("above zero")


def arguments(*, doubled: bool) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.int64, Law]:
    bases = np.array([0.2, 1.9, 0.7, 1.3])
    return bases, np.zeros((4, 2)), np.zeros((4, 2, 3)), np.int64(3), Law(doubled, 0.7, (5, 0.3))


@pytest.mark.parametrize("doubled", [False, True])
def test_machine_code_does_what_python_does(doubled: bool) -> None:
    ours, theirs = arguments(doubled=doubled), arguments(doubled=doubled)
    assert fill(*ours) == pytest.approx(fill.function(*theirs), rel=1e-14)  # some roundings of libm
    for one, other in zip(ours[1:3], theirs[1:3], strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-14)
    assert ours[1][3].tolist() == [0.0, 0.0]  # beyond the count


def test_a_division_by_zero_gives_infinity() -> None:
    bases, out, block, count, law = arguments(doubled=False)
    bases[1] = 0.0
    fill(bases, out, block, count, law)
    assert out[1, 1] == np.inf


def test_an_array_that_would_be_read_wrongly_is_refused() -> None:
    bases, out, block, count, law = arguments(doubled=False)
    for wrong in (bases.astype(int), out[:, 0], out, bases.astype(np.float32)):
        with pytest.raises(TypeError, match=r"bases is .*, not a C-contiguous array of float64 with 1 dimensions"):
            fill(wrong, out, block, count, law)
    with pytest.raises(TypeError):
        fill(bases, out, block, "3", law)
    with pytest.raises(ValueError, match="shorter"):
        fill(bases, out, block, count)


def test_a_loop_that_raises_says_so() -> None:
    complain(np.array([-0.5]))
    with pytest.raises(RuntimeError, match="complain"):
        complain(np.array([0.5]))


def test_all_that_a_loop_depends_on_is_in_its_key(monkeypatch: pytest.MonkeyPatch) -> None:
    def changed() -> bool:
        keys = [Loop(fill.function, fill.options).key for _ in range(2)]
        assert keys[0] == keys[1]
        return keys[0] != fill.key

    assert not changed()
    for name, value in (("POWERS", POWERS + 1e-15), ("EXTRA", 0.5)):
        with monkeypatch.context() as patched:
            patched.setitem(globals(), name, value)
            assert changed()
    assert Loop(fill.function, {"fastmath": {"contract"}}).key != fill.key


PROGRAM = """
import sys, numpy as np
from tests.analytic.numerics import test_compilation as here
print(here.fill(*here.arguments(doubled=True)), "numba" in sys.modules)
"""


def in_process(folder: Path) -> tuple[float, str, str]:
    """Result of the loop in a new process, whether numba is there, and what is said."""
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM],
        env=os.environ | {FOLDER: str(folder)},
        cwd=Path(__file__).parents[3],
        capture_output=True,
        text=True,
        check=True,
    )
    result, with_numba = done.stdout.split()
    return float(result), with_numba, done.stderr


def test_a_loop_is_compiled_once_and_loaded_without_numba(tmp_path: Path) -> None:
    expected = fill(*arguments(doubled=True))
    assert in_process(tmp_path) == (expected, "True", f"fembearing: {FIRST_TIME}\n")
    assert in_process(tmp_path) == (expected, "False", "")
    (file,) = tmp_path.iterdir()
    whole = file.read_bytes()
    file.write_bytes(whole[: len(whole) // 2])
    assert in_process(tmp_path) == (expected, "True", f"fembearing: {FIRST_TIME}\n")
    assert in_process(tmp_path) == (expected, "False", "")


def test_without_a_folder_the_answer_is_the_same(tmp_path: Path) -> None:
    occupied = tmp_path / "file"
    occupied.touch()
    result, with_numba, said = in_process(occupied / "inside")
    assert (result, with_numba) == (fill(*arguments(doubled=True)), "True")
    first, second = said.splitlines()
    assert first == f"fembearing: {FIRST_TIME}"
    assert "cannot be kept" in second
    assert FOLDER in second
