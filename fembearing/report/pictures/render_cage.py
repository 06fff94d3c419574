"""The off-screen picture of a cage: its pockets, its balls, and the forces between them as arrows.

It runs in the process of `fembearing.report.pictures.render`; the job, in m and pixels, is that of
`fembearing.report.pictures.cage`.
x runs to the right, y up, and z, the bearing's axis, leans towards the eye. Lengths are drawn in mm.
"""

from typing import Any

import numpy as np
import pyvista as pv

MM = 1e3
BALL, CAGE, RING, INK, FORCE = "lightsteelblue", "peru", "silver", "black", "red"
HALF_HEIGHT = 0.1  # of the cage that is drawn, in ball radii
SHAFT, TIP, HEAD = 0.05, 0.15, 0.4  # of an arrow, in ball radii: half widths, and the length of its head
LEAST_SHOWN = 0.1  # ball radii: an arrow shorter than that is left out
FAR = 200.0  # mm, to the eye: no matter in a parallel projection, as long as all lies in front of it


def cage_front(job: dict[str, Any]) -> pv.Plotter:
    """The cage from in front with its balls, the force of each, and a scale for forces and one for lengths."""
    width, height, scale = job["width"], job["height"], job["scale"] / MM  # pixels per mm
    radius, pitch = MM * job["ball_radius"], MM * job["pitch_radius"]
    right, up, eye = np.array(job["axes"])
    before = 0.2 * FAR * eye  # in front of all bodies: a parallel projection does not tell
    plotter = pv.Plotter(window_size=[width, height])
    for groove in (pitch - radius, pitch + radius):
        ring = pv.Circle(radius=groove, resolution=360).extract_feature_edges()
        plotter.add_mesh(ring.translate(-before), color=RING, line_width=3)
    for part in cage_parts(job):
        plotter.add_mesh(part, color=CAGE, ambient=0.35, diffuse=0.7)
    for place in MM * np.array(job["balls"]):
        ball = pv.Sphere(radius=radius, center=place, theta_resolution=60, phi_resolution=60)
        plotter.add_mesh(ball, color=BALL, ambient=0.4, diffuse=0.6, smooth_shading=True)
    for place, arrow in zip(MM * np.array(job["tails"]), MM * np.array(job["arrows"]), strict=True):
        if np.linalg.norm(arrow) > LEAST_SHOWN * radius:
            plotter.add_mesh(arrow_along(arrow, radius).translate(place + before), color=FORCE, lighting=False)
    for place, colour in (([0.0, 0.0, 0.0], INK), (job["centre"], CAGE)):
        dot = pv.Sphere(radius=0.1 * radius, center=MM * np.array(place) + before)
        plotter.add_mesh(dot, color=colour, lighting=False)

    def on_paper(left: float, bottom: float) -> np.ndarray:
        """The place of a pixel, in front of everything."""
        return ((left - width / 2) * right + (bottom - height / 2) * up) / scale + before

    force, length, pull = job["force_scale"], job["length_scale"], job["pull"]
    legend = arrow_along(MM * force["length"] * right, radius)
    plotter.add_mesh(legend.translate(on_paper(force["left"], 58)), color=FORCE, lighting=False)
    plotter.add_text(force["label"], position=(force["left"], 14), font_size=10, color=INK)
    ends = [on_paper(length["left"] + pixels, 58) for pixels in (0, scale * MM * length["length"])]
    plotter.add_mesh(pv.Line(ends[0], ends[1]), color=INK, line_width=4)
    plotter.add_text(length["label"], position=(length["left"], 14), font_size=10, color=INK)
    if pull["length"]:
        down = arrow_along(-MM * pull["length"] * up, radius)
        plotter.add_mesh(down.translate(on_paper(width - 40, 130)), color=INK, lighting=False)
    plotter.add_text(pull["label"], position=(width - pull["room"], 14), font_size=10, color=INK)
    for line, text in enumerate([*job["title"], *job["lines"]]):
        size = 12 if line < len(job["title"]) else 10
        plotter.add_text(text, position=(12, height - 34 - 28 * line), font_size=size, color=INK)
    plotter.background_color = pv.Color("white")
    plotter.camera.parallel_projection = True
    plotter.enable_anti_aliasing("ssaa")
    plotter.camera.focal_point = (0.0, 0.0, 0.0)
    plotter.camera.position = FAR * eye
    plotter.camera.up = up
    plotter.camera.parallel_scale = height / 2 / scale
    plotter.reset_camera_clipping_range()
    return plotter


def cage_parts(job: dict[str, Any]) -> list[pv.PolyData]:
    """A rim around each ball, and a bar from each to the next."""
    inner, wall, half = MM * job["pocket_radius"], MM * job["wall"], HALF_HEIGHT * MM * job["ball_radius"]
    places = MM * np.array(job["pockets"])
    parts = []
    for place, following in zip(places, np.roll(places, -1, axis=0), strict=True):
        rim = pv.Disc(center=place - [0.0, 0.0, half], inner=inner, outer=inner + wall, r_res=1, c_res=90)
        parts.append(rim.extrude([0.0, 0.0, 2 * half], capping=True))
        along = (following - place) / np.linalg.norm(following - place)
        ends = place + (inner + wall / 2) * along, following - (inner + wall / 2) * along
        if (ends[1] - ends[0]) @ along > 0:
            parts.append(pv.Line(ends[0], ends[1]).tube(radius=half, n_sides=24, capping=True))
    return parts


def arrow_along(arrow: np.ndarray, radius: float) -> pv.PolyData:
    """From the origin, as thick whatever its length."""
    length = float(np.linalg.norm(arrow))
    head = min(HEAD * radius, 0.5 * length)
    return pv.Arrow(
        direction=arrow,
        scale=length,
        shaft_radius=SHAFT * radius / length,
        tip_radius=TIP * radius / length,
        tip_length=head / length,
        tip_resolution=40,
        shaft_resolution=40,
    )
