"""The page of one browser tab: headline, inputs, charts, check and download."""

import asyncio
from collections.abc import Awaitable, Callable, Iterator
from contextlib import contextmanager
from typing import Any

from nicegui import Client, background_tasks, ui

from analytic.errors import FembearingError, InputError
from fembearing.app.check_panel import CheckPanel
from fembearing.app.computing import computed, computed_first
from fembearing.app.drawing_panel import DrawingPanel
from fembearing.app.inputs import SCENE, Inputs, line
from fembearing.app.scene_edit import (
    CATALOG,
    FIELDS,
    field_in,
    of_bearing,
    shown_value,
    values_in,
    with_typed,
)

FIRST = "6206"  # the bearing of a new page
MOST_WAITING = 20  # requests whose browser may still connect; it does at once
COMPUTING = "computing"
PAUSE = 0.3  # s without a change, after which the curve is computed
NUMBERS = ("torque", "unit", "interval", "power")  # lines of the headline that change with the torque


def after_handshake(build: Callable[[], object]) -> Callable[[], Awaitable[None]]:
    """What answers a request: it builds the page once the browser has connected, so that a mere request costs little.

    Any site can have an image with this address, and any program can ask again and again.
    """
    waiting: dict[str, Client] = {}

    async def root() -> None:
        client = ui.context.client
        waiting[client.id] = client
        if len(waiting) > MOST_WAITING:
            waiting.pop(next(iter(waiting))).delete()
        await client.connected()
        waiting.pop(client.id, None)
        if not client.is_deleted:
            build()

    return root


class Page:
    """One tab. The text of the scene is its state; nothing is shared with other tabs."""

    def __init__(self) -> None:
        self.text = of_bearing(FIRST, "")
        self.values = values_in(self.text)
        self.changed = SCENE  # the field that a user has changed last
        self.evaluation: Any = None  # of the last text that had a torque
        self.is_new = False  # whether the text has changed since the computation began
        self.is_evaluating = False
        self.followers = 0  # tasks that compute interval, drawing and curve, or wait for it
        self.following = asyncio.Lock()  # one of them at a time, so that no outdated work waits for the thread
        self.is_open = True
        self.lines: dict[str, ui.label] = {}
        self.charts: dict[str, ui.echart] = {}
        self._headline()
        with ui.element("main").classes("stack"):
            with ui.element("div").classes("two"):
                with ui.element("section").classes("stack").props('aria-label="Inputs"'):
                    self.inputs = Inputs(self)
                self.results = ui.element("section").classes("stack").props('aria-label="Results"')
                with self.results:
                    self._charts()
            # Pale while they are of an earlier scene
            self.dated = (self.results, *(self.lines[name] for name in NUMBERS))
            self.drawing = DrawingPanel(self)
            self.check = CheckPanel(self)
        self.fields, self.sliders = self.inputs.fields, self.inputs.sliders
        ui.context.client.on_delete(self.close)
        background_tasks.create(self.refresh())

    def close(self) -> None:
        """End what the tab has begun."""
        self.is_open = False
        self.check.close()

    # What the page is made of.

    def _headline(self) -> None:
        with ui.element("header").classes("panel head"):
            with ui.element("div").classes("big").props('role="status" aria-live="polite"'):
                self.lines["torque"] = line("span", "...")
                self.lines["unit"] = line("small")
            with ui.element("div"):
                self.lines["title"] = line("h1", "fembearing")
                with ui.element("div").classes("facts"):
                    self.lines |= {name: line("span") for name in ("interval", "power")}
        with ui.element("div").classes("panel"):
            with ui.element("div").classes("facts"):
                line("span", "Verdict")
                self.lines["verdict"] = line("span", COMPUTING).classes("verdict")
                self.lines["reason"] = line("span", "the first torque on a machine takes a minute or two")
            self.lines["problem"] = line("div").classes("problem").props('role="alert"')

    def _charts(self) -> None:
        with ui.element("div").classes("panel"):
            line("h2", "Parts of the torque")
            self._chart("parts", "Parts of the friction torque", 36)
            self.legend = ui.html("", sanitize=False)
            self.lines["split"] = line("div").classes("soft")
            self.lines |= {name: line("div").classes("soft") for name in ("film", "makers")}
        with ui.element("div").classes("panel"):
            line("h2", "Torque over the speed")
            self._chart("curve", "Friction torque over the speed, with its interval and the makers' formulas", 320)
            self.charts["curve"].set_visibility(False)
            self.lines["curve"] = line("div", COMPUTING).classes("soft")
        with ui.element("div").classes("pair stack"):
            with ui.element("div").classes("panel"):
                line("h2", "Loads of the balls")
                self._chart("ring", "Loads of the balls around the ring", 330)
                self.lines["ring"] = line("div").classes("soft")
            with ui.element("div").classes("panel"):
                line("h2", "Contact of the heaviest ball")
                for race in ("inner", "outer"):
                    self.lines[race] = line("h3")
                    self._chart(race, f"Contact ellipse on the {race} race, between the shoulders", 156)
                self.lines["contact"] = line("div").classes("soft")
        with ui.element("div").classes("panel") as self.warned:
            line("h2", "Warnings")
            self.lines["warnings"] = line("div").classes("lines")
        self.warned.set_visibility(False)

    def _chart(self, name: str, words: str, height: int) -> None:
        chart = ui.echart({}, renderer="svg").classes("chart").style(f"height: {height}px")
        self.charts[name] = chart.props(f'role="img" aria-label="{words}"')

    # What a user does.

    def type(self, key: str, typed: str) -> None:
        """Take what a user types into a field."""
        if typed == shown_value(self.values.get(key, "")):
            if self.inputs.fields[key].error:  # a refused value is taken back; else the page itself has put it there
                self._take("")
            return
        self.changed = key
        try:
            self.text, notes = (
                (of_bearing(typed, self.text), []) if key == CATALOG else with_typed(self.text, key, typed)
            )
        except InputError as problem:
            self.complain(str(problem), key)
            return
        self._take("; ".join(notes))

    def slide(self, key: str, number: float) -> None:
        """Take what a user sets a slider to."""
        unit = FIELDS[key].unit
        assert unit is not None, key
        self.type(key, f"{number:.5g} {unit.name}")

    def paste(self, text: str) -> None:
        """Take a whole scene."""
        if text != self.text:
            self.text, self.changed = text, SCENE
            self._take("")

    def _take(self, note: str) -> None:
        """Show the text in its box and its values in the fields, and compute."""
        try:
            self.values = values_in(self.text)
        except InputError as problem:
            self.complain(str(problem), SCENE)
            return
        self.complain("", None)
        self.lines["problem"].text = note
        self.inputs.show()
        background_tasks.create(self.refresh())

    def complain(self, problem: str, key: str | None) -> None:
        """Show a problem above and beside its field, or beside the scene; an empty one takes the last away.

        What is shown is of an earlier scene then.
        """
        self.inputs.complain(problem, key)
        self.lines["problem"].text = problem
        for part in self.dated:
            part.classes("old")
        if self.evaluation is not None and self.evaluation.text != self.text:
            self.lines["interval"].text = self.evaluation.lines["interval"]  # its own, or none: no more comes of it
            if self.lines["curve"].text.startswith(COMPUTING):
                self.lines["curve"].text = "not computed"

    # What is computed.

    @property
    def is_busy(self) -> bool:
        """Whether anything is computed for the tab."""
        return self.is_evaluating or self.followers > 0

    async def refresh(self) -> None:
        """Compute and show the scene; changes meanwhile are taken together, and the last one counts."""
        self.is_new = True
        if self.is_evaluating:
            return
        self.is_evaluating = True
        try:
            while self.is_new and self.is_open:
                self.is_new = False
                with self._problems_shown():
                    await self._evaluate()
        finally:
            self.is_evaluating = False

    async def _evaluate(self) -> None:
        from fembearing.app.evaluation import at_once

        found = await computed_first(at_once, self.text)
        if not self.is_new and self.is_open:
            self._show(found)
            self.followers += 1
            background_tasks.create(self._follow(found))

    @contextmanager
    def _problems_shown(self) -> Iterator[None]:
        """Show an error in place of raising it: the page and the other tabs go on."""
        try:
            yield
        except FembearingError as problem:
            self.complain(str(problem), field_in(str(problem)) or self.changed)
        except Exception as problem:
            words = f"{type(problem).__name__}: {problem}"
            self.complain(f"a defect of fembearing, not of your input: {words}; please report it", SCENE)

    def _is_shown(self, found: Any) -> bool:
        """Whether this torque is that of the scene, and the page still open."""
        return self.is_open and not self.is_new and found.text == self.text

    async def _follow(self, found: Any) -> None:
        """Compute and show what takes longer: interval, drawing and curve, as long as the scene does not change."""
        try:
            async with self.following:
                with self._problems_shown():
                    await self._follow_now(found)
        finally:
            self.followers -= 1

    async def _follow_now(self, found: Any) -> None:
        from fembearing.app.evaluation import completed

        if self._is_shown(found):
            found = await computed(completed, found)
        if self._is_shown(found):
            self._show_interval(found)
            await self.drawing.follow()
            await self._follow_speed(found)

    async def _follow_speed(self, found: Any) -> None:
        """Compute the curve in slices, until it is complete or something has changed."""
        from fembearing.app.charts import curve_options
        from fembearing.app.evaluation import curve_scenes, series_of

        await asyncio.sleep(PAUSE)
        records, words = [], ""
        scenes = curve_scenes(found)
        for number, scene in enumerate(scenes, start=1):
            if not self._is_shown(found):
                return
            try:
                records.append(await computed(series_of, scene))
            except FembearingError as problem:  # other speeds have a torque
                words = str(problem)
            if records and self._is_shown(found):
                marked = None if found.is_series else found.row["inner_speed"]
                self._draw("curve", curve_options(records, found.units, marked=marked))
                self.lines["curve"].text = words if number == len(scenes) else f"{COMPUTING} more speeds"
        if not records and self._is_shown(found):
            self._draw("curve", None)
            self.lines["curve"].text = words or "The bearing is at rest."

    def _show(self, found: Any) -> None:
        """Show a torque with its parts, its balls and its contacts."""
        from fembearing.app.charts import ellipse_options, part_legend, part_options, ring_options

        self.evaluation, lines = found, found.lines
        for name, text in lines.items():
            if name != "interval":
                self.lines[name].text = text
        for part in self.dated:
            part.classes(remove="old")
        for part in (self.lines["interval"], self.charts["curve"]):
            part.classes("old")  # until they are computed too
        self.lines["curve"].text = COMPUTING
        self.lines["verdict"].classes(replace=f"verdict {lines['verdict']}")
        self.warned.set_visibility(bool(lines["warnings"]))
        self._draw("parts", part_options(found.row, found.units))
        self.legend.content = part_legend(found.row, found.units)
        self._draw("ring", ring_options(found.result.friction, found.point, found.units))
        for race in ("inner", "outer"):
            contact = found.contacts.get(race)
            self._draw(race, None if contact is None else ellipse_options(contact, found.row, found.units))
        rating = found.result.scene.bearing.static_load_rating
        numbers = {key: found.number(key) for key in self.sliders}
        settled = {key for key, number in numbers.items() if number is None and found.derived[key] != "none"}
        self.inputs.derive(found.derived, settled)
        self.inputs.slide_to(numbers, rating)
        self.check.follow(self.text)

    def _show_interval(self, found: Any) -> None:
        """Show the interval of the torque that is shown."""
        self.evaluation = found
        self.lines["interval"].text = found.lines["interval"]
        self.lines["interval"].classes(remove="old")

    def _draw(self, name: str, options: dict[str, Any] | None) -> None:
        chart = self.charts[name]
        chart.classes(remove="old").set_visibility(options is not None)
        if options is not None:
            chart.options.clear()
            chart.options.update(options)
            chart.update()
