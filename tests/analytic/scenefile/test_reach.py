"""How far the oil reaches, and the other choices of the lubricant for film and rolling, as a scene gives them."""

import pytest

from analytic.errors import InputError
from analytic.scene import Lubricant, Reach
from analytic.scenefile.parts import lubricant
from analytic.scenefile.read import scene_of

BALL_RADIUS = 3.969e-3  # m, of a 6205


def oil_of(**keys: object) -> Lubricant:
    document = {
        "name": "6205",
        "tolerance": "2 %",
        "bearing": {"catalog": "6205"},
        "operation": {"axial_load": "730 N", "inner_speed": "410 rpm"},
        "lubricant": {"name": "ISO VG 46", **keys},
        "surface": {"finish": "ground and honed"},
    }
    found = scene_of(document, origin="scene").lubricant
    assert found is not None
    return found


def test_a_share_and_a_length_say_the_same() -> None:
    share = oil_of(reach={"ahead": 0.62}).reach
    length = oil_of(reach={"ahead": f"{0.62e3 * BALL_RADIUS} mm"}).reach
    assert share == Reach(ahead=0.62, behind=0.9)
    assert length.ahead == pytest.approx(share.ahead, rel=1e-3)  # the catalog rounds the ball to 0.01 mm
    assert oil_of(reach={"behind": "70 %"}).reach == Reach(ahead=0.9, behind=0.7)


def test_the_other_choices_reach_the_model() -> None:
    found = oil_of(
        cavitation_pressure="-0.1 MPa", compressible=False, film_formula="nijenbanning", rolling_formula="houpert"
    )
    assert found.cavitation_pressure == -1e5
    assert (found.compressible, found.film_formula, found.rolling_formula) == (False, "nijenbanning", "houpert")


@pytest.mark.parametrize(
    ("keys", "key", "value"),
    [
        ({"reach": {"ahead": "-2 mm"}}, "lubricant.reach.ahead", "mm"),
        ({"reach": {"ahead": "12 mm"}}, "lubricant.reach.ahead", "3.9"),
        ({"reach": 0.7}, "lubricant.reach", "ahead = 0.9"),
    ],
)
def test_mistakes_are_one_line_with_the_key_and_what_is_accepted(keys: dict[str, object], key: str, value: str) -> None:
    with pytest.raises(InputError) as refused:
        oil_of(**keys)
    assert key in str(refused.value)
    assert value in str(refused.value)
    assert "\n" not in str(refused.value)


def test_a_length_needs_a_ball() -> None:
    with pytest.raises(InputError, match=r"lubricant\.reach"):
        lubricant("ISO VG 46", reach={"ahead": "3 mm"})  # pyright: ignore[reportArgumentType]
