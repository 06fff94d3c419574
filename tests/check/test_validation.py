"""The main job: which contacts a scene calls for, which of them reach the torque, and what is refused at once."""

from collections.abc import Callable
from dataclasses import replace
from threading import active_count
from typing import Any

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scene import Scene
from analytic.scenefile.read import load_scene
from fembearing.check.contact import scene_contact
from fembearing.check.contact.solution import ContactSolution
from fembearing.check.torque_change import change_of_torque
from fembearing.check.validation import Validation, check_scene
from fembearing.mesh.recipe import Recipe
from fembearing.plain_types import plain
from tests.analytic.specimens import present
from tests.conftest import Checked


def test_a_scene_with_a_cage_has_both_races_and_its_pocket_twice(checked: Validation) -> None:
    """Without one it has the races alone: tests/cli/test_commands.py."""
    assert [(solved.numbers.pair, solved.numbers.geometry) for solved in checked.contacts] == [
        ("inner", "real"),
        ("outer", "real"),
        ("pocket", "real"),
        ("pocket", "wall"),
    ]


def test_the_progress_never_goes_back(checked_with_progress: Checked) -> None:
    shares = checked_with_progress.shares
    assert shares == sorted(shares)
    assert (shares[0], shares[-1]) == (0, 1)


@pytest.fixture
def oiled(shallow: Callable[[str], Recipe], monkeypatch: pytest.MonkeyPatch) -> Scene:
    """Both races with film and friction at one operating point, for meshes of few cells."""
    monkeypatch.setattr(scene_contact, "load_recipe", shallow)
    scene = load_scene("paper_6205")
    return replace(scene, cage=None, operation=scene.operation.as_series().at(np.array([3])), tolerance=0.9)


def test_numbers_and_their_order_do_not_depend_on_the_number_of_threads(
    oiled: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    """And the shares rise all the same."""

    def numbers(threads: str) -> list[Any]:
        monkeypatch.setenv("OMP_NUM_THREADS", threads)
        shares: list[float] = []
        found = check_scene(oiled, progress=lambda share, _: shares.append(share))
        assert shares == sorted(shares)
        compared = [each.numbers.quantities for each in (*found.contacts, *found.films)]
        races = [each.numbers.races for each in found.creep]
        totals = [present(found.torque_change).total, present(found.film_change)]
        return plain([compared, races, totals, found.sensitivity, found.warnings])

    assert numbers("1") == numbers("3")


def test_who_ends_a_check_at_its_contacts_waits_for_no_film(oiled: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    """The contacts come first: by one thread nothing else is solved before. All threads end."""
    monkeypatch.setenv("OMP_NUM_THREADS", "1")
    threads, steps, contacts = active_count(), [], []

    def ended(found: tuple[ContactSolution, ...]) -> None:
        contacts.extend(found)
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        check_scene(oiled, progress=lambda _, step: steps.append(step), at_contacts=ended)
    assert [each.numbers.pair for each in contacts] == ["inner", "outer"]
    assert steps[-1].startswith(("outer: solved", "inner: film on"))
    assert active_count() == threads


def test_a_failure_of_the_friction_is_noted_after_those_of_films(oiled: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whichever of them comes first."""
    monkeypatch.setenv("OMP_NUM_THREADS", "3")

    def refused(_share: float, step: str) -> None:
        if "film" in step or "friction" in step:
            raise InputError(f"{step} is refused")

    found = check_scene(oiled, progress=refused)
    assert (found.films, found.creep, found.film_change) == ((), (), None)
    assert [words.partition(":")[0] for words in found.missing] == [
        "no numerical film on the inner race",
        "no numerical film on the outer race",
        "no numerical friction",
    ]
    assert len(found.contacts) == 2


def test_a_defect_of_one_part_ends_the_check(oiled: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OMP_NUM_THREADS", "3")
    threads = active_count()

    def broken(_share: float, step: str) -> None:
        if "friction" in step:
            raise ZeroDivisionError(step)

    with pytest.raises(ZeroDivisionError, match="friction"):
        check_scene(oiled, progress=broken)
    assert active_count() == threads


def test_each_race_takes_its_own_contact_to_the_torque(checked: Validation) -> None:
    inner, outer = checked.contacts[:2]
    production = present(checked.torque).friction
    found = present(checked.torque_change).corrected.torque.total
    expected, exchanged = (
        change_of_torque(checked.scene, production, inner=first, outer=second).corrected.torque.total
        for first, second in ((inner, outer), (outer, inner))
    )
    np.testing.assert_array_equal(found, expected)
    assert np.all(found != exchanged)


def no_room_in_the_pocket(scene: Scene) -> Scene:
    return replace(scene, cage=replace(present(scene.cage), pocket_diameter=scene.bearing.ball_diameter))


@pytest.mark.parametrize(
    ("spoiled", "words"),
    [
        (lambda scene: replace(scene, effects={"rolling": "on"}), "effects.rolling"),  # which the contacts do not see
        (no_room_in_the_pocket, "pocket_diameter"),  # the third contact, after two that can be solved
        # Without a coefficient there is no torque and no effect: asking for one is an error, not a wish to pass over
        (
            lambda scene: replace(scene, friction_coefficient=None, effects={"cage": "on"}),
            r"friction\.coefficient is missing",
        ),
    ],
    ids=["effect", "pocket", "no friction"],
)
def test_what_is_impossible_is_refused_before_anything_is_solved(spoiled: Callable[[Scene], Scene], words: str) -> None:
    """A solve tells its progress before it starts."""
    told: list[str] = []
    with pytest.raises(InputError, match=words):
        check_scene(spoiled(load_scene("6205-dry")), progress=lambda _, step: told.append(step))
    assert told == []


def test_the_data_frame_has_a_row_for_each_contact(checked: Validation) -> None:
    frame = checked.to_dataframe()
    assert frame["pair"].tolist() == ["inner", "outer", "pocket", "pocket"]
    assert frame["geometry"].tolist() == ["real", "real", "real", "wall"]
    for point, contact in enumerate(checked.contacts):
        assert frame["verdict"][point] == contact.numbers.verdict
        for name, value in contact.columns().items():
            assert frame[name][point] == pytest.approx(value, nan_ok=True, rel=0, abs=0)
    assert frame.attrs["units"]["peak_pressure"] == "Pa"


def test_warnings_stand_once_and_those_of_a_bearing_name_it(checked: Validation) -> None:
    own = checked.scene.warnings
    first = checked.contacts[0].with_numbers(bearing="first", warnings=(*own, "too near"))
    second = checked.contacts[1].with_numbers(bearing="second", warnings=(*own, "too near"))
    found = replace(checked, contacts=(first, second), torque=None, torque_change=None, trouble=("no pictures",))
    assert found.warnings == (*own, "first bearing, too near", "second bearing, too near", "no pictures")
    alone = replace(found, contacts=(first.with_numbers(bearing=None), second.with_numbers(bearing=None)))
    assert alone.warnings == (*own, "too near", "no pictures")


def test_the_verdict_of_all_contacts_is_the_worst_of_those_that_are_judged(checked: Validation) -> None:
    *_, seat, sheet = (contact.numbers for contact in checked.contacts)
    assert (sheet.judged, sheet.verdict) == (False, "shown")
    assert checked.compared == {"contacts": "pass", "friction": "pass"}
    failed = checked.contacts[0].with_numbers(verdict="fail")
    assert replace(checked, contacts=(failed, *checked.contacts[1:])).verdicts.comparison == "fail"
    bare = replace(checked, torque=None).verdicts
    assert [check.where for check in bare.physical] == ["inner race", "outer race"]
    assert bare.numerical is None
    assert seat.judged
