"""Compiled functions against the same functions in Python, and what is kept of them between processes."""

import os
import shutil
import subprocess
import sys
import time
from inspect import unwrap
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from analytic.numerics.compilation import COMPILING, FOLDER, PREFIX, UNUSED, compiled
from analytic.scene import Array

ROOT = Path(__file__).parents[3]
POWERS = np.array([0.3, 1.7, 2.9])


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
    return np.array([base**power for power in POWERS])


@compiled(inline=True)
def both(base, law):
    total = powers_of(base).sum() * law.factor + law.table[1, 0]
    return total, total + law.shift[0] * law.shift[1]


@compiled
def fill(bases: Array, out: Array, count: int, law: Law) -> tuple[Sums, float]:
    total = 0.0
    for index in range(count):
        first, second = both(bases[index], law)
        out[index, 0], out[index, 1] = first, np.sinh(second) / bases[index]
        total += 2.0 * second if law.doubled else second
    return Sums((not law.doubled, count), total), np.arcsinh(total)


def arguments(*, doubled: bool = False) -> tuple[Array, Array, int, Law]:
    table = np.array([[0.1, 0.2], [0.4, 0.9]])
    return np.array([0.2, 1.9, 0.7, 1.3]), np.zeros((4, 2)), 3, Law(doubled, 0.7, (5, 0.3), table)


@pytest.mark.parametrize("doubled", [False, True])
def test_numba_does_what_python_does(doubled: bool) -> None:
    ours, theirs = arguments(doubled=doubled), arguments(doubled=doubled)
    found, expected = fill(*ours), unwrap(fill)(*theirs)
    assert isinstance(found[0], Sums)
    assert found[0].law == (not doubled, 3)
    assert found[0].total == pytest.approx(expected[0].total, rel=1e-14)  # some roundings of libm
    assert found[1] == pytest.approx(expected[1], rel=1e-14)
    np.testing.assert_allclose(ours[1], theirs[1], rtol=1e-14)
    assert ours[1][3].tolist() == [0.0, 0.0]  # beyond the count


def test_a_division_by_zero_gives_infinity() -> None:
    bases, out, count, law = arguments()
    bases[1] = 0.0
    fill(bases, out, count, law)
    assert out[1, 1] == np.inf


# Two files of formulas, which lie beside a copy of the compiler in a package of their own
INNER = """
from analytic.numerics.compilation import compiled

FACTOR = 3.0

@compiled
def scaled(x):
    return FACTOR * x
"""
OUTER = """
from analytic.inner import scaled

from analytic.numerics.compilation import compiled

@compiled
def shifted(x):
    return scaled(x) + 0.25
"""
PROGRAM = "from analytic import outer; print(outer.shifted(7.0))"


def program_in(parent: Path) -> Path:
    """The folder of the program; its files are files of the package, as those of formulas are."""
    folder = parent / "program"
    for name in ("__init__.py", "__init__.pyi", "numerics/__init__.py", "numerics/compilation.py"):
        (folder / "analytic" / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / "analytic" / name, folder / "analytic" / name)
    (folder / "analytic/inner.py").write_text(INNER)
    (folder / "analytic/outer.py").write_text(OUTER)
    return folder


@pytest.fixture
def program(tmp_path: Path) -> Path:
    return program_in(tmp_path)


def start(program: Path, cache: Path, code: str = PROGRAM) -> subprocess.Popen[str]:
    """Without byte code (-B), which Python takes for that of another file as long and written in the same second."""
    return subprocess.Popen(
        [sys.executable, "-B", "-c", code],
        env={**os.environ, "PYTHONPATH": str(program), FOLDER: str(cache)},
        cwd=program,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def result_of(process: subprocess.Popen[str]) -> tuple[float, str]:
    """The number that the program prints, and what it says on standard error."""
    out, said = process.communicate(timeout=300)
    assert process.returncode == 0, said
    return float(out), said


def run(program: Path, cache: Path, code: str = PROGRAM) -> tuple[float, str]:
    return result_of(start(program, cache, code))


SAID = f"fembearing: {COMPILING}\n"


def kept_files(cache: Path) -> list[Path]:
    return sorted(path for path in cache.rglob("*") if path.is_file())


@pytest.fixture(scope="module")
def filled(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Holds a program and the cache of its first run, in which lay folders of an old and a newer version."""
    folder = tmp_path_factory.mktemp("filled")
    program, cache = program_in(folder), folder / "cache"
    for name, age in (("old", 1.1 * UNUSED), ("new", 0.9 * UNUSED)):
        (cache / f"{PREFIX}{name}").mkdir(parents=True)
        then = time.time() - age
        os.utime(cache / f"{PREFIX}{name}", (then, then))
    assert run(program, cache) == (21.25, SAID)
    shutil.copytree(cache, folder / "kept")
    return folder


@pytest.fixture
def compiled_before(filled: Path, tmp_path: Path) -> tuple[Path, Path]:
    """A copy of the program, as another checkout of its version, and the cache as the first run left it, in its place.

    Numba takes nothing from a cache that was moved.
    """
    shutil.rmtree(filled / "cache")
    shutil.copytree(filled / "kept", filled / "cache")
    return shutil.copytree(filled / "program", tmp_path / "program"), filled / "cache"


def test_a_function_is_compiled_once_for_all_checkouts_of_its_version(compiled_before: tuple[Path, Path]) -> None:
    program, cache = compiled_before
    (program / "analytic/outer.py").touch()
    before = {path: path.stat().st_mtime_ns for path in kept_files(cache)}
    assert {path.suffix for path in before} == {".nbi", ".nbc", "", ".py"}
    assert run(program, cache) == (21.25, "")
    assert {path: path.stat().st_mtime_ns for path in kept_files(cache)} == before


def test_a_change_in_the_file_of_a_called_function_counts(compiled_before: tuple[Path, Path]) -> None:
    """Of a constant there, which is in the code of no function."""
    program, cache = compiled_before
    (program / "analytic/inner.py").write_text(INNER.replace("3.0", "5.0"))
    assert run(program, cache) == (35.25, SAID)


def test_so_does_one_in_a_file_of_another_package(program: Path, tmp_path: Path) -> None:
    """Of a function there that a formula calls by way of another file."""
    other = program / "other"
    other.mkdir()
    (other / "__init__.py").touch()
    (other / "inner.py").write_text(INNER)
    (other / "outer.py").write_text(OUTER.replace("analytic.inner", "other.inner"))
    code, cache = PROGRAM.replace("from analytic", "from other"), tmp_path / "cache"
    assert run(program, cache, code) == (21.25, SAID)
    assert run(program, cache, code) == (21.25, "")
    (other / "inner.py").write_text(INNER.replace("3.0", "5.0"))
    assert run(program, cache, code) == (35.25, SAID)


def damaged(content: bytes, how: str) -> bytes:
    half = len(content) // 2
    if how == "cut":
        return content[:half]
    return content[:half] + bytes([content[half] ^ 4]) + content[half + 1 :]  # one bit, often of the code itself


@pytest.mark.parametrize("how", ["cut", "bit"])
def test_damaged_files_are_compiled_again(compiled_before: tuple[Path, Path], how: str) -> None:
    program, cache = compiled_before
    for file in kept_files(cache):
        if how == "bit" and file.suffix != ".nbc":
            continue  # numba sees by itself what is wrong there
        file.write_bytes(damaged(file.read_bytes(), how))
    assert run(program, cache) == (21.25, SAID)
    assert run(program, cache) == (21.25, "")


def test_without_a_writable_folder_the_answer_is_the_same(program: Path, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    number, said = run(program, tmp_path / "file" / "cache")  # as a home that cannot be written, for the superuser too
    assert number == 21.25
    first, second = said.splitlines()
    assert "cannot be kept" in first
    assert f"give a writable folder in {FOLDER}" in first
    assert second == SAID.strip()


def test_a_function_without_a_folder_is_compiled_each_time(compiled_before: tuple[Path, Path]) -> None:
    """Numba would keep it beside its source, where a change of another file goes unnoticed."""
    program, cache = compiled_before
    (folder,) = {file.parents[1] for file in kept_files(cache) if "outer" in str(file)}
    shutil.rmtree(folder)
    folder.touch()
    number, said = run(program, cache)
    assert number == 21.25
    assert f"cannot be kept ({folder} is not writable)" in said
    assert SAID in said
    assert not [*(program / "analytic").rglob("*.nb?")]


def test_processes_may_compile_at_once(program: Path, tmp_path: Path) -> None:
    cache = tmp_path / "cache"
    together = [start(program, cache) for _ in range(2)]
    for number, said in map(result_of, together):
        assert number == 21.25
        assert said in (SAID, "")  # one of them may find what the other has kept
    assert run(program, cache) == (21.25, "")


def test_folders_of_other_versions_are_deleted_when_nobody_uses_them(filled: Path) -> None:
    assert not (filled / f"kept/{PREFIX}old").exists()
    assert (filled / f"kept/{PREFIX}new").exists()


THREADS = """
from concurrent.futures import ThreadPoolExecutor
from threading import Barrier
from analytic.inner import scaled
from analytic.outer import shifted

start = Barrier(8)

def called(number):
    start.wait()
    return shifted(7.0) if number % 2 else scaled(7.0)

with ThreadPoolExecutor(8) as threads:
    print(*sorted(set(threads.map(called, range(8)))))
"""


def test_threads_may_make_the_first_call_together(program: Path, tmp_path: Path) -> None:
    for _ in ("empty", "filled"):
        process = start(program, tmp_path / "cache", THREADS)
        out, said = process.communicate(timeout=300)
        assert (process.returncode, out) == (0, "21.0 21.25\n"), said


CRAMPED = """
import resource
from pathlib import Path
from analytic import outer
taken = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (taken + 240_000_000, resource.RLIM_INFINITY))
try:
    outer.shifted(7.0)
except MemoryError as problem:
    print(problem)
resource.setrlimit(resource.RLIMIT_AS, (taken + 3_000_000_000, resource.RLIM_INFINITY))
print(outer.shifted(7.0))
"""


@pytest.mark.skipif(sys.platform != "linux", reason="needs /proc and a limit of addresses")
def test_too_few_addresses_are_told_before_a_library_waits_for_them(
    program: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """240 MB are enough for numba, and then not for the OpenBLAS of SciPy, which asks for ever."""
    monkeypatch.setenv("OPENBLAS_NUM_THREADS", "2")
    out, said = start(program, tmp_path / "cache", CRAMPED).communicate(timeout=300)
    assert out.splitlines() == ["340 MB of addresses are needed to load the formulas", "21.25"], said


@pytest.mark.skipif(sys.platform != "linux", reason="the limit of addresses (RLIMIT_AS) is that of Linux")
@pytest.mark.parametrize(
    ("before", "said"), [("", "of addresses are needed"), ("import numba, scipy.linalg", "enough")]
)
def test_too_few_addresses_are_said_before_numba_asks_for_them(before: str, said: str) -> None:
    """350 MB hold Python and numpy, not numba with OpenBLAS."""
    script = f"""
import resource
{before}
from analytic.numerics.compilation import require_addresses
resource.setrlimit(resource.RLIMIT_AS, (350_000_000, 350_000_000))
try:
    require_addresses()
    print("enough")
except MemoryError as problem:
    print(problem)
"""
    ended = subprocess.run([sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True, check=True)
    assert said in ended.stdout
