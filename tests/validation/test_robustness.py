"""The attacks of validation/robustness: they detect every forbidden outcome, and what they draw is what they say."""

import ast
import math
import os
import subprocess
import sys
import warnings
from argparse import Namespace
from collections import Counter
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from analytic.errors import ConvergenceError, InputError
from analytic.scenefile.read import parse_scene

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "validation" / "robustness"
pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="calls are limited by signals and processes")


@pytest.fixture(scope="module")
def watched(part: Any) -> ModuleType:
    return part("watched")


def hang() -> None:
    while True:
        pass


def overflow() -> None:
    warnings.warn("overflow", RuntimeWarning, stacklevel=1)


def ramble() -> None:
    raise InputError("one line\nand another")


@pytest.mark.parametrize(
    ("run", "words"),
    [
        (lambda: subprocess.run(["true"], check=True), "ForbiddenError: subprocess.Popen"),
        (lambda: os.system("true"), "ForbiddenError: os.system"),
        (lambda: Path("new").write_text("a"), "ForbiddenError: open"),
        (lambda: 1 / 0, "ZeroDivisionError"),
        (hang, "TooSlowError"),
        (overflow, "RuntimeWarning: overflow"),
        (ramble, "an unclear error"),
    ],
)
def test_every_forbidden_outcome_is_detected(
    watched: ModuleType, monkeypatch: pytest.MonkeyPatch, run: Any, words: str
) -> None:
    monkeypatch.setattr(watched, "SLOWEST", 0.2)
    assert words in watched.outcome_of(run)
    assert watched.outcome_of(lambda: None) == "done"  # the limits end with the call


def test_time_that_compiles_is_not_the_time_of_a_call(watched: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(watched, "SLOWEST", 0.2)
    monkeypatch.setattr(watched, "FIRST_USES", ("compiler",))
    spin = "import time\ndef spin(end=0.5):\n    start = time.process_time()\n"
    spin += "    while time.process_time() < start + end: pass\n"
    compiler: dict[str, Any] = {}
    exec(compile(spin, "compiler", "exec"), compiler)
    call: dict[str, Any] = {}
    exec(compile(spin, "call", "exec"), call)
    assert watched.outcome_of(compiler["spin"]) == "done"
    assert "more than 0.2 s" in watched.outcome_of(lambda: (compiler["spin"](), call["spin"]()))


def refuse() -> None:
    raise InputError("too much")


def fail() -> None:
    raise ConvergenceError(iterations=7, residual=3.0, tolerance=0.2)


def test_a_process_that_dies_costs_one_input(watched: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(watched, "LARGEST", 1e8)
    runs = [refuse, lambda: os._exit(7), fail, lambda: float(np.ones(40_000_000).sum()), lambda: None]
    found = {
        each.seed: each.outcome
        for each in watched.tried(lambda seed: watched.Input("kind", b"content", runs[seed]), range(len(runs)), jobs=2)
    }
    assert found.pop(3).endswith(" MB")  # 320 of them
    assert found == {0: "refused", 1: "the process ended with status 7", 2: "not solved", 4: "done"}


def test_extreme_scenes_are_mostly_read_and_each_seed_has_its_own(part: Any) -> None:
    extreme = part("extreme")
    texts = [extreme.extreme_scene(np.random.default_rng(seed)) for seed in range(40)]
    assert len({*texts}) == 40
    assert texts == [extreme.extreme_scene(np.random.default_rng(seed)) for seed in range(40)]
    read = 0
    for text in texts:
        try:
            parse_scene(text, origin="drawn")
        except InputError:
            continue
        read += 1
    assert read > 15  # else most of the attack tests nothing but the reader


def test_numbers_that_are_not_finite_are_seen_wherever_they_stand(part: Any) -> None:
    extreme = part("extreme")
    extreme.require_finite_numbers({"a": [1.5, {"b": 2.5}], "c": None, "d": "nan"})
    with pytest.raises(extreme.SilentError, match=r"\.a\[1\]\.b = nan"):
        extreme.require_finite_numbers({"a": [1.5, {"b": math.nan}]})


def test_damaged_texts_are_partly_still_good(part: Any) -> None:
    damage = part("damage")
    good = 0
    for seed in range(60):
        try:
            parse_scene(damage.changed_scene(np.random.default_rng(seed))[1].decode(), origin="changed")
        except (InputError, UnicodeDecodeError):
            continue
        good += 1
    assert 3 < good < 40  # both paths are tried


@pytest.mark.parametrize(
    ("status", "out", "err", "words"),
    [
        (0, "torque 3 N mm", "", ""),
        (2, "", "fembearing: too much\n", ""),
        (2, "", "fembearing: warning: dry\nfembearing: too much\n", ""),
        (1, "", "Traceback (most recent call last):\nKeyError: 'a'", "traceback: KeyError"),
        (70, "", "fembearing: a defect", "status 70"),
        (1, "", "", "status 1 without a result"),
        (1, "torque 3 N mm, fail", "", ""),
        (-9, "", "", "status -9"),
        (2, "", "fembearing: one\nfembearing: another\n", "2 lines for one failure"),
        (3, "", "", "0 lines for one failure"),
        (2, "torque", "fembearing: too much\n", "a result beside a refusal"),
    ],
)
def test_how_a_command_ends_is_judged(part: Any, status: int, out: str, err: str, words: str) -> None:
    commands = part("commands")
    fault = commands.fault_of(commands.Run(status, out, err, 0.7, 3e8), base=2e8)
    assert fault.startswith(words) if words else fault == ""


def test_a_slow_or_large_command_is_a_fault(part: Any) -> None:
    commands = part("commands")
    assert commands.fault_of(commands.Run(0, "", "", 11.0, 3e8)) == "11 s"
    compiling = "fembearing: compiling formulas, once for this machine; this may take a minute\n"
    assert commands.fault_of(commands.Run(0, "", compiling, 50.0, 3e8)) == ""
    assert commands.fault_of(commands.Run(0, "", compiling, 130.0, 3e8)) == "130 s"
    assert commands.fault_of(commands.Run(0, "", "", 2.0, 1.5e9), base=2e8) == "1300 MB"


@pytest.mark.parametrize(
    ("face", "out", "words"),
    [
        ("text", "torque 3.1 N mm of nano-grease", ""),
        ("text", "torque nan N mm", "the text shows nan"),
        ("text", "uncertainty -inf", "the text shows -inf"),
        ("json", '{"a": [1.5]}', ""),
        ("json", '{"a": [1e999]}', ".a[0] = inf"),
        ("json", '{"a": [NaN]}', "json: NaN is no number of JSON"),
    ],
)
def test_what_is_not_finite_is_seen_in_every_face(part: Any, tmp_path: Path, face: str, out: str, words: str) -> None:
    commands = part("commands")
    assert commands.face_fault(face, commands.Run(0, out, "", 0.7, 3e8), tmp_path / "out") == words


def test_half_an_output_is_seen(part: Any, tmp_path: Path) -> None:
    commands = part("commands")
    target = tmp_path / "torque"
    target.mkdir()
    assert "is left of a failure" in commands.face_fault("folder", commands.Run(2, "", "", 0.7, 3e8), target)
    (target / "torque.json").write_text("{}")
    (target / "torque.csv").write_text("a,b\n1.5,nan\n")
    assert commands.face_fault("folder", commands.Run(0, "", "", 0.7, 3e8), target) == "the folder lacks torque.png"
    (target / "torque.png").touch()
    assert commands.face_fault("folder", commands.Run(0, "", "", 0.7, 3e8), target) == "a cell of torque.csv is nan"


def test_each_mutant_is_one_other_expression(part: Any) -> None:
    mutants = part("mutants")
    drawn = mutants.drawn(ROOT, 60, 3)
    packages = [each.module.partition("/")[0] for each in drawn]
    assert packages.count("analytic") == packages.count("fembearing") == 30
    for each in drawn:
        original = (ROOT / each.module).read_bytes()
        assert ast.dump(ast.parse(each.source(original))) != ast.dump(ast.parse(original)), each
        assert ast.unparse(ast.parse(f"({original[each.start : each.end].decode()})", mode="eval")) == each.before


@pytest.mark.parametrize(
    ("line", "changed"),
    [
        ("a + 2.5 * b", {"a - 2.5 * b", "a + 2.5 / b", "a + 2.75 * b"}),
        ("a ** 3", {"a ** (3 + 1)"}),
        ("a < b", {"a >= b"}),
        ("len(a) <= b", {"len(a) > b", "len(a) < b"}),
        ("not a and b", {"not a or b", "a and b"}),
        ("np.max(-a)", {"np.min(-a)", "np.max(a)"}),
        ("a is None", {"a is not None"}),
        ("'a' + b", set()),
        ("f'{a + b}'", set()),
    ],
)
def test_operators_are_changed_one_at_a_time(part: Any, tmp_path: Path, line: str, changed: set[str]) -> None:
    mutants = part("mutants")
    source = f"y = {line}\nassert y < 3\n"
    (tmp_path / "module.py").write_text(source)
    whole = {each.source(source.encode()).decode().splitlines()[0] for each in mutants.mutants(tmp_path, "module.py")}
    assert {ast.unparse(ast.parse(each)) for each in whole} == {
        ast.unparse(ast.parse(f"y = {each}")) for each in changed
    }


def test_every_module_has_tests_in_its_folder_its_own_first(part: Any) -> None:
    mutation = part("mutation")
    assert mutation.tests_of(ROOT, "analytic/oil/film.py")[0] == "tests/analytic/oil/test_film.py"
    assert mutation.tests_of(ROOT, "fembearing/sweep/store.py")[0].startswith("tests/sweep/")
    for path in (*ROOT.glob("analytic/**/*.py"), *ROOT.glob("fembearing/**/*.py")):
        assert mutation.tests_of(ROOT, path.relative_to(ROOT).as_posix()), path


def test_a_mutant_is_tested_in_a_copy_that_is_restored(
    part: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """A tree of one formula, with a test that sees its sign and not its coefficient."""
    mutants, mutation = part("mutants"), part("mutation")
    for folder in ("analytic", "tests/analytic", "fembearing"):
        (tmp_path / "small" / folder).mkdir(parents=True)
    (tmp_path / "small" / "analytic" / "__init__.py").touch()
    module = tmp_path / "small" / "analytic" / "law.py"
    module.write_text("def law(x):\n    return 5.0 - 2.5 * x\n")
    test = "import sys\nfrom pathlib import Path\nsys.path.insert(0, str(Path(__file__).parents[2]))\n"
    test += "from analytic.law import law\ndef test_law():\n    assert law(0) > law(3)\n"
    (tmp_path / "small" / "tests" / "analytic" / "test_law.py").write_text(test)
    monkeypatch.setattr(mutation, "ROOT", tmp_path / "small")
    tree = mutation.Tree(tmp_path / "copy", ())
    found = {each.after: tree.test(each).outcome for each in mutants.mutants(tmp_path / "small", "analytic/law.py")}
    assert found == {
        "5.0 + 2.5 * x": "killed",
        "2.5 / x": "killed",
        "5.5 - 2.5 * x": "survived",
        "2.75 * x": "survived",
    }
    assert (tmp_path / "copy" / "analytic" / "law.py").read_text() == module.read_text()


@pytest.fixture
def tree(part: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Any:
    """A copy of a tree whose tests pass, fail, end Python or hang."""
    mutation, folder = part("mutation"), tmp_path / "small" / "tests"
    for package in ("analytic", "fembearing", "tests"):
        (tmp_path / "small" / package).mkdir(parents=True)
    for name, line in {
        "passes": "pass",
        "fails": "assert False",
        "ends": "os._exit(7)",
        "hangs": "time.sleep(60)",
    }.items():
        (folder / f"test_{name}.py").write_text(f"import os, time\ndef test_it():\n    {line}\n")
    monkeypatch.setattr(mutation, "ROOT", tmp_path / "small")
    return mutation.Tree(tmp_path / "copy", ())


@pytest.mark.parametrize(
    ("name", "outcome", "words"),
    [
        ("passes", "survived", ""),
        ("fails", "killed", "FAILED tests/test_fails.py::test_it"),
        ("ends", "error", "status 7: "),
        ("hangs", "timeout", ""),
        ("is_not_there", "error", "status 4: "),
    ],
)
def test_only_a_test_that_fails_or_hangs_kills(
    part: Any, tree: Any, monkeypatch: pytest.MonkeyPatch, name: str, outcome: str, words: str
) -> None:
    if name == "hangs":
        monkeypatch.setattr(part("mutation"), "DEAF", 2)
    found, _, said = tree.run([f"tests/test_{name}.py"])
    assert found == outcome
    assert said.startswith(words)


@pytest.mark.parametrize(
    ("name", "fault"),
    [("passes", None), ("fails", "FAILED tests/test_fails.py::test_it"), ("hangs", "tests/test_hangs.py")],
)
def test_tests_that_killed_must_pass_without_a_mutant(
    part: Any, tree: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, name: str, fault: str | None
) -> None:
    """Within their time; those of another commit do not count."""
    mutation, record = part("mutation"), tmp_path / "mutation.csv"
    for each, commit in ((name, "this"), ("ends", "another")):
        row = dict.fromkeys(mutation.COLUMNS, "") | {"outcome": "killed", "commit": commit}
        mutation.add(record, row | {"test": f"FAILED tests/test_{each}.py::test_it"})
    monkeypatch.setattr(mutation, "commit", lambda: "this")
    if name == "hangs":
        monkeypatch.setattr(mutation, "DEAF", 2)
    found = list(mutation.failing_without(record, ()))
    assert len(found) == (fault is not None)
    assert fault is None or found[0].startswith(fault)
    assert tree.root.is_dir()


def test_a_draw_that_is_nearly_all_refused_is_a_fault(part: Any) -> None:
    run, watched = part("run"), part("watched")

    def row(refused: int, done: int, minutes: float = math.inf) -> Any:
        outcomes = refused * ["refused"] + done * ["done"]
        results = (watched.Tried("kind", seed, outcome, 0.7, 3e8) for seed, outcome in enumerate(outcomes))
        return run.gathered("part", results, run.Place(Path(), Namespace(minutes=minutes), run.SHORT))

    assert row(7, 3, minutes=0.0).outcomes.total() == 1
    assert row(70, 30).faults == []
    assert row(90, 10).faults == ["90 % are refused: the draw tests little else"]
    assert row(3, 0).faults == []  # too few to tell


def test_the_record_keeps_the_rows_of_other_parts(part: Any, tmp_path: Path) -> None:
    run, file = part("run"), tmp_path / "robustness.md"
    for name, done, faults in (("kills, sweep", 3, ["left over: a"]), ("growth", 7, []), ("kills, sweep", 5, [])):
        run.add_to_record(file, run.Row(name, Counter(done=done), faults))
        assert ("- kills, sweep: left over: a" in file.read_text()) == (name != "kills, sweep" or done == 3)
    rows = [line.split(" | ") for line in file.read_text().splitlines() if line.startswith("| ")]
    assert [(row[0], row[2]) for row in rows[2:]] == [("| growth", "7"), ("| kills, sweep", "5")]
    assert file.read_text().endswith("\n\nNo faults.\n")


def test_no_two_loads_of_the_growth_are_alike(part: Any) -> None:
    growth = part("growth")
    assert growth.oiled().lubricant is not None
    assert growth.oiled().surface is not None
    drawn = growth.loads(50.0, 2000.0, 300)
    assert np.unique(drawn).size == 300
    assert (drawn.min(), drawn.max()) == pytest.approx((50.0, 2000.0))


def test_growth_counts_all_calls_and_the_memory_after_the_first_ones(
    part: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    growth, kept, sent = part("growth"), [0.0], []
    monkeypatch.setattr(
        growth, "_torque", lambda _: lambda number: kept.append(kept[-1] + (9.0 if number < 3 else 2.0))
    )
    monkeypatch.setattr(growth, "resident", lambda: kept[-1])
    growth._measure("friction_torque", 30, math.inf, Namespace(send=sent.append))
    assert sent == [(30, 27 * 2.0)]


def test_the_short_form_names_its_parts() -> None:
    command = [sys.executable, FOLDER / "run.py", "--help"]
    words = subprocess.run(command, check=True, capture_output=True, text=True, timeout=120).stdout
    for name in ("scenes", "damaged", "kills", "limits", "growth", "mutation", "--seed", "--short"):
        assert name in words
