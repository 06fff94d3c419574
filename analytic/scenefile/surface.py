"""The surfaces of a scene: by rms roughness, by Ra, by a finish of the catalog, or by a height map."""

from collections.abc import Iterator
from math import sqrt
from pathlib import Path

from analytic.declared import read_only
from analytic.scene import Autocorrelation, HeightMapFile, Origin, Surface
from analytic.scenefile.keys import Values
from analytic.surface.profilometer import ENDING, x3p_shape_and_spacing

HEIGHT_MAPS = (".npy", ".csv", ENDING)
WAYS = ("rms_roughness", "Ra", "finish", "height_map")  # to say how rough a surface is
ROUGHNESSES = ("rms_roughness", "ball_rms_roughness")
# Neither Ra nor a finish says how long the waves of a surface are. A judgement, no source seen: 10 to 40 um.
ASSUMED_CORRELATION = Autocorrelation(kind="gaussian", length=20e-6, spacing=1e-6)
LENGTH_DEVIATION = 15e-6 / sqrt(3)  # m: of 30 um between the limits
GIVEN = Origin(status="given", uncertainty=None, source="the scene")


def surface_conflicts(v: Values) -> Iterator[tuple[str, str]]:
    """(key, problem) of keys of [surface] that are valid on their own and in conflict with each other."""
    path, has_own_law = v["surface.height_map.path"], "surface.asperities" in v
    ways = [key for key in WAYS if f"surface.{key}" in v.said]
    has_correlation = "surface.autocorrelation" in v.said
    if len(ways) != 1:
        has = f", it has {' and '.join(ways)}" if ways else ""
        yield "", f"surface needs exactly one of {', '.join(WAYS[:-1])} and {WAYS[-1]}{has}"
    elif ways == ["height_map"] and has_correlation:
        yield "", "surface.autocorrelation does not go with height_map, which has its own; leave it out"
    elif ways == ["rms_roughness"] and not has_correlation:
        yield (
            "surface.autocorrelation",
            f"is missing, which goes with rms_roughness; {Autocorrelation.HINT}, or Ra or finish that assume one",
        )
    if has_own_law and v["surface.gap"] != "truncated":
        yield "", 'surface.asperities is the law of summits of gap = "truncated": leave it out, or give that gap'
    if path is not None and Path(path).suffix.lower() not in HEIGHT_MAPS:
        yield "surface.height_map.path", f"is not one of {', '.join(HEIGHT_MAPS)}"
    elif path is not None:
        has_own, spacing = Path(path).suffix.lower() == ENDING, v["surface.height_map.spacing"]
        if has_own and spacing is not None:
            yield "surface.height_map.spacing", f"goes with .npy and .csv; a {ENDING} file has its own, so leave it out"
        elif not has_own and spacing is None:
            yield "surface.height_map.spacing", 'is missing; give that of the points, for example "2 um"'


def surface_of(v: Values, folder: Path) -> Surface:
    """The surface that the table describes; folder : that the path of a height map starts from.

    Raises InputError for a .x3p file that cannot be read: its spacing stands in it.
    """
    roughness: float | None = v["surface.rms_roughness"]
    correlation: Autocorrelation | None = v.noun(Autocorrelation, "surface.autocorrelation")
    given = {key: GIVEN for key in ROUGHNESSES if f"surface.{key}" in v.said}
    origins = given | {key: v.origins[f"surface.{key}"] for key in ROUGHNESSES if f"surface.{key}" in v.origins}
    if correlation is not None:
        origins["autocorrelation.length"] = GIVEN
    elif roughness is not None:
        source = "length and spacing are a judgement, 10 to 40 um and a twentieth of the length; no source seen"
        origins["autocorrelation.length"] = Origin(status="assumed", uncertainty=LENGTH_DEVIATION, source=source)
    assumed = None if roughness is None else ASSUMED_CORRELATION
    return Surface(
        **v.fields(
            Surface,
            "surface",
            autocorrelation=assumed if correlation is None else correlation,
            height_map=_height_map(v, folder) if "surface.height_map" in v.said else None,
            asperities=v["surface.asperities"] or Surface.asperities,
            origins=read_only(origins),
        )
    )


def _height_map(v: Values, folder: Path) -> HeightMapFile:
    path, spacing = folder / v["surface.height_map.path"], v["surface.height_map.spacing"]
    return HeightMapFile(path=str(path), spacing=x3p_shape_and_spacing(path)[1] if spacing is None else spacing)
