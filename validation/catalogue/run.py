"""Balls from load ratings, computed anew: python validation/catalogue/run.py [--out FOLDER]

Nobody prints the balls of most bearings. They follow from the printed ratings: C0 of [ISO76] and C of [ISO281] depend
on ball count, ball diameter and pitch diameter, and f0 of [ISO76] on ball over pitch diameter. For every standard ball
of [ISO3290] and every count, the residuals of the ratings are squared and summed in units of their spread. This program
does so for every bearing of the catalogue whose balls are derived. It compares the balls with those that the catalogue
has, and with balls that others print or measured. It writes catalogue.csv, one row for each bearing, and the tables of
catalogue.md into this folder.
"""

import math
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import product
from pathlib import Path

import numpy as np

from analytic.contact.hertz import hertz_contact
from validation.study import ROOT, Out, Row, markdown, numbers, published, read, run, write, write_text

HERE = Path(__file__).parent
ROWS = ROOT / "analytic" / "catalog" / "bearings"

STATIC_PRESSURE = 4200e6  # Pa, [ISO76]
MODULUS = 207e9 / (2 * (1 - 0.3**2))  # E* of the steel of [ISO76], Pa
RACES = {"inner": (1, 0.52), "outer": (-1, 0.53)}  # sign of the curvature along rolling, conformity
LOAD_SHARE = 5.0  # the heaviest ball carries 5/Z of a radial load [Stribeck1907]
DYNAMIC_FACTOR = 0.41 * 98.0665  # N and mm
REDUCTION = 0.95  # lambda of single-row bearings
MATERIAL = 1.3  # b_m of [ISO281]
LARGE_BALL = 25.4  # mm: beyond, C grows as D^1.4

METRIC = [1.5, *np.arange(2, 12.6, 0.5), *np.arange(13, 26), *np.arange(26, 51, 2), 35.0, 45.0]  # mm
INCH_32 = [25.4 / 32 * n for n in (*range(2, 49), *range(50, 86, 2))]
INCH_64 = [25.4 / 64 * n for n in range(5, 40, 2)]
# Penalties in units of the score. All balls that GMN and SNFA print are inch sizes, and odd 64ths are rare. No maker
# says how far it fills a bearing with balls; printed ones lie between 183 and 194 degrees.
METRIC_PENALTY, INCH_64_PENALTY = 4.0, 2.0
FILLING, FILLING_SPREAD = (181.0, 197.0), 4.0  # degrees
PLAY = 0.006  # standard deviation of the pitch diameter about (d + D)/2, relative
SMALL, SMALL_PLAY = 26.0, 0.03  # mm, relative: the same below this outside diameter
CLEAR = 4.0  # difference of scores: likelihoods differ by exp(2)


@dataclass(frozen=True, kw_only=True)
class Spread:
    """How far one maker's printed ratings lie from the formulas."""

    static: float  # relative
    dynamic: float
    smaller_factor: tuple[bool, ...]  # whether f0 is the smaller of both contacts, as in [ISO76], or the inner
    factor: float = 0.06  # of f0
    rounded: float = 0.0  # half of the last digit of f0
    dynamic_ratios: tuple[float, ...] = (1.0,)  # C over that of [ISO281]


SPREADS = {
    "NSK": Spread(static=0.005, dynamic=0.007, smaller_factor=(False,)),
    "KOYO": Spread(static=0.005, dynamic=0.007, smaller_factor=(True,)),
    # Found in its deep groove bearings: some of its C are 4.8 % above [ISO281]; f0 is a whole number from 10 on.
    "SKF": Spread(static=0.01, dynamic=0.011, smaller_factor=(False, True), rounded=0.5, dynamic_ratios=(1.0, 1.048)),
}


@dataclass(frozen=True, kw_only=True)
class Rating:
    """What a catalogue prints of one bearing."""

    angle: float  # rad
    dynamic: float  # C, N
    static: float  # C0, N
    factor: float | None  # f0


@dataclass(frozen=True, kw_only=True)
class Candidate:
    count: int
    diameter: float  # mm
    score: float


@cache
def _static_table(race: str) -> tuple[np.ndarray, np.ndarray]:
    """f0 of one race over gamma: a ball of 1 mm under the load that presses it with STATIC_PRESSURE, N/mm^2."""
    gamma, (sign, conformity) = np.linspace(0.0, 0.45, 901), RACES[race]
    along, across = 2e3 * (1 + sign * gamma / (1 - sign * gamma)), 1e3 * (2 - 1 / conformity)
    contact = hertz_contact(curvature_x=along, curvature_y=across, load=1.0, modulus=MODULUS)
    return gamma, (STATIC_PRESSURE / contact.peak_pressure) ** 3 / LOAD_SHARE


def static_factor(gamma: np.ndarray, *, smaller: bool = True) -> np.ndarray:
    """f0 of [ISO76], N/mm^2: of the race that reaches STATIC_PRESSURE first; smaller = False: of the inner race."""
    inner, outer = (np.interp(gamma, *_static_table(race)) for race in RACES)
    return np.minimum(inner, outer) if smaller else inner


def dynamic_factor(gamma: np.ndarray) -> np.ndarray:
    """f_c of [ISO281] for grooves of 0.52 ball diameters, N and mm."""
    _, conformity = RACES["inner"]
    weaker = (1 + (1.04 * ((1 - gamma) / (1 + gamma)) ** 1.72) ** (10 / 3)) ** -0.3
    shape = gamma**0.3 * (1 - gamma) ** 1.39 / (1 + gamma) ** (1 / 3)
    return DYNAMIC_FACTOR * REDUCTION * weaker * shape * (2 * conformity / (2 * conformity - 1)) ** 0.41


def static_rating(count: np.ndarray, diameter: np.ndarray, angle: float, factor: np.ndarray) -> np.ndarray:
    """C0, N; diameter in mm."""
    return factor * count * diameter**2 * np.cos(angle)


def dynamic_rating(count: np.ndarray, diameter: np.ndarray, angle: float, gamma: np.ndarray) -> np.ndarray:
    """C, N; diameter in mm."""
    power = np.where(diameter <= LARGE_BALL, diameter**1.8, 3.647 * diameter**1.4)
    return MATERIAL * dynamic_factor(gamma) * np.cos(angle) ** 0.7 * count ** (2 / 3) * power


def sizes() -> tuple[np.ndarray, np.ndarray]:
    """(diameters, mm; penalties) of the standard balls."""
    table = {round(float(size), 3): METRIC_PENALTY for size in METRIC}
    table |= {round(size, 3): INCH_64_PENALTY for size in INCH_64}
    table |= {round(size, 3): 0.0 for size in INCH_32}
    diameters = np.array(sorted(table))
    return diameters, np.array([table[size] for size in diameters])


def score_balls(
    ratings: Sequence[Rating], spread: Spread, *, section: float, pitch: float, play: float, priors: bool = True
) -> list[Candidate]:
    """All balls that fit into the bearing, the best first.

    section : (D - d)/2, mm; pitch : d_m, mm; play : its relative standard deviation; priors : whether penalties count
    """
    diameters, penalties = sizes()
    fits = (diameters > 0.4 * section) & (diameters < 0.8 * section)
    diameter, penalty = diameters[fits][:, None, None], penalties[fits][:, None, None]
    count = np.arange(5, 41)[None, :, None]
    offset = np.linspace(-2.0, 2.0, 9)[None, None, :]  # of the pitch, in standard deviations
    pitches = pitch * (1 + play * offset)
    half_angle = np.arcsin(diameter / pitches)
    total = np.full(np.broadcast_shapes(diameter.shape, count.shape, offset.shape), np.inf)
    for ratio, smaller in product(spread.dynamic_ratios, spread.smaller_factor):
        score = offset**2 + np.zeros_like(total)
        for rating in ratings:
            gamma = diameter * np.cos(rating.angle) / pitches
            factor = static_factor(gamma, smaller=smaller)
            static = static_rating(count, diameter, rating.angle, factor)
            dynamic = ratio * dynamic_rating(count, diameter, rating.angle, gamma)
            score = score + ((static / rating.static - 1) / spread.static) ** 2
            score = score + ((dynamic / rating.dynamic - 1) / spread.dynamic) ** 2
            if rating.factor is not None:
                rounded = spread.rounded if rating.factor == round(rating.factor) else 0.05
                beyond = np.maximum(np.abs(factor - rating.factor) - (rounded if spread.rounded else 0.0), 0.0)
                score = score + (beyond / spread.factor) ** 2
        total = np.minimum(total, score)
    if priors:
        filling = np.degrees(2 * (count - 1) * half_angle)
        outside = np.maximum(np.maximum(FILLING[0] - filling, filling - FILLING[1]), 0.0)
        total = total + penalty + (outside / FILLING_SPREAD if ratings[0].angle == 0 else 0.0) ** 2
    total = np.where(np.sin(np.pi / count) > np.sin(half_angle), total, np.inf).min(axis=2)
    order = np.argsort(total, axis=None)[:60]
    rows, columns = np.unravel_index(order, total.shape)
    return [
        Candidate(count=int(count[0, j, 0]), diameter=float(diameter[i, 0, 0]), score=float(total[i, j]))
        for i, j in zip(rows, columns, strict=True)
        if np.isfinite(total[i, j])
    ]


def same_size(one: float, other: float, tolerance: float = 1.5e-3) -> bool:
    """Whether two diameters are one standard size, rounded perhaps: neighbours differ by 0.3 % at least."""
    return math.isclose(one, other, rel_tol=tolerance)


@dataclass(frozen=True, kw_only=True)
class Check:
    """One bearing of one maker: its balls in the catalogue and those of this program, the best first."""

    maker: str
    designation: str
    grade: str
    listed: tuple[int, float] | None  # count, diameter in mm
    candidates: list[Candidate]

    @property
    def agrees(self) -> bool:
        best = self.candidates[0]
        return self.listed is not None and best.count == self.listed[0] and same_size(best.diameter, self.listed[1])

    def excess(self, count: int, diameter: float) -> float:
        """Score of these balls above the best; infinite: not among the candidates."""
        hits = (c.score for c in self.candidates if c.count == count and same_size(c.diameter, diameter))
        return min(hits, default=math.inf) - self.candidates[0].score

    @property
    def listed_excess(self) -> float:
        return self.excess(*self.listed) if self.listed else math.inf


def check_deep_groove(*, priors: bool = True) -> list[Check]:
    """Every maker's deep groove bearing by itself."""
    main, checks = {row["designation"]: row for row in read(ROWS / "deep_groove.csv")}, []
    for row in read(ROWS / "deep_groove_by_maker.csv"):
        size = main[row["designation"]]
        balls = size if row["maker"] in size["supported_by"].split(" + ") and row["grade"] != "D" else row
        bore, outside = float(size["bore_mm"]), float(size["outside_mm"])
        play = SMALL_PLAY if outside < SMALL else PLAY
        checks.append(checked([row], [0.0], size, balls, pitch=(bore + outside) / 2, play=play, priors=priors))
    return checks


def check_angular_contact() -> list[Check]:
    """Angular contact bearings whose balls are derived; all angles of one size together."""
    groups: dict[tuple[str, str], list[Row]] = defaultdict(list)
    for row in read(ROWS / "angular_contact.csv"):
        if row["ball_status"] == "derived":
            groups[row["maker"], row["designation"][:4]].append(row)
    checks = []
    for rows in groups.values():
        first, angles = rows[0], [math.radians(float(row["contact_angle_deg"])) for row in rows]
        pitch = float(first["pitch_diameter_mm"])
        checks.append(checked(rows, angles, first, first, pitch=pitch, play=PLAY, priors=True))
    return checks


def checked(
    rows: Sequence[Row], angles: Sequence[float], size: Row, balls: Row, *, pitch: float, play: float, priors: bool
) -> Check:
    """rows, angles : ratings of one size by their contact angle, rad;  size, balls : rows that have them"""
    maker, section = rows[0]["maker"], (float(size["outside_mm"]) - float(size["bore_mm"])) / 2
    ratings = [
        Rating(
            angle=angle,
            dynamic=float(row["dynamic_rating_N"]),
            static=float(row["static_rating_N"]),
            factor=float(row["f0"]) if row["f0"] else None,
        )
        for row, angle in zip(rows, angles, strict=True)
    ]
    return Check(
        maker=maker,
        designation=" ".join(row["designation"] for row in rows),
        grade=rows[0]["grade"],
        listed=(int(balls["ball_count"]), float(balls["ball_diameter_mm"])) if balls["ball_count"] else None,
        candidates=score_balls(ratings, SPREADS[maker], section=section, pitch=pitch, play=play, priors=priors),
    )


def supported(checks: Iterable[Check]) -> dict[str, Candidate]:
    """For each designation the balls that most makers' ratings support, and that fit best of those."""
    by_name: dict[str, list[Check]] = defaultdict(list)
    for check in checks:
        by_name[check.designation].append(check)
    chosen = {}
    for name, group in by_name.items():
        ranked = []
        for best in (check.candidates[0] for check in group):
            excesses = [check.excess(best.count, best.diameter) for check in group]
            within = [excess for excess in excesses if excess < CLEAR]
            ranked.append((-len(within), sum(within), best))
        chosen[name] = min(ranked, key=lambda entry: entry[:2])[2]
    return chosen


@dataclass(frozen=True, kw_only=True)
class Hit:
    """Balls that others print or measured, and those from ratings."""

    designation: str
    source: str
    printed: tuple[int, float]  # count, diameter in mm
    found: Candidate

    @property
    def count_right(self) -> bool:
        return self.found.count == self.printed[0]

    @property
    def right(self) -> bool:
        """Count, and diameter within 0.6 %: data sets round it."""
        return self.count_right and same_size(self.found.diameter, self.printed[1], 0.006)


def compare_balls(found: Mapping[str, Candidate]) -> list[Hit]:
    """Every row of published balls whose designation is among these."""
    return [
        Hit(
            designation=row["designation"],
            source=row["maker"],
            printed=(int(row["ball_count"]), float(row["ball_diameter_mm"])),
            found=found[row["designation"]],
        )
        for row in published("ball_bearing_geometry.csv")
        if row["designation"] in found
    ]


def _hits_row(name: str, hits: Sequence[Hit]) -> tuple[object, ...]:
    bearings = {hit.designation for hit in hits}
    missed = {hit.designation for hit in hits if not hit.right}
    right = sum(hit.count_right for hit in hits), sum(hit.right for hit in hits)
    return name, len(hits), *right, len(bearings), len(bearings - missed)


def factor_errors() -> tuple[float, float]:
    """Largest difference of f0 and of f_c from the printed tables."""
    rows = published("iso_ball_factors.csv")
    gamma = numbers(rows, "gamma")
    static, dynamic = (
        float(np.nanmax(np.abs(formula(gamma) - numbers(rows, name))))
        for formula, name in ((static_factor, "f0"), (dynamic_factor, "fc"))
    )
    return static, dynamic


def report(deep: Sequence[Check], angular: Sequence[Check], without_priors: Sequence[Check]) -> Iterator[str]:
    """The tables, as Markdown."""
    hits, (static, dynamic) = compare_balls(supported(deep)), factor_errors()
    yield from ("# Balls from load ratings", "")
    yield (
        "By `python validation/catalogue/run.py`. [The catalogue](../../docs/catalogue.md) says what the numbers mean."
    )
    yield ""
    yield f"f0 differs from the table of ISO 76 by at most {static:.3f}, f_c from that of ISO 281 by {dynamic:.3f};"
    yield "the tables are rounded to 0.1."
    yield from ("", "## Against balls that others print or measured", "")
    outside = {row["designation"]: float(row["outside_mm"]) for row in read(ROWS / "deep_groove.csv")}
    groups = {
        "most makers": hits,
        "most makers, outside diameter from 22 mm": [hit for hit in hits if outside[hit.designation] >= 22],
        "most makers, below 22 mm": [hit for hit in hits if outside[hit.designation] < 22],
    }
    for maker in SPREADS:
        own = {check.designation: check.candidates[0] for check in deep if check.maker == maker}
        groups[f"{maker} alone"] = compare_balls(own)
    groups["most makers, without penalties"] = compare_balls(supported(without_priors))
    heads = ("balls from", "rows", "count right", "both right", "bearings", "both right")
    yield from markdown(heads, (_hits_row(name, some) for name, some in groups.items()))
    yield from ("", "Both right: the count, and the diameter within 0.6 %. Misses:", "")
    for hit in hits:
        if not hit.right:
            yield (
                f"- {hit.designation}: {hit.source} has {hit.printed[0]} x {hit.printed[1]:.3f} mm, the ratings give "
                f"{hit.found.count} x {hit.found.diameter:.3f} mm (score {hit.found.score:.1f})"
            )
    yield from ("", "## Against the catalogue", "")
    heads = ("ratings of", "grade", "checked", "same balls", "other balls, clearly")
    yield from markdown(
        heads, (*_against_catalogue("deep groove", deep), *_against_catalogue("angular contact", angular))
    )
    yield ""
    yield f"Clearly: the catalogue's balls score more than {CLEAR:g} above the best. Other balls, of grades A to C:"
    yield ""
    for check in (*deep, *angular):
        if not check.agrees and check.grade != "D":
            best, listed = check.candidates[0], check.listed
            written = "none" if listed is None else f"{listed[0]} x {listed[1]:.3f} mm"
            words = f"here {best.count} x {best.diameter:.3f} mm, better by {check.listed_excess:.1f}"
            yield f"- {check.maker} {check.designation}: {written}; {words}"


def _against_catalogue(kind: str, checks: Sequence[Check]) -> Iterator[tuple[object, ...]]:
    groups = Counter((check.maker, check.grade) for check in checks)
    for (maker, grade), number in sorted(groups.items()):
        group = [check for check in checks if (check.maker, check.grade) == (maker, grade)]
        clear = sum(not check.agrees and check.listed_excess > CLEAR for check in group)
        yield f"{maker}, {kind}", grade, number, sum(check.agrees for check in group), clear


COLUMNS = (
    *("maker", "designation", "grade", "catalogue_count", "catalogue_diameter_mm"),
    *("count", "diameter_mm", "score", "catalogue_score", "next_count", "next_diameter_mm", "next_score"),
)


def row_of(check: Check) -> dict[str, object]:
    """What catalogue.csv has of a bearing."""
    row: dict[str, object] = {name: getattr(check, name) for name in COLUMNS[:3]}
    for candidate, before in zip(check.candidates[:2], ("", "next_"), strict=False):
        row |= {f"{before}count": candidate.count, f"{before}diameter_mm": str(candidate.diameter)}
        row[f"{before}score"] = f"{candidate.score:.2f}"
    if check.listed:
        count, diameter = check.listed
        row |= {"catalogue_count": count, "catalogue_diameter_mm": str(diameter)}
        own = check.excess(count, diameter) + check.candidates[0].score
        row |= {"catalogue_score": f"{own:.2f}"} if math.isfinite(own) else {}
    return row


def main(out: Out = HERE) -> None:
    deep, angular = check_deep_groove(), check_angular_contact()
    write(map(row_of, (*deep, *angular)), out / "catalogue.csv", COLUMNS)
    write_text(out / "catalogue.md", report(deep, angular, check_deep_groove(priors=False)))


if __name__ == "__main__":
    run(main)
