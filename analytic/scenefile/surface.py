"""The surfaces of a scene: by rms roughness, by Ra, by a finish of the catalog, or by a height map."""

from collections.abc import Iterator
from dataclasses import replace
from math import pi, sqrt
from pathlib import Path

from analytic import catalog
from analytic.noun import read_only
from analytic.scene import Autocorrelation, HeightMapFile, Origin, Surface
from analytic.scenefile.quantity import in_si
from analytic.scenefile.tables import AutocorrelationTable, HeightMapTable, SurfaceTable
from analytic.surface.profilometer import ENDING, x3p_shape_and_spacing

HEIGHT_MAPS = (".npy", ".csv", ENDING)
WAYS = ("rms_roughness", "Ra", "finish", "height_map")  # to say how rough a surface is
RMS_OVER_RA = sqrt(pi / 2)  # Sq/Ra of gaussian heights: E|z| = sigma sqrt(2/pi)
# Neither Ra nor a finish says how long the waves of a surface are. A judgement, no source seen: 10 to 40 um.
ASSUMED_CORRELATION = Autocorrelation(kind="gaussian", length=20e-6, spacing=1e-6)
LENGTH_DEVIATION = 15e-6 / sqrt(3)  # m: of 30 um between the limits
GIVEN = Origin(status="given", uncertainty=None, source="the scene")
BALL_RA = 0.020e-6  # m: limit of grade 10 of ISO 3290 [ISO3290], of balls in common bearings


def surface_conflicts(given: SurfaceTable) -> Iterator[tuple[str, str]]:
    """(key, problem) of keys of [surface] that are valid on their own and in conflict with each other."""
    ways = [key for key in WAYS if getattr(given, key) is not None]
    if len(ways) != 1:
        has = f", it has {' and '.join(ways)}" if ways else ""
        yield "", f"surface needs exactly one of {', '.join(WAYS[:-1])} and {WAYS[-1]}{has}"
    elif ways == ["height_map"] and given.autocorrelation is not None:
        yield "", "surface.autocorrelation does not go with height_map, which has its own; leave it out"
    elif ways == ["rms_roughness"] and given.autocorrelation is None:
        yield (
            "surface.autocorrelation",
            f"is missing, which goes with rms_roughness; {AutocorrelationTable.HINT}, or Ra or finish that assume one",
        )
    if given.asperities is not None and given.gap != "truncated":
        yield "", 'surface.asperities is the law of summits of gap = "truncated": leave it out, or give that gap'
    if given.height_map is not None and Path(given.height_map.path).suffix.lower() not in HEIGHT_MAPS:
        yield "surface.height_map.path", f"is not one of {', '.join(HEIGHT_MAPS)}"
    elif given.height_map is not None:
        has_own = Path(given.height_map.path).suffix.lower() == ENDING
        if has_own and given.height_map.spacing is not None:
            yield "surface.height_map.spacing", f"goes with .npy and .csv; a {ENDING} file has its own, so leave it out"
        elif not has_own and given.height_map.spacing is None:
            yield "surface.height_map.spacing", 'is missing; give that of the points, for example "2 um"'


def surface_of(given: SurfaceTable, folder: Path) -> Surface:
    """The surface that the table describes; folder : that the path of a height map starts from.

    Raises InputError for a .x3p file that cannot be read: its spacing stands in it.
    """
    origins: dict[str, Origin] = {}
    roughness, ball, correlation = given.rms_roughness, given.ball_rms_roughness, given.autocorrelation
    if given.Ra is not None:
        roughness = given.Ra * RMS_OVER_RA
        origins["rms_roughness"] = replace(GIVEN, source="Ra of the scene, gaussian heights: Sq = Ra sqrt(pi/2)")
    elif given.finish is not None:
        row = catalog.rows("finishes")[given.finish]
        middle, low, high = (in_si(row[f"{column} [um]"], "um") for column in ("Ra", "low", "high"))
        roughness = middle * RMS_OVER_RA
        deviation = (high - low) / 2 / sqrt(3) * RMS_OVER_RA
        origins["rms_roughness"] = Origin(
            status="assumed", uncertainty=deviation, source=f"finish {given.finish!r}: {row['source']}"
        )
        if ball is None:
            ball = BALL_RA * RMS_OVER_RA
            source = "Ra of grade 10 of ISO 3290, 0.020 um, the limit for its balls [ISO3290]"
            origins["ball_rms_roughness"] = Origin(status="assumed", uncertainty=None, source=source)
    elif roughness is not None:
        origins["rms_roughness"] = GIVEN
    if given.ball_rms_roughness is not None:
        origins["ball_rms_roughness"] = GIVEN
    if correlation is not None:
        origins["autocorrelation.length"] = GIVEN
    elif roughness is not None:
        source = "length and spacing are a judgement, 10 to 40 um and a twentieth of the length; no source seen"
        origins["autocorrelation.length"] = Origin(status="assumed", uncertainty=LENGTH_DEVIATION, source=source)
    heights = given.height_map
    derived = {"Ra", "finish", "rms_roughness", "ball_rms_roughness", "autocorrelation", "height_map"}
    assumed = None if roughness is None else ASSUMED_CORRELATION
    return Surface(
        **given.model_dump(exclude=derived, exclude_none=True),
        rms_roughness=roughness,
        ball_rms_roughness=ball,
        autocorrelation=assumed if correlation is None else Autocorrelation(**correlation.model_dump()),
        height_map=None if heights is None else _height_map(heights, folder),
        origins=read_only(origins),
    )


def _height_map(given: HeightMapTable, folder: Path) -> HeightMapFile:
    path = folder / given.path
    spacing = x3p_shape_and_spacing(path)[1] if given.spacing is None else given.spacing
    return HeightMapFile(path=str(path), spacing=spacing)
