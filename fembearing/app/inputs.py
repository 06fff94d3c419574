"""The inputs of the page: fields and sliders by the keys of the scene, and its text."""

from collections.abc import Callable, Mapping, Sequence
from html import escape
from typing import Any, Protocol

from nicegui import ui

from analytic.catalog.bearing_rows import bearing_names
from analytic.words import Unit
from fembearing.app.scene_edit import CATALOG, FIELDS, FOLDS, OPERATION, shown_value

SCENE = "scene"  # the box with the text, among the fields
DEBOUNCE = 200  # ms without a key stroke, after which a field counts
ENDS = {"operation.inner_speed": (0.0, 10_000.0), "lubricant.temperature": (-20.0, 140.0)}  # of sliders, rpm and degC
HEAVY, UNRATED = 0.5, 10_000.0  # end of the sliders of loads: share of C0, and N where C0 is not known
STEPS = 200  # of a slider
ELSEWHERE = "Keys without a field go into this text."


class Changed(Protocol):
    """What takes the changes of a user."""

    text: str  # of the scene
    values: dict[str, Any]  # by keys, as the text has them

    def type(self, key: str, typed: str) -> None:
        """Take what a user types into a field."""

    def slide(self, key: str, number: float) -> None:
        """Take what a user sets a slider to."""

    def paste(self, text: str) -> None:
        """Take a whole scene."""


def line(tag: str, text: str = "") -> ui.label:
    """A text that changes, in an element of HTML."""
    label = ui.label(text)
    label.tag = tag
    return label


def folded(words: str) -> ui.element:
    """A panel that opens by its head."""
    panel = ui.element("details").classes("panel")
    with panel, ui.element("summary"):
        line("h2", words)
    return panel


class Slider(ui.element):
    """The browser's own slider, which has its name, its value and the focus in one element."""

    def __init__(self, label: str, moved: Callable[[float], None]) -> None:
        super().__init__("input")
        self.value = 0.0
        self.props(f'type=range aria-label="{label}, slider"')
        self.on("input", self._take, throttle=0.1, js_handler="(event) => emit(event.target.value)")
        self._moved = moved

    def put(self, value: float, unit: Unit, *, low: float, high: float) -> None:
        """Show a value between two ends."""
        self.value = value
        step = (high - low) / STEPS
        words = f"{value:.5g} {unit.name}"
        self.props(f'min={low:g} max={high:g} step={step:g} value={value:g} aria-valuetext="{words}" title="{words}"')

    def _take(self, event: Any) -> None:
        self._moved(float(event.args))


class Inputs:
    """Fields, sliders and the text of a scene."""

    def __init__(self, page: Changed) -> None:
        self.page = page
        self.fields: dict[str, Any] = {}
        self.sliders: dict[str, Slider] = {}
        self.folds: dict[str, ui.element] = {}  # panel by the key of a field in it
        with ui.element("div").classes("panel stack"):
            line("h2", "Bearing and operation")
            self._input(CATALOG, "Bearing", bearing_names())
            self.fields[CATALOG].props["placeholder"] = "6206, 7208B, 6305-2RS/C3"
            for key in OPERATION:
                self._field(key)
        for words, keys in FOLDS.items():
            panel = folded(words)
            with panel:
                self.fill(panel, keys)
        self._scene()

    def fill(self, panel: ui.element, keys: Sequence[str]) -> None:
        """Make the fields of these keys; panel : that they open when one of them is refused"""
        with ui.element("div").classes("stack"):
            for key in keys:
                self._field(key)
                self.folds[key] = panel

    def show(self) -> None:
        """Put the scene of the page into the fields."""
        text, values = self.page.text, self.page.values
        for key, field in self.fields.items():
            value = text if key == SCENE else shown_value(values.get(key, ""))
            if isinstance(field, ui.select) and value not in field.options:
                field.set_options({**dict(field.options), value: value})
            field.value = value

    def derive(self, derived: Mapping[str, str]) -> None:
        """Show in each empty field what the torque that is shown was computed with;  derived : by the keys"""
        for key, words in derived.items():
            field = self.fields[key]
            if not isinstance(field, ui.select):
                field.props["placeholder"] = words
                continue
            words = "derived" if key in self.page.values else words.replace("_", " ")
            options = dict(field.options)
            if options[""] != words:
                field.set_options({**options, "": words})

    def complain(self, problem: str, key: str | None) -> None:
        """Show a problem beside its field, or beside the scene; an empty one takes the last away."""
        place = key if key in self.fields else SCENE
        for name, field in self.fields.items():
            field.error = problem if problem and name == place else None
        if problem and place in self.folds:
            self.folds[place].props("open")

    def slide_to(self, shown: Mapping[str, float | None], rating: float | None) -> None:
        """Put the sliders to the values that are shown, SI; rating : C0, N"""
        for key, slider in self.sliders.items():
            unit, number = FIELDS[key].unit, shown[key]
            slider.set_visibility(number is not None)
            if unit is None or number is None:
                continue
            low, high = ENDS.get(key, (0.0, UNRATED if rating is None else float(f"{HEAVY * rating:.1g}")))
            low, high = min(low, unit.number(number)), max(high, unit.number(number))
            slider.put(float(f"{unit.number(number):.5g}"), unit, low=low, high=high)

    def _field(self, key: str) -> None:
        field = FIELDS[key]
        with ui.element("div").classes("field"):
            if field.is_choice:
                self._choice(key)
            else:
                self._input(key, field.label, field.words)
            self.fields[key].props["title"] = field.meaning
            if field.unit is not None:
                self.sliders[key] = Slider(field.label, lambda number: self.page.slide(key, number))

    def _input(self, key: str, label: str, words: Sequence[str]) -> None:
        """A field of text;  words : that it offers while one types"""
        name = key.replace(".", "-")
        if words:
            options = "".join(f'<option value="{escape(word)}">' for word in words)
            ui.html(options, sanitize=False, tag="datalist").props(f"id={name}")
        made = ui.input(
            label,
            value=shown_value(self.page.values.get(key, "")),
            on_change=lambda event: self.page.type(key, event.value or ""),
        )
        listed = f"list={name}" if words else ""
        made.props(f"dense outlined stack-label debounce={DEBOUNCE} autocomplete=off {listed}")
        self.fields[key] = made.without_auto_validation()

    def _choice(self, key: str) -> None:
        field = FIELDS[key]
        made = ui.select(
            {"": "", **{word: word.replace("_", " ") for word in field.words}},
            label=field.label,
            value=shown_value(self.page.values.get(key, "")),
            on_change=lambda event: self.page.type(key, event.value or ""),
        )
        self.fields[key] = made.props("dense outlined options-dense stack-label").without_auto_validation()

    def _scene(self) -> None:
        page = self.page
        with folded("Scene (TOML), to copy, paste and edit").classes("scene"), ui.element("div").classes("stack"):
            box = ui.textarea("Scene", value=page.text, on_change=lambda event: page.paste(event.value or ""))
            self.fields[SCENE] = box.without_auto_validation().props(
                f"outlined stack-label rows=22 debounce={DEBOUNCE} spellcheck=false"
            )
            line("p", ELSEWHERE).classes("soft")
