"""The ring's equilibrium against others: the load-distribution integral, another program, a maker's rigidities."""

from pathlib import Path

import numpy as np
from scipy.integrate import quad

from analytic.loads.ring import ring_equilibrium
from analytic.scene import ContactAngle, Material
from tests.analytic.specimens import made

SOLVED = ContactAngle(rule="solved")
PUBLISHED = Path(__file__).parents[3] / "validation" / "published"
OWN_STEEL = Material(name="steel", youngs_modulus=210e9, poisson_ratio=0.3, density=7850.0, source="test")


def test_radial_load_spreads_as_the_load_distribution_integral() -> None:
    """J_r(eps) of many balls at angle 0: F = Z Q_max J_r, and 4.37 F/Z without clearance ([Stribeck1907])."""
    count = 401
    for clearance, load in ((0.0, 9100.0), (23e-6, 5200.0), (-11e-6, 7300.0)):
        bearing = made(ball=7.94e-3, pitch=39.01e-3, count=count, grooves=(0.52, 0.53), clearance=clearance)
        found = ring_equilibrium(bearing, SOLVED, radial_load_x=load)
        share = (1 - clearance / 2 / found.displacement[1]) / 2
        half_zone = np.arccos(1 - 2 * share) if share < 1 else np.pi

        def unit(azimuth: float, share: float = share) -> float:
            return max(1 - (1 - np.cos(azimuth)) / (2 * share), 0) ** 1.5 * np.cos(azimuth)

        integral = quad(unit, -half_zone, half_zone)[0] / (2 * np.pi)
        largest = float(found.balls["load"][..., 0].max())
        np.testing.assert_allclose(count * largest * integral, load, rtol=1e-5)  # 401 balls for a continuum
        if clearance == 0:
            np.testing.assert_allclose(count * largest / load, 4.37, atol=0.005)  # three printed digits


def test_displacements_of_another_program() -> None:
    """A cross-check. That program tilts and takes moments at half the pitch diameter, where ours has the grooves' R."""
    table = np.genfromtxt(PUBLISHED / "masta_ring_displacement.csv", delimiter=",", names=True, skip_header=4)
    assert len(table) == 7
    for row in table:
        bearing = made(
            ball=11.5e-3,
            pitch=43.5e-3,
            count=7,
            grooves=(0.52, 0.53),
            clearance=row["clearance_mm"] * 1e-3,
            material=OWN_STEEL,
        )
        arms = (bearing.inner.bottom_radius + bearing.inner.groove_radius) / (43.5e-3 / 2)
        found = ring_equilibrium(
            bearing,
            SOLVED,
            axial_load=row["axial_N"],
            radial_load_x=row["radial_N"],
            moment_x=row["moment_N_mm"] * 1e-3 * arms,
        )
        axial, x, y, tilt_x, tilt_y = found.displacement
        got = np.array([np.hypot(x, y) * 1e6, axial * 1e6, np.hypot(tilt_x, tilt_y) * 1e3 * arms])
        noted = np.array([row[name] for name in ("radial_um", "axial_um", "tilt_mrad")])
        known = ~np.isnan(noted)
        # K of the standard is rounded to three digits (1.48), its third root to 1e-3 of the approach
        np.testing.assert_allclose(got[known], noted[known], rtol=2e-4)
