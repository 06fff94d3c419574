"""One check of the built-in scene for all tests of the report, on as few meshes as there may be."""

import pytest

from analytic.scenefile import builtin_scene, load_scene
from fembearing.compare.validation import Validation, check_scene

LOOSE = 0.9  # tolerance: no finer mesh is called for


@pytest.fixture(scope="session")
def checked() -> Validation:
    return check_scene(load_scene(builtin_scene("6205")), tolerance=LOOSE)
