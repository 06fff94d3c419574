"""The axial rigidity of a preloaded pair beside a maker's [GMN]: python validation/benchmarks/rigidity.py"""

import numpy as np

from analytic.loads.pair import PairContacts, pair_equilibrium
from analytic.scene import Arrangement, Bearing, ContactAngle, Groove, Material, Operation
from validation.study import numbers, published, run, show

SOLVED = ContactAngle(rule="solved")
WIDTH = 15e-3  # m, of the maker's bearing, series 62 with a bore of 25 mm
GROOVES = (0.515, 0.52, 0.525, 0.53, 0.535)  # groove radii over the ball diameter; the maker gives none
BALL, PITCH, COUNT = 7.938e-3, 38.5e-3, 13  # m, m
steel = Material(name="steel", youngs_modulus=210e9, poisson_ratio=0.3, density=7850.0, source="usual values")


def main() -> None:
    rows = published("gmn_axial_rigidity.csv")
    preload, printed = numbers(rows, "preload_N"), numbers(rows, "axial_rigidity_of_pair_N_per_um")
    ours = [axial_rigidity_of_pair(groove, preload) / 1e6 for groove in GROOVES]
    heads = ("preload, N", "maker", *(f"groove radius {groove:g} D" for groove in GROOVES))
    title = "Axial rigidity of a preloaded pair GMN S 6205 C TA, N/um (cross-check: groove radii unknown)"
    show(heads, zip(preload, printed, *(np.round(each, 1) for each in ours), strict=True), title)


def axial_rigidity_of_pair(groove: float, preload: np.ndarray) -> np.ndarray:
    """Axial rigidity of two equal bearings under a rigid preload, N/m."""
    bearing = pair_bearing(groove)
    unloaded = Operation(axial_load=np.zeros(1), inner_speed=np.zeros(1))
    pairs = (Arrangement(kind="O", preload=float(each), distance=WIDTH) for each in preload)
    found = [pair_equilibrium(bearing, SOLVED, pair, unloaded, PairContacts()).stiffness[0] for pair in pairs]
    return np.array(found)


def pair_bearing(groove: float) -> Bearing:
    """The maker's bearing with both groove radii over the ball diameter, at a contact angle of 15 degrees."""
    clearance = 2 * (2 * groove - 1) * BALL * (1 - np.cos(np.radians(15)))
    inner, outer = (
        Groove(
            bottom_radius=PITCH / 2 + side * (BALL / 2 + clearance / 4),
            groove_radius=groove * BALL,
            shoulder_half_width=0.4 * BALL,
            material=steel,
        )
        for side in (-1, 1)
    )
    return Bearing(
        name="steel bearing",
        ball_count=COUNT,
        ball_diameter=BALL,
        ball_mass=steel.density * np.pi / 6 * BALL**3,
        ball_material=steel,
        inner=inner,
        outer=outer,
    )


if __name__ == "__main__":
    run(main)
