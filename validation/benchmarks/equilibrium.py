"""Accuracy of the load equilibria: python validation/benchmarks/equilibrium.py

Prints the deviation of the ring under pure thrust from the closed form, and two cross-checks with published numbers
(validation/published): ring displacements from another program [MASTA] and a maker's axial rigidity of a preloaded pair
[GMN].
"""

from pathlib import Path

import numpy as np
from rich.console import Console
from rich.table import Table

from analytic import load_scene
from analytic.loads.pair import PairContacts, pair_equilibrium
from analytic.loads.ring import ring_equilibrium
from analytic.loads.thrust import thrust_equilibrium
from analytic.scene import Arrangement, Bearing, ContactAngle, Groove, Material, Operation

PUBLISHED = Path(__file__).parents[1] / "published"
SOLVED = ContactAngle(rule="solved")
WIDTH = 15e-3  # m, of the maker's bearing, series 62 with a bore of 25 mm
GROOVES = (0.515, 0.52, 0.525, 0.53, 0.535)  # groove radii over the ball diameter; the maker gives none
steel = Material(name="steel", youngs_modulus=210e9, poisson_ratio=0.3, density=7850.0, source="usual values")
out = Console(width=110)


def main() -> None:
    thrust_limit()
    displacements()
    rigidity()


def thrust_limit() -> None:
    scene = load_scene("6205-dry")
    loads = np.geomspace(1e-3, 1e5, 33)
    ring = ring_equilibrium(scene.bearing, scene.contact_angle, axial_load=loads)
    thrust = thrust_equilibrium(scene.bearing, scene.contact_angle, axial_load=loads)
    worst = np.abs(ring.balls["load"][..., 0] / thrust["load"][:, :1] - 1).max()
    out.print(f"pure thrust, 1 mN to 100 kN: ball loads of the ring within {worst:.1e} of the closed form")


def displacements() -> None:
    rows = np.genfromtxt(PUBLISHED / "masta_ring_displacement.csv", delimiter=",", names=True, skip_header=4)
    table = Table("clearance, um", "radial, N", "axial, N", "moment, N mm", "radial, um", "axial, um", "tilt, mrad")
    for row in rows:
        pitch = 43.5e-3
        bearing = steel_bearing(
            ball=11.5e-3, pitch=pitch, count=7, grooves=(0.52, 0.53), clearance=row["clearance_mm"] * 1e-3
        )
        # Their tilt and moment refer to half the pitch diameter, ours to the circle of groove centres.
        arms = (bearing.inner.bottom_radius + bearing.inner.groove_radius) / (pitch / 2)
        axial, x, y, tilt_x, tilt_y = ring_equilibrium(
            bearing,
            SOLVED,
            axial_load=row["axial_N"],
            radial_load_x=row["radial_N"],
            moment_x=row["moment_N_mm"] * 1e-3 * arms,
        ).displacement
        ours = (np.hypot(x, y) * 1e6, axial * 1e6, np.hypot(tilt_x, tilt_y) * 1e3 * arms)
        theirs = (row["radial_um"], row["axial_um"], row["tilt_mrad"])
        pairs = ["" if np.isnan(b) else f"{a:.4f} ({b:.4f})" for a, b in zip(ours, theirs, strict=True)]
        table.add_row(
            f"{row['clearance_mm'] * 1e3:g}", *(f"{row[k]:g}" for k in ("radial_N", "axial_N", "moment_N_mm")), *pairs
        )
    out.print("Ring displacement, and in brackets that of MASTA as noted by a third party (cross-check):", table)


def rigidity() -> None:
    rows = np.genfromtxt(PUBLISHED / "gmn_axial_rigidity.csv", delimiter=",", names=True, skip_header=2)
    table = Table("preload, N", "maker", *(f"groove radius {groove:g} D" for groove in GROOVES))
    rigidities = [axial_rigidity_of_pair(groove, rows["preload_N"]) for groove in GROOVES]
    for index, row in enumerate(rows):
        maker = f"{row['axial_rigidity_of_pair_N_per_um']:g}"
        table.add_row(f"{row['preload_N']:g}", maker, *(f"{values[index] / 1e6:.1f}" for values in rigidities))
    out.print("Axial rigidity of a preloaded pair GMN S 6205 C TA, N/um (cross-check: groove radii unknown):", table)


def axial_rigidity_of_pair(groove: float, preload: np.ndarray) -> np.ndarray:
    """Axial rigidity of two equal bearings under a rigid preload, N/m."""
    ball = 7.938e-3
    clearance = 2 * (2 * groove - 1) * ball * (1 - np.cos(np.radians(15)))
    bearing = steel_bearing(ball=ball, pitch=38.5e-3, count=13, grooves=(groove, groove), clearance=clearance)
    unloaded = Operation(axial_load=np.zeros(1), inner_speed=np.zeros(1))
    pairs = (Arrangement(kind="O", preload=float(each), distance=WIDTH) for each in preload)
    contacts = PairContacts()
    found = [pair_equilibrium(bearing, SOLVED, pair, unloaded, contacts).stiffness[0] for pair in pairs]
    return np.array(found)


def steel_bearing(*, ball: float, pitch: float, count: int, grooves: tuple[float, float], clearance: float) -> Bearing:
    """A steel bearing from its ball and pitch diameter; groove radii relative to the ball diameter."""
    inner, outer = (
        Groove(
            bottom_radius=pitch / 2 + side * (ball / 2 + clearance / 4),
            groove_radius=groove * ball,
            shoulder_half_width=0.4 * ball,
            material=steel,
        )
        for side, groove in zip((-1, 1), grooves, strict=True)
    )
    return Bearing(
        name="steel bearing",
        ball_count=count,
        ball_diameter=ball,
        ball_mass=steel.density * np.pi / 6 * ball**3,
        ball_material=steel,
        inner=inner,
        outer=outer,
    )


if __name__ == "__main__":
    main()
