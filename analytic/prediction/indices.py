"""Sobol indices: which share of the variance of the total each input makes, alone and with the others.

SciPy's estimator [Saltelli2010] takes the regression in place of the torque, so that the indices cost no evaluations.
The jackknife repeats them without each group of samples.
"""

import numpy as np
from scipy.stats import norm, sobol_indices

from analytic.prediction.regression import GROUPS, Regression
from analytic.prediction.rows import SobolIndices
from analytic.scene import Array

POINTS = 2**10  # base points; the regression is evaluated at (d + 2) times as many
SEED = 2


def indices_of(regression: Regression, scores: Array, values: Array) -> SobolIndices:
    """The indices of the quantities of a regression, in the variance that it explains.

    scores, values : of the samples, (N, d) and (N, n), which it was fitted to
    """
    inputs, varies = scores.shape[1], np.flatnonzero(np.ptp(values, axis=0))
    first, total, first_error, total_error = found = np.zeros((4, inputs, values.shape[1]))
    if not varies.size:
        return SobolIndices(first=first, total=total, first_error=first_error, total_error=total_error)
    repeated = regression.without_groups(scores, values, varies)
    indices = sobol_indices(func=repeated, n=POINTS, dists=[norm()] * inputs, rng=np.random.default_rng(SEED))
    for place, part in enumerate((indices.first_order, indices.total_order)):
        of_all = part.reshape(1 + GROUPS, varies.size, inputs)
        off = of_all[1:] - of_all[1:].mean(axis=0)
        found[place][:, varies] = of_all[0].T
        found[2 + place][:, varies] = np.sqrt((GROUPS - 1) / GROUPS * np.sum(off**2, axis=0)).T
    return SobolIndices(first=first, total=total, first_error=first_error, total_error=total_error)
