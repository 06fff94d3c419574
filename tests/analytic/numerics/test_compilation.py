"""Formulas as machine code against the same formulas in Python, and the files that keep the code."""

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from analytic import load_scene
from analytic.numerics.machine_code import CACHE, families, loaded
from analytic.numerics.records import record_of
from analytic.solve.kernel import solve
from analytic.solve.model import workspace
from analytic.solve.records import BALL, POINT
from analytic.torque import races_of
from tests.analytic.numerics.formulas import SUMS, Law, Tables, fill, power_sum

ROOT = Path(__file__).parents[3]
BASES, POWERS = np.array([0.2, 1.9, 0.1, 1.3, 0.6]), np.array([0.3, 1.7, 2.9])
PROGRAM = """
from tests.analytic.numerics import test_compilation as here
count, sums = here.filled()
print(count, *(float(total).hex() for total in sums["total"][:, 1]))
"""


def arguments(*, doubled: bool = False, adds: bool = True) -> tuple[Any, ...]:
    tables = Tables(POWERS, record_of(Law(doubled, 0.7, (5.0, 0.3))))
    return BASES, tables, (0.15, 4), np.zeros((5, 2), SUMS), adds


def filled(**changed: bool) -> tuple[int, Any]:
    given = arguments(**changed)
    return fill(*given), given[3]


@pytest.mark.parametrize("doubled", [False, True])
@pytest.mark.parametrize("adds", [False, True])
def test_machine_code_does_what_python_does(doubled: bool, adds: bool) -> None:
    count, sums = filled(doubled=doubled, adds=adds)
    expected = arguments(doubled=doubled, adds=adds)
    assert fill.interpreted(*expected[:3], expected[3].view(np.recarray), adds) == count == 3
    np.testing.assert_allclose(sums["total"], expected[3]["total"], rtol=1e-14)  # some roundings of libm
    np.testing.assert_array_equal(sums["counted"], expected[3]["counted"])
    assert sums["total"][[2, 4]].tolist() == [[0.0, 0.0]] * 2  # below the least one, and beyond the number


def test_a_division_by_zero_gives_infinity() -> None:
    given = arguments()
    bases = given[0].copy()
    bases[1] = 0.0
    fill(bases, given[1], (0.0, 4), *given[3:])
    assert given[3]["total"][1, 1] == np.inf
    assert power_sum(0.0, np.array([-1.3, 2.0])) == np.inf


def test_an_array_in_pieces_is_refused() -> None:
    with pytest.raises(ValueError, match=r"shape \(5,\)"):
        fill(np.repeat(BASES, 2)[::2], *arguments()[1:])


def test_a_bound_call_sees_what_changes_in_its_arrays() -> None:
    _, *others, sums, adds = arguments(adds=False)
    bases = BASES.copy()
    call = fill.bound(bases, *others, sums, adds)
    assert call() == 3
    first = sums["total"][0, 1]
    bases[0] *= 1.5
    assert call() == 3
    assert sums["total"][0, 1] > first


def run(cache: Path, code: str = PROGRAM) -> subprocess.CompletedProcess[str]:
    """A program in a process of its own."""
    return subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "PYTHONPATH": str(ROOT), CACHE: str(cache)},
        cwd=ROOT,
        capture_output=True,
        check=False,
        text=True,
    )


COMPILING = "fembearing: compiling formulas, once on this machine\n"
WITHOUT_NUMBA = f"import sys; sys.modules['numba'] = None\n{PROGRAM}"


@pytest.fixture(scope="module")
def first(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """A cache with one file, and what the program prints."""
    cache = tmp_path_factory.mktemp("cache")
    done = run(cache)
    assert (done.returncode, done.stderr) == (0, COMPILING)
    return cache, done.stdout


def copied(cache: Path, to: Path) -> Path:
    (file,) = cache.glob("*.code")
    (to / file.name).write_bytes(file.read_bytes())
    return to / file.name


def test_the_code_is_kept_and_loaded_without_a_compiler(first: tuple[Path, str]) -> None:
    cache, told = first
    done = run(cache, WITHOUT_NUMBA + "print([name for name in sys.modules if 'numba' in name])")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == f"{told}['numba']\n"


@pytest.mark.parametrize("damage", ["cut", "bit", "empty", "foreign"])
def test_a_damaged_file_is_compiled_again(first: tuple[Path, str], damage: str, tmp_path: Path) -> None:
    file = copied(first[0], tmp_path)
    whole = file.read_bytes()
    bit = bytearray(whole)
    bit[len(whole) // 2] ^= 4
    file.write_bytes({"cut": whole[:-7], "bit": bytes(bit), "empty": b"", "foreign": b"\x7fELF" * 99}[damage])
    done = run(tmp_path)
    assert (done.returncode, done.stdout, done.stderr) == (0, first[1], COMPILING)
    assert run(tmp_path).stderr == ""


def test_without_a_compiler_one_line_says_what_to_install(tmp_path: Path) -> None:
    done = run(tmp_path, WITHOUT_NUMBA)
    assert done.returncode != 0
    assert 'pip install ".[jit]"' in done.stderr.splitlines()[-1]


def test_where_nothing_can_be_kept_the_answer_is_the_same(first: tuple[Path, str], tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    done = run(tmp_path / "file")
    assert (done.returncode, done.stdout) == (0, first[1])
    assert done.stderr.startswith(COMPILING)
    assert "give a writable folder in FEMBEARING_CACHE" in done.stderr


def test_two_processes_at_once_have_the_same_answer(first: tuple[Path, str], tmp_path: Path) -> None:
    from concurrent.futures import ThreadPoolExecutor

    with ThreadPoolExecutor(2) as pool:
        both = list(pool.map(run, [tmp_path, tmp_path]))
    assert [done.stdout for done in both] == [first[1]] * 2
    assert run(tmp_path).stderr == ""


def test_files_that_nobody_uses_are_deleted(first: tuple[Path, str], tmp_path: Path) -> None:
    old, recent = tmp_path / "old.code", tmp_path / "recent.code"
    for file in (old, recent):
        file.touch()
    os.utime(old, (0, 0))
    assert run(tmp_path).stdout == first[1]
    assert (old.exists(), recent.exists()) == (False, True)


@pytest.mark.slow  # compiles the kernel where its generic form is not kept
@pytest.mark.parametrize("rule", ["outer_control", "free"])
@pytest.mark.parametrize("load", [{"axial_load": 1100.0}, {"radial_load": 2300.0, "axial_load": 170.0}])
def test_code_of_every_processor_has_the_same_torques(rule: str, load: dict[str, Any]) -> None:
    races = races_of(replace(load_scene("6206", speed=310, **load), spin_rule=rule))
    torques = []
    for family in families():
        model = races.model.with_numbers()
        out = np.zeros(1, POINT)
        given = model.numbers, model.tables, np.ascontiguousarray(races.points), workspace(model)
        call: Any = solve.bound(*given, np.zeros((0, 0), BALL), out, model.is_free)
        loaded(solve, family)(*call.args)
        torques.append([out[name][0] for name in ("total", "spin", "rolling", "ball_rate")])
    assert len(torques) == len(families())
    np.testing.assert_allclose(torques, torques[:1] * len(torques), rtol=1e-12)
