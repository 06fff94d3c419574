"""The sheet around a cage pocket: its place, its rim, its volume."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact.geometry import pocket_contact
from analytic.errors import InputError
from analytic.scene import Contact
from fembearing.mesh.pair import pair_mesh
from fembearing.mesh.quality import mesh_quality
from fembearing.mesh.recipe import load_recipe
from tests.analytic.specimens import BEARING_6205, STAMPED_CAGE

CAGE = replace(STAMPED_CAGE, pocket_depth=3.9e-3)


def pocket(load: float = 28.0, **changed: object) -> Contact:
    return pocket_contact(BEARING_6205, replace(CAGE, **changed), load=load)


@pytest.mark.parametrize("level", [1, 2, 3])
def test_the_sheet_lies_between_two_spheres_and_is_held_at_its_rim(level: int) -> None:
    contact = pocket()
    body = pair_mesh(contact, recipe=load_recipe("wall"), level=level, semi_axes=(0.31e-3, 0.31e-3)).lower
    place = body.mesh.doflocs
    radius = np.linalg.norm(place - np.array([[0.0], [0.0], [4.07e-3]]), axis=0)
    np.testing.assert_allclose(radius[body.surface], 4.07e-3, rtol=1e-12)  # round-off
    assert radius.max() == pytest.approx(4.97e-3, rel=1e-12)
    rim = (4.07e-3 - place[2, body.clamped]) / radius[body.clamped]  # the cosine of the angle from the pole
    np.testing.assert_allclose(rim, (4.07e-3 - 3.9e-3) / 4.07e-3, atol=1e-12)
    assert body.far.size == 0


def test_volume_of_the_sheet_converges_to_that_between_the_spheres() -> None:
    contact = pocket()
    exact = 2 * np.pi / 3 * (4.97e-3**3 - 4.07e-3**3) * (3.9 / 4.07) / 4
    errors = []
    for level in (1, 2, 4):
        body = pair_mesh(contact, recipe=load_recipe("wall"), level=level, semi_axes=(0.31e-3, 0.31e-3)).lower
        quality = mesh_quality(body.mesh)
        assert quality.valid
        errors.append(abs(quality.volume / exact - 1))
    assert errors[2] < errors[1] < errors[0] < 0.01
    assert errors[2] < 1e-4


def test_a_contact_that_reaches_the_rim_is_refused() -> None:
    with pytest.raises(InputError, match=r"pocket: 28 N .* past the rim .* raise cage\.pocket_depth"):
        pair_mesh(pocket(pocket_depth=0.03e-3), recipe=load_recipe("wall"), level=1, semi_axes=(0.4e-3, 0.4e-3))
