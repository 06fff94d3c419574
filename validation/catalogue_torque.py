"""The torque of every bearing of the catalogue: python validation/catalogue_torque.py [--out FOLDER]

Every bearing of the grades printed, A and B runs at 1000 rpm in ISO VG 68 of 60 degC, with ground and honed races and
balls that turn freely, by default methods at a tolerance of 5 %. It has two loads: 0.05 C radial, and 0.02 C0 axial.
An angular contact bearing under a radial load alone slides apart, so it also carries 1.25 Fr tan(nominal angle), the
thrust by which half of its balls are loaded. Its radial load acts at its load centre, where the lines of contact meet
the axis; anywhere else a single bearing tilts, until balls run on a shoulder. The program writes catalogue_torque.csv, one row for each bearing and
load, and the figure catalogue_torque.png into the folder (validation/reports), and prints failures, kinds of warnings
and what lies outside the catalogue band. Torques that the CSV file already has are kept, so that a run that was
stopped goes on; delete the file to compute all of them anew. It takes half an hour on two cores.
"""

import argparse
import csv
import math
import multiprocessing
import os
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from analytic.catalog.bearing_rows import CatalogBearing, bearing_names, find_bearing
from analytic.errors import InputError
from analytic.scene import Scene
from analytic.scenefile.read import scene_of
from analytic.torque import friction_torque

HERE = Path(__file__).parent
GRADES = ("printed", "A", "B")
RADIAL_SHARE, AXIAL_SHARE = 0.05, 0.02  # of C, of C0
SEATED = 1.25  # of Fr tan(angle): the thrust by which half of the balls are loaded, about 1.22 for point contact
CASES = ("radial", "axial")
DOWN = {"radial": [1, 0, 0], "axial": [0, 0, 1]}  # the shaft lies, or it stands
Row = dict[str, str]
COMPUTED = (
    *("designation", "case", "radial_N", "axial_N", "moment_N_m"),
    *("torque_N_mm", "numerical_uncertainty", "warnings", "failure"),
)
NUMBER = re.compile(r"-?\d[\d.e+-]*")


def loads_of(bearing: CatalogBearing, case: str) -> tuple[float, float, float]:
    """(radial, axial) load, N, and moment about the bearing's middle, N m."""
    if case == "axial":
        return 0.0, AXIAL_SHARE * bearing.static_load_rating, 0.0
    radial = RADIAL_SHARE * bearing.dynamic_load_rating
    slope = 0.0 if bearing.nominal_angle is None else math.tan(bearing.nominal_angle)
    return radial, SEATED * radial * slope, -radial * slope * bearing.pitch_diameter / 2


def scene_at(bearing: CatalogBearing, case: str) -> Scene:
    """The scene of one bearing under one load."""
    radial, axial, moment = loads_of(bearing, case)
    document: dict[str, Any] = {
        "name": f"{bearing.designation}, {case}",
        "tolerance": "5 %",
        "bearing": {"catalog": bearing.designation},
        "operation": {
            "radial_load": f"{radial!r} N",
            "axial_load": f"{axial!r} N",
            "moment": f"{moment!r} N m",
            "inner_speed": "1000 rpm",
            "down": DOWN[case],
        },
        "lubricant": {"name": "ISO VG 68", "temperature": "60 degC"},
        "surface": {"finish": "ground and honed"},
        "friction": {"hysteresis_loss": 0.007, "spin_rule": "free"},
    }
    return scene_of(document, origin=bearing.designation)


def computed(task: tuple[str, str]) -> Row:
    """The torque of one bearing under one load, or why there is none."""
    name, case = task
    bearing = find_bearing(name)
    radial, axial, moment = loads_of(bearing, case)
    row = dict.fromkeys(COMPUTED, "") | {
        "designation": name,
        "case": case,
        "radial_N": f"{radial:.5g}",
        "axial_N": f"{axial:.5g}",
        "moment_N_m": f"{moment:.5g}",
    }
    try:
        found = friction_torque(scene_at(bearing, case))
    except InputError as problem:
        return row | {"failure": str(problem)}
    return row | {
        "torque_N_mm": f"{1e3 * found.torque.total[0]:.5g}",
        "numerical_uncertainty": f"{found.numerical_uncertainty[0]:.3g}",
        "warnings": " | ".join((*found.warnings, *(f"unknown: {each}" for each in found.unknown))),
    }


def missing_torques(done: Mapping[tuple[str, str], Row]) -> Iterator[Row]:
    """The torques that are not among those done, on all cores, with the progress."""
    names = [name for name in bearing_names() if find_bearing(name).grade in GRADES]
    tasks = [task for case in reversed(CASES) for name in names if (task := (name, case)) not in done]
    with multiprocessing.Pool(os.cpu_count()) as pool:
        for count, row in enumerate(pool.imap_unordered(computed, tasks), 1):
            if count % 25 == 0 or count == len(tasks):
                print(f"{count} of {len(tasks)} torques", flush=True)
            yield row
