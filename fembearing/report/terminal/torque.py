"""The friction torque as tables for a terminal or a pipe of 80 characters."""

from collections.abc import Mapping, Sequence

import numpy as np
from rich.console import Console
from rich.markup import escape
from rich.padding import Padding

from analytic.result import COLUMNS, COORDINATES, FrictionTorque, PairPart
from analytic.words import angle_of
from fembearing.quantities import CONTACT, MICRO, NEWTON_MILLIMETRE, QUANTITIES, RPM
from fembearing.report.phrases import (
    LOADS,
    PAIRS,
    REGIME,
    SHARES,
    capital,
    clearances_of,
    friction_of,
    pair_of,
    percent,
    uncertainty_of,
)
from fembearing.report.tables.cage import motion_table, regime_table
from fembearing.report.tables.inputs import effects_table, inputs_table
from fembearing.report.terminal.table import printed, table_of
from fembearing.report.terminal.verdicts import print_notes, print_numerical, print_physical
from fembearing.report.torque import cage_motion
from fembearing.verify.torque.scene_torque import SceneTorque

NM = NEWTON_MILLIMETRE.factor
RESIDUE = 1e-6  # of the total: a smaller part is what is left of a balance of the balls, not a torque
MOST_POINTS = 12  # shown; the JSON has all
HEADS = {
    "spin": "spin",
    "conformity": "conf.",
    "hysteresis": "hyst.",
    "rolling": "roll.",
    "cage": "cage",
    "declared": "decl.",
}


def print_torque(out: Console, result: SceneTorque) -> None:
    """Print a friction torque: parts, contacts, cage and effects, and the verdicts, in the last line in a word each."""
    friction, numbers = result.friction, result.places.computed
    points = {point: numbers[point] + 1 for point in shown_points(len(numbers))}  # place in the arrays, and number
    _print_parts(out, result, points)
    if len(points) < len(numbers) or len(result.left_out) > MOST_POINTS:
        out.print(f"{len(points)} of {result.places.size} operating points; --json has all of them.")
    scene = result.scene
    model = None if friction.model_uncertainty is None else float(friction.model_uncertainty.max())
    varied = {name: float(part.max()) for name, part in (friction.model_parts or {}).items()}
    out.print(
        f"In {NEWTON_MILLIMETRE.name} about the bearing axis; +-: numerical uncertainty.\n"
        f"{uncertainty_of(model, varied)}\n{capital(result.catalogue.note)}.\n",
        style="dim",
        markup=False,
    )
    if friction.clearances is not None:
        out.print(f"{clearances_of(friction.clearances)}\n", markup=False)
    if friction.pair is not None:
        _print_pair(out, friction.pair, points)
    if result.prediction is not None:
        from fembearing.report.terminal.prediction import print_prediction

        print_prediction(out, result.prediction.rows, points)
    _print_contacts(out, friction, points)
    _print_cage(out, result, points)
    _print_effects(out, friction)
    _print_inputs(out, result)
    names = ("loads", "contacts", "sliding", *(() if friction.cage is None else ("cage",)))
    methods = [f"{name} by {friction.provenance[name]}".replace("_", " ") for name in names]
    source = friction_of(coefficient=scene.friction_coefficient, is_lubricated=scene.has_friction)
    out.print(f"Methods: {'; '.join(methods)}. Friction: {source}.\n", markup=False)
    verdicts = result.verdicts
    print_physical(out, verdicts.physical)
    print_notes(out, result.notes)
    assert verdicts.numerical is not None
    print_numerical(out, verdicts.numerical)
    out.print(
        f"{verdicts.overall}: numerical {verdicts.numerical.verdict}, physical {verdicts.worst_physical}, "
        f"{friction.seconds:.2g} s"
    )


def shown_points(count: int) -> list[int]:
    """The operating points that a table shows: all, or an even choice of many."""
    return np.unique(np.linspace(0, count - 1, min(count, MOST_POINTS)).round().astype(int)).tolist()


def point_columns(series: Mapping[str, Sequence[float]]) -> tuple[dict[str, list[str]], list[str]]:
    """Speed and loads for a table: columns with their heads, and in words what is the same at every point.

    series : speed and loads of every operating point, keyed as `analytic.result.COORDINATES`
    """
    columns = {RPM.name: [f"{speed * RPM.factor:.5g}" for speed in series["inner_speed"]]}
    fixed = []
    for name in LOADS:
        values, load, unit = series[name], COORDINATES[name], QUANTITIES[name].shown
        if len(set(values)) > 1:
            columns[f"{load.symbol}, {unit.name}"] = [f"{unit.number(value):.4g}" for value in values]
        elif values[0] or name == "axial_load":
            fixed.append(f"{load.meaning} {unit.written(values[0], '.5g')}")
    return columns, fixed


def _print_parts(out: Console, result: SceneTorque, points: Mapping[int, int]) -> None:
    """A row for each point: parts, total, uncertainty and catalogue band; a point without a torque has none."""
    friction, band, whole = result.friction, result.catalogue.band, result.columns()
    columns, fixed = point_columns({name: np.asarray(whole[name].values).tolist() for name in COORDINATES})
    bearings = "" if friction.pair is None else "two "
    words = ", ".join([f"Friction torque of {bearings}{result.scene.bearing.name}", *fixed])
    out.print(words, style="italic", markup=False)
    parts = {name: values for name in HEADS if (values := getattr(friction.torque, name)) is not None}
    totals = ("total", "+-", *(("catalogue",) if band is not None else ()))
    table = table_of(("#", *columns, *(HEADS[name] for name in parts), *totals), fixed=totals)
    rows = {each.point + 1: [*("" for _ in parts), "left out"] for each in result.left_out[:MOST_POINTS]}
    for point, number in points.items():
        total = friction.torque.total[point]
        shown = (part[point] if part[point] > RESIDUE * total else 0.0 for part in parts.values())
        rows[number] = [
            *(f"{part * NM:.3g}" for part in shown),
            f"{total * NM:.4g}",
            percent(float(friction.numerical_uncertainty[point])),
            *(() if band is None else (f"{band.low[point] * NM:.3g}-{band.high[point] * NM:.3g}",)),
        ]
    for number, cells in sorted(rows.items()):
        table.add_row(str(number), *(values[number - 1] for values in columns.values()), *cells)
    out.print(table)


def _print_pair(out: Console, pair: PairPart, points: Mapping[int, int]) -> None:
    """The loads and the torque of each bearing of a pair, and the pair's stiffness."""
    found = pair.equilibrium
    sideways = {name: QUANTITIES[name].shown for name in ("radial_load", "moment") if np.any(getattr(found, name))}
    heads = [
        "#",
        "bearing",
        "Fa, N",
        *(f"{COORDINATES[name].symbol}, {unit.name}" for name, unit in sideways.items()),
        "ball, N",
    ]
    torque = f"torque, {NEWTON_MILLIMETRE.name}"
    table = table_of(
        (*heads, torque, "dFa/dz, N/um"), title=f"Bearings of the pair, {PAIRS[pair.kind]}", left=("bearing",)
    )
    for point in points:
        for bearing, name in enumerate(("first", "second")):
            table.add_row(
                str(points[point]),
                f"{name}, relieved" if found.is_relieved[bearing, point] else name,
                f"{found.axial_load[bearing, point]:.4g}",
                *(f"{unit.number(getattr(found, load)[bearing, point]):.4g}" for load, unit in sideways.items()),
                f"{found.ball_load[bearing, point]:.4g}",
                f"{pair.total[bearing, point] * NM:.4g}",
                "" if bearing else f"{found.stiffness[point] / MICRO.factor:.4g}",
            )
    out.print(table)
    out.print(f"{pair_of(pair.rows)}\n", style="dim", markup=False)


def _print_contacts(out: Console, friction: FrictionTorque, points: Mapping[int, int]) -> None:
    """The ball that presses hardest, on both races."""
    quantities = {name: CONTACT[name] for name in ("peak_pressure", "semi_axis_rolling", "semi_axis_transverse")}
    heads = ["#", "race", "load, N", *(f"{each.symbol}, {each.shown.name}" for each in quantities.values())]
    coefficients, films, shares = friction.friction_coefficient, friction.film, friction.asperity_share
    optional = {
        COLUMNS["friction_coefficient_inner"].symbol: (coefficients, 1.0),
        QUANTITIES["film"].heading: (films, QUANTITIES["film"].shown.factor),
        "asperities, %": (shares, 100.0),
    }
    known = {head: (group, factor) for head, (group, factor) in optional.items() if group.inner is not None}
    table = table_of((*heads, *known), title="Heaviest ball", left=("race",))
    for point in points:
        for race in ("inner", "outer"):
            contact = getattr(friction, race)
            table.add_row(
                str(points[point]),
                race,
                f"{contact.load[point]:.4g}",
                *(f"{getattr(contact, name)[point] * each.shown.factor:.4g}" for name, each in quantities.items()),
                *(f"{getattr(group, race)[point] * factor:.3g}" for group, factor in known.values()),
            )
    out.print(table)
    angles = friction.contact_angle[list(points)]
    angle = " to ".join(dict.fromkeys((angle_of(angles.min()), angle_of(angles.max()))))
    out.print(
        f"Contact angle {angle}, mean of both races. a along rolling, b transverse"
        + ("; asperities: their share of the load" if "asperities, %" in known else "")
        + ".\n",
        style="dim",
    )


def _print_cage(out: Console, result: SceneTorque, points: Mapping[int, int]) -> None:
    """The cage at the points where it moved: forces and torque, and what its motion asks of the races."""
    rows = cage_motion(result) or ()
    moved = {number: rows[point] for point, number in points.items() if rows and rows[point].torque is not None}
    if not rows:
        return
    blocks = max((row.block for row in moved.values() if row.block is not None), default=0.0)
    out.print(printed(motion_table(moved)))
    out.print(
        f"All forces: mean of their sum. Largest: of one ball on its pocket, in {blocks:.2g} s (median of blocks).\n",
        style="dim",
    )
    out.print(printed(regime_table(moved)))
    out.print(f"{REGIME}\n", style="dim")


def _print_effects(out: Console, friction: FrictionTorque) -> None:
    """Each effect with its decision, share and reason."""
    out.print(printed(effects_table(friction.shares)))
    out.print(f"{SHARES}\n", style="dim")


def _print_inputs(out: Console, result: SceneTorque) -> None:
    """The inputs that are not given as known, with where they come from."""
    stated = [each for each in result.inputs if each.status != "given"]
    if not stated:
        return
    out.print(printed(inputs_table("Inputs that are printed, derived or assumed", stated)))
    out.print("+-: one standard deviation. --json and the report name every source.\n", style="dim")
    if sources := result.scene.assumed:
        out.print("Assumed by this scene:")
        for key, source in sources.items():
            out.print(Padding(f"{key}: {escape(source)}", (0, 0, 0, 2)))
        out.print()
