"""A user's law of traction as a table: tau = tau_E f(x), x = eta gamma/tau_E, with f of any increasing form.

f is a monotone cubic of ln f over ln x. Below the first rate f is proportional to x, and beyond the last one a power
of x. Eyring's law is f = asinh; formulas have that in closed form, without a table.
"""

import numpy as np

from analytic.numerics.compilation import compiled, rows_at
from analytic.numerics.cubic import Pieces, cubic_at
from analytic.numerics.elements import formula
from analytic.scene import Array, OwnTraction

# Columns after the five of a cubic: rate x and stress f where a piece begins. The first row holds the number of rows.
RATE, STRESS, COLUMNS = 5, 6, 7
FASTEST = 1e250  # rate of oil without a film
MOST_STEPS = 100  # 2 to 4 are usual; halving the bracket alone takes 30
LAST_STEP = 1e-7  # of ln x: the next one of Newton's method would be its square
_kept: dict[str, Array] = {}  # tables by their digest, whose addresses formulas hold


@compiled
def law_rows(law: float) -> Array:
    """The table of a law, (rows, COLUMNS); law : its address, not 0"""
    return rows_at(law, int(rows_at(law, 1, 1)[0, 0]), COLUMNS)


@formula
def flow_of(law: float, rate: float) -> tuple[float, float]:
    """f and f' at the rate x >= 0; law : address of a table."""
    rows = law_rows(law)
    if rate <= rows[1, RATE]:
        slope = rows[1, STRESS] / rows[1, RATE]
        return slope * rate, slope
    log_stress, power = cubic_at(rows, Pieces(1, rows.shape[0]), np.log(rate))
    stress = np.exp(log_stress)
    return stress, power * stress / rate


@compiled
def rate_of(law: float, share: float, softness: float, asked: float) -> float:
    """The rate x with share x + softness f(x) = asked; infinite where f stays below it and the share is 0.

    law : address of a table;  share : 0 or 1
    The pieces bracket ln x, in which Newton's method finds it.
    """
    rows = law_rows(law)
    count = rows.shape[0]
    if not asked > share * rows[1, RATE] + softness * rows[1, STRESS]:
        return asked / (share + softness * rows[1, STRESS] / rows[1, RATE])
    piece, beyond = 1, count
    while beyond - piece > 1:
        middle = (piece + beyond) // 2
        if share * rows[middle, RATE] + softness * rows[middle, STRESS] < asked:
            piece = middle
        else:
            beyond = middle
    low, power = rows[piece, 0], rows[piece, 3]
    if beyond < count:
        high = rows[beyond, 0]
    elif share > 0.0:
        high = np.log(asked / share)
    else:
        return np.exp(low + np.log(asked / (softness * rows[piece, STRESS])) / power) if power > 0.0 else np.inf
    at = (low + high) / 2.0
    for _ in range(MOST_STEPS):
        rate = np.exp(at)
        log_stress, power = cubic_at(rows, Pieces(piece, piece + 1), at)
        stress = np.exp(log_stress)
        whole = share * rate + softness * stress
        missing = np.log(asked / whole)
        if missing > 0.0:
            low = at
        else:
            high = at
        steepness = (share * rate + softness * stress * power) / whole
        then = at + missing / steepness if steepness > 0.0 else np.inf
        if not low <= then <= high:
            then = (low + high) / 2.0
        step, at = abs(then - at), then
        if step <= LAST_STEP:
            break
    return np.exp(at)


def kept_table(law: OwnTraction) -> Array:
    """The table of a law, one for all laws that are equal, which the process keeps."""
    return _kept.setdefault(law.sha256, np.ascontiguousarray(law.table, dtype=np.float64))


def law_address(law: object) -> float:
    """Address of the table of a law, for compiled formulas of this process; 0 for the name of a built-in law."""
    return float(kept_table(law).ctypes.data) if isinstance(law, OwnTraction) else 0.0
