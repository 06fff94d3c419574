"""Surfaces by Ra and by finish."""

from math import pi, sqrt

import numpy as np
import pytest

from analytic import catalog
from analytic.scene import Surface
from tests.analytic.scenefile.scene_texts import PLAIN, refusal, scene
from tests.analytic.specimens import present


def surface(text: str) -> Surface:
    return present(scene(f"{PLAIN}[surface]\n{text}").surface)


def test_ra_becomes_the_rms_of_gaussian_heights() -> None:
    heights = np.random.default_rng(7).normal(scale=0.31, size=400_000)  # um
    ra = float(np.mean(np.abs(heights)))
    read = surface(f'Ra = "{ra!r} um"')
    # A mean of 400 000 scatters by 0.76/sqrt(400 000) = 0.12 %; four times that.
    assert read.rms_roughness == pytest.approx(np.std(heights) * 1e-6, rel=0.005)
    assert read.origins["rms_roughness"].status == "given"
    assert read.origins["autocorrelation.length"].status == "assumed"
    assert read.ball_rms_roughness is None


def test_a_finish_is_within_its_limits_and_says_that_it_is_assumed() -> None:
    finishes = catalog.rows("finishes")
    assert len(finishes) == 3
    for name, row in finishes.items():
        middle, low, high = (float(row[f"{column} [um]"]) for column in ("Ra", "low", "high"))
        assert low < middle < high
        read = surface(f'finish = "{name}"\nball_rms_roughness = "0.011 um"')
        assert present(read.rms_roughness) / sqrt(pi / 2) == pytest.approx(middle * 1e-6, rel=1e-12)  # round-off
        origin = read.origins["rms_roughness"]
        assert origin.status == "assumed"
        # a uniform distribution between both limits of Ra, of which Sq is sqrt(pi/2) times
        spread = (high - low) * 1e-6 / sqrt(12) * sqrt(pi / 2)
        assert present(origin.uncertainty) == pytest.approx(spread, rel=1e-12)
        length = read.origins["autocorrelation.length"]
        assert present(length.uncertainty) == pytest.approx(30e-6 / sqrt(12), rel=1e-12)  # 10 to 40 um
        assert (read.ball_rms_roughness, read.origins["ball_rms_roughness"].status) == (0.011e-6, "given")


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ('finish = "mirror"', ("surface.finish = 'mirror'", "ground, ground and honed, superfinished")),
        ('rms_roughness = "0.1 um"', ("surface.autocorrelation is missing", "Ra or finish")),
        ("", ("exactly one of rms_roughness, Ra, finish and height_map",)),
        ('Ra = "0.1 um"\nasperities = "greenwood_williamson"', ("asperities", "leave it out")),
        ('height_map = { path = "a.x3p", spacing = "1 um" }', ("spacing = '1 um' goes with .npy and .csv",)),
        ('height_map = { path = "a.npy" }', ("surface.height_map.spacing is missing",)),
        ('height_map = { path = "a.x3p" }', ("surface.height_map.path = 'a.x3p'",)),
        (
            'height_map = { path = "a.npy", spacing = "1 um" }\n'
            'autocorrelation = { kind = "gaussian", length = "33 um", spacing = "3 um" }',
            ("surface.autocorrelation does not go with height_map",),
        ),
    ],
)
def test_a_mistake_is_named_in_one_line(text: str, words: tuple[str, ...]) -> None:
    message = refusal(f"{PLAIN}[surface]\n{text}")
    assert message.isprintable()
    assert [word for word in words if word not in message] == [], message
