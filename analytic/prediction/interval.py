"""The 95 % interval of sampled quantities, with the standard error of its ends.

The regression is a control variate: its distribution is known from very many points, and the samples only correct it.
The share of values below q is that of the regression, plus the mean over the samples of what they and their own
left-out predictions differ by. So the interval does not rest on the regression being right; a good one makes it exact.
"""

import numpy as np
from scipy.special import ndtri
from scipy.stats import qmc

from analytic.prediction.regression import Regression
from analytic.prediction.rows import ENDS, Interval
from analytic.scene import Array

POINTS = 2**13  # of the regression
STEP = 0.01  # in probability, for the density at an end
SEED = 1  # of the regression's points, the same for every scene


def least_samples(inputs: int) -> int:
    """The number of samples of which one is expected beyond each end, and two for each coefficient of a linear fit."""
    return max(round(1 / ENDS[0]), 2 * (inputs + 1))


def normal_points(inputs: int) -> Array:
    """(POINTS, inputs) scores, evenly spread."""
    return ndtri(qmc.Sobol(inputs, rng=np.random.default_rng(SEED)).random(POINTS))


def interval_of(regression: Regression, scores: Array, values: Array) -> Interval:
    """The interval of the quantities of a regression.

    scores : normal_points;  values : (N, n) samples that the regression was fitted to
    """
    found, smooth = [], np.sort(regression.at(scores), axis=0)
    for own, predicted, many in zip(values.T, regression.left_out.T, smooth.T, strict=True):
        (low, low_error), (median, _), (high, high_error) = (
            _quantile(share, many, own, predicted) for share in (ENDS[0], 0.5, ENDS[1])
        )
        found.append((low, median, high, low_error, high_error))
    names = ("low", "median", "high", "low_error", "high_error")
    return Interval(**dict(zip(names, np.array(found).T, strict=True)))


def _quantile(share: float, smooth: Array, own: Array, predicted: Array) -> tuple[float, float]:
    """The value below which that share lies, and its standard error.

    smooth : (POINTS,) the regression, sorted;  own, predicted : (N,) samples, and their left-out predictions
    """
    if np.ptp(own) == 0:
        return float(own[0]), 0.0
    count = own.size
    places = np.concatenate([smooth, own, predicted])
    weights = np.concatenate(
        [np.full(smooth.size, 1 / smooth.size), np.full(count, 1 / count), np.full(count, -1 / count)]
    )
    order = np.argsort(places, kind="stable")
    below = np.cumsum(weights[order])
    # The correction can make it fall a little: it lies between the least rising one above and the largest below it.
    below = (np.maximum.accumulate(below) + np.minimum.accumulate(below[::-1])[::-1]) / 2
    place = min(int(np.searchsorted(below, share)), order.size - 1)
    value = float(places[order[place]])
    # Samples that lie on one side of q and are predicted on the other; one more, as none found does not mean none.
    crossed = np.count_nonzero((own < value) != (predicted < value)) + 1
    # The density at q is that of the regression with what it misses.
    whole = smooth + np.resize(own - predicted, smooth.size)
    edges = np.quantile(whole, (share - STEP, share + STEP))
    slope = float(edges[1] - edges[0]) / (2 * STEP)
    return value, slope * np.sqrt(crossed) / count
