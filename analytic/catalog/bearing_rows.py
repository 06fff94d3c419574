"""Bearings by their designation: dimensions, ratings, balls and grooves, with where each number comes from.

The rows are CSV files in `bearings/`; docs/catalogue.md says how they came about and how far to trust them. They are
read at the first look-up.
"""

import csv
import difflib
import heapq
import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache, partial
from importlib.resources import files
from typing import Literal, cast

from analytic.catalog.designation import Designation, other_kind, plain_name, read_designation, read_maker
from analytic.catalog.origins import INNER_CONFORMITY, OUTER_CONFORMITY, half_width, origins_of
from analytic.catalog.suffixes import Suffix, clearance_of
from analytic.declared import read_only
from analytic.errors import InputError
from analytic.scene import Origin

Row = Mapping[str, str]
Grade = Literal["printed", "A", "B", "C", "D"]
GROUPS = ("C2", "CN", "C3", "C4", "C5")
BY_HAND = "bearing.ball_count, ball_diameter, pitch_diameter, the conformity of both rings and the clearance"
BEARING_STEEL = "100Cr6"  # of every bearing of the catalogue: through-hardened, as makers print it
SILICON_NITRIDE = "Si3N4"
SAME_SIZE = 0.05  # mm, many times what makers' tolerances are
USABLE_SCORE = 10.0  # above, no ball fits the ratings


@dataclass(frozen=True, kw_only=True)
class CatalogBearing:
    """A bearing of the catalogue; SI. None: not known."""

    designation: str  # as found: "NSK 6206" if the maker was named, else "6206"
    maker: str  # whose ratings the row has
    kind: Literal["deep groove", "angular contact"]
    series: str  # "62", "618" or "72 B"; of spindle bearings as their maker calls it, "NSK 72 C" or "GMN SM"
    bore: float  # m
    outside: float  # m
    width: float  # m
    ball_count: int  # Z
    ball_diameter: float  # D, m
    pitch_diameter: float  # d_m, m
    conformity: tuple[float, float]  # r_g/D of inner and outer groove
    nominal_angle: float | None  # rad; None for a deep groove bearing
    shoulder_height: tuple[float | None, float | None]  # inner, outer, above the bottom of the groove, m
    shoulder_half_width: tuple[float | None, float | None]  # inner, outer, as in the scene, m
    far_half_width: tuple[float | None, float | None]  # of the shoulders that thrust does not load, m; None: as far
    dynamic_load_rating: float  # C, N
    static_load_rating: float  # C0, N
    grade: Grade
    ball_material: str  # by its name in the catalogue
    origins: Mapping[str, Origin]  # by scene key
    other_candidate: tuple[int, float] | None  # ball count and ball diameter (m) that fit the ratings second best
    seals: str | None  # what the suffix says
    seal_suffixes: tuple[Suffix, ...]  # that name seals or shields
    clearance_group: str | None  # of ISO 5753-1, if the suffix names one
    suffixes: Mapping[str, str]  # each suffix that was understood, and its meaning
    warnings: tuple[str, ...]
    ball_warnings: tuple[str, ...]  # those of them that are on its balls


def find_bearing(designation: str) -> CatalogBearing:
    """The bearing of this designation, for example "6206", "NSK 6305-2RS/C3" or "7208 BEP".

    Raises InputError, in one line, if the designation is unknown or can be read in two ways, if the catalogue does not
    have this maker's bearing, if a suffix means other balls, or if the balls do not follow from the ratings.
    """
    found = read_designation(designation, _names())
    if found is None:
        raise InputError(_unknown(designation))
    for suffix in found.suffixes:
        if suffix.kind == "refused":
            raise InputError(
                f"bearing {designation!r}: {suffix.text} is {suffix.meaning}; the catalogue has {found.name} "
                f"without it. Give {BY_HAND} by hand"
            )
    main = _rows()[found.name]
    row = _row_of_maker(main, found.maker)
    if row["grade"] == "D":
        raise InputError(_refusal(found, row))
    return _bearing(found, main, row)


@cache
def bearing_names() -> tuple[str, ...]:
    """The designations of all bearings that the catalogue gives, without a maker where several make it."""
    return tuple(name for name, row in _rows().items() if row["grade"] != "D")


def clearance_group(bore: float, group: str) -> tuple[float, float]:
    """(smallest, largest) radial clearance of a deep groove bearing before it is mounted, on the diameter, m.

    bore : m, above 2.5 mm and at most 800 mm
    group : C2, CN, C3, C4 or C5 of [ISO5753]
    Raises InputError outside these.
    """
    if group not in GROUPS:
        raise InputError(f"clearance group {group!r} is unknown; give one of {', '.join(GROUPS)}")
    rows = _read("clearance_groups")
    millimetres = bore * 1e3
    for row in rows:
        # A bore of exactly 30 mm, read from "30 mm", may be 30.000000000000004 here.
        if float(row["bore_over_mm"]) + 1e-9 < millimetres <= float(row["bore_up_to_mm"]) + 1e-9:
            return float(row[f"{group}_min_um"]) / 1e6, float(row[f"{group}_max_um"]) / 1e6
    raise InputError(
        f"clearance group {group} of a bore of {millimetres:g} mm is unknown: ISO 5753-1 covers more than "
        f"{rows[0]['bore_over_mm']} mm up to {rows[-1]['bore_up_to_mm']} mm; give a length"
    )


@cache
def _deep_groove_sizes() -> tuple[tuple[str, tuple[float, float, float]], ...]:
    """(series, (bore, outside diameter, width) in mm) of every deep groove bearing."""
    return tuple(
        (_series(row), (float(row["bore_mm"]), float(row["outside_mm"]), float(row["width_mm"])))
        for row in _read("deep_groove")
    )


def series_of_size(bore: float, outside: float, width: float | None) -> str | None:
    """The series of the deep groove bearing with these boundary dimensions, m; None: no bearing has them.

    The series 60 and 160 differ in width alone; without a width it is 60.
    """
    found = [
        (0.0 if width is None else abs(1e3 * width - size[2]), series)
        for series, size in _deep_groove_sizes()
        if max(abs(1e3 * bore - size[0]), abs(1e3 * outside - size[1])) <= SAME_SIZE
    ]
    return min(found, key=lambda each: (each[0], int(each[1])))[1] if found else None


def _series(row: Row) -> str:
    name = row["designation"]
    if not row["contact_angle_deg"]:
        number = re.match(r"\d+", name)
        assert number is not None, "a deep groove bearing begins with its number"
        bore_code = name[number.end() : number.end() + 1] == "/"
        series = number[0] if bore_code else number[0][: max(2, len(number[0]) - 2)]
        return {"68": "618", "69": "619"}.get(series, series)
    if row["maker"] == "SKF":
        return f"{name[:2]} B"
    if row["maker"] == "NSK":
        return f"NSK {name[:2]} {name.lstrip('0123456789')}"
    return re.split(r"\s*\d", name, maxsplit=1)[0]


@cache
def _read(name: str) -> tuple[Row, ...]:
    text = (files("analytic.catalog") / "bearings" / f"{name}.csv").read_text("utf-8")
    return tuple(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


@cache
def _rows() -> dict[str, Row]:
    return {row["designation"]: row for row in (*_read("deep_groove"), *_read("angular_contact"))}


@cache
def _makers_rows() -> dict[tuple[str, str], Row]:
    return {(row["maker"], row["designation"]): row for row in _read("deep_groove_by_maker")}


@cache
def _names() -> dict[str, str]:
    """From every way to write a number to the name of its row."""
    names: dict[str, str] = {}
    for name, row in _rows().items():
        plain = plain_name(name).removeprefix(row["maker"])
        if row["maker"] == "SKF" and row["contact_angle_deg"]:
            plain = plain[:5]  # 7208 B; the letters behind say inner design, pairing and cage
        names[plain] = name
        if row["contact_angle_deg"] == "":
            if plain[:2] in ("68", "69") and len(plain) == 4:
                names[f"61{plain[1:]}"] = name  # 6804 is ISO's 61804
            elif plain[:4] in ("618/", "619/"):
                names[f"6{plain[2]}{plain[4:]}"] = name  # 618/5 is JIS's 685
    return names


def _row_of_maker(main: Row, maker: str | None) -> Row:
    """The ratings and balls of this maker's bearing; dimensions are those of the main row."""
    if maker is None:
        return main
    own = _makers_rows().get((maker, main["designation"]))
    if own is not None:
        if own["grade"] != "D" and maker in main["supported_by"].split(" + ") and main["ball_status"] == "derived":
            balls = {key: main[key] for key in ("ball_count", "ball_diameter_mm")}
            if _same_balls(own, main):
                return {**main, **own, **balls}
            # Its own best fit is the second candidate; the residuals in the file are those of that fit.
            residuals = dict.fromkeys((f"{rating}_residual_percent" for rating in ("dynamic", "static")), "")
            return {**main, **own, **balls, **{f"second_{key}": own[key] for key in balls}, **residuals}
        remark = ""
        if main["ball_status"] == "printed":
            remark = f"they give {_balls(own)}, and {main['maker']} prints {_balls(main)} for its bearing of this size"
        return {**main, **own, "supported_by": maker, "remark": remark, "ball_status": "derived"}
    if maker != main["maker"]:
        makers = [key[0] for key in _makers_rows() if key[1] == main["designation"]]
        *others, last = sorted({*makers, main["maker"]})
        have = f"{', '.join(others)} and {last}" if others else last
        raise InputError(
            f"{maker} {main['designation'].removeprefix(main['maker']).strip()} is not in the catalogue, that of "
            f"{have} is; name that maker or none, or give {BY_HAND} by hand"
        )
    return main


def _same_balls(one: Row, other: Row) -> bool:
    """Whether count and diameter agree; neighbouring standard sizes differ by 0.3 % at least."""
    count = one["ball_count"] == other["ball_count"]
    return count and math.isclose(float(one["ball_diameter_mm"]), float(other["ball_diameter_mm"]), rel_tol=1e-3)


def _bearing(found: Designation, main: Row, row: Row) -> CatalogBearing:
    angle = row["contact_angle_deg"]
    ball = float(row["ball_diameter_mm"]) / 1e3
    # Another ball than the main row's: the same shoulders in proportion.
    scale = ball / (float(main["ball_diameter_mm"]) / 1e3) if main["ball_diameter_mm"] else 1.0
    heights = [_metres(row[f"shoulder_height_{ring}_mm"]) for ring in ("inner", "outer")]
    inner, outer = (None if height is None else height * scale for height in heights)
    conformity = (INNER_CONFORMITY, OUTER_CONFORMITY)
    widths = (half_width(inner, conformity[0] * ball), half_width(outer, conformity[1] * ball))
    one_sided = row["shoulder_status"] == "loaded side only"
    groups = [*clearance_of(list(found.suffixes))] if not angle else []
    second = row["second_ball_count"]
    seals = tuple(suffix for suffix in found.suffixes if suffix.kind == "seals")
    ceramic = [suffix.text for suffix in found.suffixes if suffix.kind == "ceramic"]
    origins, doubts = origins_of(row, scaled=scale != 1.0), tuple(_doubts(found, row))
    if ceramic:
        origins["ball_material"] = Origin(status="derived", uncertainty=None, source=f"{ceramic[0]} of the designation")
    return CatalogBearing(
        designation=row["designation"] if found.maker is None else _with_maker(row),
        maker=row["maker"],
        kind="angular contact" if angle else "deep groove",
        series=_series(row),
        bore=float(row["bore_mm"]) / 1e3,
        outside=float(row["outside_mm"]) / 1e3,
        width=float(row["width_mm"]) / 1e3,
        ball_count=int(row["ball_count"]),
        ball_diameter=ball,
        pitch_diameter=float(row["pitch_diameter_mm"]) / 1e3,
        conformity=conformity,
        nominal_angle=math.radians(float(angle)) if angle else None,
        shoulder_height=(inner, outer),
        shoulder_half_width=widths,
        far_half_width=(widths[0], 0.0) if one_sided else (None, None),
        dynamic_load_rating=float(row["dynamic_rating_N"]),
        static_load_rating=float(row["static_rating_N"]),
        grade=cast(Grade, row["grade"]),
        ball_material=SILICON_NITRIDE if ceramic else BEARING_STEEL,
        origins=read_only(origins),
        other_candidate=(int(second), float(row["second_ball_diameter_mm"]) / 1e3) if second else None,
        seals="; ".join(f"{suffix.text}: {suffix.meaning}" for suffix in seals) or None,
        seal_suffixes=seals,
        clearance_group=groups[-1] if groups else None,
        suffixes=read_only({suffix.text: suffix.meaning for suffix in found.suffixes}),
        warnings=(*doubts, *_warnings(found, row)),
        ball_warnings=doubts,
    )


def _with_maker(row: Row) -> str:
    name = row["designation"]
    return name if name.startswith(row["maker"]) else f"{row['maker']} {name}"


def _metres(text: str) -> float | None:
    return float(text) / 1e3 if text else None


def _balls(row: Row) -> str:
    return f"{row['ball_count']} x {float(row['ball_diameter_mm']):.3f} mm"


def _doubts(found: Designation, row: Row) -> Iterator[str]:
    """Warnings on balls that may not be the maker's."""
    name = _with_maker(row) if found.maker else row["designation"]
    given = {suffix.text for suffix in found.suffixes}
    if found.maker is None:
        yield from _differing_makers(row)
    if row["grade"] == "B":
        yield f"{name}: balls {_balls(row)} follow from one maker's ratings alone; about 85 % of such are right"
    elif row["grade"] == "C":
        yield f"{name}: balls {_balls(row)} follow from the ratings weakly; compare {_second(row).rstrip(',')}"
    if row["remark"]:
        yield f"{name}: {row['remark']}"
    design = row["designation"].removeprefix(row["designation"][:6])
    if row["maker"] == "SKF" and row["contact_angle_deg"] and ("E" in design) != ("E" in given):
        yield f"{name}: SKF's inner design E and the one without it may differ in balls; {row['designation']} is taken"


def _warnings(found: Designation, row: Row) -> Iterator[str]:
    name = _with_maker(row) if found.maker else row["designation"]
    groups = {*clearance_of(list(found.suffixes))}
    if len(groups) > 1:
        yield f"{name}: suffixes name the clearance groups {', '.join(sorted(groups))}; the last one is taken"
    for suffix in found.suffixes:
        if suffix.kind == "warned":
            yield f"{suffix.text}: {suffix.meaning}"
        elif suffix.kind == "clearance" and row["contact_angle_deg"]:
            yield f"{suffix.text}: ignored, as clearance groups are those of deep groove bearings"
    for part in found.unknown:
        yield f"{part}: suffix not understood and ignored"


def _differing_makers(row: Row) -> Iterator[str]:
    """Whether other makers' ratings lead to other balls; those that fit no ball say nothing."""
    others = []
    for (maker, name), other in _makers_rows().items():
        supports = maker in row["supported_by"].split(" + ")
        if name == row["designation"] and other["ball_count"] and not supports and float(other["score"]) < USABLE_SCORE:
            others.append(f"{maker} {_balls(other)}")
    if others:
        yield (
            f"{row['designation']} differs between makers: {row['maker']} {_balls(row)} is taken, {', '.join(others)}; "
            f"name the maker, for example {row['maker']} {row['designation']}"
        )


def _second(row: Row) -> str:
    if not row["second_ball_count"]:
        return "other balls"
    return f"the next best, {row['second_ball_count']} x {float(row['second_ball_diameter_mm']):.3f} mm,"


def _refusal(found: Designation, row: Row) -> str:
    name = _with_maker(row) if found.maker else row["designation"]
    why = row["remark"]
    if not why and row["score"] and float(row["score"]) >= USABLE_SCORE:
        why = f"the best fit, {_balls(row)}, is poor: score {row['score']}"
    elif not why and row["second_ball_count"]:
        why = f"{_balls(row)} and {_second(row).removeprefix('the next best, ').rstrip(',')} fit them nearly as well"
    return (
        f"bearing {name} is refused: ball count and ball diameter do not follow from its ratings ({why}). Count the "
        f"balls and measure one, or get both from BPFO and BPFI of its vibration; then give {BY_HAND} by hand"
    )


def _unknown(designation: str) -> str:
    maker, body = read_maker(designation.strip().upper())
    plain = plain_name(body)
    if kind := other_kind(plain):
        return f"bearing {designation!r} {kind}"
    angles = [
        name for name in bearing_names() if plain[:4].isdigit() and plain[:1] == "7" and name.startswith(plain[:4])
    ]
    if plain == plain[:4] and angles:
        return (
            f"bearing {designation!r} does not say its contact angle; give one of {', '.join(angles)} "
            f"(C 15, A5 25, A 30, B 40 degrees)"
        )
    names = {plain_name(name).removeprefix(row["maker"]): name for name, row in _rows().items() if row["grade"] != "D"}
    if maker in ("GMN", "SNFA"):
        names = {plain: name for plain, name in names.items() if name.startswith(maker)}
    bore = re.match(r"\D*\d+[A-Z]*\s*/\s*(\d+(?:[.,]\d+)?)(?![\d/])", body)
    if bore is None:
        number = re.match(r"\D*\d+[^\s\-/]*", body)
        like = plain if number is None else plain_name(number[0])
        near = [names[close] for close in difflib.get_close_matches(like, names, n=3, cutoff=0.0)]
    else:  # those of the nearest bore, of them the most alike
        near = heapq.nsmallest(3, names.values(), key=partial(_distance, body, float(bore[1].replace(",", "."))))
    return f"bearing {designation!r} is not in the catalogue; nearest: {', '.join(near)}. Or give {BY_HAND} by hand"


def _distance(body: str, bore: float, name: str) -> tuple[float, float]:
    """How far a row is from a bore, mm, and how little its name is like the text."""
    return abs(float(_rows()[name]["bore_mm"]) - bore), -difflib.SequenceMatcher(None, name, body).ratio()
