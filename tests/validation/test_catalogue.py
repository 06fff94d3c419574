"""Balls from load ratings: the formulas against printed tables, and known balls found again."""

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np

from validation.catalogue import run as catalogue


def test_factors_are_those_of_the_printed_tables() -> None:
    static, dynamic = catalogue.factor_errors()
    # The tables are rounded to 0.1; that of f0 has four values that lie 0.003 beyond the rounding.
    assert dynamic < 0.05
    assert static < 0.055


def test_made_up_balls_are_found_from_their_ratings() -> None:
    """Ratings of 11 balls of 9.525 mm on 61.3 mm, to four digits."""
    count, diameter, pitch = np.array(11), np.array(9.525), 61.3
    gamma = diameter / pitch
    factor = catalogue.static_factor(gamma)
    rating = catalogue.Rating(
        angle=0.0,
        dynamic=float(f"{catalogue.dynamic_rating(count, diameter, 0.0, gamma):.4g}"),
        static=float(f"{catalogue.static_rating(count, diameter, 0.0, factor):.4g}"),
        factor=round(float(factor), 1),
    )
    best, second, *_ = catalogue.score_balls(
        [rating], catalogue.SPREADS["NSK"], section=16.0, pitch=pitch * 1.004, play=0.006, priors=False
    )
    assert (best.count, best.diameter) == (11, 9.525)
    assert best.score < 1 < second.score  # one standard deviation of the pitch is 0.6 %: (0.4/0.6)^2 = 0.44 at most


def test_known_balls_are_found_again() -> None:
    names = {"6001", "6206", "6309", "6804"}
    checks = catalogue.check_deep_groove(names)
    hits = catalogue.compare_balls(catalogue.supported(checks))
    assert {hit.designation for hit in hits} == names
    assert all(hit.right for hit in hits)
    assert all(check.agrees for check in checks if check.designation != "6001" and check.grade in ("A", "B"))


def test_the_wrong_balls_are_seen() -> None:
    (check,) = (check for check in catalogue.check_deep_groove({"6206"}) if check.maker == "NSK")
    assert check.agrees
    wrong = type(check)(**{**vars(check), "listed": (8, 9.525)})
    assert not wrong.agrees
    assert wrong.excess > catalogue.CLEAR


def test_listed_balls_have_the_printed_ratings() -> None:
    """All derived rows of grades A to C: at some pitch within the play the errors are those that the file states."""
    for name in ("deep_groove", "angular_contact"):
        for row in catalogue.read(catalogue.ROWS / f"{name}.csv"):
            if row["ball_status"] != "derived" or row["grade"] == "D":
                continue
            spread = catalogue.SPREADS[row["maker"]]
            angle = math.radians(float(row["contact_angle_deg"] or 0))
            count, diameter = np.array(int(row["ball_count"])), np.array(float(row["ball_diameter_mm"]))
            bore, outside = float(row["bore_mm"]), float(row["outside_mm"])
            play = catalogue.SMALL_PLAY if outside < catalogue.SMALL else catalogue.PLAY
            middles = [(bore + outside) / 2, float(row["pitch_diameter_mm"])]
            pitches = np.outer(middles, 1 + play * np.linspace(-2, 2, 41))
            gamma = diameter * math.cos(angle) / pitches
            static = [
                catalogue.static_rating(count, diameter, angle, catalogue.static_factor(gamma, smaller=smaller))
                for smaller in spread.smaller_factor
            ]
            dynamic = [
                ratio * catalogue.dynamic_rating(count, diameter, angle, gamma) for ratio in spread.dynamic_ratios
            ]
            for computed, key in ((static, "static"), (dynamic, "dynamic")):
                error = np.min(np.abs(np.array(computed) / float(row[f"{key}_rating_N"]) - 1))
                stated = abs(float(row[f"{key}_residual_percent"])) / 100
                assert error < stated + spread.static, (row["designation"], key)  # the next size is off by 5 % or so


def test_the_script_writes_its_tables(run_script: Callable[..., str], tmp_path: Path) -> None:
    text = run_script("catalogue/run.py", "--out", tmp_path)
    assert (tmp_path / "catalogue.md").read_text("utf-8") == text
    assert "| most makers | 31 | 29 | 27 | 25 | 21 |" in text  # stated in validation/catalogue/README.md
    rows = (tmp_path / "catalogue.csv").read_text("utf-8").splitlines()
    assert len(rows) == 1 + 517 + 151  # makers' deep groove bearings, sizes of angular contact bearings
