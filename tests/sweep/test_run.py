"""Sweeps from beginning to end: numbers, units, failures, and continuing after a stop."""

import os
import re
import shutil
import sys
from collections.abc import Callable
from dataclasses import replace
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray

from analytic.errors import InputError, StorageError
from analytic.prediction.prediction import predict
from analytic.scenefile.law_packages import installed_law
from analytic.torque import friction_torque
from fembearing.sweep import parts
from fembearing.sweep.grid import Grid, load_grid
from fembearing.sweep.run import run_sweep
from fembearing.sweep.store import opened_store
from tests.analytic.scenefile.scene_texts import OILED, SPEEDS, changed
from tests.refusals import refused
from tests.sweep.swept import SCENE
from tests.traction_packages import install

AXES = """
friction.coefficient = [0.05, 0.11]
"operation.inner_speed" = ["100 rpm", "450 rpm"]
bearing.conformity = [0.515, 0.52, 0.53]
"operation.axial_load" = { from = "100 N", to = "900 N", count = 4, spacing = "log" }
"""  # an axis of the series comes before one outside it: the order in the file is not that of the computation
Write = Callable[..., Path]


@pytest.mark.usefixtures("in_process", "short_pieces")
@pytest.mark.parametrize("rule", ["balanced", "free"])
def test_every_point_is_the_torque_of_its_own_scene(grid_file: Write, tmp_path: Path, rule: str) -> None:
    path = grid_file(AXES, scene=SCENE.replace('spin_rule = "balanced"', f'spin_rule = "{rule}"'))
    found = run_sweep(path, out=tmp_path / "out").to_dataset()
    assert found["torque_total"].dims == ("coefficient", "inner_speed", "conformity", "axial_load")
    base = load_grid(path).scene(0)
    diameter = base.bearing.ball_diameter
    assert found["torque_total"].size == 48
    for point in np.ndindex(found["torque_total"].shape):
        here = found[dict(zip(found["torque_total"].dims, point, strict=True))]
        inner, outer = (
            replace(ring, groove_radius=float(here["conformity"]) * diameter)
            for ring in (base.bearing.inner, base.bearing.outer)
        )
        operation = replace(
            base.operation,
            axial_load=np.array([float(here["axial_load"])]),
            inner_speed=np.array([float(here["inner_speed"])]),
        )
        scene = replace(
            base,
            bearing=replace(base.bearing, inner=inner, outer=outer),
            friction_coefficient=float(here["coefficient"]),
            operation=operation,
        )
        alone = friction_torque(scene)
        # 1e-9: the angle is iterated; all effects of the scene are on or off by its own word, whatever the series.
        # Free balls have as many nodes as the worst point of the series needs: torques differ by the uncertainty.
        # Balls by rule take the method of sliding that the series needs.
        free, torque = rule == "free", alone.numerical_uncertainty[0]
        np.testing.assert_allclose(float(here["torque_total"]), alone.torque.total[0], rtol=torque)
        equal = 1e-3 if free else 1e-9  # friction across the grooves is a tenth of the load, and its error a hundredth
        np.testing.assert_allclose(float(here["contact_angle"]), alone.contact_angle[0], rtol=equal)
        np.testing.assert_allclose(float(here["load_outer"]), alone.outer.load[0], rtol=equal)


@pytest.mark.usefixtures("short_pieces")
def test_an_interrupted_sweep_continues(grid_file: Write, tmp_path: Path, in_process: list[Any]) -> None:
    path, out = grid_file(AXES), tmp_path / "out"
    whole = run_sweep(path, out=tmp_path / "whole").to_dataset()
    in_process.clear()

    def stop_half_way(share: float, _step: str) -> None:
        if share >= 0.5:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_sweep(path, out=out, progress=stop_half_way)
    before, files = list(in_process), {file: file.stat() for file in (out / "parts").iterdir()}
    assert len(before) == len(files) == 3  # of 6
    told: list[tuple[float, str]] = []
    found = run_sweep(path, out=out, progress=lambda *step: told.append(step))
    assert (found.points, found.computed, found.kept) == (48, 24, 24)
    assert not set(before) & set(in_process[3:])  # nothing twice
    assert len(in_process) == 6
    assert told[0] == (0.5, "24 of 48 points")
    for file, stat in files.items():
        assert (file.stat().st_ino, file.stat().st_mtime_ns) == (stat.st_ino, stat.st_mtime_ns)
    assert found.to_dataset().drop_attrs().identical(whole.drop_attrs())
    again = run_sweep(path, out=out)
    assert (again.computed, again.kept, again.failed, len(in_process)) == (0, 48, 0, 6)
    assert list(again.to_dataset("torque_total", "nothing").data_vars) == ["torque_total"]


DAMAGE: dict[str, Callable[[bytes], bytes]] = {
    "cut, as by a power failure": lambda content: content[:-1],
    "longer by a number": lambda content: content + bytes(8),
    "numbers alone": lambda content: content.partition(b"\n")[2],
    "an unknown column": lambda content: content.replace(b'"failure"', b'"failures"'),
    "a column of words more": lambda content: content.replace(b'"failure"', b'"verdict": ["pass"], "failure"'),
    "fewer words": lambda content: content.replace(b'["", ', b"[", 1),
    "a number for a word": lambda content: content.replace(b'[""', b"[7", 1),
    "a text for words": lambda content: re.sub(rb"\[[^]]*\]", b'"text"', content, count=1),
    "what a terminal would obey": lambda content: content.replace(b'[""', b'["\\u001b[2J"', 1),
    "endless brackets": lambda _: b"[" * 100_000,
    "endless digits": lambda content: content.replace(b'[""', b"[" + b"7" * 9000, 1),
}


@pytest.mark.usefixtures("short_pieces")
def test_damaged_files_of_a_folder_are_computed_again(grid_file: Write, tmp_path: Path, in_process: list[Any]) -> None:
    axes = f"friction.coefficient = {[0.01 * number for number in range(3, len(DAMAGE) + 6)]}\n"
    path, out = grid_file(axes + 'operation.axial_load = ["200 N", "500 N"]'), tmp_path / "out"
    whole = run_sweep(path, out=out).to_dataset()
    missing, huge, changed, *others = sorted((out / "parts").iterdir())
    missing.unlink()
    os.truncate(huge, 3 * 10**9)  # of nothing
    changed.write_bytes(changed.read_bytes()[:-1] + b"7")
    for damage, file in zip(DAMAGE.values(), others, strict=True):  # by somebody who knows how it begins
        before = file.read_bytes()[32:]
        after = damage(before)
        assert after != before
        file.write_bytes(sha256(after).digest() + after)
    in_process.clear()
    (out / "sweep.nc").write_bytes(b"of another program")
    assert run_sweep(path, out=out).to_dataset().drop_attrs().identical(whole.drop_attrs())
    assert len(in_process) == len(DAMAGE) + 3
    assert [file.name for file in out.rglob(".*")] == [".lock"]


@pytest.mark.usefixtures("in_process")
@pytest.mark.parametrize("text", ['{"made_from": 3}', "[]", "7", '{"made_from"', "[" * 100_000, "7" * 9000, "\0"])
def test_a_damaged_description_of_a_sweep_is_one_line(grid_file: Write, tmp_path: Path, text: str) -> None:
    path, out = grid_file('operation.axial_load = ["200 N", "500 N"]'), tmp_path / "out"
    out.mkdir()
    (out / "sweep.json").write_text(text, "utf-8")
    refused(lambda: run_sweep(path, out=out), "sweep.json in it is damaged; give a new name, or remove the folder")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="the system has no pipes in folders")
@pytest.mark.usefixtures("in_process")
@pytest.mark.parametrize("name", [".lock", "sweep.json", "sweep.nc", "parts"])
@pytest.mark.parametrize("kind", ["file", "folder", "nothing", "pipe"])
def test_what_has_one_of_our_names_and_is_not_ours_is_neither_followed_nor_waited_for(
    grid_file: Write, tmp_path: Path, name: str, kind: str
) -> None:
    """A folder that others prepared: links to a file, to a folder and to nothing, and a pipe that nobody writes."""
    path, out, victim = grid_file('operation.axial_load = ["200 N", "500 N"]'), tmp_path / "out", tmp_path / "victim"
    out.mkdir()
    os.mkfifo(out / ".fembearing-0123abcd")
    if kind == "pipe":
        os.mkfifo(out / name)
    else:
        (out / name).symlink_to(victim)
    if kind == "file":
        victim.write_text("precious", "utf-8")
    elif kind == "folder":
        victim.mkdir()
    refused(lambda: run_sweep(path, out=out), f"{name!r} in it is not of a sweep", "give a new name")
    if kind == "file":
        assert victim.read_text("utf-8") == "precious"
    else:
        assert not victim.exists() or not [*victim.iterdir()]
    (out / name).unlink()
    assert run_sweep(path, out=out).computed == 2


@pytest.mark.usefixtures("in_process")
@pytest.mark.parametrize(("space", "kept"), [(200, 0), (9_000, 0), (40_000, 48)])
def test_a_full_disk_is_one_line_and_nothing_is_lost(
    grid_file: Write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, space: int, kept: int
) -> None:
    """The disk is full when the grid, a piece, or the dataset is written."""
    resource = pytest.importorskip("resource")
    monkeypatch.setattr(sys, "dont_write_bytecode", True)  # half of a file of it would be kept
    path, out = grid_file(AXES), tmp_path / "out"
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (space, limits[1]))
    try:
        with pytest.raises(StorageError, match=r"cannot be written: .*; ") as found:
            run_sweep(path, out=out)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert "\n" not in str(found.value)
    assert run_sweep(path, out=out).kept == kept


@pytest.mark.usefixtures("in_process")
@pytest.mark.parametrize(
    ("before", "after", "changed"),
    [
        ('"100 N"', '"101 N"', "the axes changed since"),
        ("0.007", "0.008", "the scene changed since"),
        ("[scene]", 'what = "contact"\n[scene]', "what is computed changed since"),
        ("[scene]", "samples = 64\n[scene]", "what is computed changed since"),
    ],
)
def test_a_changed_grid_is_refused(grid_file: Write, tmp_path: Path, before: str, after: str, changed: str) -> None:
    path, out = grid_file(AXES), tmp_path / "out"
    run_sweep(path, out=out)
    path.write_text(path.read_text("utf-8").replace(before, after, 1), "utf-8")
    with pytest.raises(InputError, match=f"holds another sweep: {changed}; give a new name, or remove it first"):
        run_sweep(path, out=out)


@pytest.mark.usefixtures("in_process")
def test_words_that_change_no_number_are_no_other_sweep(grid_file: Write, tmp_path: Path) -> None:
    path, out = grid_file(AXES), tmp_path / "out"
    run_sweep(path, out=out)
    text = path.read_text("utf-8").replace('"100 rpm", "450 rpm"', '"100 rpm", "4.5e2 rpm"')
    path.write_text("# a note\n" + text, "utf-8")
    assert run_sweep(path, out=out).computed == 0


@pytest.mark.parametrize("asked", ["scene", "axis"])
def test_a_changed_height_map_is_another_sweep(grid_file: Write, tmp_path: Path, asked: str) -> None:
    heights = np.random.default_rng(4).normal(scale=1e-7, size=(64, 64))
    np.save(tmp_path / "race.npy", heights)
    axes = """surface.height_map.path = ["race.npy"]\nsurface.height_map.spacing = ["2 um", "3 um"]"""
    in_scene = """[scene.surface]\nheight_map = { path = "race.npy", spacing = "2 um" }"""
    text = axes if asked == "axis" else """operation.axial_load = ["30 N"]"""
    mapped = load_grid(grid_file(text, scene=SCENE + ("" if asked == "axis" else in_scene)))
    with opened_store(tmp_path / "out", mapped):
        pass
    np.save(tmp_path / "race.npy", 2 * heights)
    with pytest.raises(InputError, match="a height map changed since"), opened_store(tmp_path / "out", mapped):
        pass


def test_a_folder_that_holds_something_else_is_left_alone(grid_file: Write, tmp_path: Path) -> None:
    path, out = grid_file(AXES), tmp_path / "out"
    out.mkdir()
    (out / "mine.txt").write_text("mine")
    with pytest.raises(InputError, match="exists and holds no sweep: give a new name"):
        run_sweep(path, out=out)
    assert [file.name for file in out.iterdir()] == ["mine.txt"]
    with pytest.raises(InputError, match="exists and holds no sweep"):
        run_sweep(path, out=path)
    with pytest.raises(InputError, match="cannot be made: Not a directory; give a folder that you may write"):
        run_sweep(path, out=path / "below")
    shutil.rmtree(out)
    with pytest.raises(InputError, match="--workers 0: give a whole number from 1"):
        run_sweep(path, out=out, workers=0)


@pytest.mark.usefixtures("in_process")
def test_points_that_fail_give_a_reason_and_leave_the_others_alone(grid_file: Write, tmp_path: Path) -> None:
    """A load that drives balls over the shoulder, within a series; a groove as narrow as the ball, in its own scene."""
    rest = 'bearing.conformity = {}\noperation.axial_load = {}\noperation.inner_speed = ["90 rpm"]'
    good = rest.format([0.52], ["200 N", "500 N"])
    known = run_sweep(grid_file(good), out=tmp_path / "good").to_dataset()
    more = rest.format([0.5, 0.52], ["200 N", "90 MN", "500 N"])
    result = run_sweep(grid_file(more), out=tmp_path / "more")
    found = result.to_dataset()
    assert (result.failed, result.lost, len(result.reasons)) == (4, 0, 2)
    failed = found["failure"].values[..., 0] != ""
    np.testing.assert_array_equal(failed, [[True, True, True], [False, True, False]])
    np.testing.assert_array_equal(failed, np.isnan(found["torque_total"].values[..., 0]))
    reasons = found["failure"].values[..., 0]
    assert "shoulder" in reasons[1, 1] or "load" in reasons[1, 1]
    assert "groove" in reasons[0, 0]
    assert not any(re.search(r"\n", reason) for reason in reasons.ravel())
    kept = found["torque_total"].isel(conformity=1, axial_load=[0, 2]).values
    # Tolerance: the angle is iterated
    np.testing.assert_allclose(kept, known["torque_total"].isel(conformity=0).values, rtol=1e-9)
    again = run_sweep(grid_file(more), out=tmp_path / "more")
    assert (again.computed, again.failed) == (0, 4)


@pytest.mark.usefixtures("in_process")
def test_good_points_are_computed_however_many_fail(grid_file: Write, tmp_path: Path) -> None:
    """Bad at both ends and at every second point, so that no even choice of points meets a good one; and all bad."""
    loads = [text for number in range(6) for text in (f"{90 + number} MN", f"{200 + 70 * number} N")]
    found = run_sweep(grid_file(f"operation.axial_load = {[*loads, '99 MN']}"), out=tmp_path / "out")
    assert (found.points, found.failed) == (13, 7)
    good = [number % 2 == 1 for number in range(13)]
    np.testing.assert_array_equal(np.isfinite(found.to_dataset()["torque_total"]), good)
    none = run_sweep(grid_file('operation.axial_load = ["90 MN", "91 MN"]'), out=tmp_path / "none")
    assert (none.failed, none.computed) == (2, 2)
    assert "torque_total" not in none.to_dataset()


@pytest.mark.usefixtures("in_process")
@pytest.mark.parametrize("broken", ["scene", "torque"])
def test_a_bug_is_raised_when_all_other_points_are_done(
    grid_file: Write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, broken: str
) -> None:
    """In the reader of one scene of three, or in the torque at one point of a series; then the defect is removed."""
    whole = Grid.scene

    def scene(grid: Grid, variant: int) -> Any:
        if broken == "scene" and variant == 1:
            raise ZeroDivisionError("by nothing")
        return whole(grid, variant)

    def torque(scene: Any) -> Any:
        if broken == "torque" and np.any(scene.operation.axial_load == 300) and scene.friction_coefficient == 0.07:
            raise ZeroDivisionError("by nothing")
        return friction_torque(scene)

    path = grid_file('friction.coefficient = [0.05, 0.07]\noperation.axial_load = ["200 N", "300 N", "400 N"]')
    with monkeypatch.context() as patch:
        patch.setattr(Grid, "scene", scene)
        patch.setattr(parts, "friction_torque", torque)
        with pytest.raises(
            RuntimeError, match=r"sweep\.nc(.|\n)*in (scene|torque)\n(.|\n)*ZeroDivisionError: by nothing"
        ):
            run_sweep(path, out=tmp_path / "out")
    with xarray.open_dataset(tmp_path / "out" / "sweep.nc") as found:
        bad = [[False] * 3, [broken == "scene", True, broken == "scene"]]
        np.testing.assert_array_equal(np.isnan(found["torque_total"]), bad)
        reason = "a defect of fembearing: ZeroDivisionError: by nothing"
        np.testing.assert_array_equal(found["failure"] == reason, bad)
    repeated = run_sweep(path, out=tmp_path / "out")
    assert (repeated.computed, repeated.failed) == (6, 0)


@pytest.mark.usefixtures("in_process")
def test_a_grid_with_samples_has_the_interval_of_each_point(grid_file: Write, tmp_path: Path) -> None:
    axes = 'operation.axial_load = ["300 N", "700 N"]\nfriction.coefficient = [0.05, 0.1]\n'
    path = grid_file(axes, head="samples = 48")
    found = run_sweep(path, out=tmp_path / "out").to_dataset()
    assert found["torque_low"].attrs["units"] == "N m"
    assert np.all(found["torque_low"] < found["torque_total"])
    assert np.all(found["torque_total"] < found["torque_high"])
    assert np.all(found["torque_high_error"] > 0)
    scene = load_grid(path).scene(1)
    operation = replace(scene.operation, axial_load=np.array([300.0, 700.0]), inner_speed=scene.operation.inner_speed)
    alone = predict(replace(scene, operation=operation.as_series()), samples=48, workers=1)
    # The same samples of the same series: the regressions of one quantity and of all parts share its basis.
    np.testing.assert_allclose(found["torque_low"].sel(coefficient=0.1), alone.total.low, rtol=1e-9)


@pytest.mark.usefixtures("in_process")
def test_a_point_without_its_interval_keeps_its_torque_and_counts_as_failed(grid_file: Write, tmp_path: Path) -> None:
    """An angle that is so uncertain passes the shoulder in many samples, which then have no torque."""
    axes = 'uncertainty.bearing.contact_angle.free = ["0.02 rad", "1 rad"]'
    run = run_sweep(grid_file(axes, head="samples = 64"), out=tmp_path / "out")
    found = run.to_dataset().squeeze()
    assert run.failed == 1
    assert re.match(r"no interval: \d+ of 64 samples have no torque", run.reasons[0])
    assert np.all(np.isfinite(found["torque_total"]))
    np.testing.assert_array_equal(np.isfinite(found["torque_low"]), [True, False])


@pytest.mark.usefixtures("in_process")
def test_a_changed_law_of_traction_is_another_sweep(
    grid_file: Write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A package may change its law under the same name and version."""
    packages = tmp_path / "packages"
    install(packages, "own-laws", "1.0", {"mine": "own_laws_of_sweep:law"})
    (packages / "own_laws_of_sweep.py").write_text("from math import asinh as law, tanh as other\n", "utf-8")
    monkeypatch.syspath_prepend(str(packages))
    installed_law.cache_clear()
    (tmp_path / "oiled.toml").write_text(changed(SPEEDS, '"300 rpm"', OILED), "utf-8")
    axes = 'lubricant.traction = ["eyring_sinh", "mine"]'
    path = grid_file(axes, head='scene = "oiled.toml"', scene="")
    found = run_sweep(path, out=tmp_path / "out").to_dataset()["torque_total"]
    np.testing.assert_allclose(found.values[1], found.values[0], rtol=1e-5)  # of the table
    assert found.values[1] != found.values[0]
    import own_laws_of_sweep  # pyright: ignore[reportMissingImports]

    monkeypatch.setattr(own_laws_of_sweep, "law", own_laws_of_sweep.other)
    installed_law.cache_clear()
    with pytest.raises(InputError, match="a law of traction changed since"):
        run_sweep(path, out=tmp_path / "out")
    other = run_sweep(path, out=tmp_path / "other").to_dataset()["torque_total"]
    assert abs(other.values[1] / found.values[1] - 1) > 1e-3
    installed_law.cache_clear()


@pytest.mark.usefixtures("in_process", "short_pieces")
def test_progress_counts_points_that_are_done_and_failed(grid_file: Write, tmp_path: Path) -> None:
    """Three scenes of two points, of which the first cannot be computed; the second run has all."""
    axes = 'bearing.conformity = [0.5, 0.52, 0.53]\noperation.axial_load = ["200 N", "500 N"]'
    told: list[tuple[float, str]] = []
    run_sweep(grid_file(axes), out=tmp_path / "out", progress=lambda share, words: told.append((share, words)))
    assert [round(6 * share) for share, _ in told] == [0, 2, 4, 6, 6]
    words = [each.partition(", about")[0] for _, each in told]
    assert words == ["0 of 6 points", *(f"{done} of 6 points, 2 failed" for done in (2, 4, 6)), "gathering"]
    assert ["left" in each for _, each in told] == [False, True, True, False, False]
    told.clear()
    run_sweep(grid_file(axes), out=tmp_path / "out", progress=lambda share, words: told.append((share, words)))
    assert told == [(1.0, "6 of 6 points"), (1.0, "gathering")]
