"""Fixtures of the tests of ladders."""

import pytest

from fembearing.check.cost import cage_ladder, contact_ladder, ladder
from tests.conftest import quickly_timed


@pytest.fixture
def timed_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """The fewest timings of formulas and meshes."""
    monkeypatch.setattr(contact_ladder, "MESH_REPEATS", 1)
    quickly_timed(monkeypatch)
    monkeypatch.setattr(ladder, "FORMULA_REPEATS", 1)
    monkeypatch.setattr(cage_ladder, "SEEDS", 2)
    monkeypatch.setattr(cage_ladder, "DURATION", 6e-3)  # just longer than the cage takes to cross its pockets
