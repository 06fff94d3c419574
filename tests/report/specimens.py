"""Results made by hand: each number is known and unlike all others; and torques of scenes of all kinds."""

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from analytic.columns import OF_CAGE, OF_MOTION, Point, rows_of
from analytic.prediction.duty import DutyCycle, DutyStep, Estimate
from analytic.rows import OperatingPoint
from analytic.scene_torque import SceneTorque, torque_of_scene
from analytic.scenefile.read import load_scene
from fembearing import grid_convergence
from fembearing.check.comparison import Comparison, compared
from fembearing.check.contact.load_series import LoadPoint, LoadSeries, StiffnessLaw
from fembearing.check.contact.subsurface import NAMES, SubsurfaceComparison
from fembearing.check.cost.ladder import Ladder, Method
from fembearing.check.creep.scene_creep import CreepNumbers, RaceNumbers
from fembearing.check.film.scene_film import FilmNumbers
from fembearing.check.measured.comparison import MeasuredComparison
from fembearing.check.measured.rows import MeasuredRow
from fembearing.ehl.contact import Reach

RPM = np.pi / 30  # rad/s


def row(**changed: Any) -> MeasuredRow:
    given: dict[str, Any] = {
        "inner_speed": 20 * np.pi,  # 600 rpm
        "axial_load": 700.0,
        "radial_load": 0.0,
        "moment": 0.0,
        "temperature": 333.15,
        "measured": 0.04,
        "computed": 0.05,
        "error": 0.01,
        "numerical": 0.0004,
        "input": 0.003,
        "measurement": 0.002,
        "validation": 0.0036,
        "formulas": 0.005,
        "computed_low": 0.041,
        "computed_high": 0.062,
        "low": 0.0405,
        "high": 0.063,
        "beyond": 0.0005,
        "verdict": "model too high",
    }
    return MeasuredRow(**given | changed)


def comparison(*rows: MeasuredRow) -> MeasuredComparison:
    return MeasuredComparison(
        scene="a scene",
        file="data.csv",
        rows=rows,
        inside=sum(each.verdict == "inside" for each in rows),
        mean_error=0.21,
        scatter=0.03,
        shares={"lubricant.viscosity": 0.61},
        samples=640,
        seed=7,
        seconds=2.5,
        conclusions=("Missed: one of them.",),
        notes=("From the scene: all else.",),
        warnings=(),
    )


FASTER = row(inner_speed=30 * np.pi, verdict="inside", beyond=0.0)
TWO = comparison(row(), FASTER)


def quantity(
    formula: float, production: float, numerical: float, uncertainty: float, order: Any = 2.13, verdict: Any = "shown"
) -> Comparison:
    study = grid_convergence.Estimate(values=(numerical,), order=order, richardson=None, mesh=uncertainty / numerical)
    return compared(production, numerical, uncertainty, formula=formula, verdict=verdict, study=study)


FILM = FilmNumbers(
    pair="outer",
    load=371.5,
    inner_speed=600 * RPM,
    entrainment_speed=0.87,
    viscosity=0.043,
    pressure_viscosity=1.9e-8,
    reach=Reach(ahead=3.4e-3, behind=2.7e-3, side=3.1e-3),
    loading=214.0,
    thickening=6.7,
    ellipticity=0.124,
    quantities={
        "central_film": quantity(0.52e-6, 0.55e-6, 0.5e-6, 0.02e-6),
        "minimum_film": quantity(0.29e-6, 0.294e-6, 0.3e-6, 0.009e-6, None, "pass"),
        "rolling_force": quantity(3.6e-3, 2.25e-3, 3e-3, 0.6e-3),
        "pressure_centre": quantity(8.2e-6, 8e-6, 8e-6, 0.0),
    },
    dissipated_force=3.9e-3,
    verdict="undecided",
    tolerance=0.05,
    seconds=12.34,
    warnings=(),
)

MOVES = {
    "inner_speed": 900 * RPM,
    "torque": 2.13e-3,
    "start": "ramp",
    "block": 0.012,
    "other/start": "whirl",
    "other/state": "irregular",
    "other/torque": 2.2e-3,
    "mean_force": 3.21,
    "max_force": 1.34,
    "interval/torque": (2.02e-3, 2.24e-3),
    "interval/max_force": (1.21, 1.47),
    "duration": 0.24,
    "state": "irregular",
    "signed_moment": -0.43e-3,
    "whirl_speed": 360 * RPM,
    "wobble": 4.4e-6,
    "ball_lead": 23.5e-6,
    "grip_share": 0.37,
    "grip_number": 0.83,
    "race_excess": 0.31e-3,
}
UNKNOWN = {name: np.nan if column.unit else None for name, column in (OF_CAGE | OF_MOTION).items()}


def moved(*without: str) -> Point:
    """The cage at a point at which nothing is known of these columns."""
    lacking = {name: unknown for name, unknown in UNKNOWN.items() if name.startswith(without)} if without else {}
    columns: dict[str, Any] = {name: [value] for name, value in (MOVES | lacking).items()}
    (row,) = rows_of(columns)
    return row


NOTHING = compared(0.0, 0.0, 2e-6, formula=0.0)
SUMS = compared(2.9e-3, 2.5e-3, 1.23e-4, formula=3.1e-3)


def race(**known: Comparison) -> RaceNumbers:
    names = ("creepage_along", "creepage_across", "spin_creepage", "spin_moment", "rolling_moment", "transverse_force")
    quantities: Any = dict.fromkeys((*names, "slip_share", "power"), NOTHING) | known
    return RaceNumbers(
        contact_angle=0.31, load=87.0, semi_axis_rolling=0.12e-3, semi_axis_transverse=0.9e-3, quantities=quantities
    )


def numbers(inner: RaceNumbers | None = None, **changed: Any) -> CreepNumbers:
    given: dict[str, Any] = {
        "point": OperatingPoint(axial_load=700.0, inner_speed=600 * RPM, radial_load=0.0, moment=0.0),
        "friction_coefficient": None,
        "races": {"inner": inner or race(), "outer": race()},
        "torque": SUMS,
        "solved_balls": 3,
        "different_balls": 3,
        "strips": 31,
        "cells": 60,
        "tolerance": 0.01,
        "seconds": 2.7,
        "production_seconds": 0.003,
        "warnings": (),
    }
    return CreepNumbers(**given | changed)


def estimate(value: float) -> Estimate:
    return Estimate(value=value, low=0.7 * value, high=1.9 * value)


def step(number: int, *, temperature: float | None = 313.15, power: float = 2.5, speed: float = 600.0) -> DutyStep:
    """Each lasts 3 s longer than the one before."""
    duration = 20.0 + 3 * number
    return DutyStep(
        inner_speed=speed * RPM,
        axial_load=300.0 + 40 * number,
        radial_load=0.0,
        moment=0.0,
        duration=duration,
        temperature=temperature,
        torque=estimate(0.04 if power else 0.0),
        power=power,
        energy=power * duration,
    )


def cycle(*steps: DutyStep) -> DutyCycle:
    return DutyCycle(
        scene="a spindle",
        file="cycle.csv",
        steps=steps,
        duration=sum(each.duration for each in steps),
        energy=estimate(sum(each.energy for each in steps)),
        mean_torque=estimate(0.03),
        worst_torque=estimate(0.05),
        worst_step=1,
        mean_power=estimate(1.4),
        steady=None,
        warnings=(),
        seconds=0.1,
    )


def under(load: float, hertz: float, approach: float, mesh: float, tangent: tuple[Any, Any]) -> LoadPoint:
    """One load of a series; mesh : relative uncertainty, beside 4 % of the domain"""
    uncertainty = float(np.hypot(mesh, 0.04)) * approach
    return LoadPoint(
        load=load,
        quantities={"approach": compared(hertz, approach, uncertainty)},
        tangent=tangent[0],
        tangent_uncertainty=tangent[1],
        hertz_tangent=1.5 * load / hertz,
    )


def series(**changed: Any) -> LoadSeries:
    given: dict[str, Any] = {
        "pair": "pocket",
        "contact_angle": 0.0,
        "geometry": "wall",
        "tolerance": 0.05,
        "points": (
            under(20.0, 5.6e-6, 5e-6, 0.03, (7.1e6, 0.034)),
            under(64.0, 8.2e-6, 8e-6, 0.03, (9.3e6, None)),
            under(40.0, 6e-6, 7.5e-6, 0.075, (None, None)),
        ),
        "law": None,
        "pocket_law": None,
        "hertz_stiffness": 60e9,
        "verdict": "shown",
        "warnings": (),
        "meshes": 3,
        "seconds": 12.3,
        "peak_memory": None,
    }
    return LoadSeries(**given | changed)


HERTZ = Method(name="Hertz", error=0.031, bound=0.036, known_error=0.036, seconds=2e-6, memory=2**28, chosen=True)
COARSE = Method(name="finite elements, level 2", error=0.007, known_error=0.0072, seconds=0.4, spread=0.06, unknowns=31)
FAILED = Method(name="finite elements, level 3", failed="no room")
FINEST = Method(
    name="finite elements, level 4", bound=2e-4, known_error=2e-4, seconds=3.5, warm_up=0.8, memory=3 * 2**28
)
CONTACT = Ladder(quantity="the contact", reference="the finest", methods=(HERTZ, COARSE, FAILED, FINEST))
FAR = Ladder(
    quantity="the load",
    reference="the ring",
    methods=(Method(name="thrust", error=9.0, seconds=1e-3), Method(name="ring", error=1e-9, bound=77.0, seconds=0.1)),
)
ABSENT = Ladder(quantity="roughness", absent="no surface")

CREEP = numbers(
    race(
        creepage_along=compared(-2.1e-3, -2e-3, 0.2e-3, formula=-2.4e-3),
        spin_creepage=compared(2200.0, 2500.0, 50.0, formula=2600.0),
        rolling_moment=compared(4e-6, 3e-6, 4e-6, formula=5e-6),
        slip_share=compared(0.66, 0.6, 0.03, formula=0.97),
        power=compared(0.25, 0.25, 0.0, formula=0.45),
    )
)
LAW = StiffnessLaw(
    stiffness=24.5e9,
    exponent=1.47,
    stiffness_uncertainty=0.21,
    misfit=0.012,
    propagated=0.005,
    exponent_uncertainty=0.017,
)
STRESS = SubsurfaceComparison(
    side="lower",
    quantities=dict(
        zip(
            NAMES,
            map(
                compared,
                (0.612e9, 75.3e-6, 1.12e9, 0.0),
                (0.6e9, 75e-6, 1.11e9, 3.5e-6),
                (0.003e9, 0.61e-6, 0.0222e9, 1.4e-6),
            ),
            strict=True,
        )
    ),
)


RIG = str(Path(__file__).parents[2] / "validation/scenes/thrust_rig_3mm.toml")
SCENES: dict[str, tuple[str, dict[str, Any], dict[str, Any]]] = {  # name, what is given, and how it is computed
    "dry": ("6205-dry", {}, {}),
    "paper": ("paper_6205", {"settings": {"report.units": "inch", "effects.cage_dynamics": "off"}}, {}),
    "radial": ("6206", {"radial_load": "2 kN", "speed": "1500 rpm"}, {"samples": 128}),
    "sealed": ("6204-2RS", {"radial_load": "300 N", "speed": "5000 rpm", "supply": "grease"}, {}),
    "pair": (
        "7014C",
        {"speed": "12000 rpm", "supply": "grease", "axial_load": "400 N"}
        | {"settings": {"arrangement.kind": "O", "arrangement.preload": "300 N"}},
        {},
    ),
    "thrust": (RIG, {"axial_load": "9 N", "speed": "500 rpm"}, {}),
    "tilted": ("6309", {"radial_load": "3 kN", "speed": "2900 rpm", "settings": {"operation.moment": "20 N m"}}, {}),
    "series": (
        "7206B",
        {"axial_load": ["100 N", "900 N", "200 kN"], "radial_load": "500 N", "speed": "3000 rpm"},
        {"keep_going": True},
    ),
}


@cache
def torque_of(name: str) -> SceneTorque:
    """The torque of one of these scenes."""
    designation, given, how = SCENES[name]
    return torque_of_scene(load_scene(designation, **given), **how)
