"""The pages: what they run prints what they say, sources are cited by keys that exist, links lead somewhere."""

import re
import tomllib
from pathlib import Path

import pytest

from analytic.catalog.bearing_rows import bearing_names
from analytic.effects import TABLE
from analytic.scenefile.keys import scene_table
from analytic.scenefile.read import load_scene
from tests.executed_pages import BLOCK, Output, differences, run_in

ROOT = Path(__file__).resolve().parents[1]
MADE = {ROOT / "docs/reference" / f"{name}.md" for name in ("api", "json", "keys", "options")}  # from the tree
WRITTEN = sorted(page for page in (ROOT / "docs").rglob("*.md") if page not in MADE and "gallery" not in page.parts)
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *WRITTEN]
EXECUTED = [page for page in PAGES if BLOCK.search(page.read_text("utf-8"))]
# 5 s of a processor and more, for commands that other tests run
LONG = {
    "cage.md",
    "compare-with-measurements.md",
    "contact.md",
    "friction.md",
    "map.md",
    "report.md",
}
TEXTS = [
    *(page for page in PAGES if page.name != "references.md"),
    *(p for top in ("analytic", "fembearing", "tests", "validation") for p in sorted((ROOT / top).rglob("*.*"))),
]
KEYS = set(re.findall(r"^- \*\*\[(\w+)\]\*\* ", (ROOT / "docs/references.md").read_text("utf-8"), re.MULTILINE))
DATED_KEY = re.compile(r"(?<![\w\])])\[([A-Z][A-Za-z]{2,}\d{2,5}[a-z]?)\]")


LINES = [
    (f"{path.relative_to(ROOT).as_posix()}:{number}", line)
    for path in TEXTS
    if path.suffix in (".py", ".md", ".toml", ".csv", ".html") and path.name != Path(__file__).name
    for number, line in enumerate(path.read_text("utf-8").splitlines(), start=1)
]


def test_every_cited_source_stands_in_the_references() -> None:
    cited = [(place, key) for place, line in LINES for key in DATED_KEY.findall(line)]
    assert cited
    assert [f"{place}: [{key}]" for place, key in cited if key not in KEYS] == []


def anchors(page: Path) -> set[str]:
    """Of a page's headings, as GitHub makes them."""
    headings = re.findall(r"^#+ (.+)$", page.read_text("utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-") for heading in headings}


def test_every_link_leads_somewhere() -> None:
    links = [
        (page, target, anchor)
        for page in PAGES
        for target, anchor in re.findall(r"\]\(([^)#\s]*)#?([\w-]*)\)", page.read_text("utf-8"))
        if not target.startswith("http")
    ]
    assert len(links) > 40
    for page, target, anchor in links:
        place = page.parent / target if target else page
        assert place.exists(), f"{page.name}: {target}"
        assert not anchor or anchor in anchors(place), f"{page.name}: {target}#{anchor}"


def test_every_number_of_readme_is_run_or_stands_on_a_page() -> None:
    """Those of the pages have the command that measures them beside them."""
    readme = (ROOT / "README.md").read_text("utf-8")
    prose = re.sub(r"```.*?```", "", readme, flags=re.DOTALL)
    prose = re.sub(r"\]\([^)]*\)", "]", prose)
    pages = "\n".join(page.read_text("utf-8") for page in WRITTEN)
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    known = set(re.findall(r"\d+(?:\.\d+)?", pages + project["requires-python"]))
    stated = set(re.findall(r"\d+(?:\.\d+)?", prose))
    assert len(stated) > 20
    assert sorted(stated - known) == []
    assert f"[{len(bearing_names())} bearings]" in prose


def test_the_page_of_effects_lists_those_of_the_code() -> None:
    """By name, in order, each with what it needs."""
    page = (ROOT / "docs/effects.md").read_text("utf-8").split("## The effects\n\n", 1)[1].split("\n\n", 1)[0]
    items = [" ".join(item.split()) for item in re.split(r"^- ", page, flags=re.MULTILINE)[1:]]
    assert [re.findall(r"`(\w+)`", item)[0] for item in items] == [entry.name for entry in TABLE]
    for entry, item in zip(TABLE, items, strict=True):
        assert entry.needs is None or entry.needs.keys in item, entry.name


def has_long_block(page: Path) -> bool:
    return any(block["long"] for block in BLOCK.finditer(page.read_text("utf-8")))


@pytest.mark.parametrize("page", [pytest.param(page, id=page.stem) for page in EXECUTED if page.name not in LONG])
@pytest.mark.slow
def test_a_page_prints_what_it_says(page: Path, tmp_path: Path) -> None:
    """Up to its first long block."""
    found = run_in(tmp_path, page, whole=False)
    assert found or "<!-- output -->" not in re.split(r", long\b.* -->", page.read_text("utf-8"))[0]
    assert wrong(found) == {}, "python -m tests.executed_pages PAGE"


@pytest.mark.parametrize(
    "page", [pytest.param(page, id=page.stem) for page in EXECUTED if page.name in LONG or has_long_block(page)]
)
@pytest.mark.nightly
def test_a_long_page_prints_what_it_says(page: Path, tmp_path: Path) -> None:
    assert wrong(run_in(tmp_path, page)) == {}, "python -m tests.executed_pages PAGE"


def wrong(found: list[Output]) -> dict[int, list[str]]:
    """The lines that were not printed, by the places of their outputs."""
    return {output.place[0]: lines for output in found if (lines := differences(output))}


def test_every_scene_in_the_pages_is_read(tmp_path: Path) -> None:
    blocks = [text for page in PAGES for text in re.findall(r"```toml\n(.*?)```", page.read_text("utf-8"), re.DOTALL)]
    scenes = [block for block in blocks if "[bearing]" in block]
    assert len(scenes) > 1
    for number, scene in enumerate(scenes):
        (tmp_path / f"{number}.toml").write_text(scene, "utf-8")
        assert load_scene(tmp_path / f"{number}.toml").name.startswith("my ")


def test_every_key_of_a_scene_file_is_explained() -> None:
    """By its meaning, which the page of keys has, or on the page of scenes."""
    page, table = (ROOT / "docs/scenes.md").read_text("utf-8"), scene_table()
    paths = [path for path in table.paths() if not path.startswith(("assumed.", "uncertainty."))]
    named = [path for path in paths if not getattr(table.find(path), "meaning", "")]
    assert [path for path in named if not re.search(rf"\b{path.rpartition('.')[2]}\b", page)] == []
