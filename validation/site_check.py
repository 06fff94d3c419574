"""Check of pages in a real browser: python validation/site_check.py PAGES [--shots FOLDER] [--axe FILE]

PAGES is a report, as report.html, or the folder of the built documentation. Opens every page in a headless Chromium or
Chrome from PATH at the widths of a desktop and of a telephone, and checks that the console shows no message, that
nothing makes the page wider than the window, that every picture is loaded and has a text in its place, and that nothing
comes from elsewhere. Of a report also that no part reaches beyond the window, that no table scrolls on a desktop, and
that it names no address outside itself. --axe takes axe.min.js of the package axe-core: serious and critical faults of
accessibility fail. --shots keeps screenshots of a report with its printed pages (A4), or of the pages that a section
begins with. Exit status: 0 all checks pass, 1 a check fails, 2 no browser, no page or no script.
"""

import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
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
# The outer page opens one page after the other in a frame, which may be narrower than the least window of the browser.
# Each page ends with the probe, which sends what it sees; the outer page writes all where --dump-dom shows it.
FRAME, PROBE = (Path(__file__).with_name(name).read_text("utf-8") for name in ("site_frame.html", "site_probe.js"))
ADDRESS = re.compile(
    r"""(?:src|href|action|data|poster)\s*=\s*["'](?!data:|#)([^"']+)|url\(\s*["']?(?!data:|#)([^)"']+)"""
)
FETCHED = re.compile(r"""<(?:script|img|link|iframe|source)\b[^>]*(?:src|href)=["']((?:https?:)?//[^"']+)""")
# Console messages, except those of a graphics driver on its performance, and of the theme on its own state
COMPLAINT = re.compile(r"CONSOLE[^\]]*\]\s*(?!.*GL Driver Message \(OpenGL, Performance)(.*)")
REMARK = re.compile(r'"(?:\[PST\]|Got invalid theme mode: \.)')


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pages", type=Path, metavar="PAGES")
    parser.add_argument("--shots", type=Path, help="folder for screenshots")
    parser.add_argument("--axe", type=Path, help="axe.min.js of axe-core")
    options = parser.parse_args()
    browser, given, is_report = found_browser(), options.pages, not options.pages.is_dir()
    pages = [Path(given.name)] if is_report else [page.relative_to(given) for page in written_pages(given, "*.html")]
    if not pages:
        leave(f"{given} has no page; build it first", 2)
    script = f"<script>{read_script(options.axe)}</script><script>{PROBE}</script></body>"
    out, faults = Console(highlight=False, markup=False, soft_wrap=True), []
    with tempfile.TemporaryDirectory() as folder:
        site = Path(folder) / "site"
        try:
            if is_report:
                site.mkdir()
                shutil.copy(given, site)
            else:
                shutil.copytree(given, site)
            texts = {page.as_posix(): (site / page).read_text("utf-8") for page in pages}
        except (OSError, UnicodeDecodeError) as problem:
            leave(f"cannot be read: {problem}", 2)
        for page, text in texts.items():
            faults += [f"{page}: {words}" for words in addresses(text, is_report=is_report)]
            (site / page).write_text(text.replace("</body>", script), "utf-8")
        for width in WIDTHS:
            found = list(look(browser, site, list(texts), width, is_report=is_report))
            faults += found
            out.print(f"{width} pixels: {len(texts)} pages, {len(found)} faults")
    if options.shots is not None:
        shoot(browser, given, options.shots)
    finish(out, faults)


def found_browser() -> str:
    """The first of BROWSERS on PATH."""
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    return browser or leave(f"no browser on PATH: looked for {', '.join(BROWSERS)}", 2)


def read_script(path: Path | None) -> str:
    """The script of axe-core; nothing without a file."""
    try:
        return "" if path is None else path.read_text("utf-8")
    except OSError as problem:
        leave(f"cannot be read: {problem}", 2)


def addresses(text: str, *, is_report: bool) -> Iterator[str]:
    """Addresses outside that a page would fetch; those of a report that an element, a style or a link names."""
    if is_report:
        yield from (f"names the address {each}" for each in sorted({a or b for a, b in ADDRESS.findall(text)}))
    else:
        yield from (f"would fetch {each}" for each in FETCHED.findall(text))


def finish(out: Console, faults: list[str]) -> NoReturn:
    """Print the faults, and end."""
    for fault in faults:
        out.print(fault)
    out.print("all checks pass" if not faults else f"{len(faults)} faults")
    sys.exit(1 if faults else 0)


def written_pages(site: Path, pattern: str) -> list[Path]:
    """The pages of a site, without those that the theme keeps for itself."""
    return sorted(page for page in site.rglob(pattern) if "_static" not in page.parts)


def look(browser: str, site: Path, pages: list[str], width: int, *, is_report: bool) -> Iterator[str]:
    """Open all pages in a frame of this width; gives what is wrong with them."""
    frame = site / "frame.html"
    sized = FRAME.replace("WIDTH", str(width)).replace("HEIGHT", str(HEIGHT))
    frame.write_text(sized.replace("PAGES", json.dumps(pages)), "utf-8")
    patience = f"--virtual-time-budget={max(5000, 2000 * len(pages))}"  # ms, of which idle ones cost nothing
    window = f"--window-size={max(WIDTHS)},{HEIGHT}"
    done = run_browser(browser, str(site), patience, window, "--dump-dom", frame.as_uri())
    note = re.search(r'<pre id="probe">(.*?)</pre>', done.stdout, re.DOTALL)
    if note is None:
        leave(f"the pages did not load at {width} pixels within {PATIENCE} s: {done.stderr.strip()[-300:]}", 1)
    for page, result in zip(pages, json.loads(unescape(note[1])), strict=True):
        yield from (f"{page} at {width} pixels: {words}" for words in faults_of(result, width, is_report=is_report))
    for text in COMPLAINT.findall(done.stderr):
        if not REMARK.match(text):
            yield f"at {width} pixels: the console says {text}"


def faults_of(result: dict[str, Any], width: int, *, is_report: bool) -> Iterator[str]:
    """What is wrong with a page, in words. A report's tables may scroll in their own frame, but only on a telephone."""
    if result["scroll"] > result["width"]:
        yield f"the page is {result['scroll']} pixels wide"
    yield from (f"the picture {name} is not loaded" for name in result["broken"])
    yield from (f"the picture {name} has no text" for name in result["silent"])
    yield from (f"fetches {name}" for name in result["fetched"] if is_report or name.startswith("http"))
    yield from (f"axe-core: {words}" for words in result["barriers"])
    if is_report:
        if result["width"] != width:
            yield f"the window is {result['width']} pixels wide, so the width cannot be checked"
        yield from (f"reaches beyond the window: {part}" for part in result["beyond"])
        yield from (f"a table scrolls: {part}" for part in result["scrolling"] if width == WIDTHS[0])


def shoot(browser: str, pages: Path, folder: Path) -> None:
    """Write screenshots at each width: of a report with its printed pages, or of the first page of each section."""
    folder.mkdir(parents=True, exist_ok=True)
    firsts = {"home" if page.parent == pages else page.parent.name: page for page in written_pages(pages, "index.html")}
    with tempfile.TemporaryDirectory() as profile:
        for name, page in (firsts or {pages.stem: pages}).items():
            for width in WIDTHS:
                target = f"--screenshot={(folder / f'{name}-{width}.png').absolute()}"
                size = f"--window-size={width},{HEIGHT if firsts else 12000}"
                run_browser(browser, profile, size, target, page.absolute().as_uri())
        if not firsts:
            target = f"--print-to-pdf={(folder / 'printed.pdf').absolute()}"
            run_browser(browser, profile, "--no-pdf-header-footer", target, pages.absolute().as_uri())


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
