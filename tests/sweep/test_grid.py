"""Grid files: the scenes that they give, and the mistakes that they refuse."""

import os
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scenefile.read import load_scene
from fembearing.sweep.dataset import axis_names
from fembearing.sweep.grid import Axis, load_grid
from fembearing.sweep.parts import Piece, compute_part, pieces
from tests.sweep.swept import SCENE

LOADS = 'operation.axial_load = ["100 N", "0.7 kN"]\n'


@pytest.mark.parametrize(
    ("axes", "loads"),
    [
        ('operation.axial_load = ["300 N", "500 N"]\n', (300.0, 0.0, 0.0)),
        ('operation.radial_load = ["300 N", "500 N"]\n', (0.0, 300.0, 0.0)),
        ('operation.moment = ["0.3 N m", "0.5 N m"]\n', (0.0, 0.0, 0.3)),
        ('operation.inner_speed = ["300 rpm", "500 rpm"]\n', (0.0, 560.0, 0.0)),
    ],
)
def test_no_usual_load_is_added_to_an_axis_of_loads(
    grid_file: Callable[..., Path], axes: str, loads: tuple[float, ...]
) -> None:
    operation = load_grid(grid_file(axes, head='scene = "6206"', scene="")).first_scene().operation
    assert tuple(map(np.max, (operation.axial_load, operation.radial_load, operation.moment))) == loads


def test_values_come_out_in_si_and_in_order(grid_file: Callable[..., Path]) -> None:
    grid = load_grid(
        grid_file(
            LOADS
            + '"operation.inner_speed" = { from = "60 rpm", to = "600 rpm", count = 3 }\n'
            + 'surface.rms_roughness = { from = "0.1 um", to = "1.6 um", count = 5, spacing = "log" }'
        )
    )
    load, speed, roughness = grid.axes
    assert load.values == (100.0, 700.0)
    # Tolerance: round-off
    np.testing.assert_allclose(np.array(speed.values, float), 2 * np.pi * np.array([1.0, 5.5, 10.0]), rtol=1e-14)
    np.testing.assert_allclose(np.array(roughness.values, float), [1e-7, 2e-7, 4e-7, 8e-7, 1.6e-6], rtol=1e-14)
    assert [axis.key for axis in grid.order] == [
        "surface.rms_roughness",
        "operation.axial_load",
        "operation.inner_speed",
    ]
    assert (grid.size, grid.length) == (30, 6)


def test_a_point_is_the_scene_that_a_user_would_write(grid_file: Callable[..., Path], tmp_path: Path) -> None:
    axes = 'friction.coefficient = [0.06, 0.08]\nbearing.inner.groove_radius = ["4.14 mm", "4.17 mm"]\n'
    grid = load_grid(grid_file(axes + 'operation.axial_load = ["120 N", "340 N"]'))
    text = grid.text.partition("[axes]")[0].replace("[scene]\n", "").replace("[scene.", "[")
    text = text.replace("0.09", "0.08").replace("300 N", "120 N")
    text = text.replace("[operation]", '[bearing.inner]\ngroove_radius = "4.14 mm"\n[operation]')
    (tmp_path / "written.toml").write_text(text, "utf-8")
    written, found = load_scene(tmp_path / "written.toml"), grid.scene(2)
    assert (found.bearing, found.friction_coefficient) == (written.bearing, 0.08)
    assert found.operation.axial_load == written.operation.axial_load


def test_a_clearance_is_swept_as_a_length_or_as_a_group(grid_file: Callable[..., Path]) -> None:
    solved = SCENE.replace(', free = "0.18 rad"', "")
    groups = load_grid(grid_file('bearing.clearance = ["C3", "CN"]\n' + LOADS, scene=solved)).scene(0)
    lengths = load_grid(grid_file('bearing.clearance = ["9 um", "20.5 um"]\n' + LOADS, scene=solved)).scene(1)
    # 13 to 28 um is C3 of a bore of 25 mm; a difference of radii of 20 mm has a round-off of 1e-9 of it
    assert groups.bearing.diametral_clearance == pytest.approx(20.5e-6, rel=1e-9)
    assert lengths.bearing.diametral_clearance == pytest.approx(20.5e-6, rel=1e-9)


def test_conformity_sets_both_grooves_and_nothing_else(grid_file: Callable[..., Path]) -> None:
    grid = load_grid(grid_file("bearing.conformity = [0.515, 0.53]\n" + LOADS))
    plain = load_grid(grid_file(LOADS)).scene(0).bearing
    found = grid.scene(1).bearing
    for ring in ("inner", "outer"):
        assert getattr(found, ring).groove_radius == pytest.approx(0.53 * plain.ball_diameter, rel=1e-15)
        assert getattr(found, ring).bottom_radius == getattr(plain, ring).bottom_radius
    assert found.diametral_clearance == plain.diametral_clearance


def test_the_points_of_a_piece_lie_in_it_from_its_start(grid_file: Callable[..., Path]) -> None:
    """Also where it begins and ends within a series."""
    axes = 'operation.axial_load = ["100 N", "300 N", "700 N"]\nfriction.coefficient = [0.03, 0.08]'
    grid = load_grid(grid_file(axes))
    whole = compute_part(grid, Piece(0, grid.size)).values
    assert np.unique(whole["torque_total"]).size == grid.size
    for start, stop in ((1, 3), (2, 5), (4, 6)):
        part = compute_part(grid, Piece(start, stop)).values
        np.testing.assert_allclose(
            part["torque_total"], whole["torque_total"][start:stop], rtol=1e-9
        )  # of other starts


def test_a_point_that_fails_has_its_reason_in_its_own_place(grid_file: Callable[..., Path]) -> None:
    """A bearing without an axial load has no contact angle; the piece begins behind the start of the series."""
    grid = load_grid(grid_file('operation.axial_load = ["100 N", "300 N", "0 N", "700 N", "900 N"]'))
    part = compute_part(grid, Piece(1, 5)).values
    assert np.isfinite(part["torque_total"]).tolist() == [True, False, True, True]
    assert [bool(reason) for reason in part["failure"]] == [False, True, False, False]


@pytest.mark.parametrize(
    ("given", "complaint"),
    [
        ("", "axes = {} is empty; give for example operation.axial_load"),
        ('load = ["1 N"]', "axes: load is no key of a scene file; did you mean operation.radial_load or "),
        ('operation.axial_load = ["3 mm"]', r"axial_load\[0\] = '3 mm' is not in a unit like kN; give for example"),
        ("operation.axial_load = []", "axial_load is empty; give at least one value"),
        ('operation.axial_load = ["7 N", "3 N", "0.003 kN"]', "has 3.0 twice"),
        ('operation.axial_load = { from = "1 N", to = "3 N" }', "axial_load.count is missing"),
        ('operation.axial_load = { from = "1 N", to = "3 N", count = 1 }', "count = 1 is not a number of values"),
        ('operation.axial_load = { from = "1 N", to = "1 N", count = 4 }', "from and to are the same"),
        ('operation.axial_load = { from = "0 N", to = "3 N", count = 4, spacing = "log" }', "has no logarithm"),
        ('bearing.catalog = { from = "paper_6205", to = "6208", count = 2 }', "has no order to step through"),
        ('operation.axial_load = ["3 N"]\n"operation.axial_load" = ["4 N"]', "axial_load is there twice"),
        ('bearing.clearance = ["C3", "10 um"]', "bearing.clearance mixes words and quantities; give one kind"),
        ('bearing.clearance = { from = "C3", to = "10 um", count = 3 }',
            "steps through quantities, not words; give a list"),
        ('pair = ["inner"]', 'pair is of a contact; write what = "contact"'),
        ('bearing.ball_material.hardness = ["7 GPa"]', None),  # a table that the scene has as a word: found at a point
        ('operation.axial_load = { from = "1 N", to = "9 N", count = 90000 }\n'
            'operation.inner_speed = { from = "1 rpm", to = "9 rpm", count = 90000 }',
            "90000 x 90000 = 8,100,000,000 points are too many for this machine's memory"),
        (("seen = 3", LOADS), "seen = 3 is an unknown key; did you mean scene"),
        (('pair = "inner"', LOADS), "pair is of a contact"),
        (('what = "contact"\npair = "between"', LOADS), 'give "inner", "outer" or "pocket"'),
        (('what = "contact"\npair = "inner"', 'pair = ["outer"]'), "pair is an axis and has one value"),
    ],
)  # fmt: skip
def test_a_mistake_is_one_line(
    grid_file: Callable[..., Path], given: str | tuple[str, str], complaint: str | None
) -> None:
    """Of axes, or of what stands above them."""
    head, axes = ("", given) if isinstance(given, str) else given
    path = grid_file(axes, head=head)
    if complaint is None:
        assert load_grid(path).axes
        return
    with pytest.raises(InputError, match=complaint) as found:
        load_grid(path)
    assert "\n" not in str(found.value)
    assert str(path) in str(found.value)


def test_as_many_points_as_half_of_the_memory_holds_are_accepted(
    grid_file: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    """At 400 bytes a point: 12 of them in half of 3 pages of 3200 bytes."""
    monkeypatch.setattr(os, "sysconf", {"SC_PAGE_SIZE": 3200, "SC_PHYS_PAGES": 3}.get)
    speeds = 'operation.inner_speed = { from = "60 rpm", to = "600 rpm", count = COUNT }'
    assert load_grid(grid_file(LOADS + speeds.replace("COUNT", "6"))).size == 12
    with pytest.raises(InputError, match=r"2 x 7 = 14 points are too many .* which holds the results of 12;"):
        load_grid(grid_file(LOADS + speeds.replace("COUNT", "7")))


def test_a_scene_has_a_path_or_is_built_in(grid_file: Callable[..., Path], tmp_path: Path) -> None:
    axes = 'operation.inner_speed = ["90 rpm"]'
    builtin = load_grid(grid_file(axes, head='scene = "paper_6205"', scene="")).scene(0)
    text = grid_file("").read_text("utf-8").partition("[axes]")[0]
    (tmp_path / "own.toml").write_text(text.replace("[scene]", "").replace("[scene.", "["), "utf-8")
    assert load_grid(grid_file(axes, head='scene = "own.toml"', scene="")).scene(0).name == "swept"
    assert builtin.name == "6205 of the paper under 1000 N thrust, oil"
    with pytest.raises(InputError, match=r"nowhere\.toml: No such file or directory; give the path of a scene file"):
        load_grid(grid_file(axes, head='scene = "nowhere.toml"', scene=""))
    with pytest.raises(InputError, match="scene is missing; give its path"):
        load_grid(grid_file(axes, scene=""))


LOAD_STEPS = 'operation.axial_load = { from = "100 N", to = "1 kN", count = COUNT }\n'
TWO = "friction.coefficient = [0.05, 0.07]\n"


CAGED = SCENE + "\n[scene.cage]\n"


@pytest.mark.parametrize(
    ("axes", "above", "counts"),
    [
        (LOAD_STEPS.replace("COUNT", "1000"), {}, [1000]),
        (TWO + LOAD_STEPS.replace("COUNT", "1000"), {}, [1000, 1000]),  # each scene by itself
        (TWO + LOAD_STEPS.replace("COUNT", "1001"), {}, [500, 501, 500, 501]),
        ("friction.coefficient = { from = 0.01, to = 0.1, count = 101 }\n", {}, [50, 50, 1]),
        (
            "friction.coefficient = { from = 0.01, to = 0.1, count = 7 }\n" + LOAD_STEPS.replace("COUNT", "300"),
            {},
            [900, 900, 300],
        ),
        ('operation.radial_load = { from = "10 N", to = "1 kN", count = 75 }', {}, [15] * 5),  # of unlike loads
        (
            'operation.moment = ["0 N m", "1 N m"]\nfriction.coefficient = { from = 0.02, to = 0.1, count = 20 }',
            {},
            [16, 16, 8],
        ),
        (TWO + LOAD_STEPS.replace("COUNT", "3"), {"head": "samples = 64"}, [3, 3]),
        (TWO + LOAD_STEPS.replace("COUNT", "3"), {"head": 'what = "contact"'}, [1] * 6),
        ('cage.start = ["rest", "whirl"]\n' + LOAD_STEPS.replace("COUNT", "3"), {}, [1] * 6),
        (LOAD_STEPS.replace("COUNT", "4"), {"scene": CAGED}, [4]),
        (LOAD_STEPS.replace("COUNT", "4"), {"scene": CAGED + 'start = "rest"\n'}, [1] * 4),
    ],
)
def test_pieces_take_a_few_seconds_each(
    grid_file: Callable[..., Path], axes: str, above: dict[str, str], counts: list[int]
) -> None:
    """At most 1000 points under thrust and 50 scenes; an interval, a contact and a moving cage stand by themselves."""
    found = list(pieces(load_grid(grid_file(axes, **above))))
    assert [len(piece) for piece in found] == counts
    assert [point for piece in found for point in range(piece.start, piece.stop)] == list(range(sum(counts)))


def test_a_list_of_one_value_in_the_scene_is_no_series(grid_file: Callable[..., Path]) -> None:
    one = SCENE.replace("[scene.operation]", '[scene.operation]\nmoment = ["0.1 N m"]')
    assert load_grid(grid_file(LOADS, scene=one)).size == 2
    two = SCENE.replace("[scene.operation]", '[scene.operation]\nmoment = ["0.1 N m", "0.2 N m"]')
    with pytest.raises(InputError, match=r"operation\.moment has 2 values in the scene"):
        load_grid(grid_file(LOADS, scene=two))
    both = two.replace("moment", "radial_load").replace("N m", "N")
    assert load_grid(grid_file(LOADS + 'operation.radial_load = ["10 N", "30 N", "40 N"]', scene=both)).size == 6


def test_names_of_dimensions_are_short_where_they_are_clear(grid_file: Callable[..., Path]) -> None:
    axes = (
        "bearing.inner.conformity = [0.52, 0.53]\nbearing.outer.conformity = [0.52, 0.53]\n"
        'friction.coefficient = [0.1]\ncage.friction_coefficient = [0.1, 0.2]\nbearing.catalog = ["paper_6205"]\n'
    )
    names = axis_names(load_grid(grid_file(axes)).axes)
    assert names == {
        "bearing.inner.conformity": "inner_conformity",
        "bearing.outer.conformity": "outer_conformity",
        "friction.coefficient": "coefficient",
        "cage.friction_coefficient": "friction_coefficient",
        "bearing.catalog": "bearing",
    }
    made = [Axis(key=key, unit=None, values=(1.0,)) for key in ("lubricant.name", "bearing.name", "name")]
    assert axis_names(made) == {"lubricant.name": "lubricant_name", "bearing.name": "bearing_name", "name": "name"}
