"""Check of `fembearing app` in a real browser: python validation/app_check.py [--short] [--axe FILE] [--shots FOLDER]

Starts the page and opens it in a headless Chromium or Chrome from PATH, as wide as a desktop and a telephone, light and
dark. It reads /proc, as Linux has it. Checks:

- a torque comes, it follows a field, and a refused input has its reason beside its field;
- nothing is wider than the window, every input has a name, the console shows no fault, nothing comes from elsewhere;
- with the keys alone: a bearing is chosen, a slider moved, the scene checked, and the ZIP file saved with its report;
- two tabs do not mix, and a closed tab ends its check;
- time of a change, and memory of the server over 200 changes.

--axe takes axe.min.js of the package axe-core: serious and critical faults of accessibility fail. --short has two of
the four looks and the keyboard with the check of a dry scene, without two tabs, time and memory. Exit status: 0 all
checks pass, 1 a check fails, 2 no browser or no script.
"""

import argparse
import re
import socket
import statistics
import subprocess
import sys
import time
import urllib.request
import zipfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from rich.console import Console

from validation.browser_tab import LOOK, PATIENCE, Browser, Tab, started
from validation.site_check import WIDTHS, finish, found_browser, leave, read_script

TORQUE = "document.querySelector('.big span')?.textContent ?? ''"
TITLE = "document.querySelector('h1')?.textContent ?? ''"
BESIDE = "document.querySelector('.q-field--error [role=alert], .q-field--error .q-field__messages')?.textContent ?? ''"
COMPUTING = "document.querySelector('.old') || document.body.innerText.includes('computing') ? 'computing' : ''"
STATUS = "document.querySelector('.check [role=status]')?.textContent ?? ''"
REPORT = "[...document.querySelectorAll('a')].find((each) => each.textContent === 'The whole report')?.href ?? ''"
SCENE = "document.querySelector('textarea')?.value ?? ''"
UNFOLD = "document.querySelectorAll('details').forEach((each) => { each.open = true; })"
CHECK = """[...document.querySelectorAll("button")].find((each) => each.textContent.includes("Check this scene"))
  .click()"""
SHOWN = """[...document.querySelectorAll('.pictures img')].every((each) => each.complete && each.naturalWidth)
  && document.querySelector('.pictures iframe') && document.querySelectorAll('.check tbody tr').length > 3"""
NAMELESS = """[...document.querySelectorAll("input, textarea, [role=slider], button, [role=img], iframe")]
  .filter((each) => each.offsetParent && each.type !== "hidden" && !each.getAttribute("aria-label") && !each.title
    && !each.labels?.length && !each.textContent.trim() && !each.closest("label"))
  .map((each) => each.outerHTML.slice(0, 100))"""
STRANGE = """performance.getEntriesByType("resource").map((entry) => entry.name)
  .filter((name) => !name.startsWith(location.origin) && !name.startsWith("data:") && !name.startsWith("blob:"))"""
SLIDER = "input: Radial load, slider"
DRY = """name = "6204 without oil"
tolerance = "20 %"
[bearing]
catalog = "6204"
[operation]
axial_load = "300 N"
inner_speed = "900 rpm"
[friction]
coefficient = 0.1
"""
IS_NUMBER = re.compile(r"\d").match  # of a torque that is shown
MOST_START, MOST_CHANGE, MOST_MEMORY = 2.0, 0.3, 300.0  # s, s and MB; 110 MB are files of compiled libraries
WARM, CHANGES, MOST_GROWTH = 40, 200, 8.0  # changes before and between two measurements, and MB of growth
TIMED = 21  # changes of the slider, whose median counts
ENDS = 60.0  # s after which a closed tab has no process: the server waits 30 s for a tab to come back


class Server(NamedTuple):
    """The running program."""

    address: str
    number: int  # of its process
    start: float  # s until it gave the first page

    @property
    def memory(self) -> float:
        """Resident, MB."""
        lines = Path(f"/proc/{self.number}/status").read_text().splitlines()
        return next(float(line.split()[1]) for line in lines if line.startswith("VmRSS")) / 1e3

    @property
    def checks(self) -> set[int]:
        """Processes of checks that it has started, and that still run."""
        children = Path(f"/proc/{self.number}/task/{self.number}/children").read_text().split()
        found = set()
        for each in children:
            with suppress(OSError):  # it has just ended
                if b"spawn_main" in Path(f"/proc/{each}/cmdline").read_bytes():
                    found.add(int(each))
        return found


@dataclass(frozen=True)
class Check:
    """What the checks share."""

    browser: Browser
    server: Server
    axe: str  # script of axe-core; empty: none
    shots: Path | None
    short: bool

    def shoot(self, tab: Tab, name: str) -> None:
        """Keep a picture, if any are kept."""
        if self.shots is not None:
            tab.shoot(self.shots / f"app-{name}.png")

    def barriers(self, tab: Tab) -> list[str]:
        """What axe-core sees, if it is there."""
        return [f"axe-core: {words}" for words in tab.barriers(self.axe)] if self.axe else []


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--short", action="store_true", help="what the gate has time for")
    parser.add_argument("--axe", type=Path, help="axe.min.js of axe-core")
    parser.add_argument("--shots", type=Path, help="folder for screenshots")
    options = parser.parse_args()
    program, axe = found_browser(), read_script(options.axe)
    out, faults = Console(highlight=False, markup=False, soft_wrap=True), []
    with started(program) as browser, served() as server:
        check = Check(browser, server, axe, options.shots, options.short)
        parts = () if options.short else (measured, two_tabs)  # the memory before drawings and reports
        for is_right, words in (each for part in (*parts, keys_alone) for each in part(check)):
            out.print(f"{'' if is_right else 'FAILED: '}{words}")
            faults += [] if is_right else [words]
        looks = [(width, mode) for width in WIDTHS for mode in ("light", "dark")]
        for width, mode in (looks[0], looks[-1]) if options.short else looks:
            found = list(look(check, width, mode))
            faults += [f"{width} pixels, {mode}: {fault}" for fault in found]
            out.print(f"{width} pixels, {mode}: {len(found)} faults")
        out.print(f"at the end the server has {server.memory:.0f} MB")
    finish(out, faults)


@contextmanager
def served() -> Iterator[Server]:
    """The program at a free port."""
    with socket.socket() as tried:
        tried.bind(("127.0.0.1", 0))
        port = tried.getsockname()[1]
    begin, address = time.monotonic(), f"http://127.0.0.1:{port}/"
    command = [sys.executable, "-m", "fembearing", "app", "--no-browser", "--port", str(port)]
    server = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    try:
        while time.monotonic() - begin < PATIENCE and server.poll() is None:
            try:
                urllib.request.urlopen(address, timeout=PATIENCE).close()
            except OSError:
                time.sleep(LOOK)
            else:
                yield Server(address, server.pid, time.monotonic() - begin)
                return
        leave("the page did not start", 1)
    finally:
        server.terminate()
        server.wait(PATIENCE)


def look(check: Check, width: int, mode: str) -> Iterator[str]:
    """What is wrong with the page at one width and in one mode, in words."""
    with check.browser.tab(check.server.address, width=width, mode=mode) as tab:
        if not tab.wait(IS_NUMBER, TORQUE):
            yield "no torque comes"
            return
        first = tab.value(TORQUE)
        tab.type("Radial load", "2.5 kN")
        if not tab.wait(lambda text: text not in ("", first), TORQUE):
            yield "the torque does not follow the radial load"
        tab.type("Speed of the inner ring", "900 kg")
        if not tab.wait(lambda text: "operation.inner_speed = '900 kg'" in text, BESIDE):
            yield "a refused speed has no reason beside its field"
        check.shoot(tab, f"{width}-{mode}-refused")
        tab.type("Speed of the inner ring", "900 rpm")
        tab.wait(lambda text: not text, BESIDE)
        tab.value(UNFOLD)
        if not tab.wait(bool, "document.querySelector('.drawing img')?.naturalWidth ?? ''"):
            yield "the bearing is not drawn"
        tab.wait(lambda text: not text, COMPUTING, most=60)
        if beyond := tab.value("document.documentElement.scrollWidth - document.documentElement.clientWidth"):
            yield f"the page is {beyond} pixels wider than its window"
        yield from (f"has no name: {part}" for part in tab.value(NAMELESS))
        yield from (f"fetches {name}" for name in tab.value(STRANGE))
        yield from check.barriers(tab)
        check.shoot(tab, f"{width}-{mode}")
        yield from (f"the console says {text}" for text in tab.complaints)


def keys_alone(check: Check) -> Iterator[tuple[bool, str]]:
    """Choose a bearing, move a slider, check and save with the keyboard alone; whether each works, in words."""
    with check.browser.tab(check.server.address, width=WIDTHS[0], mode="light") as tab:
        tab.wait(IS_NUMBER, TORQUE)
        yield tab.tab_to("input: Bearing")[-1] == "input: Bearing", "the keyboard reaches the bearing"
        tab.press("Tab")  # and back, so that the field is selected as a user finds it
        tab.press("Tab", modifiers=8)
        tab.ask("Input.insertText", text="6308")
        yield tab.wait(lambda text: text.startswith("6308"), TITLE, most=30), "a bearing is chosen"
        first = tab.value(TORQUE)
        yield tab.tab_to(SLIDER)[-1] == SLIDER, "the keyboard reaches a slider"
        for _ in range(20):
            tab.press("ArrowRight")
        yield (
            tab.wait(lambda text: bool(IS_NUMBER(text)) and text != first, TORQUE, most=30),
            "a slider changes the torque",
        )
        if check.short:
            tab.tab_to("summary: Scene (TOML), to copy, paste and edit")
            tab.press("Enter")
            tab.tab_to("textarea: Scene")
            tab.press("Space", commands=["selectAll"])
            tab.ask("Input.insertText", text=DRY)
            yield tab.wait(lambda text: "without oil" in text or text.startswith("6204"), TITLE), "a scene is pasted"
        tab.wait(lambda text: not text, COMPUTING, most=60)
        yield tab.tab_to("button: Check this scene")[-1].startswith("button"), "the keyboard reaches the check"
        begin = time.monotonic()
        tab.press("Enter")
        is_checked = tab.wait(bool, REPORT)
        yield is_checked, f"the check is done after {time.monotonic() - begin:.0f} s: {tab.value(STATUS)}"
        yield tab.wait(bool, f"({SHOWN}) ? 'yes' : ''", most=30), "pictures, turning view and table are shown"
        faults = check.barriers(tab)
        yield not faults, f"axe-core with a report: {'; '.join(faults) or 'no serious fault'}"
        check.shoot(tab, "checked")
        tab.tab_to("button: Download all", most=90)
        tab.press("Enter")
        begin, folder = time.monotonic(), check.browser.profile / "downloads"
        while not (saved := [*folder.glob("*.zip")]) and time.monotonic() - begin < ENDS:
            time.sleep(LOOK)
        names = set(zipfile.ZipFile(saved[0]).namelist()) if saved else set()
        wanted = {"scene.toml", "torque.csv", "report/report.html", "report/report.json"}
        yield wanted <= names, f"the download has {len(names)} files with scene, CSV and report"


def two_tabs(check: Check) -> Iterator[tuple[bool, str]]:
    """Two tabs with scenes of their own, one of which is closed during its check."""
    address, here = check.server.address, {"width": WIDTHS[0], "mode": "light"}

    def waited(is_over: Callable[[], object]) -> float:
        """Seconds until it is, or that it may take."""
        begin = time.monotonic()
        while not is_over() and time.monotonic() - begin < ENDS:
            time.sleep(LOOK)
        return time.monotonic() - begin

    with check.browser.tab(address, **here) as first:
        with check.browser.tab(address, **here) as second:
            for tab in (first, second):
                tab.wait(IS_NUMBER, TORQUE)
            first.type("Bearing", "6010")
            second.type("Speed of the inner ring", "1730 rpm")
            named = first.wait(lambda text: "6010" in text, TITLE), second.wait(lambda text: "1730 rpm" in text, TITLE)
            mixed = "1730" in first.value(TITLE) or "6010" in second.value(TITLE)
            yield all(named) and not mixed, "two tabs do not mix"
            second.value(CHECK)
            waited(lambda: check.server.checks)
            running = bool(check.server.checks)
            second.wait(lambda text: bool(text) and "waits" not in text, STATUS, most=ENDS)
        seconds = waited(lambda: not check.server.checks)
        yield running and not check.server.checks, f"a closed tab ends its check after {seconds:.1f} s"
        first.type("Bearing", "6011")
        yield first.wait(lambda text: "6011" in text, TITLE, most=30), "the other tab continues"


def measured(check: Check) -> Iterator[tuple[bool, str]]:
    """Time to the first page, time of a change, and memory over many changes."""
    server = check.server
    yield server.start <= MOST_START, f"first page {server.start:.1f} s after the start, at most {MOST_START:g} s"
    with check.browser.tab(server.address, width=WIDTHS[0], mode="light") as tab:
        tab.wait(IS_NUMBER, TORQUE)
        tab.tab_to(SLIDER)
        times = [changed(tab, number) for number in range(TIMED)]
        median = statistics.median(times)
        of_times = f"(median of {TIMED}, longest {max(times):.2f} s), at most {MOST_CHANGE:g} s"
        yield median <= MOST_CHANGE, f"a change takes {median:.2f} s {of_times}"
        for number in range(WARM):
            changed(tab, number)
        before = server.memory
        for number in range(CHANGES):
            changed(tab, number)
        after = server.memory
        words = f"{CHANGES} changes: {before:.0f} MB before, {after:.0f} MB after, at most {MOST_GROWTH:g} MB more"
        yield after - before <= MOST_GROWTH, words
        yield after <= MOST_MEMORY, f"the server has {after:.0f} MB, at most {MOST_MEMORY:g} MB"


def changed(tab: Tab, number: int) -> float:
    """Seconds from a key on the slider until the torque has changed; 50 steps up, 50 down and so on."""
    first, begin = tab.value(TORQUE), time.monotonic()
    tab.press("ArrowRight" if number % 100 < 50 else "ArrowLeft")
    if not tab.wait(lambda text: text != first, TORQUE, most=ENDS):
        leave("a key on the slider changes no torque", 1)
    return time.monotonic() - begin


if __name__ == "__main__":
    main()
