"""What the paper behind the production model prints, next to what a scene gives.

The paper's numbers are computed too: this is a cross-check. Where a scene says that inputs of it were chosen until the
paper's numbers came out (its `calibration`), agreement in those is a fit, and no evidence for either.
"""

import csv
from dataclasses import asdict, dataclass
from importlib.resources import files

import numpy as np

from analytic.result import FrictionTorque
from analytic.scene import Bearing, Operation, Scene

PAPER = "Effect of Surface Roughness on the Friction Moment in a Ball Bearing"
BALLS, BALL_DIAMETER, PITCH_DIAMETER, THRUST = 9, 7.94e-3, 39.01e-3, 1000.0  # of the paper's case; m, N
SAME = 1e-6  # relative: two numbers that a person wrote alike
UNITS = {"N mm": 1e-3, "N": 1.0}
NOT_GIVEN = (  # by the paper, and so chosen by every scene: key of the scene file, unit
    ("lubricant", "viscosity", "Pa s"),
    ("lubricant", "pressure_viscosity", "1/Pa"),
    ("lubricant", "eyring_stress", "Pa"),
    ("surface", "hardness", "Pa"),
    ("surface", "boundary_friction", ""),
    ("autocorrelation", "length", "m"),
)


@dataclass(frozen=True, kw_only=True)
class Printed:
    """A number of the paper, SI."""

    quantity: str
    rms_roughness: float  # Sq of each surface, m
    inner_speed: float  # rad/s
    value: float  # N m or N
    note: str  # printed, or printed as about


@dataclass(frozen=True, kw_only=True)
class Compared(Printed):
    """A number of the paper with that of the scene."""

    ours: float  # the scene's number, SI
    deviation: float  # from the paper's, relative


@dataclass(frozen=True, kw_only=True)
class Chosen:
    """An input that the paper does not give, as the scene has it."""

    value: float  # SI
    unit: str  # SI


@dataclass(frozen=True, kw_only=True)
class BesidePaper:
    """The numbers of the paper that a scene of the same case has too, at its own speeds and roughness."""

    paper: str  # its title
    absent: str | None  # why no number of the scene is compared
    calibration: str | None  # what was chosen until it came out, in the scene's words
    chosen: dict[str, Chosen]
    rows: tuple[Compared, ...]


def printed_numbers() -> tuple[Printed, ...]:
    """All that the paper's text gives of torques and forces."""
    text = (files("fembearing.compare.torque") / "paper_torque.csv").read_text("utf-8")
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    return tuple(
        Printed(
            quantity=row["quantity"],
            rms_roughness=float(row["rms_roughness_um"]) * 1e-6,
            inner_speed=float(row["inner_speed_rpm"]) * np.pi / 30,
            value=float(row["value"]) * UNITS[row["unit"]],
            note=row["note"],
        )
        for row in csv.DictReader(lines)
    )


def beside_paper(scene: Scene, friction: FrictionTorque | None) -> BesidePaper:
    """The paper's numbers next to a scene's.

    friction : torque of the scene, by its own effects; None where it has none
    """
    absent = _other_case(scene)
    rows: tuple[Compared, ...] = ()
    if absent is None and friction is not None:
        ours = ((printed, _ours(printed, scene, friction)) for printed in printed_numbers())
        rows = tuple(_compared(printed, value) for printed, value in ours if value is not None)
    if absent is None and not rows:
        absent = "the scene has neither of its speeds, 100 and 500 rpm, at one of its finishes, Sq 0.1 and 1 um"
    return BesidePaper(
        paper=PAPER,
        absent=absent,
        calibration=scene.calibration,
        chosen={} if absent else _chosen(scene),
        rows=rows,
    )


def is_papers_case(scene: Scene) -> bool:
    """Whether bearing, load and the way to the friction coefficient are the paper's."""
    return _other_case(scene) is None


def _other_case(scene: Scene) -> str | None:
    """In what the scene is not the paper's case."""
    if not is_papers_bearing(scene.bearing):
        return "the scene has another bearing"
    if not is_papers_load(scene.operation):
        return f"the paper has {THRUST:g} N of thrust alone, and the scene another load"
    if scene.surface is None or scene.lubricant is None or scene.friction_coefficient is not None:
        return (
            "the paper's friction coefficient comes from mixed lubrication; the scene gives a coefficient, or lacks a "
            "lubricant or a surface"
        )
    return None


def is_papers_bearing(bearing: Bearing) -> bool:
    """Whether balls and pitch are those of the paper's 6205."""
    own = bearing.ball_count, bearing.ball_diameter, bearing.pitch_diameter
    return bool(np.allclose(own, (BALLS, BALL_DIAMETER, PITCH_DIAMETER), rtol=SAME))


def is_papers_load(operation: Operation) -> bool:
    """Whether it is the paper's thrust alone, at every operating point."""
    sideways = np.any(operation.radial_load) or np.any(operation.moment)
    return not sideways and bool(np.allclose(operation.axial_load, THRUST, rtol=SAME))


def _chosen(scene: Scene) -> dict[str, Chosen]:
    surface = scene.surface
    groups = {
        "lubricant": scene.lubricant,
        "surface": surface,
        "autocorrelation": None if surface is None else surface.autocorrelation,
    }
    values = {
        f"{group} {name}".replace("_", " "): (getattr(groups[group], name, None), unit)
        for group, name, unit in NOT_GIVEN
    }
    values["hysteresis loss"] = (scene.hysteresis_loss, "")
    return {name: Chosen(value=float(value), unit=unit) for name, (value, unit) in values.items() if value is not None}


def _compared(printed: Printed, ours: float) -> Compared:
    return Compared(**asdict(printed), ours=ours, deviation=ours / printed.value - 1)


def _ours(printed: Printed, scene: Scene, friction: FrictionTorque) -> float | None:
    """The scene's number at the same speed and roughness; None where it has none."""
    roughness = None if scene.surface is None else scene.surface.rms_roughness
    if roughness is None or not np.isclose(roughness, printed.rms_roughness, rtol=SAME):
        return None
    (at,) = np.nonzero(np.isclose(np.abs(friction.inner_speed), printed.inner_speed, rtol=SAME))
    if not at.size:
        return None
    point = int(at[0])
    if printed.quantity == "cage_max_force":
        motion = None if friction.cage is None else friction.cage.motion[point]
        return None if motion is None else motion.max_force
    if printed.quantity == "total_torque" and friction.torque.cage is None:
        return None  # the paper's has the cage in it
    part = getattr(friction.torque, printed.quantity.removesuffix("_torque"))
    return None if part is None else float(part[point])
