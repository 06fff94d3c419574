"""The friction torque as tables for a terminal or a pipe of 80 characters."""

from collections.abc import Sequence

from rich.console import Console
from rich.markup import escape
from rich.padding import Padding

from analytic.scene import OwnTraction
from analytic.scene_torque import SceneTorque
from analytic.verdicts import PhysicalCheck
from fembearing.quantities import METRIC, SYSTEMS, Units
from fembearing.report.headline import film_words, headline_table, makers_words
from fembearing.report.phrases import clearances_of, friction_of, numerical_words
from fembearing.report.tables.cage import cage_tables
from fembearing.report.tables.inputs import effects_table, inputs_table
from fembearing.report.tables.points import shown_places
from fembearing.report.tables.prediction import prediction_tables
from fembearing.report.tables.torque import ball_table, pair_table, torque_table
from fembearing.report.tables.verdicts import physical_table
from fembearing.report.terminal.table import show
from fembearing.report.torque import TorqueRecord, cage_motion, torque_record


def print_headline(out: Console, result: SceneTorque) -> None:
    """Print what was computed, the torque with its interval, the film, the makers' formulas, and the verdict."""
    record = torque_record(result)
    units = SYSTEMS[result.scene.report.units]
    show(out, headline_table(result.scene, record, units))
    for line in (film_words(result), makers_words(record, units), f"{record.standing.word}: {record.standing.reason}"):
        if line is not None:
            out.print(line, markup=False)


def print_details(out: Console, result: SceneTorque) -> None:
    """Print a friction torque: parts, contacts, cage and effects, and the verdicts, in the last line in a word each."""
    scene, verdicts, torque = result.scene, result.verdicts, torque_record(result, measured=True)
    places, units = shown_places(torque), SYSTEMS[scene.report.units]
    show(out, torque_table(torque, scene.bearing.name, places, units))
    if torque.clearances is not None:
        out.print(f"{clearances_of(torque.clearances, units)}\n", markup=False)
    tables = [*prediction_tables(torque, places, units), ball_table(torque, places, units)]
    tables += cage_tables(cage_motion(result), torque, places, units)
    for table in (*([] if torque.pair is None else [pair_table(torque.pair, places, units)]), *tables):
        show(out, table)
    show(out, effects_table(torque.effects, torque.measured_points))
    _print_inputs(out, result, units)
    names = ("loads", "contacts", "sliding", "kinematics", *(() if result.friction.cage is None else ("cage",)))
    methods = [f"{name} by {torque.provenance[name]}".replace("_", " ") for name in names]
    source = friction_of(coefficient=scene.friction_coefficient, is_lubricated=scene.has_friction)
    law = None if scene.lubricant is None else scene.lubricant.traction
    own = f" Law of traction: {law.origin}." if isinstance(law, OwnTraction) else ""
    out.print(f"Methods: {'; '.join(methods)}. Friction: {source}.{own}\n", markup=False)
    print_verdicts(out, verdicts.physical, torque, units)
    out.print(f"{verdicts.summary.words}, {torque.seconds:.2g} s")


def print_verdicts(
    out: Console, physical: Sequence[PhysicalCheck], torque: TorqueRecord | None, units: Units = METRIC
) -> None:
    """Print the physical limits; of a torque its notes, and whether it is solved within the tolerance."""
    show(out, physical_table(physical, units))
    if torque is not None and torque.verdicts.numerical is not None:
        for note in (*torque.notes, numerical_words(torque.verdicts.numerical)):
            out.print(note, markup=False)


def _print_inputs(out: Console, result: SceneTorque, units: Units) -> None:
    """The inputs that are not given as known, with where they come from."""
    stated = [each for each in result.inputs if each.status != "given"]
    if not stated:
        return
    show(out, inputs_table("Printed, derived and assumed inputs", stated, units))
    if sources := result.scene.assumed:
        out.print("Assumed in this scene:")
        for key, source in sources.items():
            out.print(Padding(f"{key}: {escape(source)}", (0, 0, 0, 2)))
        out.print()
