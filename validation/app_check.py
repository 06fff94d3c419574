"""Check of `fembearing app` in a real browser: python validation/app_check.py [--shots FOLDER]

Starts the page and opens it in a headless Chromium or Chrome from PATH at the widths of a desktop and of a telephone,
light and dark. Checks that a torque comes, that it follows a field, that a refused input has its reason beside its
field, that nothing makes the page wider than the window, that every input has a name for those who hear a page, that
the console shows no fault, and that nothing is fetched from elsewhere. Exit status: 0 all checks pass, 1 a check fails,
2 no browser.
"""

import argparse
import base64
import json
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from rich.console import Console
from websockets.sync.client import ClientConnection, connect

from validation.report_check import BROWSERS, HEIGHT, WIDTHS, leave

PATIENCE = 300.0  # s: the first torque on a machine compiles formulas
TORQUE = "document.querySelector('.big span')?.textContent ?? ''"
NAMELESS = """[...document.querySelectorAll("input, textarea, [role=slider], button, [role=img], iframe")]
  .filter((each) => !each.closest("[hidden]") && each.type !== "hidden" && !each.getAttribute("aria-label")
    && !each.labels?.length && !each.title && !each.textContent.trim() && !each.closest("label"))
  .map((each) => each.outerHTML.slice(0, 100))"""
STRANGE = """performance.getEntriesByType("resource").map((entry) => entry.name)
  .filter((name) => !name.startsWith(location.origin) && !name.startsWith("data:") && !name.startsWith("blob:"))"""


class Tab:
    """A tab of the browser, by the protocol of its developer tools."""

    def __init__(self, link: ClientConnection) -> None:
        self.link, self.number = link, 0
        self.complaints: list[str] = []  # of the console

    def ask(self, method: str, **parameters: Any) -> dict[str, Any]:
        """The answer to a command; events on the way are looked at."""
        self.number += 1
        self.link.send(json.dumps({"id": self.number, "method": method, "params": parameters}))
        while True:
            told = json.loads(self.link.recv(PATIENCE))
            if told.get("id") == self.number:
                return told.get("result", {})
            if told.get("method") == "Runtime.exceptionThrown":
                self.complaints.append(str(told["params"]["exceptionDetails"].get("text")))
            entry = told.get("params", {}).get("entry", {})
            if told.get("method") == "Log.entryAdded" and entry.get("level") == "error":
                self.complaints.append(entry["text"])

    def value(self, script: str) -> Any:
        """What a script gives."""
        return self.ask("Runtime.evaluate", expression=script, returnByValue=True)["result"].get("value")

    def wait(self, is_so: Callable[[str], bool], script: str) -> bool:
        """Wait until the value of a script is as wanted; whether it came to that."""
        begin = time.monotonic()
        while time.monotonic() - begin < PATIENCE:
            if is_so(self.value(script) or ""):
                return True
            time.sleep(0.2)
        return False

    def type(self, label: str, text: str) -> None:
        """Replace what a field has, by keys."""
        self.value(
            f"(() => {{ const it = document.querySelector('[aria-label=\"{label}\"]'); it.focus(); it.select(); }})()"
        )
        self.ask("Input.insertText", text=text)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--shots", type=Path, help="folder for screenshots")
    shots = parser.parse_args().shots
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None:
        leave(f"no browser on PATH: looked for {', '.join(BROWSERS)}", 2)
    with socket.socket() as tried:
        tried.bind(("127.0.0.1", 0))
        port = tried.getsockname()[1]
    command = [sys.executable, "-m", "fembearing", "app", "--no-browser", "--port", str(port)]
    faults: list[str] = []
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        driven = [browser, "--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--remote-debugging-port=0"]
        server = subprocess.Popen(command, stdout=subprocess.DEVNULL)
        shown = subprocess.Popen([*driven, f"--user-data-dir={profile}", "about:blank"], stderr=subprocess.DEVNULL)
        try:
            for width in WIDTHS:
                for mode in ("light", "dark"):
                    with opened(Path(profile), port, width, mode) as tab:
                        faults += [f"{width} pixels, {mode}: {fault}" for fault in look(tab, width)]
                        if shots is not None:
                            shots.mkdir(parents=True, exist_ok=True)
                            taken = tab.ask("Page.captureScreenshot", captureBeyondViewport=True)["data"]
                            (shots / f"app-{width}-{mode}.png").write_bytes(base64.b64decode(taken))
        finally:
            for process in (shown, server):
                process.terminate()
                process.wait(PATIENCE)
    out = Console(highlight=False, markup=False, soft_wrap=True)
    for fault in faults:
        out.print(fault)
    out.print("all checks pass" if not faults else f"{len(faults)} faults")
    sys.exit(1 if faults else 0)


@contextmanager
def opened(profile: Path, port: int, width: int, mode: str) -> Iterator[Tab]:
    """The page in a new tab of this width and mode."""
    begin, address = time.monotonic(), f"http://127.0.0.1:{port}/"
    while time.monotonic() - begin < PATIENCE:
        try:
            tools = (profile / "DevToolsActivePort").read_text().split()[0]
            urllib.request.urlopen(address, timeout=PATIENCE).close()
            break
        except OSError:
            time.sleep(0.2)
    else:
        leave("page or browser did not start", 1)
    new = urllib.request.Request(f"http://127.0.0.1:{tools}/json/new?about:blank", method="PUT")
    with urllib.request.urlopen(new, timeout=PATIENCE) as told:
        link = json.load(told)["webSocketDebuggerUrl"]
    with connect(link, max_size=None) as socket_of_tab:
        tab = Tab(socket_of_tab)
        for part in ("Runtime.enable", "Log.enable", "Page.enable"):
            tab.ask(part)
        tab.ask("Emulation.setDeviceMetricsOverride", width=width, height=HEIGHT, deviceScaleFactor=1, mobile=False)
        tab.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": mode}])
        tab.ask("Page.navigate", url=address)
        yield tab
        tab.ask("Page.close")


def look(tab: Tab, width: int) -> list[str]:
    """What is wrong with the page, in words."""
    if not tab.wait(lambda text: text[:1].isdigit(), TORQUE):
        return ["no torque comes"]
    first, faults = tab.value(TORQUE), []
    tab.type("Radial load", "2.5 kN")
    if not tab.wait(lambda text: text not in ("", first), TORQUE):
        faults.append("the torque does not follow the radial load")
    tab.type("Speed of the inner ring", "900 kg")
    beside = (
        "document.querySelector('.q-field--error [role=alert], .q-field--error .q-field__messages')?.textContent ?? ''"
    )
    if not tab.wait(lambda text: "operation.inner_speed = '900 kg'" in text, beside):
        faults.append("a refused speed has no reason beside its field")
    if (wide := tab.value("document.documentElement.scrollWidth")) > width:
        faults.append(f"the page is {wide} pixels wide")
    faults += [f"has no name: {part}" for part in tab.value(NAMELESS)]
    faults += [f"fetches {name}" for name in tab.value(STRANGE)]
    return faults + [f"the console says {text}" for text in tab.complaints]


if __name__ == "__main__":
    main()
