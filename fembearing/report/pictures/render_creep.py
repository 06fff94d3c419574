"""The off-screen picture of friction in a rolling contact, above pressure and tractions, below stick and slip.

It runs in the process of `fembearing.report.pictures.render`; the job is that of `fembearing.report.pictures.creep`.
Across the groove runs to the right, along rolling up, towards the leading edge; places are drawn in pixels.
"""

from typing import Any

import numpy as np
import pyvista as pv

INK, EDGE, STUCK, ARROW = "black", "dimgrey", "royalblue", "crimson"
PRESSURES, SLIPS = "YlGnBu", "YlOrRd"
SHAFT, HEAD, TIP = 0.75, 6.0, 2.6  # pixels of an arrow: half width of its shaft, length and half width of its head
NEAREST = 12.0  # pixels between two arrows
LEAST = 3.0  # pixels: a shorter arrow is left out
ABOVE, BELOW = 612, 248  # pixels from the lower edge: the middles of both ellipses
FAR, NEARER = 100.0, np.array([0.0, 0.0, 1.0])  # pixels, to the eye


def creep_map(job: dict[str, Any]) -> pv.Plotter:
    """Both maps of a contact."""
    width, height = job["width"], job["height"]
    plotter = pv.Plotter(window_size=[width, height])
    upper, lower = np.array([width / 2, ABOVE, 0.0]), np.array([width / 2, BELOW, 0.0])
    _paint(plotter, job, "pressure", at=upper, colours=PRESSURES, title="pressure", left=0.66)
    _paint(plotter, job, "slip", at=lower, colours=SLIPS, title="slip speed", left=0.66)
    sticks = _rectangles(job, np.array(job["sticks"]))
    if sticks is not None:
        plotter.add_mesh(sticks.translate(lower + 1.0 * NEARER), color=STUCK, lighting=False)
    a, b = job["semi_axes"]
    angle = np.linspace(0, 2 * np.pi, 721)
    ring = _placed(job, a * np.sin(angle), b * np.cos(angle))
    for middle in (upper, lower):
        plotter.add_mesh(pv.lines_from_points(ring + middle + 3.0 * NEARER), color=INK, line_width=2)
    _arrows(plotter, job, upper)
    _legend(plotter, job)
    plotter.background_color = pv.Color("white")
    plotter.camera.parallel_projection = True
    plotter.enable_anti_aliasing("ssaa")
    plotter.camera.focal_point = (width / 2, height / 2, 0.0)
    plotter.camera.position = (width / 2, height / 2, FAR)
    plotter.camera.up = (0.0, 1.0, 0.0)
    plotter.camera.parallel_scale = height / 2
    plotter.reset_camera_clipping_range()
    return plotter


def _placed(job: dict[str, Any], x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Places in the contact, m, in pixels about its middle; x along rolling."""
    return np.column_stack([job["scale"] * y, job["scale"] * job["stretch"] * x, np.zeros_like(x)])


def _rectangles(job: dict[str, Any], wanted: np.ndarray) -> pv.PolyData | None:
    """Those of the rectangles that are wanted, (strips, cells), in pixels; None where there are none."""
    edges, (left, right) = np.array(job["edges"]), np.array(job["sides"])
    rows, columns = np.nonzero(wanted)
    if rows.size == 0:
        return None
    rear, front = edges[rows, columns], edges[rows, columns + 1]
    x = np.stack([rear, rear, front, front], axis=1).ravel()
    y = np.stack([left[rows], right[rows], right[rows], left[rows]], axis=1).ravel()
    corners = np.arange(4 * rows.size).reshape(-1, 4)
    return pv.PolyData.from_regular_faces(_placed(job, x, y), corners)


def _paint(
    plotter: pv.Plotter, job: dict[str, Any], name: str, *, at: np.ndarray, colours: str, title: str, left: float
) -> None:
    """One quantity of all rectangles in colours, with its bar."""
    shown = job[name]
    values = np.array(shown["values"])
    faces = _rectangles(job, np.ones(values.shape, dtype=bool))
    assert faces is not None
    faces.cell_data[name] = values.ravel()
    bar: Any = {
        "title": f"{title}, {shown['unit']}\n",
        "vertical": False,
        "width": 0.3,
        "height": 0.075,
        "position_x": left,
        "position_y": (at[1] - 245) / job["height"],
        "color": INK,
        "fmt": "%g",
        "title_font_size": 16,
        "label_font_size": 14,
        "n_colors": 256,
    }
    plotter.add_mesh(
        faces.translate(at),
        scalars=name,
        cmap=colours,
        clim=[0, shown["most"]],
        lighting=False,
        show_edges=True,
        edge_color=EDGE,
        edge_opacity=0.25,
        scalar_bar_args=bar,
    )
    labels = plotter.scalar_bars[bar["title"]]
    labels.SetCustomLabels(pv.convert_array(np.array(shown["ticks"])))
    labels.UseCustomLabelsOn()


def _arrows(plotter: pv.Plotter, job: dict[str, Any], middle: np.ndarray) -> None:
    """The tractions on the ball, of as many rectangles as there is room for."""
    edges, (left, right) = np.array(job["edges"]), np.array(job["sides"])
    along, across = job["per_traction"] * np.array(job["traction"])
    cells = edges.shape[1] - 1
    tall = job["scale"] * job["stretch"] * np.median(edges[:, 1] - edges[:, 0])
    every = max(1, int(np.ceil(NEAREST / tall)))
    last = -np.inf
    for j in range(len(edges)):
        place = job["scale"] * (left[j] + right[j]) / 2
        if place - last < NEAREST:
            continue
        last = place
        for k in range(every // 2, cells, every):
            arrow = np.array([across[j, k], along[j, k], 0.0])
            if np.linalg.norm(arrow) < LEAST:
                continue
            x = (edges[j, k] + edges[j, k + 1]) / 2
            tail = _placed(job, np.array([x]), np.array([(left[j] + right[j]) / 2]))[0] + middle + 4.0 * NEARER
            plotter.add_mesh(_flat_arrow(tail, arrow), color=ARROW, lighting=False)


def _flat_arrow(tail: np.ndarray, arrow: np.ndarray) -> pv.PolyData:
    """In pixels, in the plane of the picture."""
    length = float(np.linalg.norm(arrow))
    e = arrow / length
    n, head = np.array([-e[1], e[0], 0.0]), min(HEAD, 0.6 * length)
    neck = (length - head) * e
    points = tail + np.array(
        [
            -SHAFT * n,
            neck - SHAFT * n,
            neck - TIP * n,
            arrow,
            neck + TIP * n,
            neck + SHAFT * n,
            SHAFT * n,
        ]
    )
    return pv.PolyData(points, faces=[4, 0, 1, 5, 6, 3, 2, 3, 4])


def _legend(plotter: pv.Plotter, job: dict[str, Any]) -> None:
    """Title, scale of the arrows, lengths, and what is blue."""
    height = job["height"]
    plotter.add_text(job["title"], position=(12, height - 34), font_size=12, color=INK)
    plotter.add_text("surfaces enter at the upper edge", position=(12, height - 64), font_size=10, color=INK)
    size, words = job["arrow"]
    row = ABOVE - 205
    arrow = np.array([job["per_traction"] * size, 0.0, 0.0])
    plotter.add_mesh(_flat_arrow(np.array([24.0, row, 5.0]), arrow), color=ARROW, lighting=False)
    plotter.add_text(f"traction on the ball: {words}", position=(96, row - 12), font_size=10, color=INK)
    row = BELOW - 205
    square = pv.Rectangle([[24.0, row - 8, 5.0], [44.0, row - 8, 5.0], [44.0, row + 8, 5.0]])
    plotter.add_mesh(square, color=STUCK, lighting=False)
    plotter.add_text("sticks", position=(56, row - 12), font_size=10, color=INK)
    (across, words_across), (ahead, words_ahead) = job["bars"]
    right, up = job["scale"] * across, job["scale"] * job["stretch"] * ahead
    corner = np.array([480.0, row - 8, 5.0])
    for end in ([right, 0.0, 0.0], [0.0, up, 0.0]):
        plotter.add_mesh(pv.Line(corner, corner + end), color=INK, line_width=3)
    plotter.add_text(words_across, position=(int(corner[0] + right + 12), row - 20), font_size=10, color=INK)
    plotter.add_text(words_ahead, position=(int(corner[0] + 12), int(row - 8 + up - 12)), font_size=10, color=INK)
