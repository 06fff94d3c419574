"""The main job: which contacts a scene calls for, which of them reach the torque, and what is refused at once."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scene import Scene
from analytic.scenefile.read import load_scene
from fembearing.progress import silent
from fembearing.verify import validation
from fembearing.verify.torque.change import change_of_torque
from fembearing.verify.validation import Validation, check_scene
from tests.analytic.specimens import present
from tests.conftest import Checked


def test_a_scene_with_a_cage_has_both_races_and_its_pocket_twice(checked: Validation) -> None:
    """Without one it has the races alone: tests/cli/test_scenes.py."""
    assert [(solved.contact.pair, solved.geometry) for solved in checked.contacts] == [
        ("inner", "real"),
        ("outer", "real"),
        ("pocket", "real"),
        ("pocket", "wall"),
    ]


def test_the_progress_never_goes_back(checked_with_progress: Checked) -> None:
    """One contact after the other; each solve tells the start of its steps, the last one in the last third."""
    shares = checked_with_progress.shares
    assert shares == sorted(shares)
    assert shares[0] == 0
    assert 2 / 3 < shares[-1] <= 1


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
        assert frame["verdict"][point] == contact.shown_verdict
        for name, value in contact.columns().items():
            assert frame[name][point] == pytest.approx(value, nan_ok=True, rel=0, abs=0)
    assert frame.attrs["units"]["peak_pressure"] == "Pa"


def bearing(name: Any, points: list[int], tolerance: float = 0.05) -> Any:
    """One of a pair, or the only one."""
    return SimpleNamespace(name=name, points=np.array(points), scene=SimpleNamespace(tolerance=tolerance))


@dataclass(frozen=True)
class Numbers:
    """What is read of a film or of creep."""

    pair: str = ""
    bearing: str | None = None
    change: float = 0.0
    races: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Found:
    numbers: Numbers
    place: int = 0


def test_films_that_cannot_be_solved_have_a_reason_and_the_others_their_bearing(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    first, second = bearing("first", [0]), bearing("second", [0])
    shares: list[float] = []

    def film(scene: Any, *, pair: str, progress: Any) -> Found:
        progress(0.0, "begins")
        progress(1.0, "ends")
        if scene is second.scene and pair == "inner":
            raise InputError("no oil there")
        return Found(Numbers(pair=pair))

    monkeypatch.setattr(validation, "film_of", film)
    monkeypatch.setattr(validation, "film_change", lambda *_: np.array([0.03, -0.01]))
    friction: Any = object()
    scene: Any = object()

    def films(of: Any = friction) -> Any:
        return validation._films(scene, [first, second], of, lambda share, _: shares.append(share))

    found, change, reasons = films()
    assert [(each.numbers.bearing, each.numbers.pair) for each in found] == [
        ("first", "inner"),
        ("first", "outer"),
        ("second", "outer"),
    ]
    assert change.tolist() == [0.03, -0.01]
    assert reasons == ("no numerical film on the inner race of the second bearing: no oil there",)
    np.testing.assert_allclose(shares, [0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1], rtol=1e-12)
    assert films(None)[1] is None  # without a torque nothing changes

    def refuse(*_: Any) -> None:
        raise InputError("too thin")

    monkeypatch.setattr(validation, "film_change", refuse)
    _, change, reasons = films()
    assert change is None
    assert reasons[1:] == ("no torque with the numerical films: too thin",)


def test_friction_changes_the_torque_by_the_share_that_slides_at_the_heaviest_ball(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """At the point of the pair: of 20 N mm there 5 and 3 slide, and the numerical friction is 12 % more."""
    first, second = bearing("first", [2, 0]), bearing("second", [1, 3], tolerance=1e-9)
    loads = {"first": {"inner": 310.0, "outer": 330.0}, "second": {"inner": 250.0, "outer": 290.0}}
    asked, shares = [], list[float]()

    def creep(scene: Any, *, tolerance: float, progress: Any) -> Found:
        progress(1.0, "ends")
        name = "first" if scene is first.scene else "second"
        asked.append(tolerance)
        races = {race: SimpleNamespace(load=load) for race, load in loads[name].items()}
        return Found(Numbers(change=0.12 if name == "first" else 0.3, races=races), place=0)

    monkeypatch.setattr(validation, "creep_of", creep)
    torque = SimpleNamespace(
        spin=np.array([0.0, 0.0, 5e-3, 0.0]), conformity=np.array([0.0, 1e-3, 3e-3, 0.0]), total=np.full(4, 20e-3)
    )
    friction: Any = SimpleNamespace(torque=torque)
    found, change, reasons = validation._creep([first, second], friction, lambda share, _: shares.append(share))
    assert [(each.numbers.bearing, each.place) for each in found] == [("first", 2), ("second", 1)]
    assert change == pytest.approx(0.12 * 8 / 20, rel=1e-12)
    assert reasons == ()
    assert asked == [0.05, validation.CREEP_TOLERANCE]
    assert shares == [0.5, 1.0]
    torque.spin = None
    _, change, _ = validation._creep([first, second], friction, silent)
    assert change == pytest.approx(0.12 * 3 / 20, rel=1e-12)

    def refuse(*_: Any, **__: Any) -> None:
        raise InputError("nothing slides")

    monkeypatch.setattr(validation, "creep_of", refuse)
    assert validation._creep([first], friction, silent) == (
        (),
        None,
        ("no numerical friction of the first bearing: nothing slides",),
    )


def test_the_seeds_are_those_of_what_was_random() -> None:
    cage, rough = SimpleNamespace(seeds=3), SimpleNamespace(autocorrelation=object())
    scene: Any = SimpleNamespace(cage=cage, surface=rough)
    moved: Any = SimpleNamespace(
        friction=SimpleNamespace(cage=SimpleNamespace(motion=[None, object()])), prediction=SimpleNamespace(seed=11)
    )
    measured: Any = SimpleNamespace(seed=17)
    assert validation._seeds(scene, moved, measured, cost=True) == {
        "motion of the cage": range(3),
        "samples of the interval": (11,),
        "samples beside the measured torques": (17,),
        "generated surface": (validation.SEED,),
    }
    assert validation._seeds(scene, None, None, cost=False) == {}
    moved.prediction, moved.friction.cage.motion = None, [None, None]
    rough.autocorrelation = None
    assert validation._seeds(scene, moved, None, cost=True) == {}
    moved.friction.cage = scene.surface = scene.cage = None
    assert validation._seeds(scene, moved, None, cost=True) == {}


@pytest.mark.parametrize(
    ("motion", "points"),
    [([None, "a", None, "b", "c"], [1, 4]), (["a", None, None, None, None], [0]), ([None] * 5, [])],
)
def test_motions_are_kept_of_the_slowest_and_the_fastest_point_whose_cage_moved(
    monkeypatch: pytest.MonkeyPatch, motion: list[Any], points: list[int]
) -> None:
    monkeypatch.setattr(validation, "record_cage", lambda _scene, _friction, point: point)
    friction: Any = SimpleNamespace(
        cage=SimpleNamespace(motion=motion), inner_speed=np.array([50.0, 10.0, 5.0, -20.0, -30.0])
    )
    scene: Any = object()
    assert validation._recorded(scene, friction) == tuple(points)
    friction.cage = None
    assert validation._recorded(scene, friction) == ()


def test_the_contacts_of_the_torque_are_those_of_the_bearing_with_the_heaviest_ball() -> None:
    def solved(pair: str, load: float) -> Any:
        return SimpleNamespace(contact=SimpleNamespace(pair=pair, load=load))

    light = [solved("inner", 200.0), solved("outer", 230.0)]
    heavy = [solved("inner", 210.0), solved("outer", 240.0)]
    for contacts in ([*light, *heavy], [*heavy, *light], [*heavy, solved("pocket", 900.0)]):
        assert validation._heaviest(contacts) == dict(zip(("inner", "outer"), heavy, strict=True))


def test_a_race_without_a_known_ring_has_a_warning(checked: Validation, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(_: Any) -> None:
        raise InputError("no seats")

    monkeypatch.setattr(validation, "with_ring", refuse)
    contact = checked.contacts[0]
    assert validation._with_ring_if_known(contact).warnings == (*contact.warnings, "no seats")


def test_warnings_stand_once_and_those_of_a_bearing_name_it(checked: Validation) -> None:
    own = checked.scene.warnings
    first = replace(checked.contacts[0], bearing="first", warnings=(*own, "too near"))
    second = replace(checked.contacts[1], bearing="second", warnings=(*own, "too near"))
    found = replace(checked, contacts=(first, second), torque=None, torque_change=None, trouble=("no pictures",))
    assert found.warnings == (*own, "first bearing, too near", "second bearing, too near", "no pictures")
    alone = replace(found, contacts=(replace(first, bearing=None), replace(second, bearing=None)))
    assert alone.warnings == (*own, "too near", "no pictures")


def test_the_verdict_of_all_contacts_is_the_worst_of_those_that_are_judged(checked: Validation) -> None:
    seat, sheet = checked.contacts[2:]
    assert not sheet.judged
    assert checked.comparison == "pass"
    tight = [replace(contact, tolerance=1e-9) for contact in checked.contacts]
    assert replace(checked, contacts=(tight[0], *checked.contacts[1:])).comparison == "fail"
    assert replace(checked, contacts=(*checked.contacts[:3], tight[3])).comparison == "pass"
    bare = replace(checked, torque=None).verdicts
    assert [check.where for check in bare.physical] == ["inner race", "outer race"]
    assert bare.numerical is None
    assert seat.judged
