"""The page of one browser tab: headline, inputs, charts, check and download."""

import asyncio
from html import escape
from importlib.resources import files
from typing import Any

from nicegui import background_tasks, ui

from analytic.catalog.bearing_rows import bearing_names
from analytic.errors import FembearingError, InputError
from fembearing.app.check_panel import CheckPanel
from fembearing.app.computing import computed
from fembearing.app.scene_edit import (
    CATALOG,
    FIELDS,
    Field,
    field_in,
    of_bearing,
    shown_value,
    values_in,
    with_dimensions,
    with_typed,
)

FIRST = "6206"  # the bearing of a new page
SCENE = "scene"  # the box with the text, among the fields
DEBOUNCE = 400  # ms without a key stroke, after which a field counts
FEW = 8  # words that are shown as a list to choose from; more are searched
ENDS = {"operation.inner_speed": (0.0, 10_000.0), "lubricant.temperature": (-20.0, 140.0)}  # of sliders, rpm and degC
HEAVY, UNRATED = 0.5, 10_000.0  # end of the sliders of loads: share of C0, and N where C0 is not known
PAUSE = 0.3  # s without a change, after which the curve is computed
STEPS = 200  # of a slider
NUMBERS = ("torque", "unit", "interval", "power")  # lines that are pale while the scene has no torque
PRIMARY = "#1f6fb2"  # white letters on it have a contrast of 5.2


def line(tag: str, text: str = "") -> ui.label:
    """A text that changes, in an element of HTML."""
    label = ui.label(text)
    label.tag = tag
    return label


class Page:
    """One tab. The text of the scene is its state; nothing is shared with other tabs."""

    def __init__(self) -> None:
        self.text = of_bearing(FIRST, "")
        self.values = values_in(self.text)
        self.evaluation: Any = None  # of the last text that had a torque
        self.is_new = False  # whether the text has changed since the computation began
        self.is_busy = False
        self.is_open = True
        self.fields: dict[str, Any] = {}
        self.sliders: dict[str, ui.slider] = {}
        self.lines: dict[str, ui.label] = {}
        self.charts: dict[str, ui.echart] = {}
        ui.colors(primary=PRIMARY)
        ui.add_css(files("fembearing.app").joinpath("style.css").read_text("utf-8"))
        self._headline()
        with ui.element("main").classes("two"):
            with ui.element("section").classes("stack").props('aria-label="Inputs"'):
                self._inputs()
                self._scene()
            with ui.element("section").classes("stack").props('aria-label="Results"'):
                self._charts()
                self.check = CheckPanel(self)
        ui.context.client.on_delete(self.close)
        background_tasks.create(self.refresh())

    def close(self) -> None:
        """End what the tab has begun."""
        self.is_open = False
        self.check.close()

    # What the page is made of.

    def _headline(self) -> None:
        with ui.element("header").classes("panel head"):
            self.lines["title"] = line("h1", "fembearing")
            with ui.element("div").classes("big").props('role="status" aria-live="polite"'):
                self.lines["torque"] = line("span", "...")
                self.lines["unit"] = line("small")
            with ui.element("div").classes("facts"):
                self.lines |= {name: line("span") for name in ("interval", "power")}
            with ui.element("div").classes("facts"):
                self.lines["verdict"] = line("span", "computing").classes("verdict")
                self.lines["reason"] = line("span", "the first torque on a machine takes a minute or two")
            self.lines["problem"] = line("div").classes("problem").props('role="alert"')

    def _inputs(self) -> None:
        with ui.element("div").classes("panel stack"):
            line("h2", "Bearing and operation")
            self._input(CATALOG, "Bearing", "6206, 7208B, 6305-2RS/C3", words=bearing_names())
            for key, field in FIELDS.items():
                with ui.element("div").classes("field"):
                    self._choice(key, field) if 0 < len(field.words) <= FEW else self._input(
                        key, field.label, field.example, words=field.words
                    )
                    if field.unit is not None:
                        self._slider(key, field)

    def _input(self, key: str, label: str, example: str, *, words: tuple[str, ...]) -> None:
        """A field of text;  words : that it offers while one types"""
        name = key.replace(".", "-")
        if words:
            options = "".join(f'<option value="{escape(word)}">' for word in words)
            ui.html(options, sanitize=False, tag="datalist").props(f"id={name}")
        made = ui.input(
            label,
            value=shown_value(self.values.get(key, "")),
            placeholder=example,
            on_change=lambda event: self.type(key, event.value or ""),
        )
        listed = f"list={name}" if words else ""
        made.props(f"dense outlined stack-label debounce={DEBOUNCE} autocomplete=off {listed}")
        self.fields[key] = made.without_auto_validation()

    def _choice(self, key: str, field: Field) -> None:
        made = ui.select(
            {"": field.example, **{word: word.replace("_", " ") for word in field.words}},
            label=field.label,
            value=shown_value(self.values.get(key, "")),
            on_change=lambda event: self.type(key, event.value or ""),
        )
        self.fields[key] = made.props("dense outlined options-dense stack-label").without_auto_validation()

    def _slider(self, key: str, field: Field) -> None:
        low, high = ENDS.get(key, (0.0, UNRATED))
        slider = ui.slider(min=low, max=high, step=(high - low) / STEPS, value=low)
        slider.on("update:model-value", lambda event: self.slide(key, event.args), throttle=0.1)
        self.sliders[key] = slider.props(f'dense aria-label="{field.label}"')

    def _scene(self) -> None:
        with ui.element("details").classes("panel scene"):
            with ui.element("summary"):
                line("span", "Scene (TOML), to copy, paste and edit")
            box = ui.textarea("Scene", value=self.text, on_change=lambda event: self.paste(event.value or ""))
            self.fields[SCENE] = box.without_auto_validation().props(
                f"outlined stack-label rows=22 debounce={DEBOUNCE} spellcheck=false"
            )
            own = ui.button("Dimensions of my own", on_click=self.own_dimensions, color=None)
            own.props("outline no-caps")
            line("p", "Writes the derived dimensions of the bearing into the scene, to edit.").classes("soft")

    def _charts(self) -> None:
        with ui.element("div").classes("panel"):
            line("h2", "Parts of the torque")
            self._chart("parts", "Parts of the friction torque", 104)
            self.lines |= {name: line("div").classes("soft") for name in ("split", "film", "makers")}
        with ui.element("div").classes("panel"):
            line("h2", "Torque over the speed")
            self._chart("curve", "Friction torque over the speed, with its interval and the makers' formulas", 320)
            self.charts["curve"].set_visibility(False)
            self.lines["curve"] = line("div", "computing").classes("soft")
        with ui.element("div").classes("pair stack"):
            with ui.element("div").classes("panel"):
                line("h2", "Loads of the balls")
                self._chart("ring", "Loads of the balls around the ring", 330)
                self.lines["ring"] = line("div").classes("soft")
            with ui.element("div").classes("panel"):
                line("h2", "Contact of the heaviest ball")
                for race in ("inner", "outer"):
                    self.lines[race] = line("h3")
                    self._chart(race, f"Contact ellipse on the {race} race, between the shoulders", 150)
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
            return  # the page itself has put it there
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
            self.text = text
            self._take("")

    def own_dimensions(self) -> None:
        """Make the derived dimensions keys of the scene."""
        self.paste(with_dimensions(self.text))

    def _take(self, note: str) -> None:
        """Show the text in its box and its values in the fields, and compute."""
        try:
            self.values = values_in(self.text)
        except InputError as problem:
            self.complain(str(problem), SCENE)
            return
        self.complain("", None)
        self.lines["problem"].text = note
        for key, field in self.fields.items():
            value = self.text if key == SCENE else shown_value(self.values.get(key, ""))
            if isinstance(field, ui.select) and value not in field.options:
                field.set_options({**dict(field.options), value: value})
            field.value = value
        background_tasks.create(self.refresh())

    def complain(self, problem: str, key: str | None) -> None:
        """Show a problem above and beside its field, or beside the scene; an empty one takes the last away."""
        place = key if key in self.fields else SCENE
        for name, field in self.fields.items():
            field.error = problem if problem and name == place else None
        self.lines["problem"].text = problem
        for name in NUMBERS:
            self.lines[name].classes(add="old" if problem else None, remove=None if problem else "old")

    # What is computed.

    async def refresh(self) -> None:
        """Compute and show the scene; changes meanwhile are taken together, and the last one counts."""
        self.is_new = True
        if self.is_busy:
            return
        self.is_busy = True
        try:
            while self.is_new and self.is_open:
                self.is_new = False
                await self._evaluate()
        finally:
            self.is_busy = False

    async def _evaluate(self) -> None:
        from fembearing.app.evaluation import evaluated

        try:
            found = await computed(evaluated, self.text)
            if self.is_current:
                self._show(found)
                await self._follow_speed(found)
        except FembearingError as problem:
            self.complain(str(problem), field_in(str(problem)))
        except Exception as problem:  # the other tabs go on
            words = f"{type(problem).__name__}: {problem}"
            self.complain(f"a defect of fembearing, not of your input: {words}; please report it", SCENE)

    @property
    def is_current(self) -> bool:
        """Whether the scene is unchanged since the computation began, and the page still open."""
        return self.is_open and not self.is_new

    async def _follow_speed(self, found: Any) -> None:
        """Compute the curve in slices, until it is complete or something has changed."""
        from fembearing.app.charts import curve_options
        from fembearing.app.evaluation import curve_scenes, series_record

        await asyncio.sleep(PAUSE)
        records, words = [], ""
        scenes = curve_scenes(found)
        for number, scene in enumerate(scenes, start=1):
            if not self.is_current:
                return
            try:
                records.append(await computed(series_record, scene))
            except FembearingError as problem:  # other speeds have a torque
                words = str(problem)
            if records and self.is_current:
                self._draw("curve", curve_options(records, marked=None if found.is_series else found.row.inner_speed))
                self.lines["curve"].text = words if number == len(scenes) else "computing more speeds"
        if not records:
            self._draw("curve", None)
            self.lines["curve"].text = words or "The bearing is at rest."

    def _show(self, found: Any) -> None:
        """Show a torque with its parts, its balls and its contacts."""
        from fembearing.app.charts import ellipse_options, part_options, ring_options

        self.evaluation, lines = found, found.lines
        for name, text in lines.items():
            self.lines[name].text = text
        self.lines["verdict"].classes(replace=f"verdict {lines['verdict']}")
        self.warned.set_visibility(bool(lines["warnings"]))
        self._draw("parts", part_options(found.row))
        self._draw("ring", ring_options(found.row))
        for race in ("inner", "outer"):
            contact, row = found.contacts.get(race), getattr(found.row.contact, race)
            self._draw(race, None if contact is None else ellipse_options(contact, row))
        self._follow(found)
        self.check.follow(self.text)

    def _draw(self, name: str, options: dict[str, Any] | None) -> None:
        chart = self.charts[name]
        chart.set_visibility(options is not None)
        if options is not None:
            chart.options.clear()
            chart.options.update(options)
            chart.update()

    def _follow(self, found: Any) -> None:
        """Put the sliders to the point that is shown."""
        rating = found.result.scene.bearing.static_load_rating
        for key, slider in self.sliders.items():
            unit, number = FIELDS[key].unit, found.number(key)
            if unit is None or number is None:
                continue
            low, high = ENDS.get(key, (0.0, UNRATED if rating is None else float(f"{HEAVY * rating:.1g}")))
            high = max(high, unit.number(number))
            slider.props(f"min={low:g} max={high:g} step={(high - low) / STEPS:g}")
            slider.value = float(f"{unit.number(number):.5g}")
