"""The pages: sources are cited by keys that exist, links lead somewhere, README stays short."""

import re
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
TEXTS = [
    *(page for page in PAGES if page.name != "references.md"),
    *(p for top in ("analytic", "fembearing", "tests", "validation") for p in sorted((ROOT / top).rglob("*.*"))),
]
KEYS = set(re.findall(r"^- \*\*\[(\w+)\]\*\* ", (ROOT / "docs/references.md").read_text("utf-8"), re.MULTILINE))
DATED_KEY = re.compile(r"(?<![\w\])])\[([A-Z][A-Za-z]{2,}\d{2,5}[a-z]?)\]")


def lines() -> Iterator[tuple[str, str]]:
    for path in TEXTS:
        if path.suffix in (".py", ".md", ".toml", ".csv", ".html") and path.name != Path(__file__).name:
            for number, line in enumerate(path.read_text("utf-8").splitlines(), start=1):
                yield f"{path.relative_to(ROOT)}:{number}", line


def test_every_cited_source_stands_in_the_references() -> None:
    cited = [(place, key) for place, line in lines() for key in DATED_KEY.findall(line)]
    assert cited
    assert [f"{place}: [{key}]" for place, key in cited if key not in KEYS] == []


def test_every_reference_is_cited() -> None:
    text = "\n".join(line for _, line in lines())
    listed = (ROOT / "docs/references.md").read_text("utf-8")
    assert len(KEYS) > 40
    assert [key for key in sorted(KEYS) if f"[{key}]" not in text and listed.count(f"[{key}]") < 2] == []


def test_code_cites_by_key() -> None:
    """Authors, years and "not seen" stand in the references alone."""
    old_form = re.compile(r"\((?:18|19|20)\d\d\)|\bnot seen\b|neither seen")
    code = [(place, line) for place, line in lines() if place.startswith(("analytic", "fembearing"))]
    assert [f"{place}: {line.strip()}" for place, line in code if ".py:" in place and old_form.search(line)] == []


def test_every_link_leads_to_a_file() -> None:
    links = [
        (page, target)
        for page in PAGES
        for target in re.findall(r"\]\(([^)#\s]+)(?:#[\w-]+)?\)", page.read_text("utf-8"))
        if not target.startswith("http")
    ]
    assert links
    assert [f"{page.name}: {target}" for page, target in links if not (page.parent / target).exists()] == []


def test_readme_is_short_and_leads_to_every_page() -> None:
    readme = (ROOT / "README.md").read_text("utf-8")
    assert len(readme.splitlines()) <= 150
    assert "[bearing]" in "\n".join(readme.splitlines()[:60])  # a scene of one's own
    assert [page.name for page in PAGES[2:] if f"(docs/{page.name})" not in readme] == []
