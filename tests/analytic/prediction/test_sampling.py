"""Samples of uncertain inputs: the same for any number of threads, some of which may have no torque."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.special import ndtr

from analytic.prediction import sampling
from analytic.prediction.sampling import Samples, sampled
from analytic.scene import Array
from tests.refusals import refused

INPUTS = 3


def problem_of() -> Any:
    """Two parts of the torque at two points."""
    return SimpleNamespace(inputs=(None,) * INPUTS, parts=("total", "spin"), held=np.zeros(2))


def drawn(
    count: int = 200, *, lost: int = 0, seed: int = 3, told: list[Any] | None = None, **options: Any
) -> tuple[Samples, list[int]]:
    """Samples whose first `lost` scores have no torque, and how many scores each task had."""
    sizes: list[int] = []
    left = [lost]

    def evaluated(_: Any, scores: Array) -> tuple[Array, list[str], float]:
        torque = np.repeat(scores[:, :1, None], 2, axis=1) * np.array([1.0, 2.0])
        why = []
        for row in range(len(scores)):
            if left[0]:
                left[0] -= 1
                torque[row] = np.nan
                why.append(("no thrust", "no oil")[left[0] % 2])
        sizes.append(len(scores))
        return torque, why, 0.5

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sampling, "evaluated", evaluated)
        found = sampled(
            problem_of(),
            count=count,
            seed=(seed, 0),
            workers=options.pop("workers", 1),
            progress=lambda share, words: None if told is None else told.append((share, words)),
        )
    return found, sizes


def test_scores_are_a_latin_hypercube_of_normal_numbers() -> None:
    """One in each of equal slices of the probability, by every input; another seed has others."""
    found, _ = drawn()
    slices = np.sort(np.floor(ndtr(found.scores) * 200), axis=0)
    np.testing.assert_array_equal(slices, np.repeat(np.arange(200.0)[:, None], INPUTS, axis=1))
    assert not np.array_equal(drawn(seed=4)[0].scores, found.scores)


def test_torques_belong_to_their_scores_however_they_are_shared_out() -> None:
    whole = drawn()[0]
    for workers in (1, 3, 7):
        found, sizes = drawn(workers=workers)
        assert sum(sizes) == 200
        np.testing.assert_array_equal(found.scores, whole.scores)
        np.testing.assert_array_equal(found.torque[:, 1, 1], 2 * whole.scores[:, 0])
        assert found.seconds == pytest.approx(0.5 * len(sizes))


def test_a_hundredth_of_the_samples_may_have_no_torque() -> None:
    found, _ = drawn(lost=2)
    assert (found.count, found.failed, len(found.scores), len(found.torque)) == (200, 2, 198, 198)
    assert np.isfinite(found.torque).all()
    assert sorted(found.reasons) == ["no oil (1 times)", "no thrust (1 times)"]
    refused(
        lambda: drawn(lost=3), "3 of 200 samples have no torque, limit 1 %", "no thrust (2 times); no oil (1 times)"
    )
