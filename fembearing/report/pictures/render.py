"""Off-screen pictures by VTK, in a process of their own: python -m fembearing.report.pictures.render

Where a machine has no GL library VTK ends the process instead of raising, so nothing else may live in it. The jobs,
one line of JSON, are those of `fembearing.report.pictures.draw`; each picture is one PNG, or the numbers of a view.
Frame of the meshes: z along the load into the ball, x along rolling, y transverse; lengths are drawn in mm.
"""

import json
import os
import sys
from pathlib import Path
from threading import Thread
from typing import Any

import numpy as np
import pyvista as pv

from fembearing.report.pictures import render_mesh as mesh
from fembearing.report.pictures.render_cage import cage_front
from fembearing.report.pictures.render_creep import creep_map
from fembearing.report.pictures.render_view import contact_view

BARE = "gainsboro"
FAR = 100.0  # mm, to the eye: no matter in a parallel projection, as long as all lies in front of it
VIEW = np.array([-0.74, 0.38, 0.55])  # towards the eye, over the cut plane x = 0
SLENDER = 3.0  # ratio of semi-axes
AROUND = 4.0  # half widths of the lower body around the contact: what lies farther off need not be in sight


def main() -> None:
    """Draw every job of standard input into its file, in a folder that is still being made."""
    pv.OFF_SCREEN = True
    jobs = json.loads(sys.stdin.readline())
    Thread(target=end_with_the_other, daemon=True).start()
    for job in jobs:
        made = KINDS[job["kind"]](job)
        target = Path(job["file"])
        if isinstance(made, dict):
            target.write_text(json.dumps(made), "utf-8")
        else:
            made.screenshot(target)
            made.close()


def end_with_the_other() -> None:
    """End where the process that wants the pictures was killed: it holds standard input open until they are drawn."""
    os.read(sys.stdin.fileno(), 1)
    os._exit(1)


def pressure_map(job: dict[str, Any]) -> pv.Plotter:
    """The contact seen along the load, to scale, with Hertz's ellipse and a bar of a round length."""
    frame, axes = job["frame"], np.eye(3)
    width, height, scale = frame["width"], frame["height"], frame["scale"] / mesh.MM  # pixels per mm
    eye, up = axes[2], axes[1] if frame["rolling_is_horizontal"] else -axes[0]  # y upwards or to the right
    right = np.cross(up, eye)
    middle = (frame["centre"][1] - height / 2) / scale * up
    plotter = pv.Plotter(window_size=[width, height])
    body = mesh.scaled(job["lower"], job)
    missing = (0, *mesh.across(job))
    surface = mesh.mirrored(mesh.loaded_face(body), missing)
    edges = mesh.cell_edges(mesh.mirrored(body, missing), loaded=True)
    above = np.ptp(surface.points[:, 2]) * eye  # the projection is parallel: height does not show
    plotter.add_mesh(surface, color=BARE, lighting=False)
    bar = colour_bar(job, width=420 / width, left=1 - 440 / width, height=80 / height)
    show_pressure(plotter, surface.translate(above), job, bar=bar)
    plotter.add_mesh(edges.translate(2 * above), color=mesh.LINES, opacity=0.3, line_width=1)
    computed = ellipse(job["computed"]).translate(3 * above + mesh.MM * job["centroid"] * axes[1])
    plotter.add_mesh(computed, color=mesh.INK, line_width=2)
    for shoulder in job["shoulders"]:
        ends = [mesh.MM * shoulder * axes[1] + side * max(width, height) / scale * axes[0] for side in (-1, 1)]
        plotter.add_mesh(pv.Line(*ends).translate(5 * above), color=mesh.SHOULDER, line_width=3)
        plotter.add_text("orange: shoulder", position=(470, height - 62), font_size=10, color=mesh.SHOULDER)
    plotter.add_mesh(ellipse(job["hertz"]).translate(4 * above), color=mesh.HERTZ, line_width=3)
    length = frame["bar"] * mesh.MM
    start = middle + 3 * above + ((30 - width / 2) * right + (30 - height / 2) * up) / scale
    plotter.add_mesh(pv.Line(start, start + length * right), color=mesh.INK, line_width=4)
    direction = "rolling" if frame["rolling_is_horizontal"] else "transverse"
    plotter.add_text(f"{length:g} mm, {direction}", position=(30, 38), font_size=10, color=mesh.INK)
    plotter.add_text(job["title"], position=(12, height - 34), font_size=12, color=mesh.INK)
    plotter.add_text("red: Hertz's ellipse", position=(12, height - 62), font_size=10, color=mesh.HERTZ)
    plotter.add_text("black: finite elements", position=(190, height - 62), font_size=10, color=mesh.INK)
    look(plotter, at=middle, eye=eye, up=up, half_height=height / 2 / scale)
    return plotter


def section(job: dict[str, Any]) -> pv.Plotter:
    """Left both bodies cut along the plane x = 0, the ball lifted off; right the lower one alone, near the contact."""
    plotter = pv.Plotter(shape=(1, 2), window_size=[1500, 800], border=False)
    bodies = {side: mesh.scaled(job[side], job) for side in mesh.BODIES}
    bodies["upper"] = bodies["upper"].translate([0.0, 0.0, mesh.MM * job["lifted"]])
    middle, half_height = fitted(bodies, job)
    plotter.subplot(0, 0)
    for side, body in bodies.items():
        draw(plotter, body, side, job, eye=VIEW, half_height=half_height)
    look(plotter, at=middle, eye=VIEW, up=[0, 0, 1], half_height=half_height)
    plotter.add_text(job["title"], position=(12, 766), font_size=12, color=mesh.INK)
    plotter.subplot(0, 1)
    bar = colour_bar(job, width=0.6, left=0.3, height=0.1)
    longer, shorter = mesh.MM * max(job["computed"]), mesh.MM * min(job["computed"])
    eye, half_height = (mesh.STEEP, 1.15 * longer) if longer > SLENDER * shorter else (VIEW, 1.25 * longer)
    draw(plotter, bodies["lower"], "lower", job, eye=eye, half_height=half_height, bar=bar)
    look(plotter, at=[0, 0, 0], eye=eye, up=[0, 0, 1], half_height=half_height)
    plotter.add_text(job["near"], position=(12, 766), font_size=12, color=mesh.INK)
    return plotter


def fitted(bodies: dict[str, pv.UnstructuredGrid], job: dict[str, Any]) -> tuple[np.ndarray, float]:
    """Middle and half height of a square picture from VIEW that holds the lower body and what is around it."""
    around = AROUND * bodies["lower"].points[:, 1].max()
    points = np.vstack([mesh.mirrored(body, mesh.across(job)).points for body in bodies.values()]).clip(-around, around)
    right = np.cross([0, 0, 1], VIEW) / np.linalg.norm(VIEW[:2])
    up = np.cross(VIEW, right)
    seen = points @ np.column_stack([right, up])
    low, high = seen.min(axis=0), seen.max(axis=0)
    return (low + high) / 2 @ np.array([right, up]), 1.2 * float(np.max(high - low)) / 2


def draw(
    plotter: pv.Plotter,
    body: pv.DataSet,
    side: str,
    job: dict[str, Any],
    *,
    eye: np.ndarray,
    half_height: float,
    bar: Any = None,
) -> None:
    """Half of a body, cut along x = 0, with its cells and the pressure on it."""
    half = mesh.mirrored(body, mesh.across(job))
    solid = half.extract_surface(nonlinear_subdivision=mesh.ROUND, algorithm="dataset_surface")
    surface = mesh.mirrored(mesh.loaded_face(body), mesh.across(job))
    nearer = 0.002 * half_height * eye  # what lies on a face is moved towards the eye, to be drawn on top of it
    plotter.add_mesh(solid, color=mesh.BODIES[side], ambient=0.45, diffuse=0.6)
    show_pressure(plotter, surface.translate(nearer), job, bar=bar)
    plotter.add_mesh(mesh.cell_edges(half).translate(2 * nearer), color=mesh.LINES, line_width=1)


def show_pressure(plotter: pv.Plotter, surface: pv.DataSet, job: dict[str, Any], *, bar: Any = None) -> None:
    """The part of a surface that carries pressure, in colours."""
    for shoulder in job["shoulders"]:  # cells beyond would be painted down to their next nodes
        inwards = -np.sign(shoulder) * np.eye(3)[1]
        surface = surface.clip(normal=inwards, origin=(0.0, mesh.MM * shoulder, 0.0), invert=False)
    pressed = surface.clip_scalar(scalars="pressure", value=mesh.LEAST_SHOWN * job["peak"], invert=False)
    plotter.add_mesh(
        pressed,
        scalars="pressure",
        cmap=mesh.COLOURS,
        clim=[0, job["peak"]],
        lighting=False,
        show_scalar_bar=bar is not None,
        scalar_bar_args=bar,
    )
    if bar is not None:
        labels = plotter.scalar_bars[bar["title"]]
        labels.SetCustomLabels(pv.convert_array(np.array(job["ticks"])))
        labels.UseCustomLabelsOn()


def ellipse(semi_axes: tuple[float, float]) -> pv.PolyData:
    """An ellipse around the origin as a line; semi-axes in m."""
    angle = np.linspace(0, 2 * np.pi, 721)
    x, y = mesh.MM * semi_axes[0] * np.cos(angle), mesh.MM * semi_axes[1] * np.sin(angle)
    return pv.lines_from_points(np.column_stack([x, y, np.zeros_like(x)]))


def look(plotter: pv.Plotter, *, at: Any, eye: Any, up: Any, half_height: float) -> None:
    """Set the camera: a parallel projection from `eye`, with the point `at` in the middle."""
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
        "color": mesh.INK,
        "fmt": "%g",
        "title_font_size": 18,
        "label_font_size": 16,
    }


KINDS = {"pressure": pressure_map, "section": section, "view": contact_view, "cage": cage_front, "creep": creep_map}

if __name__ == "__main__":
    main()
