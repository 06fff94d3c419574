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
from fembearing.report.torque import cage_motion


def print_headline(out: Console, result: SceneTorque) -> None:
    """Print what was computed, the torque with its interval, the film, the makers' formulas, and the verdict."""
    units = SYSTEMS[result.scene.report.units]
    show(out, headline_table(result, units))
    for line in (film_words(result), makers_words(result, units), f"{result.standing.word}: {result.standing.reason}"):
        if line is not None:
            out.print(line, markup=False)


def print_details(out: Console, result: SceneTorque) -> None:
    """Print a friction torque: parts, contacts, cage and effects, and the verdicts, in the last line in a word each."""
    scene, friction, verdicts = result.scene, result.friction, result.verdicts
    places, units = shown_places(result), SYSTEMS[scene.report.units]
    show(out, torque_table(result, scene.bearing.name, places, units))
    if friction.clearances is not None:
        out.print(f"{clearances_of(friction.clearances, units)}\n", markup=False)
    tables = [*prediction_tables(result, places, units), ball_table(result, places, units)]
    tables += cage_tables(cage_motion(result), result, places, units)
    for table in (*([] if friction.pair is None else [pair_table(friction.pair, places, units)]), *tables):
        show(out, table)
    show(out, effects_table(friction.effects, friction.effects.among(result.places.computed).points))
    _print_inputs(out, result, units)
    names = ("loads", "contacts", "sliding", "kinematics", *(() if friction.cage is None else ("cage",)))
    methods = [f"{name} by {friction.provenance[name]}".replace("_", " ") for name in names]
    source = friction_of(coefficient=scene.friction_coefficient, is_lubricated=scene.has_friction)
    law = None if scene.lubricant is None else scene.lubricant.traction
    own = f" Law of traction: {law.origin}." if isinstance(law, OwnTraction) else ""
    out.print(f"Methods: {'; '.join(methods)}. Friction: {source}.{own}\n", markup=False)
    print_verdicts(out, verdicts.physical, result, units)
    out.print(f"{verdicts.summary.words}, {friction.seconds:.2g} s")


def print_verdicts(
    out: Console, physical: Sequence[PhysicalCheck], torque: SceneTorque | None, units: Units = METRIC
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
