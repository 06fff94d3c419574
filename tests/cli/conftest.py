"""What the tests of the command line share."""

from collections.abc import Callable

import pytest

from fembearing.compare.contact import discrepancy
from fembearing.mesh.recipe import Recipe


@pytest.fixture
def coarse(shallow: Callable[[str], Recipe], monkeypatch: pytest.MonkeyPatch) -> None:
    """Contacts are solved on meshes of few cells, for tests whose assertions do not depend on the accuracy."""
    monkeypatch.setattr(discrepancy, "load_recipe", shallow)
