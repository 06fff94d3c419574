"""Friction of a ball on both races by formula, production and reference."""

from collections.abc import Iterator

from analytic.units import METRIC, Units, speed_words
from analytic.words import Unit, percent_of
from fembearing.check.comparison import Comparison
from fembearing.check.contact.scene_contact import which_bearing
from fembearing.check.creep.scene_creep import CreepNumbers, RaceNumbers
from fembearing.report.document import Group, Head, Section, Table, Text
from fembearing.report.phrases import shown
from fembearing.report.report import Report

WORDS = (
    "This appendix compares formula and production of friction with a numerical solution of rolling contact: the "
    "heaviest ball between both races, each contact divided into rectangles that stick or slip on elastic half spaces. "
    "The verdict asks whether the reference changes the torque by less than the tolerance."
)
BODIES = {"half-space": "half spaces", "meshed": "ball and race of true shape by finite elements"}
ONE, WATT = Unit("", 1.0), Unit("W", 1.0)


def creep_table(creep: CreepNumbers, units: Units = METRIC) -> Table:
    """A group for each race of the heaviest ball, and one for the torque by sliding of all balls."""
    speed = speed_words(creep.point.inner_speed, units)
    races = [
        Group(
            [_row(words, unit, each) for words, unit, each in _shown(race, units)],
            f"Friction on the {name} race{which_bearing(creep.bearing)}: {units.force.written(race.load, '.4g')} at "
            f"{units.angle.written(abs(race.contact_angle), '.2f')}, inner ring at {speed}",
        )
        for name, race in creep.races.items()
    ]
    whole = Group(
        [_row("torque by sliding", units.torque, creep.torque)],
        f"All balls{which_bearing(creep.bearing)} about the bearing axis",
    )
    heads = [Head("quantity", "name"), Head("formula"), Head("production"), Head("reference")]
    heads += [Head("prod./ref.-1", fixed=True), Head("+-")]
    return Table(
        f"Stick and slip of the heaviest ball{which_bearing(creep.bearing)}",
        heads,
        [*races, whole],
        list(_notes(creep, units)),
    )


def _shown(race: RaceNumbers, units: Units) -> Iterator[tuple[str, Unit, Comparison]]:
    """Words, unit and numbers of each quantity that is not 0 by all methods."""
    length = units.length
    each = {
        "creepage_along": ("creepage along", ONE),
        "creepage_across": ("creepage across", ONE),
        "spin_creepage": ("spin over speed", Unit(f"1/{length.name}", 1 / length.factor)),
        "spin_moment": ("spin moment", units.torque),
        "rolling_moment": ("rolling moment", units.torque),
        "transverse_force": ("transverse force", units.force),
        "slip_share": ("area that slips", units.share),
        "power": ("power", WATT),
    }
    for key, quantity in race.quantities.items():
        methods = quantity.formula or 0.0, quantity.production, quantity.reference
        if max(map(abs, methods)) > quantity.uncertainty:
            yield (*each[key], quantity)


def _row(words: str, unit: Unit, each: Comparison) -> list[str]:
    """Where the reference may be 0, its uncertainty stands in the unit of the quantity."""
    relative = shown(each.relative_uncertainty, ".1%", absent=f"{unit.factor * each.uncertainty:.1g}")
    return [
        f"{words}, {unit.name}" if unit.name else words,
        *(shown(value, ".4g", unit.factor) for value in (each.formula, each.production, each.reference)),
        f"{shown(each.discrepancy, '+.1%', absent='none')} {'*' if each.resolved else ' '}",
        relative,
    ]


def _notes(creep: CreepNumbers, units: Units) -> Iterator[str]:
    yield (
        "+-: numerical uncertainty of the reference, 95 %, relative or, for values near 0, in the unit of the row; "
        "*: the difference exceeds it. Moments and power resist; forces act on the ball."
    )
    yield (
        "Formula: a long ellipse that slides everywhere, closed kinematics; production: marched creep, a free ball; "
        f"reference: rolling contact of {BODIES[creep.compliance]}, stick and slip, a free ball. All by Hertz's "
        "contacts."
    )
    if not creep.spins:
        yield "The ball does not spin: slip is by the conformity of the groove and by elastic creep only."
    if creep.solved_balls < creep.different_balls:
        yield (
            f"{creep.solved_balls} of {creep.different_balls} different balls are solved; the others take the change "
            "of the last one."
        )
    if creep.point.radial_load or creep.point.moment:
        yield "The position of the ring is that of production."
    total = units.torque.written(creep.torque.reference - creep.torque.production, "+.3g")
    yield (
        f"The reference changes the torque by sliding by {creep.change:+.1%}, {total}, +- "
        f"{percent_of(creep.relative_uncertainty, 2)}."
    )
    yield (
        f"Finest grid {creep.strips} strips of {creep.cells} rectangles; reference {creep.seconds:.1f} s, production "
        f"{creep.production_seconds:.2g} s."
    )


def creep_section(document: Report) -> Section:
    """Friction of the heaviest ball of each bearing; without blocks: none was solved."""
    tables = [creep_table(creep, document.units) for creep in document.creep]
    change = (
        []
        if document.creep_change is None
        else [
            Text(
                "With the numerical friction of the heaviest ball the torque at its operating point changes by "
                f"{document.creep_change:+.1%}."
            )
        ]
    )
    return Section("Spin, conformity and creep", [Text(WORDS, wide=True), *tables, *change] if tables else [])
