"""Do the balls settle on shafts of any direction?

    python validation/promises/shafts.py

Computes deep groove bearings of the catalogue under their usual light radial load, on level, leaning and upright
shafts, at speeds around the one at which centrifugal force carries the weight of a ball. Prints each torque that is
refused, and how many are.
"""

from itertools import product

from analytic import friction_torque
from analytic.errors import FembearingError
from validation.study import out, run

SERIES = ("60", "62", "63", "619", "618")
BORES = ("00", "01", "02", "04", "05", "06", "10", "12", "16")  # 61808 has no dimensions that follow from its ratings
DOWN = ((1.0, 0.0, 0.0), (1.0, 0.0, 0.02), (1.0, 0.0, 0.1), (1.0, 0.0, 1.0), (0.1, 0.0, 1.0), (0.0, 0.0, 1.0))
RPM = (50, 450, 500, 550, 700, 1000, 3000)


def main() -> None:
    """Count the refused torques."""
    bearings = [series + bore for series, bore in product(SERIES, BORES)]
    refused = 0
    for bearing, down, rpm in product(bearings, DOWN, RPM):
        try:
            friction_torque(bearing, speed=f"{rpm} rpm", settings={"operation.down": list(down)})
        except FembearingError as problem:
            refused += 1
            out.print(f"{bearing}, down {down}, {rpm} rpm: {problem}", soft_wrap=True)
    out.print(f"{refused} of {len(bearings) * len(DOWN) * len(RPM)} refused")


if __name__ == "__main__":
    run(main)
