"""The bearing that most of these tests use."""

import pytest

from analytic.scene import Bearing
from tests.analytic.specimens import BEARING_6205


@pytest.fixture(scope="session")
def bearing_6205() -> Bearing:
    return BEARING_6205
