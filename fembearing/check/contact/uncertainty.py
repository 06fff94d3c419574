"""The parts of the stated uncertainty of a contact: relative half-widths, 95 %, and the contacts that they come from.

- meshes with a twin, and pixels: `with_twin` and `on_pixels`, in `Estimate.mesh`
- plain levels: `fembearing.grid_convergence.estimate`, in `Estimate.mesh`
- far boundary: `meshed_region.effects`, in `Estimate.domain`
- sides and lands: `meshed_region.with_effect_of_sides`, in `Estimate.domain`
- an ellipse on the mesh of another: `load_series.off_mesh_uncertainty`, in `Estimate.mesh`

`Estimate.total`, which is stated, joins mesh and domain in quadrature. docs/validation.md has the coverage on other
contacts.
"""

STIFFNESS = 1.5  # relative change of load/approach^1.5 over that of the approach

# Meshes with a twin: LEAST_WITH_TWIN, CURVED times (c/r)^2 and the largest error that the twin shows, with the larger
# semi-axis c and the ball's radius r, and LEFT times the largest extrapolation of a quantity. UNSTEADY_PRESSURE is
# added for the peak pressure, which has no steady order. Chosen on the calibration contacts of
# validation/intervals/twin.py, which tests them on others.
LEAST_WITH_TWIN, CURVED, LEFT, UNSTEADY_PRESSURE = 1.5e-4, 0.3, 1.0, 1e-4

# Pixels: FEW_SAMPLES times (c/r)^2 in place of CURVED, for what few samples miss of the compliance, chosen likewise.
# BETWEEN is added between samples: at most 0.008 % on the inner and the outer race of a 6205, in ranges of 6 and of
# 100, against a compliance sampled at the load itself.
FEW_SAMPLES, BETWEEN = 3e-3, 1e-4

# Far boundary: share of the whole effect on semi-axes and pressure. Of the change of the approach between the blocks
# the cells outside leave LEFT_WITH_TWIN open; without twins all cells do. Of what the twins correct in that change
# LEFT_BY_TWIN stays.
UNCERTAIN, LEFT_WITH_TWIN, LEFT_BY_MESHES, LEFT_BY_TWIN = 0.5, 0.25, 0.5, 0.1

# Sides: their effect on the second level differs from that on the third by at most these shares of the largest
# effect, which is that on the approach, and SIDES_COARSE (b/r)^2: on 26 contacts with shoulders 1.13 to 2 semi-axes
# away.
SIDES_COARSE = 1e-3
SIDES_LEFT = {"semi_axis_rolling": 0.15, "semi_axis_transverse": 0.15, "peak_pressure": 0.15, "approach": 0.3}
SIDES_LEFT_IN_OTHERS = STIFFNESS * SIDES_LEFT["approach"]

# Lands: what they add to the effect on the approach up to the larger block, 0.05 to 0.08 % at 40 degrees, differs on
# the first level from that on the second by up to 23 %, or 4e-5, and on the second from the third by up to 11 %: 16
# and 12 contacts at 0.08 to 0.61 rad, a 6205 and seeds 107 to 155 of validation/intervals/twin.py. Where cells of the
# larger block turn inside out under a steep land it is not known: at most STEEP times the sine of the angle, from
# 0.14 % on a land of 0.69 rad.
FARTHER_LEFT, FARTHER_LEFT_ON_SECOND, STEEP = 0.25, 0.125, 2.2e-3

# A series on plain levels: where the edge of an ellipse crosses cells made for another ellipse, the error of the
# approach oscillates with the load, alike on all levels. On 14 idealised contacts at 33 sizes from 0.65 to 1.35 of
# the mesh's it exceeded the error that the levels show by 0.21 % in 95 of 100 and 0.43 % at worst
# (validation/benchmarks/calibrations.py); it is smaller where the ellipse is close to the mesh's.
OFF_MESH = 3e-3
OFF_FROM = 0.1  # difference of the ellipses, in semi-axes, from which OFF_MESH applies in full; in proportion below


def with_twin(*, shape: float, shown: float, step: float) -> dict[str, float]:
    """Of the meshes, for each quantity, from corrected levels.

    shape : (c/r)^2;  shown : largest error that the twin shows, relative;  step : largest extrapolation, relative
    """
    return _each(LEAST_WITH_TWIN + CURVED * shape * shown + LEFT * step)


def on_pixels(*, shape: float, step: float, is_sampled: bool) -> dict[str, float]:
    """Of compliance and pixels, for each quantity; is_sampled : whether the compliance is of this load."""
    return _each(LEAST_WITH_TWIN + FEW_SAMPLES * shape + LEFT * step + (0.0 if is_sampled else BETWEEN))


def _each(uncertainty: float) -> dict[str, float]:
    return {
        "semi_axis_rolling": uncertainty,
        "semi_axis_transverse": uncertainty,
        "peak_pressure": uncertainty + UNSTEADY_PRESSURE,
        "approach": uncertainty,
        "stiffness": STIFFNESS * uncertainty,
    }
