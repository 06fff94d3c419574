"""Torques that the scene declares: added, listed, and no part of what the races lose."""

from dataclasses import replace

import numpy as np
import pytest

from analytic import catalog
from analytic.errors import InputError
from analytic.scene import Losses, Operation, Scene
from analytic.scenefile.read import load_scene, parse_scene
from analytic.torque import friction_torque
from tests.analytic.specimens import present


@pytest.fixture(scope="module")
def scene() -> Scene:
    """At 500 and 900 N."""
    series = Operation(axial_load=np.array([500.0, 900.0]), inner_speed=np.array([31.0, 47.0]))
    return replace(load_scene("6205-dry"), operation=series)


def test_declared_losses_are_added_and_listed(scene: Scene) -> None:
    plain = friction_torque(scene)
    assert plain.torque.declared is None
    both = friction_torque(replace(scene, losses=Losses(seals=5e-3, drag=2e-3)))
    np.testing.assert_allclose(present(both.torque.declared), 7e-3, rtol=1e-15)
    np.testing.assert_allclose(both.torque.total - plain.torque.total, 7e-3, rtol=1e-13)  # round-off
    np.testing.assert_array_equal(both.torque.race, plain.torque.race)
    # what is not known of the race is less of the total
    np.testing.assert_allclose(
        both.numerical_uncertainty * both.torque.total, plain.numerical_uncertainty * plain.torque.total, rtol=1e-13
    )
    told = {effect.name: effect for effect in both.effects}
    assert (told["seals"].decision, told["seals"].reason) == ("on", "declared by the scene")
    assert told["drag"].share == pytest.approx(2e-3 / both.torque.total[0], rel=1e-13)  # least torque at the light load
    assert told["spin"].share == np.max(present(both.torque.spin) / both.torque.total)
    one = friction_torque(replace(scene, losses=Losses(drag=0.0)))
    told = {effect.name: effect for effect in one.effects}
    assert (told["seals"].decision, told["seals"].share, told["seals"].reason) == ("off", None, "not declared")
    assert (told["drag"].decision, told["drag"].share) == ("on", 0.0)
    np.testing.assert_array_equal(present(one.torque.declared), 0.0)


def test_a_scene_file_declares_losses() -> None:
    text = catalog.path("scenes", "6205-dry").read_text("utf-8")
    found = parse_scene(text + '\n[losses]\nseals = "5 N mm"\ndrag = "0.3 N cm"\n', origin="here")
    assert found.losses == Losses(seals=5e-3, drag=3e-3)
    assert parse_scene(text, origin="here").losses == Losses()
    for line, words in (
        ('seals = "-5 N mm"', r"losses\.seals = '-5 N mm' is out of range"),
        ("seals = 5", r"losses\.seals = 5 has no unit"),
        ('seal = "5 N mm"', r"losses\.seal = '5 N mm' is an unknown key; did you mean seals"),
        ('drag = "5 N"', r"losses\.drag = '5 N' is not in a unit like N m"),
    ):
        with pytest.raises(InputError, match=words):
            parse_scene(f"{text}\n[losses]\n{line}\n", origin="here")


def test_a_negative_loss_is_refused(scene: Scene) -> None:
    with pytest.raises(InputError, match=r"losses\.drag must be at least 0"):
        friction_torque(replace(scene, losses=Losses(drag=-1e-3)))
