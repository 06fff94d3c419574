"""Grid files, and sweeps without processes of their own."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.sweep.swept import SCENE


@pytest.fixture
def grid_file(tmp_path: Path) -> Callable[..., Path]:
    """Writes a grid of `SCENE` with these lines below [axes], and others above."""

    def write(axes: str, *, head: str = "", scene: str = SCENE, name: str = "grid.toml") -> Path:
        path = tmp_path / name
        path.write_text(f"{head}\n{scene}\n[axes]\n{axes}\n", "utf-8")
        return path

    return write


@pytest.fixture
def short_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    """One scene in each piece, so that a small sweep has several pieces."""
    monkeypatch.setattr("fembearing.sweep.parts.MOST_SCENES", 1)


def one_by_one(function: Any, tasks: list[Any], **_: Any) -> Iterator[tuple[Any, Any]]:
    """As `each_done`, in this process."""
    for task in tasks:
        yield task, function(task)


@pytest.fixture
def in_process(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """Every piece is computed in this process; the list of computed pieces, in order."""
    computed: list[Any] = []

    def recorded(function: Any, tasks: list[Any], *, workers: None, scheduler: None, **_: Any) -> Any:
        assert workers is scheduler is None
        for task, result in one_by_one(function, tasks):
            computed.append(task)
            yield task, result

    monkeypatch.setattr("fembearing.sweep.run.each_done", recorded)
    return computed
