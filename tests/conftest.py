"""Settings and shared solves of the whole test run.

On the gate (CI is set) property tests draw the same examples every time, so that a failure is caused by the change
under test. Elsewhere they draw new ones, and a failure prints the blob that reproduces it.
"""

import os
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

import pytest
from hypothesis import settings

if TYPE_CHECKING:
    from analytic.scene import Contact
    from fembearing.check.contact.solution import ContactSolution
    from fembearing.check.validation import Validation
    from fembearing.mesh.recipe import Recipe

# Before NumPy loads: workers already use all cores, and last digits of a page depend on the number of threads.
os.environ.setdefault("OMP_NUM_THREADS", "1")

SHARE_CHECKED = (  # files and folders of tests that use `checked` or `cut_contact`, which take six seconds each
    "tests/report/",
    "tests/fem/test_shoulder.py",
    "tests/test_brief.py",
    "tests/check/contact/test_solution.py",
    "tests/check/test_validation.py",
)
PROFILE = "gate" if os.environ.get("CI") else "explore"

# No deadline: the first call of a compiled kernel takes seconds, later ones microseconds.
settings.register_profile("explore", deadline=None, print_blob=True)
settings.register_profile("gate", deadline=None, print_blob=True, derandomize=True)
settings.load_profile(PROFILE)


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--renew", action="store_true", help="write the golden texts of tests/report/golden again")


def pytest_report_header() -> str:
    return f"hypothesis profile: {PROFILE}"


@pytest.hookimpl(optionalhook=True)  # of pytest-xdist
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """Tests that share a solve run on one worker: those of a file, and those of SHARE_CHECKED."""
    if config.getvalue("dist") != "load":  # the user chose another distribution
        return None
    from xdist.scheduler import LoadScopeScheduling

    class SharedSolves(LoadScopeScheduling):
        def _split_scope(self, nodeid: str) -> str:
            return "checked" if nodeid.startswith(SHARE_CHECKED) else nodeid.partition("::")[0]

    return SharedSolves(config, log)


@pytest.fixture(scope="session")
def contacts() -> "dict[str, Contact]":
    """The race contacts of a 6205."""
    from tests.contacts import CONTACTS  # it loads NumPy: not before the threads are set

    return CONTACTS


@pytest.fixture(scope="session")
def cut_contact(contacts: "dict[str, Contact]") -> "ContactSolution":
    """Half a contact on three meshes: its shoulder cuts it off, Hertz's semi-axis would be 0.946 mm."""
    from fembearing.check.contact.solution import compare_contact

    narrow = replace(contacts["inner"], shoulder=0.8e-3)
    return compare_contact(narrow, recipe=shallow_recipe("race"), tolerance=0.9)


def shallow_recipe(name: str) -> "Recipe":
    """Meshes of half the cells or fewer: one layer of cells below and around the contact where the recipe has more."""
    from fembearing.mesh.recipe import load_recipe

    recipe = load_recipe(name)
    cells = recipe.cells
    return replace(recipe, cells=replace(cells, depth=min(cells.depth, 1), outside=min(cells.outside, 1)))


@pytest.fixture(scope="session")
def shallow() -> "Callable[[str], Recipe]":
    """Loads a recipe of few cells, for tests whose assertions do not depend on the accuracy of the mesh."""
    return shallow_recipe


class Checked(NamedTuple):
    validation: "Validation"
    shares: list[float]  # that its progress told


@pytest.fixture(scope="session")
def checked_with_progress(shallow: "Callable[[str], Recipe]") -> Checked:
    """The built-in scene, checked on coarse meshes with a tolerance that needs no finer one."""
    from analytic.scenefile.read import load_scene
    from fembearing.check.contact import scene_contact
    from fembearing.check.validation import check_scene

    shares: list[float] = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(scene_contact, "load_recipe", shallow)
        scene = load_scene("6205-dry")
        return Checked(check_scene(scene, tolerance=0.9, progress=lambda share, _: shares.append(float(share))), shares)


@pytest.fixture(scope="session")
def checked(checked_with_progress: Checked) -> "Validation":
    return checked_with_progress.validation


class Result(NamedTuple):
    status: int
    out: str
    err: str


@pytest.fixture
def command(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch):
    """Runs the command line with these arguments, in this process."""
    from fembearing import cli

    def run(*arguments: str) -> Result:
        monkeypatch.setattr("sys.argv", ["fembearing", *arguments])
        with pytest.raises(SystemExit) as stop:
            cli.main()
        captured = capsys.readouterr()
        return Result(int(stop.value.code or 0), captured.out, captured.err)

    return run
