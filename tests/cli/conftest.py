"""Fixtures of the tests of the command line; the sweep command runs on the grids of the sweep's own tests."""

from collections.abc import Callable

import pytest

from fembearing.check.contact import scene_contact
from fembearing.mesh.recipe import Recipe
from tests.sweep.conftest import grid_file, in_process

__all__ = ["coarse", "grid_file", "in_process"]


@pytest.fixture
def coarse(shallow: Callable[[str], Recipe], monkeypatch: pytest.MonkeyPatch) -> None:
    """Contacts are solved on meshes of few cells, for tests whose assertions do not depend on the accuracy."""
    monkeypatch.setattr(scene_contact, "load_recipe", shallow)
