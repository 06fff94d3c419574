"""A picture as its renderer composes it, without a window and GL: parts and words with their places in pixels."""

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any, NamedTuple
from unittest.mock import patch

import numpy as np
import pyvista as pv
from numpy.typing import NDArray

Places = NDArray[np.float64]
LETTER = 2  # pixels of a letter's height for each unit of its size, as pyvista draws it


class Part(NamedTuple):
    mesh: Any  # of pyvista
    look: dict[str, Any]


class Word(NamedTuple):
    text: str
    left: float  # pixels
    bottom: float  # pixels, of its line
    size: float
    colour: str

    @property
    def top(self) -> float:
        return self.bottom + LETTER * self.size


class Window:
    """One view of a picture."""

    def __init__(self, width: int, height: int) -> None:
        self.width, self.height = width, height
        self.camera, self.parts, self.words = SimpleNamespace(), list[Part](), list[Word]()

    def of(self, colour: str) -> list[Any]:
        """The meshes of one colour, in the order in which they were added."""
        return [part.mesh for part in self.parts if part.look.get("color") == colour]

    def word(self, begin: str) -> Word:
        (found,) = (word for word in self.words if word.text.startswith(begin))
        return found

    def pixels(self, places: Any) -> Places:
        """(n, 3) from the left, from below, and towards the eye from the middle of the picture, of places or a mesh."""
        camera, points = self.camera, np.asarray(getattr(places, "points", places), dtype=float)
        assert camera.parallel_projection
        eye = np.subtract(camera.position, camera.focal_point)
        right = np.cross(camera.up, eye)
        axes = np.array([axis / np.linalg.norm(axis) for axis in (right, np.cross(eye, right), eye)])
        middle = np.array([self.width / 2, self.height / 2, 0.0])
        return middle + self.height / 2 / camera.parallel_scale * (points - camera.focal_point) @ axes.T

    def box(self, places: Any) -> Places:
        """(2, 3) the least and the greatest of these pixels."""
        found = self.pixels(places)
        return np.array([found.min(axis=0), found.max(axis=0)])

    def require_whole(self) -> None:
        """Every word is within the picture, and the eye before everything."""
        for word in self.words:
            assert 0 <= word.left < self.width, word
            assert 0 <= word.bottom < word.top <= self.height, word
        away = np.linalg.norm(np.subtract(self.camera.position, self.camera.focal_point))
        far = self.height / 2 / self.camera.parallel_scale * away
        for part in self.parts:
            assert self.box(part.mesh)[1, 2] < far, part


class Sketch:
    """What stands in for VTK's plotter."""

    def __init__(self, *, window_size: list[int], shape: tuple[int, int] = (1, 1), **_: Any) -> None:
        (width, height), (rows, columns) = window_size, shape
        places = [(row, column) for row in range(rows) for column in range(columns)]
        self.windows = {place: Window(width // columns, height // rows) for place in places}
        self.scalar_bars: dict[str, Labels] = {}
        self.subplot(0, 0)

    @property
    def camera(self) -> SimpleNamespace:
        return self.window.camera

    def subplot(self, row: int, column: int) -> None:
        self.window = self.windows[row, column]

    def add_mesh(self, mesh: Any, **look: Any) -> None:
        self.window.parts.append(Part(mesh, look))
        if look.get("scalar_bar_args") and look.get("show_scalar_bar", True):
            self.scalar_bars[look["scalar_bar_args"]["title"]] = Labels()

    def add_text(self, text: str, *, position: tuple[float, float], font_size: float, color: str) -> None:
        self.window.words.append(Word(text, *position, font_size, color))

    def enable_anti_aliasing(self, kind: str) -> None:
        pass

    def reset_camera_clipping_range(self) -> None:
        pass


class Labels:
    """Of a colour bar."""

    def SetCustomLabels(self, labels: Any) -> None:  # noqa: N802  # VTK's name
        self.values = pv.convert_array(labels)

    def UseCustomLabelsOn(self) -> None:  # noqa: N802
        self.used = True


def sketched(draws: Callable[[dict[str, Any]], object], job: dict[str, Any]) -> Sketch:
    """What a renderer composes of a job."""
    with patch.object(pv, "Plotter", Sketch):
        sketch = draws(job)
    assert isinstance(sketch, Sketch)
    for window in sketch.windows.values():
        window.require_whole()
    return sketch
