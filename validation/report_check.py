"""Check of a report page in a real browser: python validation/report_check.py REPORT.html [--shots FOLDER] [--axe FILE]

Opens the page in a headless Chromium or Chrome from PATH at the widths of a desktop and of a telephone, and checks that
the console shows no message, that nothing is wider than the window, that every picture is loaded, and that the page
names no address outside itself. --shots keeps screenshots and the printed pages (A4). --axe takes axe.min.js of the
package axe-core, and checks that it sees no serious or critical fault of accessibility. Exit status: 0 all checks pass,
1 a check fails, 2 no browser, no page or no script.
"""

import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from html import unescape
from pathlib import Path
from typing import Any, NoReturn

from rich.console import Console

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
SILENT = (  # no window, no first-run questions, no network traffic of the browser itself
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--hide-scrollbars"),
    *("--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-extensions"),
    "--enable-unsafe-swiftshader",  # 3D views need WebGL, and there may be no graphics card; the page is trusted
    *("--enable-logging=stderr", "--v=0", "--virtual-time-budget=5000"),
)
WIDTHS = (1280, 390)  # pixels: desktop, telephone
HEIGHT = 900
PATIENCE = 120  # s, time limit of one browser run
# The page is in a frame, which may be narrower than the least window of the browser. The probe runs in the page after
# loading and sends its result to the outer page, which writes it where --dump-dom shows it.
FRAME = """<!DOCTYPE html><body style="margin: 0"><script>
addEventListener("message", (event) => {{
  const note = document.createElement("pre");
  note.id = "probe";
  note.textContent = event.data;
  document.body.append(note);
}});
</script><iframe src="page.html" style="border: 0; width: {width}px; height: {height}px"></iframe></body>"""
PROBE = """<script>
addEventListener("load", async () => {
  const wide = document.documentElement.clientWidth;
  const beyond = [...document.querySelectorAll("body *")].filter((part) => {
    const scrolled = part.parentElement.closest(".wide");
    return !scrolled && part.getBoundingClientRect().right > wide + 1;
  });
  const scrolling = [...document.querySelectorAll(".wide")].filter((part) => part.scrollWidth > part.clientWidth + 1);
  const result = {
    width: wide,
    scroll: document.documentElement.scrollWidth,
    beyond: beyond.slice(0, 5).map((part) => part.outerHTML.slice(0, 80)),
    scrolling: scrolling.map((part) => part.textContent.trim().slice(0, 60)),
    images: document.images.length,
    broken: [...document.images].filter((image) => !image.naturalWidth).map((image) => image.alt),
    fetched: performance.getEntriesByType("resource").map((entry) => entry.name).filter((name) => !/^data:/.test(name)),
    barriers: [],
  };
  if (window.axe) {
    const found = (await axe.run(document, { iframes: false })).violations;
    const serious = found.filter((each) => ["serious", "critical"].includes(each.impact));
    result.barriers = serious.map((each) => `${each.help}: ${each.nodes[0].html.slice(0, 80)}`);
  }
  parent.postMessage(JSON.stringify(result), "*");
});
</script>"""
ADDRESS = re.compile(
    r"""(?:src|href|action|data|poster)\s*=\s*["'](?!data:|#)([^"']+)|url\(\s*["']?(?!data:|#)([^)"']+)"""
)
# Console messages, except those of a graphics driver on its performance.
COMPLAINT = re.compile(r"CONSOLE[^\]]*\]\s*(?!.*GL Driver Message \(OpenGL, Performance)(.*)")


@dataclass(frozen=True, kw_only=True)
class Look:
    """The result of the probe at one width."""

    width: int  # pixels
    result: dict[str, Any]
    complaints: tuple[str, ...]

    def faults(self, *, desk: bool) -> list[str]:
        """The failed checks, in words. Tables may scroll in their own frame, but only on a telephone."""
        result, at = self.result, f"at {self.width} pixels"
        faults = [f"{at}: the console says {text}" for text in self.complaints]
        if result["width"] != self.width:
            faults.append(f"{at}: the window is {result['width']} pixels wide, so the width cannot be checked")
        if result["scroll"] > result["width"]:
            faults.append(f"{at}: the page is {result['scroll']} pixels wide")
        faults += [f"{at}: reaches beyond the window: {part}" for part in result["beyond"]]
        faults += [f"{at}: a table scrolls: {part}" for part in result["scrolling"] if desk]
        faults += [f"{at}: the picture {name!r} is not loaded" for name in result["broken"]]
        faults += [f"{at}: fetches {name}" for name in result["fetched"]]
        faults += [f"{at}: axe-core: {words}" for words in result["barriers"]]
        return faults


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", type=Path, metavar="REPORT.html")
    parser.add_argument("--shots", type=Path, help="folder for screenshots and printed pages")
    parser.add_argument("--axe", type=Path, help="axe.min.js of axe-core")
    options = parser.parse_args()
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None:
        leave(f"no browser on PATH: looked for {', '.join(BROWSERS)}", 2)
    try:
        text = options.page.read_text("utf-8")
        axe = "" if options.axe is None else options.axe.read_text("utf-8")
    except (OSError, UnicodeDecodeError) as problem:
        leave(f"cannot be read: {problem}", 2)
    looks = [look(browser, text, width, axe=axe) for width in WIDTHS]
    faults = [fault for one in looks for fault in one.faults(desk=one.width == WIDTHS[0])]
    faults += [f"names the address {address}" for address in addresses(text)]
    if options.shots is not None:
        shoot(browser, options.page, options.shots)
    out = Console(highlight=False, markup=False, soft_wrap=True)
    for one in looks:
        out.print(f"{one.width} pixels: {one.result['images']} pictures, page {one.result['scroll']} pixels wide")
    for fault in faults:
        out.print(fault)
    out.print("all checks pass" if not faults else f"{len(faults)} faults")
    sys.exit(1 if faults else 0)


def look(browser: str, text: str, width: int, *, axe: str) -> Look:
    """Open the page with the probe in a frame of this width; axe : the script of axe-core, or nothing."""
    scripts = f"<script>{axe}</script>{PROBE}</body>" if axe else f"{PROBE}</body>"
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "page.html").write_text(text.replace("</body>", scripts), "utf-8")
        frame = Path(folder) / "frame.html"
        frame.write_text(FRAME.format(width=width, height=HEIGHT), "utf-8")
        done = run_browser(browser, folder, f"--window-size={max(WIDTHS)},{HEIGHT}", "--dump-dom", frame.as_uri())
    note = re.search(r'<pre id="probe">(.*?)</pre>', done.stdout, re.DOTALL)
    if note is None:
        leave(f"the page did not load within {PATIENCE} s: {done.stderr.strip()[-200:]}", 1)
    return Look(width=width, result=json.loads(unescape(note[1])), complaints=tuple(COMPLAINT.findall(done.stderr)))


def addresses(text: str) -> list[str]:
    """Addresses outside the page that an element or a style would fetch or a link names."""
    return sorted({first or second for first, second in ADDRESS.findall(text)})


def shoot(browser: str, page: Path, folder: Path) -> None:
    """Write a screenshot at each width, and the printed pages."""
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as profile:
        for width in WIDTHS:
            target = f"--screenshot={(folder / f'{width}.png').absolute()}"
            run_browser(browser, profile, f"--window-size={width},12000", target, page.absolute().as_uri())
        target = f"--print-to-pdf={(folder / 'printed.pdf').absolute()}"
        run_browser(browser, profile, "--no-pdf-header-footer", target, page.absolute().as_uri())


def run_browser(browser: str, profile: str, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = (browser, *SILENT, f"--user-data-dir={profile}/browser", *arguments)
    try:
        return subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE, check=False)
    except subprocess.TimeoutExpired:
        leave(f"the browser did not finish within {PATIENCE} s", 1)


def leave(words: str, status: int) -> NoReturn:
    Console(stderr=True, highlight=False, markup=False, soft_wrap=True).print(f"{Path(sys.argv[0]).stem}: {words}")
    sys.exit(status)


if __name__ == "__main__":
    main()
