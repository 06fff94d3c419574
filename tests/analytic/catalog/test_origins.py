"""How far the dimensions of a bearing of the catalogue are trusted, by rows of every kind."""

import csv
import math
from pathlib import Path

import numpy as np
import pytest

from analytic.catalog.origins import INNER_CONFORMITY, OUTER_CONFORMITY, origins_of
from analytic.scene import Origin
from tests.analytic.specimens import present

ROW = {
    "maker": "NSK",
    "grade": "A",
    "ball_status": "derived",
    "ball_diameter_mm": "8.7",
    "outside_mm": "52",
    "contact_angle_deg": "40",
    "f0": "13.2",
    "dynamic_rating_N": "14300",
    "static_rating_N": "7900",
    "static_residual_percent": "0.4",
    "dynamic_residual_percent": "-0.7",
    "supported_by": "SKF",
    "second_ball_count": "",
    "second_ball_diameter_mm": "",
    "pitch_diameter_mm": "38.5",
    "pitch_source": "mean",
    "shoulder_height_inner_mm": "1.9",
    "shoulder_height_outer_mm": "1.7",
    "shoulder_status": "derived",
}
PUBLISHED = Path(__file__).parents[3] / "validation" / "published"


def origins(*, scaled: bool = False, **changed: str) -> dict[str, Origin]:
    return origins_of(ROW | changed, scaled=scaled)


@pytest.mark.parametrize("ring", ["inner", "outer"])
def test_a_groove_lies_evenly_between_the_tightest_print_and_the_limit_of_the_ratings(ring: str) -> None:
    """The standard deviation of numbers that lie evenly in a range is its width over sqrt(12)."""
    lines = (PUBLISHED / "groove_radii.csv").read_text("utf-8").splitlines()
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    printed = [float(row[f"{ring}_low"]) for row in rows if row["kind"] == "printed"]
    (limit,) = (float(row[f"{ring}_high"]) for row in rows if row["kind"] == "limit")
    evenly = np.linspace(min(printed), limit, 200_001)
    default = {"inner": INNER_CONFORMITY, "outer": OUTER_CONFORMITY}[ring]
    np.testing.assert_allclose(default, evenly.mean(), atol=0.0005, rtol=0)  # rounded to 0.001
    origin = origins()[f"{ring}.conformity"]
    assert origin.status == "assumed"
    assert f"{min(printed):g}, to the limit of the rating standards, {limit:g}" in origin.source
    np.testing.assert_allclose(present(origin.uncertainty), evenly.std(), rtol=1e-4)  # of so many numbers


@pytest.mark.parametrize(
    ("changed", "status", "expected"),
    [
        ({"pitch_source": "GMN"}, "printed", 0.001 * 38.5e-3),
        ({"pitch_source": "load centre"}, "derived", 0.003 * 38.5e-3),
        ({"pitch_source": "SKF shoulders"}, "derived", 0.006 * 38.5e-3),
        ({"pitch_source": "mean"}, "assumed", 0.006 * 38.5e-3),
        ({"pitch_source": "mean", "outside_mm": "26"}, "assumed", 0.006 * 38.5e-3),
        ({"pitch_source": "mean", "outside_mm": "25.9"}, "assumed", 0.03 * 38.5e-3),
    ],
)
def test_the_pitch_diameter_is_as_uncertain_as_its_source(
    changed: dict[str, str], status: str, expected: float
) -> None:
    found = origins_of(ROW | changed, scaled=False)["pitch_diameter"]
    assert found.status == status
    assert found.uncertainty == pytest.approx(expected, rel=1e-12)
    assert ("shoulder diameters that SKF prints" in found.source) == (changed["pitch_source"] == "SKF shoulders")
    assert ("mean of bore and outside" in found.source) == (changed["pitch_source"] == "mean")


def test_a_load_centre_in_whole_millimetres_moves_the_pitch_diameter() -> None:
    """a = B/2 + d_m tan(al)/2, with a rounded to 1 mm: by two of its values."""
    found = origins(pitch_source="load centre", maker="SKF")["pitch_diameter"]
    one, other = (2 * a / math.tan(math.radians(40)) for a in (15e-3, 16e-3))
    np.testing.assert_allclose(present(found.uncertainty), abs(other - one) / math.sqrt(12), rtol=1e-12)  # round-off
    assert "SKF's distance of the load centre" in found.source


@pytest.mark.parametrize(
    ("ring", "height", "conformity"), [("inner", 1.9e-3, INNER_CONFORMITY), ("outer", 1.7e-3, OUTER_CONFORMITY)]
)
@pytest.mark.parametrize(
    ("status", "scaled", "expected", "words"),
    [
        ("derived", False, "derived", "chamfer ignored"),
        ("loaded side only", False, "derived", "loaded side only"),
        ("assumed", False, "assumed", "as in bearings with printed shoulders"),
        ("derived", True, "assumed", "of another maker"),
    ],
)
def test_a_shoulder_is_as_uncertain_as_its_height(
    ring: str, height: float, conformity: float, status: str, scaled: bool, expected: str, words: str
) -> None:
    """Against the groove's circle at two heights, 0.03 ball diameters being their standard deviation."""
    found = origins(shoulder_status=status, scaled=scaled)[f"{ring}.shoulder_half_width"]
    radius, step = conformity * 8.7e-3, 1e-8
    ends = [math.sqrt(radius**2 - (radius - height - side * step) ** 2) for side in (-1, 1)]
    slope = (ends[1] - ends[0]) / (2 * step)
    np.testing.assert_allclose(present(found.uncertainty), 0.03 * 8.7e-3 * slope, rtol=1e-6)  # of the difference
    assert found.status == expected
    assert words in found.source
    if status == "assumed":
        assert f"height {height / 8.7e-3:.2f} ball diameters" in found.source
