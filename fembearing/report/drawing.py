"""A scene's bearing drawn to scale, and the drawing as a file."""

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Unpack

from analytic.any_scene import scene_by
from analytic.errors import InputError
from analytic.given import SceneOptions
from analytic.scene import Scene
from analytic.writing import new_file
from fembearing.quantities import SYSTEMS

if TYPE_CHECKING:
    from matplotlib.figure import Figure

ENDINGS = (".svg", ".png", ".pdf")


def draw_bearing(
    scene: Scene | str | os.PathLike[str],
    *,
    out: Path | str | None = None,
    force: bool = False,
    **options: Unpack[SceneOptions],
) -> "Figure":
    """Draw the bearing of a scene to scale, with its dimensions and where they come from.

    Parameters
    ----------
    scene : Scene, str or path
        Of one bearing, or of a pair, which is drawn in its arrangement.
    out : str or path, optional
        File that ends with .svg, .png or .pdf. None writes nothing.
    force : bool
        The file takes the place of one that exists.
    **options : float, str, list or mapping
        With a name, the other arguments of `load_scene`: radial_load="3 kN", speed="3000 rpm", settings.

    Returns
    -------
    matplotlib.figure.Figure
        A section through a ball, the view along the axis, and a table of dimensions, in the scene's system of units.
        Each view has its own scale. A dimension that the scene lacks is drawn at a guess, dashed.

    Raises
    ------
    InputError
        The file exists, cannot be written or has another ending; or the bearing has more than 500 balls.

    Notes
    -----
    The rings are drawn in operation, after mounting, without load: the ball touches both races at the unloaded contact
    angle al0, cos al0 = 1 - P_d/(2 A0), with the diametral clearance P_d and the distance A0 of the groove centres
    [Harris2007].
    """
    scene = scene_by(scene, options)
    content = None if out is None else _content_of(Path(out))
    from fembearing.report.figures.bearing_drawing import NOT_DRAWABLE, drawing_of, shown_bearing

    given = scene.contact_angle
    shown = shown_bearing(
        scene.bearing,
        given.rule,
        given.value if given.rule == "given" else given.free,
        pocket=None if scene.cage is None else scene.cage.pocket_diameter,
    )
    if scene.bearing.name == "unnamed":
        shown = shown._replace(name=scene.name)
    if scene.arrangement is not None:
        shown = shown._replace(arrangement=scene.arrangement.kind, distance=scene.arrangement.distance)
    figure = drawing_of(shown, SYSTEMS[scene.report.units])
    if figure is None:
        raise InputError(f"{scene.bearing.name}: {NOT_DRAWABLE} It takes at most 500 balls, and lengths in proportion")
    if out is not None and content is not None:
        with new_file(Path(out), force=force) as file:
            file.write_bytes(content(figure))
    return figure


def _content_of(target: Path) -> "Callable[[Figure], bytes]":
    """What a file of this name holds. Raises InputError for an ending that is not known."""
    from fembearing.report.figures.style import pdf, png, svg

    contents: Mapping[str, Callable[[Figure], bytes]] = dict(zip(ENDINGS, (svg, png, pdf), strict=True))
    content = contents.get(target.suffix.casefold())
    if content is None:
        raise InputError(
            f"--out {str(target)!r} ends with {target.suffix!r}: give a file that ends with {', '.join(ENDINGS)}"
        )
    return content
