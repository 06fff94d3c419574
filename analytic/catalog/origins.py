"""Where the dimensions of a bearing of the catalogue come from, and how far to trust them: see docs/catalogue.md."""

import math
from collections.abc import Mapping

from analytic.scene import Origin, Status

Row = Mapping[str, str]
# Evenly between the tightest printed groove, 0.5177, and the widest that ratings assume, 0.52 and 0.53: the middle,
# rounded to 0.001, and the standard deviation.
INNER_CONFORMITY, OUTER_CONFORMITY = 0.519, 0.524
INNER_SPREAD, OUTER_SPREAD = (0.52 - 0.5177) / math.sqrt(12), (0.53 - 0.5177) / math.sqrt(12)
BALL_UNCERTAINTY = {"printed": 0.001, "A": 0.001, "B": 0.001, "C": 0.06}  # relative, if the ball is the right one
RIGHT = {
    "A": "right in about 95 %, else one size off (3 to 6 %)",
    "B": "right in about 85 %, else one size off (3 to 6 %)",
}
HEIGHT_UNCERTAINTY = 0.03  # of the shoulder, in ball diameters
SMALL = 26.0  # mm: below this outside diameter, an estimated pitch diameter is off by 3 %
LOAD_CENTRE_ROUNDING = 1.0 / math.sqrt(12)  # mm: SKF prints the distance in whole millimetres


def origins_of(row: Row, *, scaled: bool) -> dict[str, Origin]:
    """By scene key; lengths in m, forces in N.

    scaled : whether the shoulders are those of another ball, in proportion
    """
    maker = row["maker"]
    printed = Origin(status="printed", uncertainty=None, source=f"catalogue of {maker}")
    ball = float(row["ball_diameter_mm"]) / 1e3
    heights = (row["shoulder_height_inner_mm"], row["shoulder_height_outer_mm"])
    far: dict[str, Origin] = {}
    if row["shoulder_status"] == "loaded side only":
        for ring, words in (("inner", "as on the loaded side"), ("outer", "turned off to the groove for the assembly")):
            origin = Origin(status="assumed", uncertainty=None, source=f"{words}; no print says so")
            far[f"{ring}.far_shoulder_half_width"] = origin
    return {
        "ball_count": _ball_origin(row, 1.0 if row["grade"] == "C" else 0.0),
        "ball_diameter": _ball_origin(row, BALL_UNCERTAINTY[row["grade"]] * ball),
        "pitch_diameter": _pitch_origin(row),
        "inner.conformity": _groove_origin(INNER_SPREAD, "0.52"),
        "outer.conformity": _groove_origin(OUTER_SPREAD, "0.53"),
        "inner.shoulder_half_width": _shoulder_origin(row, heights[0], INNER_CONFORMITY * ball, scaled),
        "outer.shoulder_half_width": _shoulder_origin(row, heights[1], OUTER_CONFORMITY * ball, scaled),
        **dict.fromkeys(("bore_diameter", "outside_diameter", "width"), printed),
        **dict.fromkeys(("static_load_rating", "dynamic_load_rating"), printed),
    } | far


def half_width(height: float | None, groove_radius: float) -> float | None:
    """From the middle of the groove to its shoulder, m; sqrt(r^2 - (r - h)^2) with the height h above the bottom."""
    return None if height is None else math.sqrt(height * (2 * groove_radius - height))


def _groove_origin(spread: float, limit: str) -> Origin:
    words = f"evenly from the tightest of four printed grooves, 0.5177, to the limit of the rating standards, {limit}"
    return Origin(status="assumed", uncertainty=spread, source=words)


def _ball_origin(row: Row, uncertainty: float) -> Origin:
    maker = row["maker"]
    if row["ball_status"].startswith("printed"):
        rounded = ", rounded; the nearest inch size is taken" if "inch" in row["ball_status"] else ""
        return Origin(status="printed", uncertainty=uncertainty, source=f"catalogue of {maker}{rounded}")
    factor = f", f0 {row['f0']}" if row["f0"] else ""
    dynamic, static = (f"{float(row[f'{kind}_rating_N']) / 1e3:g} kN" for kind in ("dynamic", "static"))
    parts = [f"{maker}'s C {dynamic}, C0 {static}{factor}"]
    if row["static_residual_percent"]:
        parts.append(f"residuals C {row['dynamic_residual_percent']} %, C0 {row['static_residual_percent']} %")
    trust = f", {RIGHT[row['grade']]}" if row["grade"] in RIGHT else ""
    parts += [f"supported by {row['supported_by']}", f"grade {row['grade']}{trust}"]
    if row["second_ball_count"]:
        parts.append(f"next best {row['second_ball_count']} x {float(row['second_ball_diameter_mm']):.3f} mm")
    source = "; ".join(parts)
    return Origin(status="derived", uncertainty=uncertainty, source=source)


def _pitch_origin(row: Row) -> Origin:
    pitch = float(row["pitch_diameter_mm"]) / 1e3
    source = row["pitch_source"]
    if source == "GMN":
        return Origin(status="printed", uncertainty=0.001 * pitch, source="GMN prints it for its bearing of this size")
    if source == "load centre":
        angle = math.radians(float(row["contact_angle_deg"]))
        rounding = 2e-3 * LOAD_CENTRE_ROUNDING / math.tan(angle)
        uncertainty = rounding if row["maker"] == "SKF" else 0.003 * pitch
        words = f"from {row['maker']}'s distance of the load centre, a = B/2 + d_m tan(angle)/2"
        return Origin(status="derived", uncertainty=uncertainty, source=words)
    share = 0.03 if float(row["outside_mm"]) < SMALL else 0.006
    status: Status = "derived" if source == "SKF shoulders" else "assumed"
    words = (
        "mean of the shoulder diameters that SKF prints" if source == "SKF shoulders" else "mean of bore and outside"
    )
    return Origin(status=status, uncertainty=share * pitch, source=words)


def _shoulder_origin(row: Row, height_mm: str, groove_radius: float, scaled: bool) -> Origin:
    if not height_mm:
        return Origin(status="not known", uncertainty=None, source="no shoulder diameter is printed")
    ball = float(row["ball_diameter_mm"]) / 1e3
    height = float(height_mm) / 1e3
    width = math.sqrt(height * (2 * groove_radius - height))
    uncertainty = HEIGHT_UNCERTAINTY * ball * (groove_radius - height) / width  # d(half width)/d(height)
    if scaled:
        return Origin(
            status="assumed",
            uncertainty=uncertainty,
            source="height over ball diameter as in the bearing of the same size of another maker",
        )
    sources: dict[str, tuple[Status, str]] = {
        "derived": ("derived", "from printed shoulder diameters; chamfer ignored"),
        "loaded side only": ("derived", "from printed shoulder diameters, loaded side only"),
        "assumed": ("assumed", f"height {height / ball:.2f} ball diameters, as in bearings with printed shoulders"),
    }
    status, words = sources[row["shoulder_status"]]
    return Origin(status=status, uncertainty=uncertainty, source=words)
