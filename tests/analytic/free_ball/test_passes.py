"""How closely the passes of a point with free balls settle, and how they take their number of nodes."""

from collections.abc import Callable
from dataclasses import replace
from inspect import unwrap
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.contact.geometry import RACES, race_curvatures
from analytic.contact.rolling_contact import EllipticContact
from analytic.free_ball import passes
from analytic.free_ball.passes import FreeAccuracy, FreeEnd
from analytic.free_ball.rounds import ROUGHLY_STEADY, SKIDS, STEADY
from analytic.free_ball.state import contact_states
from analytic.free_ball.turning import ACCURACY, ENOUGH
from analytic.loads.ring_rounds import OPEN, SETTLED, Round
from analytic.loads.state import ball_states, ring_state
from analytic.numerics.records import Records
from analytic.oil.film import film_asymptotes
from analytic.oil.mixed import mixed_contact
from analytic.oil.traction import mixed_traction
from analytic.solve.model import model_of, workspace
from analytic.solve.records import SETTLED as POINT_SETTLED
from analytic.solve.solution import points_of, solved
from analytic.surface.gap import gap_law
from analytic.surface.roughness import gap_roughness
from tests.analytic.free_ball.specimens import COUNTED, angular_contact, dry_scene
from tests.analytic.specimens import FINISH, OIL
from tests.contacts import STEEL


def test_the_last_pass_is_steady_to_the_digits_that_a_torque_needs() -> None:
    """Passes before it need not be, and the nodes of the last one change the forces."""
    push, speed = np.array([60.0, 170.0, 480.0]), np.array([610.0, 1450.0, 870.0])  # N, rad/s
    scene = dry_scene(angular_contact(), None, 0.07, load=push, speed=speed)
    found = solved(model_of(scene, COUNTED, creep="closed", allowed=0.04), points_of(scene.operation, 0.0)).points
    np.testing.assert_array_equal(found["status"], POINT_SETTLED)
    assert np.all(found["passes"] >= 2)
    np.testing.assert_array_equal(found["tolerance"], STEADY)
    assert np.all(found["left"] <= STEADY)


def test_each_race_has_the_law_of_its_own_film() -> None:
    """By the film formulas for its load, semi-axes and speeds; the outer groove is far wider, and carries more."""
    narrow, speed = angular_contact(), 1450.0
    wide = replace(narrow.outer, groove_radius=0.6 * narrow.ball_diameter)
    scene = dry_scene(replace(narrow, outer=wide), 0.5, 0.1, load=np.array([170.0]), speed=np.array([speed]))
    scene = replace(scene, friction_coefficient=None, lubricant=OIL, surface=FINISH)
    model = model_of(scene, COUNTED | {"asperities": True}, creep="closed", passes=1)
    work = workspace(model)
    ball = solved(model, points_of(scene.operation, model.temperature), work=work).balls[0, 0]
    bodies, modulus = (STEEL, STEEL), STEEL.youngs_modulus / (2 * (1 - STEEL.poisson_ratio**2))
    gap = gap_law(FINISH, gap_roughness(FINISH), modulus=modulus, bodies=bodies)
    for race, name in enumerate(RACES):
        angle = float(ball["angle"][race])
        rolling, transverse = race_curvatures(scene.bearing, name, contact_angle=angle)
        contact = EllipticContact(
            load=float(ball["load"][race]),
            semi_axis_rolling=float(ball["semi_axis_rolling"][race]),
            semi_axis_transverse=float(ball["semi_axis_transverse"][race]),
            curvature_rolling=float(rolling),
            curvature_transverse=float(transverse),
            modulus=modulus,
        )
        film = film_asymptotes(
            contact,
            entrainment_speed=speed * float(ball["motion"][f"{name}_entrainment"]),
            viscosity=OIL.viscosity,
            pressure_viscosity=OIL.pressure_viscosity,
            compressible=OIL.compressible,
        )
        expected = mixed_traction(OIL, FINISH.boundary_friction, mixed_contact(contact, film, gap=gap)).point_law
        held = work.contacts[0, race]
        # Passes end where the torque settles; films still follow the speeds by 1e-3.
        for field in ("boundary", "limit", "eyring", "share", "alpha", "bend", "exponent", "rises"):
            np.testing.assert_allclose(held[field], getattr(expected, field), rtol=1e-4, err_msg=field)
        np.testing.assert_allclose(held["fluidity"], speed * expected.fluidity, rtol=2e-3)


OTHER = 0.3  # N m: all torque but that of sliding
END = Round(SETTLED, 3, 1e-7, 1e-6)
MODEL: Any = SimpleNamespace(ring=SimpleNamespace(bearing=None), quadratures=range(6))


class Settled:
    """What came of passes whose torque of sliding is that of `torque_of`, of a quadrature and the pass, from 0."""

    def __init__(
        self,
        patch: pytest.MonkeyPatch,
        torque_of: Callable[[int, int], float],
        *,
        known: int = 0,
        end: Round = END,
        **wanted: Any,
    ) -> None:
        self.numbers: list[int] = []
        self.nearly: list[bool] = []
        self.begun: list[bool] = []
        self.left = 0
        self.balls: Records = ball_states(2).view(np.recarray)
        self.ring = ring_state()
        self.ring.passes = known

        def one_pass(*given: Any) -> tuple[Round, float]:
            self.numbers.append(given[6])
            self.nearly.append(given[7])
            return end, OTHER

        def slid(*_: Any) -> tuple[float, float]:
            torque = torque_of(self.numbers[-1], len(self.numbers) - 1)
            return torque, 0.6 * torque

        def leave(*_: Any) -> None:
            self.left += 1

        patch.setattr(passes, "_one_pass", one_pass)
        patch.setattr(passes, "_slid", slid)
        patch.setattr(passes, "_begin", lambda _model, _ball, known: self.begun.append(known))
        patch.setattr(passes, "_leave", leave)
        accuracy = FreeAccuracy(**({"allowed": 0.01, "passes": 0, "nearly": False, "spin_alone": False} | wanted))
        self.found: FreeEnd = unwrap(passes.settle_freely)(
            MODEL, 1.0, None, self.ring, self.balls, None, accuracy, None
        )


def test_nodes_are_refined_until_the_change_of_the_torque_is_small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Twice the last change, or a quarter of the one before, as two quadratures may agree by chance."""
    torques = {1: 1.10, 2: 1.02, 3: 1.0005, 4: 1.0, 5: 1.0}
    refined = Settled(monkeypatch, lambda number, _: torques[number])
    assert refined.numbers == [1, 2, 3, 4, 4]  # the last one again, by the laws of its own loads
    assert refined.begun == [False, False]
    assert refined.found.error == pytest.approx((1.02 - 1.0005) / 4, rel=1e-12)
    assert (refined.ring.passes, refined.left, refined.found.torque, refined.found.spin) == (4, 2, 1.0, 0.6)
    torques[3] = 1.019
    near = Settled(monkeypatch, lambda number, _: torques[number], allowed=0.03)
    assert near.numbers == [1, 2, 3, 3]
    assert near.found.error == pytest.approx((1.10 - 1.02) / 4, rel=1e-12)
    assert Settled(monkeypatch, lambda number, _: torques[number], allowed=0.0151).numbers == [1, 2, 3, 4, 5, 5]


def test_two_quadratures_that_agree_leave_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of shares of sliding, 1, and of the whole torque, 1.3: with 32 strips 0.025 and 5e-4, then 0.004 and 2e-5."""
    for allowed, last, least in ((0.01975, 2, 0.025 + 5e-4 * 1.3), (0.01970, 3, 0.004 + 2e-5 * 1.3)):
        even = Settled(monkeypatch, lambda _number, _pass: 1.0, allowed=allowed)
        assert even.numbers == [*range(1, last + 1), last]
        assert even.found.error == pytest.approx(least, rel=1e-12)


def test_the_last_quadrature_is_taken_however_much_it_errs(monkeypatch: pytest.MonkeyPatch) -> None:
    coarse = Settled(monkeypatch, lambda number, _: 1.0 + 0.5**number)
    assert coarse.numbers == [1, 2, 3, 4, 5, 5]
    assert coarse.found.error == pytest.approx(2 * (0.5**4 - 0.5**5), rel=1e-12)


@pytest.mark.parametrize("chosen", [{"known": 3}, {"passes": 3}, {"passes": 3, "known": 2}])
def test_a_quadrature_that_is_known_stays_until_its_torque_does(
    monkeypatch: pytest.MonkeyPatch, chosen: dict[str, Any]
) -> None:
    """The change from pass to pass falls by a tenth each time, to 3e-7 of the whole torque."""
    held = Settled(monkeypatch, lambda _, count: 1.0 + 0.1**count, **chosen)
    assert held.numbers == [3] * 9  # 9e-8 is the first change that is below 3.9e-7, and 9e-7 is not
    assert held.found.error == 0
    small = Settled(monkeypatch, lambda _, count: 0.05 + 3 * 0.1**count, **chosen)
    assert small.numbers == [3] * 10  # 2.7e-8 is below 1.05e-7, and 2.7e-7 is not
    assert held.begun == ["known" in chosen] * 2


def test_one_rough_pass_is_enough_from_a_known_start_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    rough = Settled(monkeypatch, lambda _, count: 1.0 / (1 + count), known=2, nearly=True)
    assert (rough.numbers, rough.nearly, rough.found.torque) == ([2], [True], 1.0)
    assert not any(Settled(monkeypatch, lambda _number, _pass: 1.0, nearly=True).nearly)


def test_balls_that_skid_have_no_start_for_the_next_point(monkeypatch: pytest.MonkeyPatch) -> None:
    skids = Settled(monkeypatch, lambda _number, _pass: 1.0, end=Round(SKIDS, 3, 0.1, 1e-7), known=2)
    assert (skids.numbers, skids.ring.passes, skids.left, skids.found.torque) == ([2], 0, 0, 0.0)
    assert skids.found.round.end == SKIDS


def test_a_torque_that_moves_on_after_the_estimate_is_compared_with_another_quadrature(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """With 32 strips it is thought to err by 0.0256, and then its own laws move it by 0.06."""

    def torque(number: int, count: int) -> float:
        return {1: 1.0, 2: 1.0 if count == 1 else 1.06, 3: 1.058}[number]

    moved = Settled(monkeypatch, torque, allowed=0.021)
    assert moved.numbers == [1, 2, 2, 2, 3, 3]
    assert np.isnan(moved.balls["given"][:, 0]).all()
    assert moved.found.error == pytest.approx(max(2 * 0.002, 0.004 * 1.058 + 2e-5 * 1.358), rel=1e-12)
    loose = Settled(monkeypatch, torque, allowed=0.1)  # twice what it moved is less than that
    assert loose.numbers == [1, 2, 2, 2]
    assert loose.found.error == pytest.approx(2 * 0.06, rel=1e-9)


def test_a_torque_that_moves_by_less_than_its_error_keeps_it(monkeypatch: pytest.MonkeyPatch) -> None:
    moved = Settled(monkeypatch, lambda _, count: 1.0 if count < 2 else 1.02, allowed=0.03)
    assert moved.numbers == [1, 2, 2, 2]
    assert moved.found.error == pytest.approx(0.025 + 5e-4 * 1.3, rel=1e-12)


def test_the_last_quadrature_ends_a_comparison_that_does_not_agree(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its own laws move the torque by 0.3, and the quadrature before it settles elsewhere."""

    def torque(number: int, count: int) -> float:
        return 1.3 if number == 5 and count > 4 else 1.0 + 0.5**number

    far = Settled(monkeypatch, torque, allowed=1e-3)
    assert far.numbers == [1, 2, 3, 4, 5, 5, 5, 4, 4, 5, 5]
    assert far.found.error == pytest.approx(2 * (1.3 - 1.0625), rel=1e-9)


def test_passes_that_never_settle_err_by_what_they_moved(monkeypatch: pytest.MonkeyPatch) -> None:
    """Since the estimate, which two quadratures that agree made."""
    swinging = Settled(monkeypatch, lambda _, count: 1.0 if count < 2 else 1.0 + 0.1 * (count % 3), allowed=0.5)
    assert len(swinging.numbers) == passes.MOST_PASSES
    assert swinging.found.error == pytest.approx(2 * 0.2, rel=1e-9)


def passed(
    patch: pytest.MonkeyPatch, residual: float, *, number: int = 2, nearly: bool = False, end: int = SETTLED,
    turned: float = 0.0, is_ring: bool | None = None,
) -> tuple[Round, float, list[Any], list[str], Records]:  # fmt: skip
    """One pass whose rounds leave this residual; turning on leaves `turned`. Also nodes, what was called, and balls."""
    called, nodes, balls = [], [], ball_states(3).view(np.recarray)

    def settle(name: str) -> Callable[..., Round]:
        def rounds(*given: Any) -> Round:
            called.append(name)
            nodes.append(given[-1])
            for ball in balls:
                ball.residual = residual
            return Round(end, 4, 1e-7, given[-1].steady)

        return rounds

    def turn(*_: Any) -> float:
        called.append("turned on")
        return turned

    patch.setattr(passes, "settle_free_ring", settle("ring"))
    patch.setattr(passes, "settle_free_thrust", settle("thrust"))
    patch.setattr(passes, "turn_ball", turn)
    patch.setattr(passes, "_hold_laws", lambda *given: 0.011 + 0.001 * given[4])
    model: Any = SimpleNamespace(
        ring=SimpleNamespace(bearing=SimpleNamespace(ball_count=12)), free=None, quadratures="abcdef"
    )
    ring = SimpleNamespace(load=[31.0])
    one_pass = unwrap(passes._one_pass)
    found, other = one_pass(model, 1.0, None, ring, balls, [0, 1, 2], number, nearly, is_ring)
    return found, other, nodes, called, balls


def test_a_pass_turns_balls_on_until_they_are_as_steady_as_it_asks(monkeypatch: pytest.MonkeyPatch) -> None:
    found, other, (nodes,), called, balls = passed(monkeypatch, 2 * ACCURACY, turned=0.7 * ENOUGH)
    assert (nodes.coarse, nodes.fine, nodes.steady, nodes.accuracy) == ("b", "c", STEADY, passes.FIRST)
    assert called == ["thrust", *["turned on"] * 3]
    assert found.end == SETTLED
    np.testing.assert_array_equal(balls["residual"], 0.7 * ENOUGH)
    assert other == pytest.approx(4 * (0.011 + 0.012 + 0.013), rel=1e-12)  # each stands for four
    assert np.isnan(balls["gave"]).all()
    assert np.isnan(balls["left"]).all()
    assert passed(monkeypatch, 0.5 * ACCURACY, is_ring=True)[3] == ["ring"]
    assert passed(monkeypatch, 0.5 * ACCURACY, is_ring=False)[3] == ["thrust"]
    first = passed(monkeypatch, 0.5 * ACCURACY, number=1)[2][0]
    assert (first.steady, first.accuracy) == (ROUGHLY_STEADY, passes.FIRST)
    rough = passed(monkeypatch, 0.9 * passes.NEARLY, nearly=True)
    assert (rough[2][0].steady, rough[2][0].accuracy, rough[3]) == (ROUGHLY_STEADY, passes.NEARLY, ["thrust"])


def test_balls_that_do_not_come_to_rest_skid_unless_their_rounds_have_failed(monkeypatch: pytest.MonkeyPatch) -> None:
    assert passed(monkeypatch, 2e-9, turned=1.1 * ENOUGH)[0] == Round(SKIDS, 4, 1.1 * ENOUGH, ENOUGH)
    assert passed(monkeypatch, 2e-9, turned=np.nan)[0].end == SKIDS
    assert passed(monkeypatch, 2e-9, turned=1.1 * ENOUGH, end=OPEN)[0].end == OPEN
    rough = passed(monkeypatch, 1.1 * passes.NEARLY, turned=0.9 * passes.NEARLY, nearly=True)
    assert rough[0].end == SETTLED
    assert passed(monkeypatch, 1.0, turned=1.1 * passes.NEARLY, nearly=True)[0].end == SKIDS


@pytest.mark.parametrize("spin_alone", [False, True])
def test_each_ball_stands_for_those_that_are_alike(monkeypatch: pytest.MonkeyPatch, spin_alone: bool) -> None:
    monkeypatch.setattr(passes, "put_motion", lambda *_: None)
    monkeypatch.setattr(passes, "free_motion", lambda *_: None)
    contacts = contact_states(3).view(np.recarray)
    contacts["power"], contacts["spin_power"] = [[1, 2], [3, 5], [7, 11]], [[0.5, 0.25], [1, 2], [3, 4]]
    bearing: Any = SimpleNamespace(ball_count=12, ball_radius=4e-3)
    torque, spin = unwrap(passes._slid)(bearing, ball_states(3).view(np.recarray), contacts, spin_alone)
    assert spin == pytest.approx(4 * 10.75)
    assert torque == pytest.approx(4 * (10.75 if spin_alone else 29.0))
