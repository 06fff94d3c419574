"""fembearing checks the closed forms of ball-bearing contact against finite elements.

    import analytic, fembearing
    scene = analytic.load_scene("bearing.toml")
    contact = fembearing.solve_contact(scene, pair="inner")
    series = fembearing.solve_load_series(scene, pair="inner", loads=[10.0, 100.0, 1000.0])
    result = fembearing.validate(scene, out="report-folder")
    found = fembearing.run_sweep("map.toml", out="map-folder").dataset()

Names are imported on first use, so that a program pays only for what it calls.
"""

from importlib import import_module
from importlib.metadata import version
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from fembearing.compare.contact.discrepancy import ContactSolution, solve_contact
    from fembearing.compare.contact.load_series import LoadSeries, solve_load_series
    from fembearing.compare.validation import Validation
    from fembearing.report.folder import validate
    from fembearing.sweep.run import Sweep, run_sweep

    __version__: str

__all__ = [
    "ContactSolution",
    "LoadSeries",
    "Sweep",
    "Validation",
    "__version__",
    "run_sweep",
    "solve_contact",
    "solve_load_series",
    "validate",
]

_HOME = {
    "ContactSolution": "fembearing.compare.contact.discrepancy",
    "LoadSeries": "fembearing.compare.contact.load_series",
    "Sweep": "fembearing.sweep.run",
    "Validation": "fembearing.compare.validation",
    "run_sweep": "fembearing.sweep.run",
    "solve_contact": "fembearing.compare.contact.discrepancy",
    "solve_load_series": "fembearing.compare.contact.load_series",
    "validate": "fembearing.report.folder",
}


def __getattr__(name: str) -> Any:
    if name == "__version__":
        return version("fembearing")
    if name in _HOME:
        return getattr(import_module(_HOME[name]), name)
    raise AttributeError(f"module 'fembearing' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
