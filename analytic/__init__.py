"""The production model: friction torque of a ball bearing from closed forms.

    import analytic
    scene = analytic.load_scene("bearing.toml")
    torque = analytic.friction_torque(scene).torque

Names are imported on first use, so that a program pays only for what it calls.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from analytic.contact.hertz import hertz_contact
    from analytic.loads.finite_geometry import thrust_correction
    from analytic.loads.ring import ring_equilibrium
    from analytic.loads.thrust import thrust_equilibrium
    from analytic.scenefile.read import load_scene
    from analytic.torque import friction_torque

    __version__: str

__all__ = [
    "__version__",
    "friction_torque",
    "hertz_contact",
    "load_scene",
    "ring_equilibrium",
    "thrust_correction",
    "thrust_equilibrium",
]

_HOME = {
    "friction_torque": "analytic.torque",
    "hertz_contact": "analytic.contact.hertz",
    "load_scene": "analytic.scenefile.read",
    "ring_equilibrium": "analytic.loads.ring",
    "thrust_correction": "analytic.loads.finite_geometry",
    "thrust_equilibrium": "analytic.loads.thrust",
}


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version

        return version("fembearing")
    if name in _HOME:
        return getattr(import_module(_HOME[name]), name)
    raise AttributeError(f"module 'analytic' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
