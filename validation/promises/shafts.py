"""Do the balls settle on shafts of any direction?

    python validation/promises/shafts.py

Computes deep groove bearings of the catalogue under their usual light radial load, on level, leaning and upright
shafts, at speeds around the one at which centrifugal force carries the weight of a ball. Prints each torque that is
refused, and how many are.
"""

from collections.abc import Iterator

from analytic import friction_torque
from analytic.errors import FembearingError
from validation.study import out, run

SERIES = ("60", "62", "63", "619", "618")
BORES = ("00", "01", "02", "04", "05", "06", "10", "12", "16")  # 61808 has no dimensions that follow from its ratings
DOWN = ((1.0, 0.0, 0.0), (1.0, 0.0, 0.02), (1.0, 0.0, 0.1), (1.0, 0.0, 1.0), (0.1, 0.0, 1.0), (0.0, 0.0, 1.0))
RPM = (50, 450, 500, 550, 700, 1000, 3000)


def refused(bearing: str) -> Iterator[str]:
    """Each direction and speed of a bearing without a torque, with its reason."""
    for down in DOWN:
        for rpm in RPM:
            try:
                friction_torque(bearing, speed=f"{rpm} rpm", settings={"operation.down": list(down)})
            except FembearingError as problem:
                yield f"{bearing}, down {down}, {rpm} rpm: {problem}"


def main() -> None:
    """Count the refused torques."""
    bearings = [series + bore for series in SERIES for bore in BORES]
    found = [line for bearing in bearings for line in refused(bearing)]
    for line in found:
        out.print(line, soft_wrap=True)
    out.print(f"{len(found)} of {len(bearings) * len(DOWN) * len(RPM)} refused")


if __name__ == "__main__":
    run(main)
