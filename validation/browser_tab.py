"""A tab of a headless Chromium, driven by the protocol of its developer tools, and the browser that has it."""

import base64
import json
import subprocess
import tempfile
import time
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from websockets.sync.client import ClientConnection, connect

from validation.site_check import HEIGHT, leave

PATIENCE = 300.0  # s: the first torque on a machine compiles formulas
SETTLED = 0.5  # s in which a page takes another size
LOOK = 0.02  # s between two looks at a value
KEYS = {  # name -> (code of the key, text that it types)
    "Tab": (9, ""),
    "Enter": (13, "\r"),
    "Escape": (27, ""),
    "Space": (32, " "),
    "ArrowRight": (39, ""),
    "ArrowLeft": (37, ""),
}
FLAGS = (  # no window, no sandbox (the pages are ours), no question at the first start; WebGL without a graphics card
    *("--headless", "--no-sandbox", "--no-first-run", "--hide-scrollbars", "--disable-dev-shm-usage"),
    "--enable-unsafe-swiftshader",
    *("--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-extensions"),
    "--remote-debugging-port=0",
)
FOCUS = """(() => { const it = document.activeElement, role = it.getAttribute("role") ?? it.tagName.toLowerCase();
  const name = it.getAttribute("aria-label") || it.labels?.[0]?.textContent || it.title || it.textContent;
  return role + ": " + name.trim();
})()"""
BARRIERS = """axe.run(document, { iframes: false, resultTypes: ["violations"] }).then((found) => found.violations
  .filter((each) => ["serious", "critical"].includes(each.impact))
  .flatMap((each) => each.nodes.map((node) => `${each.id}: ${node.html.slice(0, 120)}`)))"""


class Tab:
    """A tab of the browser."""

    def __init__(self, link: ClientConnection, width: int) -> None:
        self.link, self.width, self.number = link, width, 0
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
        """The value of a script, or of its promise."""
        told = self.ask("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        return told["result"].get("value")

    def wait(self, is_so: Callable[[str], bool], script: str, *, most: float = PATIENCE) -> bool:
        """Wait until the value of a script is as wanted; whether it came to that;  most : s"""
        begin = time.monotonic()
        while time.monotonic() - begin < most:
            if is_so(self.value(script) or ""):
                return True
            time.sleep(LOOK)
        return False

    def type(self, label: str, text: str) -> None:
        """Replace what a field has."""
        self.value(
            f"(() => {{ const it = document.querySelector('[aria-label=\"{label}\"]'); it.focus(); it.select(); }})()"
        )
        self.ask("Input.insertText", text=text)

    def press(self, key: str, **more: Any) -> None:
        """Press and release a key; more : parameters of the protocol, as commands=["selectAll"]"""
        code, text = KEYS[key]
        named = {"key": " " if key == "Space" else key, "code": key, "windowsVirtualKeyCode": code}
        kind = {"type": "keyDown", "text": text} if text else {"type": "rawKeyDown"}
        self.ask("Input.dispatchKeyEvent", **kind, **named, **more)
        self.ask("Input.dispatchKeyEvent", type="keyUp", **named)

    def tab_to(self, wanted: str, *, most: int = 60) -> list[str]:
        """Press Tab until the focus has this role and name; what had it on the way, without `wanted` if never."""
        seen: list[str] = []
        while len(seen) < most and wanted not in seen:
            self.press("Tab")
            seen.append(self.value(FOCUS))
        return seen

    def barriers(self, axe: str) -> list[str]:
        """Serious and critical faults of accessibility;  axe : script of axe-core"""
        self.value(axe)
        return self.value(BARRIERS)

    def shoot(self, target: Path) -> None:
        """Write a picture of the whole page."""
        target.parent.mkdir(parents=True, exist_ok=True)
        whole = self.value("document.documentElement.scrollHeight")
        self.view(height=whole)
        time.sleep(SETTLED)
        target.write_bytes(base64.b64decode(self.ask("Page.captureScreenshot")["data"]))
        self.view(height=HEIGHT)

    def view(self, *, height: int) -> None:
        """Make the window as high, pixels; charts follow its size only where it stays while a picture is taken."""
        size = {"width": self.width, "height": height}
        self.ask("Emulation.setDeviceMetricsOverride", **size, deviceScaleFactor=1, mobile=False)


class Browser:
    """A running browser."""

    def __init__(self, profile: Path) -> None:
        self.profile = profile

    @contextmanager
    def tab(self, address: str, *, width: int, mode: str) -> Iterator[Tab]:
        """The page in a new tab;  width : pixels;  mode : light or dark"""
        new = urllib.request.Request(f"http://127.0.0.1:{self._port()}/json/new?about:blank", method="PUT")
        with urllib.request.urlopen(new, timeout=PATIENCE) as told:
            link = json.load(told)["webSocketDebuggerUrl"]
        with connect(link, max_size=None) as socket_of_tab:
            tab = Tab(socket_of_tab, width)
            for part in ("Runtime.enable", "Log.enable", "Page.enable"):
                tab.ask(part)
            tab.view(height=HEIGHT)
            tab.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": mode}])
            folder = str(self.profile / "downloads")
            tab.ask("Browser.setDownloadBehavior", behavior="allow", downloadPath=folder)
            tab.ask("Page.navigate", url=address)
            yield tab
            tab.ask("Page.close")

    def _port(self) -> str:
        """Of the developer tools."""
        begin, file = time.monotonic(), self.profile / "DevToolsActivePort"
        while not (file.exists() and (lines := file.read_text().split())):
            if time.monotonic() - begin > PATIENCE:
                leave("the browser did not start", 1)
            time.sleep(LOOK)
        return lines[0]


@contextmanager
def started(program: str) -> Iterator[Browser]:
    """The browser with a profile of its own, which ends with it."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        command = [program, *FLAGS, f"--user-data-dir={profile}", "about:blank"]
        shown = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            yield Browser(Path(profile))
        finally:
            shown.terminate()
            shown.wait(PATIENCE)
