"""The comparison of speed with the recorded commit: ratios, second attempts, and commits that a clone lacks."""

import subprocess
from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import replace
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic import friction_torque, load_scene
from analytic.scene import Operation


@pytest.fixture(scope="module")
def run(script: Callable[[str], ModuleType]) -> ModuleType:
    return script("run")


@pytest.fixture(scope="module")
def trees(script: Callable[[str], ModuleType]) -> ModuleType:
    return script("trees")


def row_of(run: ModuleType, **given: Any) -> Any:
    """A row whose trees are lists of seconds."""

    def measure(tree: SimpleNamespace) -> Any:
        tree.calls += 1
        return run.Sample(wall=9.0, cpu=next(tree.seconds))

    return run.Row(name="example", title="an example", measure=measure, **given)


def tree_of(*seconds: float) -> SimpleNamespace:
    """A tree whose measurements take these seconds, and then the last ones; the first measurement only warms it."""

    def all_of() -> Iterator[float]:
        yield 99.0
        yield from seconds
        while True:
            yield seconds[-1]

    return SimpleNamespace(seconds=all_of(), calls=0)


def test_the_ratio_is_that_of_the_best_turns(run: ModuleType) -> None:
    compared = run.measured(row_of(run), [tree_of(0.9, 0.6, 0.7), tree_of(0.8, 0.5, 0.9)], repeats=3, patience=9.0)
    assert compared.ratio == pytest.approx(0.6 / 0.5)
    assert not compared.slower


def test_a_row_that_takes_long_has_fewer_turns(run: ModuleType) -> None:
    tree = tree_of(0.5)
    compared = run.measured(row_of(run), [tree], repeats=3, patience=0.0)
    assert tree.calls == 2  # to warm it, and one turn
    assert compared.now.figure(compared.row) == 0.5


def test_more_is_better_where_the_figure_is_a_speed_up(run: ModuleType) -> None:
    row = row_of(run, unit="times", once=True)
    slow, fast = tree_of(), tree_of()
    slow.seconds, fast.seconds = iter([1.1] * 9), iter([1.9] * 9)
    compared = run.measured(row, [slow, fast], repeats=3, patience=9.0)
    assert compared.ratio == pytest.approx(1.9 / 1.1)
    assert compared.slower


def test_a_disturbed_row_is_measured_again_and_a_slow_one_fails(run: ModuleType, capsys: Any) -> None:
    disturbed, before = tree_of(2.1, 2.3, 1.2), tree_of(1.0)
    assert not run.measured(row_of(run), [disturbed, before], repeats=2, patience=9.0).slower
    assert disturbed.calls == 1 + 2 * 2  # warm, and two attempts of two turns
    slow = tree_of(1.7)
    failing = run.measured(row_of(run), [slow, tree_of(1.0)], repeats=2, patience=9.0)
    assert slow.calls == 1 + 3 * 2
    assert run.verdict([failing]) == 1
    assert "FAILED example: 1.70 times as bad" in capsys.readouterr().out


def test_only_this_tree_must_be_able_to_do_a_job(run: ModuleType, capsys: Any) -> None:
    def failing(_: object) -> None:
        raise run.FailedError("no such method")

    row = replace(row_of(run), measure=lambda tree: run.Sample(wall=1.0, cpu=0.3) if tree else failing(tree))
    older = run.measured(row, [tree_of(0.3), None], repeats=2, patience=9.0)
    assert older.ratio is None
    assert "then: that tree cannot" in run.cells(older)[-1]
    assert run.verdict([older]) == 0
    assert run.verdict([run.measured(row, [None, tree_of(0.3)], repeats=2, patience=9.0)]) == 1
    assert "FAILED example: no such method" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("seconds", "words"),
    [(2.5, "2.5 s"), (0.13, "0.13 s"), (0.031, "31 ms"), (0.25e-3, "0.25 ms"), (0.27e-6, "0.27 us"), (None, "-")],
)
def test_figures_have_units(run: ModuleType, seconds: float | None, words: str) -> None:
    assert run.shown(seconds, row_of(run)) == words


def git(folder: Path, *arguments: str) -> str:
    who = ("-c", "user.name=A", "-c", "user.email=a@example.org")
    return subprocess.run(["git", "-C", folder, *who, *arguments], check=True, capture_output=True, text=True).stdout


@pytest.fixture
def history(tmp_path: Path) -> tuple[Path, str]:
    """A repository of two commits, and the first one."""
    folder = tmp_path / "origin"
    (folder / "analytic").mkdir(parents=True)
    git(folder, "init", "--quiet")
    commits = []
    for text in ("old", "new"):
        (folder / "analytic" / "file.py").write_text(text, "utf-8")
        git(folder, "add", ".")
        git(folder, "commit", "--quiet", "--message", text)
        commits.append(git(folder, "rev-parse", "HEAD").strip())
    return folder, commits[0]


def test_a_commit_is_checked_out_for_a_while(trees: ModuleType, history: tuple[Path, str]) -> None:
    root, commit = history
    with trees.checked_out(commit, root=root) as folder:
        assert (folder / "analytic" / "file.py").read_text("utf-8") == "old"
        assert (root / "analytic" / "file.py").read_text("utf-8") == "new"
    assert not folder.exists()
    assert len(git(root, "worktree", "list").splitlines()) == 1


def test_a_shallow_clone_says_that_it_lacks_the_commit(
    trees: ModuleType, history: tuple[Path, str], tmp_path: Path
) -> None:
    root, commit = history
    git(tmp_path, "clone", "--quiet", "--depth", "1", f"file://{root}", "shallow")
    with (
        pytest.raises(trees.CommitMissingError, match=f"{commit[:9]} is not in this clone.*--unshallow"),
        trees.checked_out(commit, root=tmp_path / "shallow"),
    ):
        pass


def test_a_changed_tree_has_no_commit_to_record(trees: ModuleType, history: tuple[Path, str]) -> None:
    root, first = history
    (root / "notes").write_text("of no package", "utf-8")
    git(root, "add", ".")
    git(root, "commit", "--quiet", "--message", "notes")
    last = trees.last_change(root=root)
    assert last == git(root, "rev-parse", "HEAD~1").strip() != first
    (root / "analytic" / "file.py").write_text("newer", "utf-8")
    assert trees.last_change(root=root) is None


@pytest.mark.slow
def test_a_job_runs_in_the_process_of_its_tree(trees: ModuleType) -> None:
    with closing(trees.Tree(trees.ROOT)) as tree:
        sample = tree.job("calibrated_point")
    scene = load_scene(trees.ROOT / "validation" / "scenes" / "6205_paper_calibrated.toml")
    point = Operation(axial_load=np.array([1000.0]), inner_speed=np.array([52.0]))  # as the job has it
    torque = friction_torque(replace(scene, operation=point, spin_rule="balanced")).torque.total[0]
    assert sample.result == pytest.approx(torque, rel=1e-12)
    assert 0 < sample.cpu < 1
    with (
        closing(trees.Tree(Path("/elsewhere"))) as other,
        pytest.raises(trees.FailedError, match="not from /elsewhere"),
    ):
        other.job("calibrated_point")
