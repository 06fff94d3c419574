"""Check of the built documentation in a real browser: python validation/site_check.py build/docs [--shots FOLDER]

Opens every page in a headless Chromium or Chrome from PATH at the widths of a desktop and of a telephone, and checks
that the console shows no message, that nothing makes the page wider than the window, that every picture is loaded and
has a text in its place, and that no page names an address outside as anything but a link. --shots keeps screenshots of
the pages that a section begins with. Exit status: 0 all checks pass, 1 a check fails, 2 no browser or no page.
"""

import argparse
import json
import re
import shutil
import sys
import tempfile
from html import unescape
from pathlib import Path
from typing import Any

from rich.console import Console

from validation.report_check import BROWSERS, COMPLAINT, HEIGHT, WIDTHS, leave, run_browser

# The outer page opens one page after the other in a frame. Each page ends with the probe, which sends what it sees.
FRAME = """<!DOCTYPE html><body style="margin: 0">
<iframe style="border: 0; width: {width}px; height: {height}px"></iframe>
<script>
const pages = {pages}, seen = [], frame = document.querySelector("iframe");
const next = () => {{ frame.src = pages[seen.length]; }};
addEventListener("message", (event) => {{
  seen.push(JSON.parse(event.data));
  if (seen.length < pages.length) return next();
  const note = document.createElement("pre");
  note.id = "probe";
  note.textContent = JSON.stringify(seen);
  document.body.append(note);
}});
next();
</script></body>"""
PROBE = """<script>
addEventListener("load", () => {
  const root = document.documentElement;
  parent.postMessage(JSON.stringify({
    page: document.title,
    width: root.clientWidth,
    scroll: root.scrollWidth,
    broken: [...document.images].filter((image) => !image.naturalWidth).map((image) => image.src),
    silent: [...document.images].filter((image) => !image.alt.trim()).map((image) => image.src),
    fetched: performance.getEntriesByType("resource").map((entry) => entry.name).filter((name) => /^http/.test(name)),
  }), "*");
});
</script>"""
REMARK = re.compile(r'"(?:\[PST\]|Got invalid theme mode: \.)')  # of the theme, on its own state
FETCHED = re.compile(r"""<(?:script|img|link|iframe|source)\b[^>]*(?:src|href)=["']((?:https?:)?//[^"']+)""")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("site", type=Path, metavar="FOLDER")
    parser.add_argument("--shots", type=Path, help="folder for screenshots")
    options = parser.parse_args()
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None:
        leave(f"no browser on PATH: looked for {', '.join(BROWSERS)}", 2)
    pages = [page.relative_to(options.site) for page in written_pages(options.site, "*.html")]
    if not pages:
        leave(f"{options.site} has no page; build it first", 2)
    out, faults = Console(highlight=False, markup=False, soft_wrap=True), []
    with tempfile.TemporaryDirectory() as folder:
        site = Path(folder) / "site"
        shutil.copytree(options.site, site)
        for page in pages:
            text = (site / page).read_text("utf-8")
            faults += [f"{page}: would fetch {address}" for address in FETCHED.findall(text)]
            (site / page).write_text(text.replace("</body>", f"{PROBE}</body>"), "utf-8")
        for width in WIDTHS:
            found = list(look(browser, site, pages, width))
            faults += found
            out.print(f"{width} pixels: {len(pages)} pages, {len(found)} faults")
        if options.shots is not None:
            shoot(browser, options.site, options.shots)
    for fault in faults:
        out.print(fault)
    out.print("all checks pass" if not faults else f"{len(faults)} faults")
    sys.exit(1 if faults else 0)


def written_pages(site: Path, pattern: str) -> list[Path]:
    """The pages of a site, without those that the theme keeps for itself."""
    return sorted(page for page in site.rglob(pattern) if "_static" not in page.parts)


def look(browser: str, site: Path, pages: list[Path], width: int) -> list[str]:
    """Open all pages in a frame of this width; gives what is wrong with them."""
    frame = site / "frame.html"
    names = json.dumps([page.as_posix() for page in pages])
    frame.write_text(FRAME.format(width=width, height=HEIGHT, pages=names), "utf-8")
    patience = f"--virtual-time-budget={2000 * len(pages)}"  # ms, of which idle ones cost nothing
    window = f"--window-size={max(WIDTHS)},{HEIGHT}"
    done = run_browser(browser, str(site), patience, window, "--dump-dom", frame.as_uri())
    note = re.search(r'<pre id="probe">(.*?)</pre>', done.stdout, re.DOTALL)
    if note is None:
        leave(f"the pages did not load at {width} pixels: {done.stderr.strip()[-300:]}", 1)
    seen = json.loads(unescape(note[1]))
    faults = [fault for page, result in zip(pages, seen, strict=True) for fault in faults_of(page, result, width)]
    said = (text for text in COMPLAINT.findall(done.stderr) if not REMARK.match(text))
    return faults + [f"at {width} pixels: the console says {text}" for text in said]


def faults_of(page: Path, result: dict[str, Any], width: int) -> list[str]:
    """What is wrong with a page, in words."""
    at = f"{page} at {width} pixels"
    faults = [f"{at}: the page is {result['scroll']} pixels wide"] if result["scroll"] > result["width"] else []
    faults += [f"{at}: the picture {name} is not loaded" for name in result["broken"]]
    faults += [f"{at}: the picture {name} has no text" for name in result["silent"]]
    return faults + [f"{at}: fetches {name}" for name in result["fetched"]]


def shoot(browser: str, site: Path, folder: Path) -> None:
    """Write a screenshot of the first page of each section at each width."""
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as profile:
        for page in written_pages(site, "index.html"):
            name = page.parent.name if page.parent != site else "home"
            for width in WIDTHS:
                target = f"--screenshot={(folder / f'{name}-{width}.png').absolute()}"
                run_browser(browser, profile, f"--window-size={width},{HEIGHT}", target, page.absolute().as_uri())


if __name__ == "__main__":
    main()
