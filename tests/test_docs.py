"""The pages: sources are cited by keys that exist, links lead somewhere, README stays short."""

import re
from collections.abc import Iterator
from pathlib import Path

from pydantic import BaseModel

from analytic.scenefile.read import load_scene
from analytic.scenefile.tables import EffectsTable, SceneTable

ROOT = Path(__file__).resolve().parents[1]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
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


def test_every_reference_is_cited() -> None:
    text = "\n".join(line for _, line in LINES)
    listed = (ROOT / "docs/references.md").read_text("utf-8")
    assert len(KEYS) > 40
    assert [key for key in sorted(KEYS) if f"[{key}]" not in text and listed.count(f"[{key}]") < 2] == []


def test_code_cites_by_key() -> None:
    """Authors, years and "not seen" stand in the references alone."""
    old_form = re.compile(r"\((?:18|19|20)\d\d\)|(?<!has )not seen|neither seen")
    code = [(place, line) for place, line in LINES if place.startswith(("analytic", "fembearing"))]
    code = [(place, line) for place, line in code if "sensitivity.py" not in place]  # its texts are for readers
    assert [f"{place}: {line.strip()}" for place, line in code if ".py:" in place and old_form.search(line)] == []


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


def test_readme_is_short_and_leads_to_every_page() -> None:
    readme = (ROOT / "README.md").read_text("utf-8")
    assert len(readme.splitlines()) <= 150
    assert "[bearing]" in "\n".join(readme.splitlines()[:60])  # a scene of one's own
    assert [page.name for page in PAGES[2:] if f"(docs/{page.name})" not in readme] == []


def test_every_scene_in_the_pages_is_read(tmp_path: Path) -> None:
    blocks = [text for page in PAGES for text in re.findall(r"```toml\n(.*?)```", page.read_text("utf-8"), re.DOTALL)]
    scenes = [block for block in blocks if "[bearing]" in block]
    assert len(scenes) > 1
    for number, scene in enumerate(scenes):
        (tmp_path / f"{number}.toml").write_text(scene, "utf-8")
        assert load_scene(tmp_path / f"{number}.toml").name == "my 6205"


def keys_of(table: type[BaseModel]) -> Iterator[str]:
    for key, field in table.model_fields.items():
        yield key
        for part in (field.annotation, *getattr(field.annotation, "__args__", ())):
            if isinstance(part, type) and issubclass(part, BaseModel):
                yield from keys_of(part)


def test_every_key_of_a_scene_file_is_explained() -> None:
    page = (ROOT / "docs/scenes.md").read_text("utf-8")
    keys = set(keys_of(SceneTable))
    assert keys > set(EffectsTable.model_fields)
    assert [key for key in sorted(keys) if not re.search(rf"\b{key}\b", page)] == []
