"""Links of a page to files of the tree: to their page where they have one, plain words where they are folders."""

import re
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

PAGES = {
    "../CHANGELOG.md": "changelog.md",
    "../CONTRIBUTING.md": "contributing.md",
    **{f"../validation/reports/{name}.md": f"reports/{name}.md" for name in ("catalogue", "measured", "paper")},
}
LINK = re.compile(r"(?<!!)\[(?P<words>[^]]+)\]\((?P<target>\.\./[^)#]+)\)")


def setup(app: Sphinx) -> dict[str, Any]:
    app.connect("source-read", to_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def to_pages(app: Sphinx, page: str, source: list[str]) -> None:
    """Rewrite the source of a page in place."""
    for file, target in PAGES.items():
        source[0] = source[0].replace(f"({file}", f"({target}")
    folder = (Path(app.srcdir) / page).parent

    def words_of_folder(found: re.Match[str]) -> str:
        return found["words"] if (folder / found["target"]).is_dir() else found[0]

    source[0] = LINK.sub(words_of_folder, source[0])
