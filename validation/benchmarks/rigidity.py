"""The axial rigidity of a preloaded pair beside a maker's [GMN]: python validation/benchmarks/rigidity.py"""

from dataclasses import replace
from pathlib import Path

import numpy as np

from analytic.loads.pair import PairContacts, pair_equilibrium
from analytic.scene import ContactAngle
from analytic.scenefile.read import load_scene
from validation.study import numbers, published, run, show

PAIR, SOLVED = Path(__file__).with_name("gmn_6205.toml"), ContactAngle(rule="solved")
GROOVES = (0.515, 0.52, 0.525, 0.53, 0.535)  # groove radii over the ball diameter; the maker gives none


def main() -> None:
    rows = published("gmn_axial_rigidity.csv")
    preload, printed = numbers(rows, "preload_N"), numbers(rows, "axial_rigidity_of_pair_N_per_um")
    ours = [axial_rigidity_of_pair(groove, preload) / 1e6 for groove in GROOVES]
    heads = ("preload, N", "maker", *(f"groove radius {groove:g} D" for groove in GROOVES))
    title = "Axial rigidity of a preloaded pair GMN S 6205 C TA, N/um (cross-check: groove radii unknown)"
    show(heads, zip(preload, printed, *(np.round(each, 1) for each in ours), strict=True), title)


def axial_rigidity_of_pair(groove: float, preload: np.ndarray) -> np.ndarray:
    """Axial rigidity of two equal bearings under a rigid preload, N/m."""
    scene = load_scene(PAIR, settings={"bearing.conformity": groove})
    pairs = (replace(scene.arrangement, preload=float(each)) for each in preload)
    found = (pair_equilibrium(scene.bearing, SOLVED, pair, scene.operation, PairContacts()) for pair in pairs)
    return np.array([each.stiffness[0] for each in found])


if __name__ == "__main__":
    run(main)
