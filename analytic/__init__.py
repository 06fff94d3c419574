"""The production model: friction torque of a ball bearing from closed forms.

    import analytic
    scene = analytic.load_scene("bearing.toml")
    torque = analytic.friction_torque(scene).torque

`__init__.pyi` lists the names. Each is imported on first use, so that a program pays only for what it calls.
"""

from lazy_loader import attach_stub

_named, __dir__, __all__ = attach_stub(__name__, __file__)


def __getattr__(name: str) -> object:
    if name == "__version__":
        from importlib.metadata import version  # slow to import

        return version("fembearing")
    return _named(name)
