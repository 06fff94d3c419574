"""`fembearing list`: what scene files may name."""

import json
import math
from collections.abc import Callable, Sequence
from typing import Annotated, Any, Literal, get_args

import typer

from analytic.given import UnitSystem
from fembearing.cli.options import AsJson, Units

Topic = Literal["bearings", "oils", "materials", "scenes", "effects"]
Schema = Literal["scene", "grid", "report", "torque", "compare", "duty"]
Row = dict[str, Any]  # SI
OF_BEARING = (
    *("designation", "kind", "bore", "outside", "width", "ball_count", "ball_diameter", "nominal_angle"),
    *("dynamic_load_rating", "static_load_rating", "grade", "maker"),
)
NARROW = 6  # columns; so many and more stand close together, to fit a screen of 80 characters


def listing(
    topic: Annotated[
        Topic | None, typer.Argument(metavar="TOPIC", help=f"One of {', '.join(get_args(Topic))}.")
    ] = None,
    beginning: Annotated[str, typer.Argument(metavar="FILTER", help="Beginning of the names, for example 62.")] = "",
    schema: Annotated[
        Schema | None,
        typer.Option(
            help="Print the JSON Schema of a file in place of a list, for the completion of keys in editors. scene, "
            "grid: input files; report, torque, compare, duty: JSON results."
        ),
    ] = None,
    units: Units = None,
    as_json: AsJson = False,
) -> None:
    """List the names for scenes: bearings of the catalog, oils, materials, built-in scenes, effects."""
    if (topic is None) == (schema is None):
        from analytic.errors import InputError

        raise InputError(f"give a topic, one of {', '.join(get_args(Topic))}, or --schema scene")
    if topic is None:
        assert schema is not None
        typer.echo(json.dumps(_schema_of(schema), indent=1, ensure_ascii=False))
        return
    wanted = _plain(beginning)
    rows = [row for row in ROWS[topic]() if _plain(next(iter(row.values()))).startswith(wanted)]
    if not rows:
        from analytic.errors import InputError

        raise InputError(f"none of the {topic} begins with {beginning!r}; `fembearing list {topic}` shows all")
    if as_json:
        from fembearing.cli.console import print_json

        print_json({topic: rows})
    else:
        _print(_bearing_columns(units or "metric") if topic == "bearings" else COLUMNS[topic], rows)


def _schema_of(file: Schema) -> dict[str, Any]:
    """Each import is slow, and needed by one file only."""
    if file == "scene":
        from analytic.scenefile.schema import scene_schema

        return scene_schema()
    if file == "grid":
        from fembearing.sweep.schema import grid_schema

        return grid_schema()
    from fembearing.report.schema import schema_of

    return schema_of("validation" if file == "report" else file)


def _plain(name: str) -> str:
    return "".join(name.split()).casefold()


def _bearings() -> list[Row]:
    from analytic.catalog.bearing_rows import bearing_names, find_bearing

    return [{key: getattr(bearing, key) for key in OF_BEARING} for bearing in map(find_bearing, bearing_names())]


def _oils() -> list[Row]:
    from analytic import catalog
    from analytic.scenefile.oil import assumed_properties

    return [
        {
            "oil": name,
            "kind": row["kind"],
            "base_oil": row["base oil"],
            "kinematic_viscosity_40": _si(row["viscosity_40 [mm^2/s]"]),
            "kinematic_viscosity_100": _si(row["viscosity_100 [mm^2/s]"]),
            "assumed": list(assumed_properties(name)),
        }
        for name, row in catalog.rows("oils").items()
    ]


def _si(viscosity: str) -> float | None:
    """m^2/s of a viscosity in mm^2/s; None: not known."""
    return float(viscosity) * 1e-6 if viscosity else None


def _materials() -> list[Row]:
    from analytic import catalog

    return [{"material": name} | catalog.entry("materials", name) for name in catalog.names("materials")]


def _scenes() -> list[Row]:
    from analytic import catalog

    return [{"scene": name, "title": catalog.entry("scenes", name)["name"]} for name in catalog.names("scenes")]


def _effects() -> list[Row]:
    from analytic.effects import TABLE

    return [
        {
            "effect": entry.name,
            "meaning": entry.meaning,
            "kind": entry.kind,
            "needs": entry.needs.keys.replace("`", "") if entry.needs is not None else None,
        }
        for entry in TABLE
    ]


ROWS: dict[Topic, Callable[[], list[Row]]] = {
    "bearings": _bearings,
    "oils": _oils,
    "materials": _materials,
    "scenes": _scenes,
    "effects": _effects,
}
SHORT = {"pressure_viscosity": "alpha", "viscosity_100": "nu100"}
Column = tuple[str, Callable[[Row], str]]


def _text(key: str, head: str = "") -> Column:
    return head or key.replace("_", " "), lambda row: "" if row.get(key) is None else str(row[key])


def _number(key: str, head: str, factor: float, form: str = "g") -> Column:
    return head, lambda row: "" if row[key] is None else f"{row[key] * factor:{form}}"


COLUMNS: dict[Topic, Sequence[Column]] = {
    "oils": (
        _text("oil"),
        _text("kind"),
        _text("base_oil"),
        _number("kinematic_viscosity_40", "40 degC, mm2/s", 1e6),
        _number("kinematic_viscosity_100", "100 degC", 1e6),
        ("assumed", lambda row: ", ".join(SHORT[each] for each in row["assumed"])),
    ),
    "materials": (
        _text("material"),
        _text("youngs_modulus", "E"),
        _text("poisson_ratio", "nu"),
        _text("density"),
        _text("hardness"),
    ),
    "scenes": (_text("scene"), _text("title")),
    "effects": (_text("effect"), _text("meaning"), _text("needs")),
}


def _bearing_columns(system: UnitSystem) -> Sequence[Column]:
    """The columns of bearings, in mm and kN or in inches and 1000 lbf."""
    from analytic.units import INCH, POUND

    length, force, unit, heavy = (
        (1e3, 1e-3, "mm", "kN") if system == "metric" else (1 / INCH, 1e-3 / POUND, "in", "klbf")
    )
    return (
        _text("designation"),
        ("type", lambda row: row["kind"].split()[0]),
        _number("bore", "d", length, ".4g"),
        _number("outside", "D", length, ".4g"),
        _number("width", "B", length, ".4g"),
        _text("ball_count", "Z"),
        _number("ball_diameter", f"Dw, {unit}", length, ".5g"),
        _number("nominal_angle", "deg", math.degrees(1), ".3g"),
        _number("dynamic_load_rating", "C", force, ".4g"),
        _number("static_load_rating", f"C0, {heavy}", force, ".4g"),
        _text("grade"),
    )


def _print(columns: Sequence[Column], rows: Sequence[Row]) -> None:
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    from fembearing.cli.console import out

    gap = 0 if len(columns) >= NARROW else 1  # beside the blank between columns
    table = Table(*(head for head, _ in columns), box=SIMPLE_HEAD, padding=(0, gap, 0, 0))
    table.columns[0].no_wrap = True
    for row in rows:
        table.add_row(*(text_of(row) for _, text_of in columns))
    out.print(table, markup=False)
