"""Compiled functions against the same functions in Python, and what is kept of them between processes."""

import os
import subprocess
import sys
from inspect import unwrap
from pathlib import Path
from typing import Any, NamedTuple, cast

import numpy as np
import pytest

from analytic.numerics.compilation import FIRST_TIME, Compiled, compiled
from analytic.numerics.machine_code import FOLDER
from analytic.scene import Array

POWERS = np.array([0.3, 1.7, 2.9])
EXTRA = 0.25


class Law(NamedTuple):
    """What a function is given by name."""

    doubled: bool
    factor: float
    shift: tuple[int, float]
    table: Array


class Sums(NamedTuple):
    """What it gives."""

    law: tuple[bool, int]
    total: float


@compiled
def powers_of(base: float) -> Array:
    found = np.zeros(3)
    for index in range(3):
        found[index] = base ** POWERS[index]
    return found


@compiled(inline=True)
def both(base, law):
    total = powers_of(base).sum() * law.factor + law.table[1, 0]
    return total, total + law.shift[0] * law.shift[1] + EXTRA


@compiled
def fill(bases: Array, out: Array, count: int, law: Law) -> tuple[Sums, float]:
    total = 0.0
    for index in range(count):
        first, second = both(bases[index], law)
        out[index, 0], out[index, 1] = first, np.sinh(second) / bases[index]
        total += 2.0 * second if law.doubled else second
    return Sums((not law.doubled, count), total), np.arcsinh(total)


@compiled
def pairs(count: int) -> Array:
    found = np.empty((count, 2))
    for index in range(count):
        found[index, 0], found[index, 1] = index, -0.5 * index
    return found


@compiled
def split(values: Array):
    return Sums((False, values.size), values[0]), values.reshape((2, -1)) * 2.0


@compiled
def refuse(value: float) -> None:
    if value > 0.0:
        raise ValueError("above zero")


def arguments(*, doubled: bool = False) -> tuple[Array, Array, Any, Law]:
    table = np.array([[0.1, 0.2], [0.4, 0.9]])
    return np.array([0.2, 1.9, 0.7, 1.3]), np.zeros((4, 2)), np.int64(3), Law(doubled, 0.7, (5, 0.3), table)


@pytest.mark.parametrize("doubled", [False, True])
def test_machine_code_does_what_python_does(doubled: bool) -> None:
    ours, theirs = arguments(doubled=doubled), arguments(doubled=doubled)
    found, expected = fill(*ours), unwrap(fill)(*theirs)
    assert isinstance(found[0], Sums)
    assert (found[0].law, type(found[0].law[0])) == ((not doubled, 3), bool)
    assert found[0].total == pytest.approx(expected[0].total, rel=1e-14)  # some roundings of libm
    assert found[1] == pytest.approx(expected[1], rel=1e-14)
    np.testing.assert_allclose(ours[1], theirs[1], rtol=1e-14)
    assert ours[1][3].tolist() == [0.0, 0.0]  # beyond the count


def test_any_array_is_read_where_it_lies() -> None:
    bases, out, count, law = arguments()
    fill(bases, out, count, law)
    wide, transposed = np.zeros((2, 4)), law._replace(table=law.table.T.copy().T)
    assert not transposed.table.flags.c_contiguous
    wide.flags.writeable, bases.flags.writeable = True, False
    fill(np.repeat(bases, 2)[::2], wide.T, 3, transposed)
    np.testing.assert_array_equal(wide.T, out)
    law.table[1, 0] += 0.05  # the same tuple, whose array has changed
    fill(bases, out, count, law)
    assert np.all(wide.T[:3, 0] + 0.05 - out[:3, 0] == pytest.approx(0.0, abs=1e-15))


def test_arrays_are_given_with_their_shapes() -> None:
    assert pairs(3).tolist() == [[0.0, 0.0], [1.0, -0.5], [2.0, -1.0]]
    assert pairs(0).shape == (0, 2)
    many = [pairs(1000) for _ in range(300)]  # memory that is given back is used again, and no array changes
    assert all(np.array_equal(each, many[0]) for each in many)
    np.testing.assert_allclose(powers_of(2), [2**0.3, 2**1.7, 2**2.9], rtol=1e-14)  # an integer for a float


def test_results_have_their_names_without_annotations() -> None:
    sums, doubled = split(np.array([0.5, 1.5, 2.5, 3.5]))
    assert (type(sums), sums) == (Sums, ((False, 4), 0.5))
    assert doubled.tolist() == [[1.0, 3.0], [5.0, 7.0]]  # by a function of numba's own, for the shape


def test_a_division_by_zero_gives_infinity() -> None:
    bases, out, count, law = arguments()
    bases[1] = 0.0
    fill(bases, out, count, law)
    assert out[1, 1] == np.inf


def test_what_machine_code_does_not_take_is_refused() -> None:
    with pytest.raises(TypeError, match="take no str"):
        fill(*arguments()[:2], cast(Any, "3"), arguments()[3])
    with pytest.raises(TypeError, match="take no list"):
        fill(*arguments()[:3], cast(Any, ([1.0], 2)))
    refuse(-0.5)
    with pytest.raises(RuntimeError, match="refuse"):
        refuse(0.5)


def test_all_that_a_function_depends_on_is_in_its_source(monkeypatch: pytest.MonkeyPatch) -> None:
    def source() -> list[str]:
        return [*cast(Compiled, fill).source()]

    before = source()
    assert source() == before
    for name, value in (("POWERS", POWERS + 1e-15), ("EXTRA", 0.5), ("both", powers_of), ("Sums", Law)):
        with monkeypatch.context() as patched:
            patched.setitem(globals(), name, value)
            assert source() != before
    fast = Compiled(cast(Any, unwrap(fill)), {"fastmath": {"contract"}, "inline": "never"})
    assert [*fast.source()] != before
    monkeypatch.setitem(globals(), "EXTRA", sys.modules["pathlib"])
    with pytest.raises(TypeError, match="pathlib: import what it takes"):
        source()


PROGRAM = """
import sys
from tests.analytic.numerics import test_compilation as here
print(here.fill(*here.arguments())[1], "numba" in sys.modules)
assert here.split(here.arguments()[0])[1][1, 0] == 1.4

"""


def ended(program: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """A program in a new process, which keeps machine code in a folder."""
    return subprocess.run(
        [sys.executable, "-c", program],
        env=os.environ | {FOLDER: str(folder)},
        cwd=Path(__file__).parents[3],
        capture_output=True,
        text=True,
        check=False,
    )


def in_process(folder: Path) -> tuple[float, str, str]:
    """Result of the function in a new process, whether numba is there, and what is said."""
    done = ended(PROGRAM, folder)
    assert done.returncode == 0, done.stderr
    result, with_numba = done.stdout.split()
    return float(result), with_numba, done.stderr


def test_a_function_is_compiled_once_and_loaded_without_numba(tmp_path: Path) -> None:
    expected = fill(*arguments())[1]
    assert in_process(tmp_path) == (expected, "True", f"fembearing: {FIRST_TIME}\n")
    assert in_process(tmp_path) == (expected, "False", "")
    file, other = sorted(tmp_path.iterdir())
    assert [each.name.partition("-")[0].rpartition(".")[2] for each in (file, other)] == ["fill", "split"]
    whole = file.read_bytes()
    file.write_bytes(whole[: len(whole) // 2])
    assert in_process(tmp_path) == (expected, "True", f"fembearing: {FIRST_TIME}\n")
    assert in_process(tmp_path) == (expected, "False", "")


def test_without_a_folder_the_answer_is_the_same(tmp_path: Path) -> None:
    occupied = tmp_path / "file"
    occupied.touch()
    result, with_numba, said = in_process(occupied / "inside")
    assert (result, with_numba) == (fill(*arguments())[1], "True")
    first, second = said.splitlines()
    assert first == f"fembearing: {FIRST_TIME}"
    assert "cannot be kept" in second
    assert FOLDER in second


THREADS = """
from concurrent.futures import ThreadPoolExecutor
from threading import Barrier
from tests.analytic.numerics.test_compilation import arguments, fill, powers_of

start = Barrier(8)

def called(number):
    start.wait()
    return fill(*arguments())[1] if number % 2 else powers_of(0.7).sum()

with ThreadPoolExecutor(8) as threads:
    print(*sorted(set(threads.map(called, range(8)))))
"""


def test_threads_may_make_the_first_call_together(tmp_path: Path) -> None:
    """LLVM takes one thread at a time: without a lock most such processes crash."""
    expected = sorted([fill(*arguments())[1], powers_of(0.7).sum()])
    for cache in ("empty", "filled"):
        done = ended(THREADS, tmp_path)
        assert done.returncode == 0, (cache, done.stderr)
        assert [float(word) for word in done.stdout.split()] == expected
