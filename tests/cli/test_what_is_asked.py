"""What a command asks of the library, by its options; nothing is solved."""

import os
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.errors import InputError
from fembearing.cli.status import INPUT_AT_FAULT
from fembearing.cli.sweep import _maps

RPM = np.pi / 30


@pytest.fixture
def asked(command, monkeypatch: pytest.MonkeyPatch):
    """Runs a command, and gives what it asks of a function, which then refuses."""

    def run(target: str, *arguments: str) -> dict[str, Any]:
        found: dict[str, Any] = {}

        def note(_: object, **how: Any) -> None:
            found.update(how)
            raise InputError("enough")

        monkeypatch.setattr(target, note)
        assert command(*arguments).status == INPUT_AT_FAULT
        return found

    return run


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        ((), {"cost": False, "samples": None, "film": True, "creep": True}),
        (("--no-film",), {"film": False, "creep": True}),
        (("--no-creep",), {"film": True, "creep": False}),
        (("--interval", "--cost"), {"samples": "enough", "cost": True}),
        (("--tolerance", "7 %"), {"tolerance": pytest.approx(0.07, rel=1e-12)}),
    ],
)
def test_a_check_has_what_its_options_say(asked, options: tuple[str, ...], expected: dict[str, Any]) -> None:
    found = asked("fembearing.report.folder.validate", "validate", "6205-dry", *options)
    assert {name: found[name] for name in expected} == expected


@pytest.mark.parametrize(
    ("command_", "target"),
    [
        ("film", "fembearing.check.film.scene_film.film_of"),
        ("creep", "fembearing.check.creep.scene_creep.creep_of"),
    ],
)
def test_load_and_tolerance_are_the_scenes_unless_they_are_given(asked, command_: str, target: str) -> None:
    usual = asked(target, command_, "6205-dry")
    assert (usual["load"], usual["compliance"]) == (None, "half-space")
    given = asked(target, command_, "6205-dry", "--load", "0.31 kN", "--tolerance", "3 %")
    assert (given["load"], given["tolerance"]) == (pytest.approx(310.0), pytest.approx(0.03))
    if command_ == "creep":
        assert usual["friction"] is None
        assert asked(target, command_, "6205-dry", "--friction", "0.07")["friction"] == 0.07


def test_one_load_is_a_contact_and_several_are_a_series(asked) -> None:
    single, series = "solution.solve_contact", "load_series.solve_load_series"
    place = "fembearing.check.contact"
    assert asked(f"{place}.{single}", "contact", "6205-dry")["load"] is None
    assert asked(f"{place}.{single}", "contact", "6205-dry", "--load", "70 N")["load"] == 70.0
    found = asked(f"{place}.{series}", "contact", "6205-dry", "--load", "70 N", "--load", "90 N", "--pair", "outer")
    assert (found["loads"], found["pair"]) == ([70.0, 90.0], "outer")


def test_maps_are_drawn_again_where_the_dataset_is_newer(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from fembearing.report.figures import sweep_maps

    drawn: list[Path] = []

    def draw(_: object, folder: Path) -> None:
        drawn.append(folder)
        (folder / f"{len(drawn)}.png").write_text("a map")

    monkeypatch.setattr(sweep_maps, "write_maps", draw)
    dataset = tmp_path / "sweep.nc"
    dataset.write_text("numbers")
    result: Any = SimpleNamespace(folder=str(tmp_path), file=str(dataset), to_dataset=lambda *_: None)
    assert [file.name for file in _maps(result)] == ["1.png"]
    (folder,) = (each for each in tmp_path.iterdir() if each.is_dir())
    os.utime(dataset, ns=(0, folder.stat().st_mtime_ns - 10**9))
    assert [file.name for file in _maps(result)] == ["1.png"]
    os.utime(dataset, ns=(0, folder.stat().st_mtime_ns + 10**9))
    assert [file.name for file in _maps(result)] == ["2.png"]
    assert len(drawn) == 2
