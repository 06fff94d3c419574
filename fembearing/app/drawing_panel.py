"""The part of the page with the bearing drawn to scale and the fields of its dimensions."""

from typing import Any, Protocol

from nicegui import background_tasks, ui

from analytic.errors import FembearingError
from fembearing.app.computing import computed
from fembearing.app.inputs import Inputs, folded, line
from fembearing.app.scene_edit import DIMENSIONS

HEAD = "Bearing drawn to scale, dimensions of your own"


class Shown(Protocol):
    """The page that a panel is a part of."""

    inputs: Inputs
    evaluation: Any  # that it shows; None: none yet


class DrawingPanel:
    """The drawing, made while the panel is open, with fields beside it."""

    def __init__(self, page: Shown) -> None:
        self.page = page
        self.is_open = False
        self.drawn: Any = None  # the evaluation whose bearing the drawing shows
        self.panel = folded(HEAD).on("toggle", self._turn, js_handler="(event) => emit(event.target.open)")
        with self.panel, ui.element("div").classes("beside"):
            page.inputs.fill(self.panel, DIMENSIONS)
            region = ui.element("div").classes("wide stack")
            with region.props('role=region tabindex=0 aria-label="Bearing drawn to scale"'):
                self.picture = ui.html("", sanitize=False).classes("drawing")
                self.said = line("p").classes("soft")

    async def follow(self) -> None:
        """Draw the bearing of the page, if the panel is open and another was drawn."""
        found = self.page.evaluation
        if not self.is_open or found is None or found is self.drawn:
            return
        from fembearing.app.evaluation import drawing_of

        self.drawn, said = found, ""
        try:
            content = await computed(drawing_of, found)
        except FembearingError as problem:
            content, said = "", str(problem)
        if self.drawn is found:
            self.said.text = said
            self.picture.content = content

    def _turn(self, event: Any) -> None:
        """The user opens or closes the panel."""
        self.is_open = bool(event.args)
        background_tasks.create(self.follow())
