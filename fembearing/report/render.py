"""Off-screen pictures by VTK, in a process of their own: python -m fembearing.report.render < jobs.json

Where a machine has no GL library VTK ends the process instead of raising, so nothing else may live in it. The jobs
are those of `fembearing.report.pictures`; each picture is one PNG, whole or not at all.
Frame of the meshes: z along the load into the ball, x along rolling, y transverse; lengths are drawn in mm.
"""

import json
import os
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pyvista as pv

MM = 1e3
COLOURS, BARE, INK, HERTZ, LINES = "viridis", "gainsboro", "black", "red", "dimgrey"
BODIES = {"upper": "lightsteelblue", "lower": "wheat"}
LEAST_SHOWN = 0.005  # of the peak pressure: below, a surface is bare
ROUND = 3  # subdivisions that draw a quadratic cell's face as the curve it is
FAR = 100.0  # mm, to the eye: no matter in a parallel projection, as long as all lies in front of it
VIEW = np.array([-0.74, 0.38, 0.55])  # towards the eye, over the cut plane x = 0


def main() -> None:
    pv.OFF_SCREEN = True
    for job in json.load(sys.stdin):
        plotter = KINDS[job["kind"]](job)
        target = Path(job["file"])
        temporary = target.with_name(f".{target.stem}-{os.getpid()}.png")
        plotter.screenshot(temporary)
        plotter.close()
        os.replace(temporary, target)


def pressure_map(job: dict[str, Any]) -> pv.Plotter:
    """The contact seen along the load, to scale, with Hertz's ellipse and a bar of a round length."""
    frame, axes = job["frame"], np.eye(3)
    width, height, scale = frame["width"], frame["height"], frame["scale"] / MM  # pixels per mm
    eye, up = axes[2], axes[1 if frame["rolling_is_horizontal"] else 0]
    right = np.cross(up, eye)
    middle = (frame["centre"][1] - height / 2) / scale * up
    plotter = pv.Plotter(window_size=[width, height])
    body = scaled(job["lower"], job)
    surface = mirrored(loaded_face(body, ROUND), (0, 1))
    edges = mirrored(loaded_face(body, 0).extract_all_edges(), (0, 1))
    above = np.ptp(surface.points[:, 2]) * eye  # the projection is parallel: height does not show
    plotter.add_mesh(surface, color=BARE, lighting=False)
    bar = colour_bar(job, width=420 / width, left=1 - 440 / width, height=80 / height)
    show_pressure(plotter, surface.translate(above), job, bar=bar)
    plotter.add_mesh(edges.translate(2 * above), color=LINES, opacity=0.3, line_width=1)
    plotter.add_mesh(ellipse(job["computed"]).translate(3 * above), color=INK, line_width=2)
    plotter.add_mesh(ellipse(job["hertz"]).translate(4 * above), color=HERTZ, line_width=3)
    length = frame["bar"] * MM
    start = middle + 3 * above + ((30 - width / 2) * right + (30 - height / 2) * up) / scale
    plotter.add_mesh(pv.Line(start, start + length * right), color=INK, line_width=4)
    direction = "rolling" if frame["rolling_is_horizontal"] else "transverse"
    plotter.add_text(f"{length:g} mm, {direction}", position=(30, 38), font_size=10, color=INK)
    plotter.add_text(job["title"], position=(12, height - 34), font_size=12, color=INK)
    plotter.add_text("red: Hertz's ellipse", position=(12, height - 62), font_size=10, color=HERTZ)
    plotter.add_text("black: the computed one", position=(190, height - 62), font_size=10, color=INK)
    look(plotter, at=middle, eye=eye, up=up, half_height=height / 2 / scale)
    return plotter


def section(job: dict[str, Any]) -> pv.Plotter:
    """Left both bodies cut along the plane x = 0, the ball lifted off; right the lower one alone, near the contact."""
    plotter = pv.Plotter(shape=(1, 2), window_size=[1500, 800], border=False)
    bodies = {side: scaled(job[side], job) for side in BODIES}
    radius, longer, wide = MM * job["ball_radius"], MM * max(job["hertz"]), 1.3 * MM * job["reach"]
    lifted = np.array([0.0, 0.0, MM * job["lifted"]])
    plotter.subplot(0, 0)
    draw(plotter, bodies["lower"], "lower", job, half_height=wide)
    draw(plotter, bodies["upper"].translate(lifted), "upper", job, half_height=wide)
    look(plotter, at=[0, 0, 0.75 * radius], eye=VIEW, up=[0, 0, 1], half_height=wide)
    plotter.add_text(job["title"], position=(12, 766), font_size=12, color=INK)
    plotter.subplot(0, 1)
    bar = colour_bar(job, width=0.6, left=0.3, height=0.1)
    draw(plotter, bodies["lower"], "lower", job, half_height=1.25 * longer, bar=bar)
    look(plotter, at=[0, 0, 0], eye=VIEW, up=[0, 0, 1], half_height=1.25 * longer)
    plotter.add_text(job["near"], position=(12, 766), font_size=12, color=INK)
    return plotter


def scaled(path: str, job: dict[str, Any]) -> pv.UnstructuredGrid:
    """A quarter of a body in mm, its pressure in the unit of the picture."""
    body = pv.read(path)
    body.points *= MM
    body.point_data["pressure"] *= job["factor"]
    return body


def mirrored(mesh: pv.DataSet, axes: tuple[int, ...]) -> pv.DataSet:
    for axis in axes:
        mesh = mesh.merge(mesh.reflect(np.eye(3)[axis], point=(0, 0, 0)))
    return mesh


def loaded_face(body: pv.DataSet, subdivision: int) -> pv.PolyData:
    """The faces whose nodes all lie on the loaded surface."""
    face = body.extract_surface(nonlinear_subdivision=subdivision, algorithm="dataset_surface")
    loaded = face.threshold(0.999, scalars="surface", all_scalars=True)
    return loaded.extract_surface(algorithm="dataset_surface")


def draw(
    plotter: pv.Plotter,
    body: pv.DataSet,
    side: str,
    job: dict[str, Any],
    *,
    half_height: float,
    bar: Any = None,
) -> None:
    """Half of a body, cut along x = 0, with its cells and the pressure on it."""
    half = mirrored(body, (1,))
    solid = half.extract_surface(nonlinear_subdivision=ROUND, algorithm="dataset_surface")
    cells = half.extract_surface(nonlinear_subdivision=0, algorithm="dataset_surface").extract_all_edges()
    surface = mirrored(loaded_face(body, ROUND), (1,))
    nearer = half_height * VIEW  # what lies on a face is moved towards the eye, to be drawn on top of it
    plotter.add_mesh(solid, color=BODIES[side], ambient=0.35, diffuse=0.7)
    show_pressure(plotter, surface.translate(0.002 * nearer), job, bar=bar)
    plotter.add_mesh(cells.translate(0.01 * nearer), color=LINES, line_width=1)


def show_pressure(plotter: pv.Plotter, surface: pv.DataSet, job: dict[str, Any], *, bar: Any = None) -> None:
    """The part of a surface that carries pressure, in colours."""
    pressed = surface.clip_scalar(scalars="pressure", value=LEAST_SHOWN * job["peak"], invert=False)
    plotter.add_mesh(
        pressed,
        scalars="pressure",
        cmap=COLOURS,
        clim=[0, job["peak"]],
        lighting=False,
        show_scalar_bar=bar is not None,
        scalar_bar_args=bar,
    )


def ellipse(semi_axes: tuple[float, float]) -> pv.PolyData:
    angle = np.linspace(0, 2 * np.pi, 721)
    x, y = MM * semi_axes[0] * np.cos(angle), MM * semi_axes[1] * np.sin(angle)
    return pv.lines_from_points(np.column_stack([x, y, np.zeros_like(x)]))


def look(plotter: pv.Plotter, *, at: Any, eye: Any, up: Any, half_height: float) -> None:
    plotter.background_color = pv.Color("white")
    plotter.camera.parallel_projection = True
    plotter.enable_anti_aliasing("ssaa")
    plotter.camera.focal_point = at
    plotter.camera.position = np.asarray(at) + FAR * np.asarray(eye)
    plotter.camera.up = up
    plotter.camera.parallel_scale = half_height
    plotter.reset_camera_clipping_range()


def colour_bar(job: dict[str, Any], *, width: float, left: float, height: float) -> Any:
    """A bar with its unit near the lower edge; lengths are shares of the picture."""
    return {
        "title": f"contact pressure, {job['unit']}\n",  # the line break keeps it off the numbers
        "vertical": False,
        "width": width,
        "height": height,
        "position_x": left,
        "position_y": 0.03,
        "color": INK,
        "n_labels": 5,
        "fmt": "%.3g",
        "title_font_size": 18,
        "label_font_size": 16,
    }


KINDS = {"pressure": pressure_map, "section": section}

if __name__ == "__main__":
    main()
