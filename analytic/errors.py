"""Errors that a user can act on; any other exception is a bug in fembearing."""

from importlib.util import find_spec
from numbers import Integral

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.given import has_unit, why_no_unit

# Modules that not every installation has: the package of each, and the extra of fembearing that has it.
BROUGHT_BY = {
    "skfem": ("scikit-fem", "check"),
    **{name: (name, "check") for name in ("jinja2", "matplotlib", "meshio", "openpyxl", "pyvista", "threadpoolctl")},
    **{name: (name, "sweep") for name in ("dask", "distributed", "netCDF4", "pandas", "xarray")},
    **dict.fromkeys(("nicegui", "fastapi", "starlette"), ("nicegui", "app")),
    "SurfaceTopography": ("SurfaceTopography", "profilometer"),
    **dict.fromkeys(("numba", "llvmlite"), ("numba", "jit")),
    "elftools": ("pyelftools", "jit"),
}


class FembearingError(Exception):
    """Base class; the command line prints these errors without a traceback."""


class InputError(FembearingError, ValueError):
    """A value that the model cannot accept."""


class StorageError(FembearingError):
    """A file or stream that cannot be written or read, through no fault of its name: the disk is full, or gone."""


class ResourceError(FembearingError):
    """Memory or processes that the system does not give."""


class MissingPackageError(FembearingError, ImportError):
    """A package that this installation left out."""

    def __init__(self, purpose: str, module: str) -> None:
        """purpose : what needs it; module : a key of `BROUGHT_BY`"""
        package, extra = BROUGHT_BY[module]
        super().__init__(f'{purpose} needs {package}: pip install ".[{extra}]" in the folder of fembearing')


class ConvergenceError(FembearingError):
    """An iteration that did not converge; its numbers are attributes."""

    def __init__(
        self,
        *,
        iterations: int,
        residual: float,
        tolerance: float,
        unit: str = "N",
        problem: str = "contact",
        remedy: str = "Use more load steps or refine the contact zone.",
    ) -> None:
        self.iterations, self.residual, self.tolerance = iterations, residual, tolerance
        super().__init__(
            f"{problem} did not converge in {iterations} iterations: residual {residual:.1e} {unit}, "
            f"tolerance {tolerance:.1e} {unit}. {remedy}"
        )


class SingularError(ConvergenceError):
    """Equations that cannot be solved: there was no iteration."""

    def __init__(self, *, problem: str, remedy: str) -> None:
        self.iterations, self.residual, self.tolerance = 0, np.inf, 0.0
        FembearingError.__init__(self, f"{problem}. {remedy}")


def require_packages(purpose: str, *modules: str) -> None:
    """Raise MissingPackageError unless all these keys of `BROUGHT_BY` are installed; purpose : what needs them."""
    for module in modules:
        if find_spec(module) is None:
            raise MissingPackageError(purpose, module)


# Formulas call these often with few numbers: the ends are fast, and comparisons with NaN fail. One number is no array.
FEW = 4  # numbers that are compared faster one by one


def require_finite(**values: ArrayLike) -> None:
    """Raise InputError unless every element is a finite number, of any sign."""
    for name, value in values.items():
        if type(value) is float and -np.inf < value < np.inf:
            continue
        array = real_numbers(name, value)
        if not all(-np.inf < each < np.inf for each in _ends(array)):
            _refuse(name, array, np.isfinite(array), "finite")


def require_positive(**values: ArrayLike) -> None:
    """Raise InputError unless every element is finite and above 0."""
    for name, value in values.items():
        if type(value) is float and 0.0 < value < np.inf:
            continue
        array = real_numbers(name, value)
        if not all(0 < each < np.inf for each in _ends(array)):
            _refuse(name, array, np.isfinite(array) & (array > 0), "positive and finite")


def require_non_negative(**values: ArrayLike) -> None:
    """Raise InputError unless every element is finite and at least 0."""
    for name, value in values.items():
        if type(value) is float and 0.0 <= value < np.inf:
            continue
        array = real_numbers(name, value)
        if not all(0 <= each < np.inf for each in _ends(array)):
            _refuse(name, array, np.isfinite(array) & (array >= 0), "at least 0 and finite")


def require_whole(*, low: int, **values: int | None) -> None:
    """Raise InputError unless every value is a whole number from `low`, or None."""
    for name, value in values.items():
        if value is not None and not (isinstance(value, Integral) and value >= low):
            raise InputError(f"{name} = {value!r:.80}: give a whole number from {low}, or leave it out")


def _ends(array: NDArray[np.float64]) -> list[float]:
    """Numbers that lie between limits if all do: the ends, or all of a few; NaN where one is NaN."""
    return array.ravel().tolist() if array.size <= FEW else [float(array.min()), float(array.max())]


def real_numbers(name: str, value: ArrayLike) -> NDArray[np.float64]:
    """The numbers as an array. Raises InputError for texts, complex numbers and numbers with a unit of their own."""
    if type(value) is float or (isinstance(value, np.ndarray) and value.dtype == np.float64):
        return np.asarray(value)
    if has_unit(value):
        raise InputError(why_no_unit(name, value))
    try:
        given = np.asarray(value)
        if given.dtype.kind in "US":  # "5" would be read as 5
            raise TypeError
        if given.dtype.kind != "c":
            return given.astype(np.float64)
    except (TypeError, ValueError, OverflowError) as problem:
        raise InputError(f"{name} must be a number or an array of numbers in SI units, got {value!r:.80}") from problem
    raise InputError(f"{name} must be a real number, got a complex one; check how it was computed")


def _refuse(name: str, array: NDArray[np.float64], holds: NDArray[np.bool_], limit: str) -> None:
    where = tuple(int(i) for i in np.argwhere(~holds)[0])
    place = f" at index {list(where)}" if where else ""
    raise InputError(f"{name} must be {limit}, got {float(array[where])!r}{place}; check its sign and its SI unit")
