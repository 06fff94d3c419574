"""What is said of a friction torque: headline, parts, heaviest ball, effects, inputs and limits."""

from analytic.scene import OwnTraction
from analytic.scene_torque import SceneTorque
from fembearing.quantities import SYSTEMS, Units
from fembearing.report.document import Block, Bullets, Drawing, Section, Text
from fembearing.report.headline import film_words, headline_table, makers_words
from fembearing.report.phrases import clearances_of, friction_of, numerical_words
from fembearing.report.tables.cage import cage_tables
from fembearing.report.tables.inputs import effects_table, inputs_table
from fembearing.report.tables.points import shown_places
from fembearing.report.tables.prediction import prediction_tables
from fembearing.report.tables.torque import ball_table, pair_table, torque_table
from fembearing.report.tables.verdicts import physical_table
from fembearing.report.torque import cage_motion

CAPTION = "Friction torque by effect, with the 95 % interval of the total and the formulas of makers, as far as known."
METHODS = ("loads", "contacts", "sliding", "kinematics", "cage")


def headline_section(result: SceneTorque) -> Section:
    """What was computed, the torque with its interval, the film, the makers' formulas, and how far to trust it."""
    units = SYSTEMS[result.scene.report.units]
    lines = [line for line in (film_words(result), makers_words(result, units)) if line is not None]
    standing = Text(result.standing.reason, verdict=result.standing.word)
    return Section("", [headline_table(result, units), *map(Text, lines), standing])


def torque_sections(result: SceneTorque, *, figure: str = "") -> list[Section]:
    """All that is known of a torque beyond its headline;  figure : data address of its plot; empty: none"""
    friction, places, units = result.friction, shown_places(result), SYSTEMS[result.scene.report.units]
    caption = (
        "Friction torque by effect, with the 95 % interval of the total and the formulas of makers, as far as known."
    )
    parts: list[Block] = [Drawing(figure, caption)] if figure else []
    parts.append(torque_table(result, result.scene.bearing.name, places, units))
    if friction.pair is not None:
        parts.append(pair_table(friction.pair, places, units))
    if friction.clearances is not None:
        parts.append(Text(clearances_of(friction.clearances, units)))
    contacts = [ball_table(result, places, units), *cage_tables(cage_motion(result), result, places, units)]
    effects = effects_table(friction.effects, friction.effects.among(result.places.computed).points)
    return [
        Section("Parts of the torque", [*parts, *prediction_tables(result, places, units)]),
        Section("Contacts and cage", contacts),
        Section("Effects", [effects]),
        Section("Inputs and methods", _inputs(result, units)),
        limits_section(result, units),
    ]


def limits_section(result: SceneTorque, units: Units) -> Section:
    """The physical limits, what else to know of the torque, and the verdicts in a word each."""
    numerical = result.verdicts.numerical
    words = [*result.notes, *([] if numerical is None else [numerical_words(numerical)])]
    summary = result.verdicts.summary
    verdict = Text(summary.words.partition(": ")[2], verdict=summary.overall)
    return Section(
        "Solver error and limits", [physical_table(result.verdicts.physical, units), *map(Text, words), verdict]
    )


def _inputs(result: SceneTorque, units: Units) -> list[Block]:
    """The inputs that are not given as known, with where they come from, and the methods."""
    scene, friction = result.scene, result.friction
    stated = [each for each in result.inputs if each.status != "given"]
    blocks: list[Block] = []
    if stated:
        blocks.append(inputs_table("Printed, derived and assumed inputs", stated, units))
        if scene.assumed:
            sources = [f"{key}: {source}" for key, source in scene.assumed.items()]
            blocks.append(Bullets(sources, "Assumed in this scene:"))
    names = [name for name in METHODS if name != "cage" or friction.cage is not None]
    methods = [f"{name} by {friction.provenance[name]}".replace("_", " ") for name in names]
    source = friction_of(coefficient=scene.friction_coefficient, is_lubricated=scene.has_friction)
    law = None if scene.lubricant is None else scene.lubricant.traction
    own = f" Law of traction: {law.origin}." if isinstance(law, OwnTraction) else ""
    return [*blocks, Text(f"Methods: {'; '.join(methods)}. Friction: {source}.{own}")]
