"""fembearing checks the closed forms of ball-bearing contact against finite elements.

    import analytic, fembearing
    scene = analytic.load_scene("bearing.toml")
    contact = fembearing.solve_contact(scene, pair="inner")
    series = fembearing.solve_load_series(scene, pair="inner", loads=[10.0, 100.0, 1000.0])
    result = fembearing.validate(scene, out="report-folder")
    found = fembearing.compare_measured(scene, "data.csv")
    dataset = fembearing.run_sweep("map.toml", out="map-folder").to_dataset()
    fembearing.export("bearing.toml", to="fmu", out="bearing.fmu", over={"radial_load": "500 N to 5 kN in 7 log"})

`__init__.pyi` lists the names. Each is imported on first use, so that a program pays only for what it calls.
"""

from lazy_loader import attach_stub

_named, __dir__, __all__ = attach_stub(__name__, __file__)


def __getattr__(name: str) -> object:
    if name == "__version__":
        from importlib.metadata import version  # slow to import

        return version("fembearing")
    try:
        return _named(name)
    except ModuleNotFoundError as problem:
        from analytic.errors import BROUGHT_BY, MissingPackageError

        if problem.name not in BROUGHT_BY:
            raise
        raise MissingPackageError(f"fembearing.{name}", problem.name) from problem
