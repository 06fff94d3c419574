"""A user's own law of traction: a function f and its table.

    tau = min(tau_E f(x), zeta p),  x = eta v/(h tau_E)
f(0) = 0, f has the slope 1 at 0 and never falls.
"""

import hashlib
from collections.abc import Callable

import numpy as np

from analytic.errors import InputError
from analytic.numerics.cubic import Pieces, cubic_at, monotone_cubic
from analytic.oil.law_table import COLUMNS
from analytic.scene import Array, OwnTraction

FIRST, LAST = 1e-6, 1e30  # rates x of the table; those of contacts in oil are below 1e20
ACCURACY = 1e-5  # relative, of the table against the function: a thousandth of the scatter of traction tests
SLOPE_ERROR = 1e-3  # of f(x)/x at FIRST
ROUND_OFF = 1e-12  # relative, by which values of a function that never falls may fall
WIDEST, NARROWEST = 0.5, 1e-6  # pieces of ln x; a kink needs some 1e-5, where it misses ACCURACY/2 at most
MOST_ROWS = 4000  # a kink takes some 50, a smooth law some 200


def own_traction(
    name: str, function: Callable[[float], float], *, distribution: str = "", version: str = ""
) -> OwnTraction:
    """A law of traction from a function, for `Lubricant.traction`.

    Parameters
    ----------
    name : str
        Of the law, for results.
    function : callable
        f(x), dimensionless: shear stress over `eyring_stress` at the rate x, which is the Newtonian shear stress over
        `eyring_stress`. It takes one float and gives one.
    distribution, version : str
        Of the package that has it; empty: none.

    Returns
    -------
    OwnTraction
        With a table of the function, whose error is at most 1e-5.

    Raises
    ------
    InputError
        A function that fails, gives no finite number, falls, jumps, is not 0 at rest, or has another slope than 1
        there.
    """
    table = law_table(name, function)
    text = ";".join(f"{row[0]:.9g},{row[4]:.9g}" for row in table[1:])  # alike on machines that round differently
    digest = hashlib.sha256(text.encode()).hexdigest()
    return OwnTraction(name=name, sha256=digest, distribution=distribution, version=version, rows=table)


def law_table(name: str, function: Callable[[float], float]) -> Array:
    """(rows, COLUMNS) for `analytic.oil.law_table`. Raises InputError as `own_traction`."""
    if not _value(name, function, 0.0) == 0.0:
        raise InputError(f"law of traction {name}: f(0) = {_value(name, function, 0.0):.6g}; give a law with f(0) = 0")
    slope = _value(name, function, FIRST) / FIRST
    if not abs(slope - 1) <= SLOPE_ERROR:
        raise InputError(
            f"law of traction {name}: f(x)/x = {slope:.6g} at x = {FIRST:g}; give a law with the slope 1 at rest, "
            "where oil has its Newtonian viscosity"
        )
    known: dict[float, float] = {}  # ln f by ln x

    def logs_at(places: Array) -> Array:
        for place in places.tolist():
            if place not in known:
                known[place] = _logarithm(name, function, float(np.exp(place)))
        return np.array([known[place] for place in places.tolist()])

    places = np.linspace(np.log(FIRST), np.log(LAST), 1 + int(np.ceil(np.log(LAST / FIRST) / WIDEST)))
    while True:
        cubic = monotone_cubic(places, logs_at(places))
        between = (places[:-1, None] + np.diff(places)[:, None] * [0.25, 0.5, 0.75]).ravel()
        misses = (
            np.abs(np.expm1(cubic_at(cubic, Pieces(0, len(cubic)), between)[0] - logs_at(between))) > ACCURACY / 2
        )  # between these places too
        _require_rising(name, known)
        if not misses.any():
            return _with_ends(cubic, places[-1], known[float(places[-1])])
        halved = misses.reshape(-1, 3).any(axis=1)
        if len(places) > MOST_ROWS or np.diff(places)[halved].min() < NARROWEST:
            raise InputError(
                f"law of traction {name}: no table of {MOST_ROWS} numbers follows it to {ACCURACY:g}, first near x = "
                f"{float(np.exp(between[misses][0])):.4g}; give a law without jumps"
            )
        places = np.union1d(places, between.reshape(-1, 3)[halved, 1])


def _value(name: str, function: Callable[[float], float], rate: float) -> float:
    try:
        with np.errstate(all="ignore"):  # what is not finite is refused
            value = float(function(rate))
    except Exception as problem:  # a function of the user's may raise anything
        raise InputError(
            f"law of traction {name}: f({rate:.4g}) raises {in_words(problem)}; give a function of one float from 0 to "
            f"{LAST:g}"
        ) from problem
    if not np.isfinite(value):
        raise InputError(
            f"law of traction {name}: f({rate:.4g}) = {value}; give a law that is finite from 0 to {LAST:g}"
        )
    return value


def _logarithm(name: str, function: Callable[[float], float], rate: float) -> float:
    value = _value(name, function, rate)
    if not value > 0:
        raise InputError(
            f"law of traction {name}: f({rate:.4g}) = {value:.6g}; give a law that is positive above x = 0"
        )
    return float(np.log(value))


def _require_rising(name: str, known: dict[float, float]) -> None:
    places = np.array(sorted(known))
    logs = np.array([known[place] for place in places.tolist()])
    falls = np.flatnonzero(np.diff(logs) < -ROUND_OFF)
    if falls.size:
        (slow, fast), (more, less) = np.exp(places[falls[0] :][:2]), np.exp(logs[falls[0] :][:2])
        raise InputError(
            f"law of traction {name}: f falls from {more:.6g} at x = {slow:.4g} to {less:.6g} at x = {fast:.4g}; give "
            "a law that never falls"
        )


def _with_ends(cubic: Array, last: float, log_stress: float) -> Array:
    """The cubic between a straight line of slope 1 and one of its own last slope, below the number of rows."""
    power = max(cubic_at(cubic, Pieces(0, len(cubic)), last)[1], 0.0)
    first = [cubic[0, 0], 0.0, 0.0, 1.0, cubic[0, 4]]
    pieces = np.vstack([first, cubic, [last, 0.0, 0.0, power, log_stress]])
    table = np.zeros((len(pieces) + 1, COLUMNS))
    table[0, 0] = len(table)
    table[1:, :5] = pieces
    table[1:, 5], table[1:, 6] = np.exp(pieces[:, 0]), np.exp(pieces[:, 4])
    return table


def in_words(problem: Exception) -> str:
    """An exception in one line: its class and its text."""
    return f"{type(problem).__name__}: {' '.join(str(problem).split())[:200]}".rstrip(": ")
