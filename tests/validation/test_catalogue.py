"""The balls of the catalogue against the printed load ratings."""

import math

import numpy as np

from validation.catalogue import run as catalogue


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
