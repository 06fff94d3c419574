"""Solvers and kept topologies of a test."""

from collections import OrderedDict

import pytest

from fembearing.fem import factor, topology


@pytest.fixture
def nothing_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    """No test before has left a topology."""
    monkeypatch.setattr(topology, "_kept", OrderedDict())


@pytest.fixture(params=["as installed", "scipy"])
def solver(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch, nothing_kept: None) -> None:  # noqa: ARG001
    """The factorisation is that of the installed PARDISO, if any, or that of SciPy."""
    if request.param == "scipy":
        monkeypatch.setattr(factor, "PardisoSolver", None)
