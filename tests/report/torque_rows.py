"""A friction torque made by hand, with a row for each operating point: what a test does not give is as plain as can be.

Without oil, without a cage, and without a maker's formula.
"""

from typing import Any

import numpy as np

from analytic.cage.torque import CagePoint
from analytic.left_out import LeftOut
from analytic.result import FrictionCoefficients, LoadedContact, OnRaces, TorqueParts, TorqueUncertainty
from analytic.standing import Standing
from analytic.verdicts import Verdicts
from fembearing.report.torque import Band, TorqueRecord

RPM = np.pi / 30  # rad/s


def point(number: int = 0, **changed: Any) -> TorquePoint:
    """At 600, 750, ... rpm and 700, 720, ... N; number : of the point, from 0"""
    given: dict[str, Any] = {
        "inner_speed": (600 + 150 * number) * RPM,
        "axial_load": 700.0 + 20 * number,
        "radial_load": 0.0,
        "moment": 0.0,
        "contact_angle": 0.3013,
        "torque": TorqueParts(total=0.04, race=0.04, spin=0.03, conformity=0.01, hysteresis=None),
        "friction_coefficient": FrictionCoefficients(inner=0.0612, outer=0.0573, pocket=None),
        **dict.fromkeys(("film", "asperity_share", "boundary_share"), OnRaces(inner=None, outer=None)),
        "contact": OnRaces(inner=loaded(310.0), outer=loaded(290.0)),
        "uncertainty": TorqueUncertainty(numerical=0.013, model=None, model_parts=None),
        "cage": CagePoint(),
        "ring": None,
    }
    return TorquePoint(**given | changed)


def loaded(load: float, **changed: float) -> LoadedContact:
    given = {"semi_axis_rolling": 0.12e-3, "semi_axis_transverse": 0.88e-3, "peak_pressure": 1.7e9, "approach": 5.3e-6}
    return LoadedContact(load=load, **given | changed)


def lost(number: int) -> LeftOut:
    """The same point, without a torque."""
    row = point(number)
    loads = {name: getattr(row, name) for name in ("inner_speed", "axial_load", "radial_load", "moment")}
    return LeftOut(point=number, reason="a ball fell out", **loads)


def record(*points: TorquePoint, **changed: Any) -> TorqueRecord:
    given: dict[str, Any] = {
        **dict.fromkeys(("gap_roughness", "clearances", "pair", "other_candidate", "prediction")),
        **dict.fromkeys(("effects", "measured_points", "warnings", "notes", "inputs", "left_out"), ()),
        "provenance": {},
        "seconds": 0.3,
        "tolerance": 0.02,
        "interval": (None,) * len(points),
        "catalogue_band": Band(low=None, high=None, values={}, note="no maker's formula holds"),
        "verdicts": Verdicts(numerical=None, physical=()),
        "standing": Standing(word="check", reason="no maker's formula holds"),
    }
    return TorqueRecord(points=points, **given | changed)
