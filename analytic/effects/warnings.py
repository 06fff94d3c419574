"""Warnings: what the reader has to know before using the numbers of a friction torque."""

from collections.abc import Iterator

import numpy as np

from analytic.contact.geometry import RACES
from analytic.effects.ledger import Ledger, size_of
from analytic.effects.table import NO_CAGE
from analytic.effects.washers import HELD
from analytic.numerics.records import Records
from analytic.oil.grease import MEASURED_SIZES
from analytic.oil.lubrication import SHORTEST
from analytic.scene import Scene, Supply
from analytic.solve.solution import Solution
from analytic.surface.roughness import GapRoughness
from analytic.words import MICROMETRE, MILLIMETRE, RPM, percent_of

LIGHT = 0.01  # of the heaviest ball's load: a film of a lighter ball hardly changes the torque
# Speed n d_m, mm/min, beyond which bearings need more than usual design; rules of thumb [BearingWorks], [Anderson1973]
USUAL_SPEEDS: dict[Supply, float] = {"grease": 0.5e6, "oil_bath": 1e6, "oil_spot": 1e6, "oil_jet": 2e6}
HYBRID_JET = 3e6  # with an oil jet and ceramic balls
ENDLESS = "the formula is -8 to +1 % off for endless ellipses"  # `analytic.oil.film.FORMULA_UNCERTAINTY`
LIGHTEST_STEEL = 6000.0  # kg/m^3: a lighter ball is a ceramic one


def torque_warnings(
    ledger: Ledger, found: Solution, *, roughness: GapRoughness | None, limits: tuple[str, ...]
) -> list[str]:
    """Every warning, the worst first: limits, what the total is without, and how it was read and computed.

    roughness : of ball and race together, where film and asperities share the load
    limits : those of `analytic.effects.limits`
    """
    scene = ledger.scene
    warnings = [*limits, *_lacking(ledger), *_decisions(ledger), *scene.warnings]
    if scene.clearances is not None and scene.clearances.operating < 0:
        warnings.append(
            f"no clearance in operation: {MICROMETRE.written(scene.clearances.unmounted, '.3g')} unmounted, "
            f"{MICROMETRE.written(scene.clearances.mounted, '.3g')} mounted, an interference of "
            f"{MICROMETRE.written(-scene.clearances.operating, '.3g')} on the diameter in operation; it preloads every "
            f"ball with {scene.clearances.ball_load:.3g} N"
        )
    if scene.friction_coefficient is not None:
        warnings.append(
            f"the friction coefficient {scene.friction_coefficient:g} is from the scene, not from a lubrication model"
        )
    if scene.microslip == "as_printed":
        warnings.append(
            'friction.microslip = "as_printed" is no model: equations 2 to 7 as printed exchange M_z and M_r without '
            "spin and from a spin-to-roll ratio of 1/2 on, equation 2 lacks its factor 0.322, and both moments jump "
            'there; "derived" is correct'
        )
    if (seals := scene.losses.origins.get("seals")) is not None and scene.losses.seals is not None:
        warnings.append(
            f"the drag of the seals, {1e3 * scene.losses.seals:.3g} N mm, is assumed: {seals.source}; give "
            "losses.seals by a measured torque"
        )
    if (speed := too_fast(scene)) is not None:
        warnings.append(speed)
    warnings += _greased(ledger)
    if roughness is not None:
        warnings += roughness.warnings
    for race, name in enumerate(RACES):
        if roughness is not None:
            warnings += _film(found.balls, race)
        if ledger.is_on("rolling") and found.points["rolling_extrapolated"][:, race].any():
            warnings.append(
                f"rolling on the {name} race is extrapolated: the law holds for slow rolling, contacts longer across "
                f"rolling than along, and oil {SHORTEST:g} semi-axes ahead or more"
            )
    return warnings


def _lacking(ledger: Ledger) -> Iterator[str]:
    """Parts of unknown size that the total is without."""
    scene = ledger.scene
    if scene.bearing.seals_rub and scene.losses.seals is None:
        yield (
            f"the total is without the drag of the seals ({scene.bearing.seals}): give losses.seals, for example "
            '"5 N mm" or "estimate"'
        )
    if scene.cage is None and scene.losses.pockets is None and not ledger.rules_out("cage"):
        yield f"the total is without the cage: {NO_CAGE}"
    if scene.lubricant is None and not ledger.rules_out("rolling"):
        yield "the total is without the hydrodynamic rolling resistance: add a table [lubricant]"


def _decisions(ledger: Ledger) -> Iterator[str]:
    """Effects that are neglected for another reason than their size, and could exceed the tolerance."""
    for effect in ledger.made.values():
        if ledger.scene.bearing.kind == "thrust" and effect.name in HELD:
            continue
        if effect.decision == "off" and effect.share is not None and effect.share > ledger.scene.tolerance:
            limit = f"tolerance {percent_of(ledger.scene.tolerance)}"
            yield f"{effect.name} is neglected, {size_of(effect.share)}, {limit}: {effect.reason}"


def too_fast(scene: Scene) -> str | None:
    """That n d_m is beyond usual practice, in words; None: it is not."""
    oil, bearing = scene.lubricant, scene.bearing
    supply = "oil_bath" if oil is None else oil.supply
    is_hybrid = bearing.ball_material.density < LIGHTEST_STEEL
    limit = HYBRID_JET if is_hybrid and supply == "oil_jet" else USUAL_SPEEDS[supply]
    fastest = float(np.max(np.abs(scene.operation.inner_speed), initial=0.0))
    found = MILLIMETRE.number(RPM.number(fastest) * bearing.pitch_diameter)
    if found <= limit:
        return None
    return (
        f"n d_m = {found:.3g} mm/min exceeds {limit:.2g} mm/min, the usual limit with {supply.replace('_', ' ')}: life "
        "of cage and lubrication not checked"
    )


def _greased(ledger: Ledger) -> Iterator[str]:
    """A greased bearing of another size than the measured ones."""
    bearing, oil = ledger.scene.bearing, ledger.scene.lubricant
    if oil is None or not oil.starves_as_measured(bearing) or not ledger.is_on("starvation"):
        return
    (low, high), mean = MEASURED_SIZES, bearing.pitch_diameter
    if not low <= mean <= high:
        yield (
            f"films with grease are extrapolated: measured in bearings of {MILLIMETRE.written(low, 'g')} to "
            f"{MILLIMETRE.written(high, 'g')} pitch diameter (6204 to 6209), here {MILLIMETRE.written(mean, '.3g')}"
        )


def _film(balls: Records, race: int) -> Iterator[str]:
    """Films that the formula does not give, on balls that carry enough to matter."""
    load = balls["load"][..., race]
    carries = load > LIGHT * np.max(load, axis=-1, keepdims=True, initial=0.0)
    if np.any((balls["film_extrapolated"][..., race] != 0) & carries):
        a, b = (balls[f"semi_axis_{way}"][..., race] for way in ("rolling", "transverse"))
        error = "error not known: it is longer along rolling than across" if np.any(a > b) else ENDLESS
        yield f"the film on the {RACES[race]} race is extrapolated: contact ellipse outside the fitted shapes; {error}"
    if np.any((balls["film_capped"][..., race] != 0) & carries):
        yield f"the film on the {RACES[race]} race is limited to the space between the bodies, less than the formula"
