"""Links of a page to files of the tree: to the page of the site, if any; plain words for a folder or other Markdown.

A Markdown page is also read in the tree, where its links lead to the files themselves.
"""

import os
import re
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

PAGES = {  # files of the tree, and the pages that show them
    "README.md": "index.md",
    "examples/README.rst": "gallery/index.rst",
    **{f"validation/{name}/{name}.md": f"{name}.md" for name in ("catalogue", "measured")},
}
EXAMPLE = re.compile(r"examples/(plot_\w+)\.py")
LINK = re.compile(r"(?<!!)\[(?P<words>[^]]+)\]\((?P<file>\.\./[^)#]+)(?P<place>#[^)]*)?\)")


def setup(app: Sphinx) -> dict[str, Any]:
    app.connect("source-read", rewrite)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def rewrite(app: Sphinx, page: str, source: list[str]) -> None:
    """Rewrite the source of a page in place."""
    docs = Path(app.srcdir)
    folder = (docs / page).parent

    def rewritten(found: re.Match[str]) -> str:
        file = Path(os.path.normpath(folder / found["file"]))
        if file.is_dir():
            return found["words"]
        name = Path(os.path.relpath(file, docs.parent)).as_posix()
        shown = PAGES.get(name) or EXAMPLE.sub(r"gallery/\1.rst", name)
        if shown == name:
            return found["words"] if file.suffix == ".md" and not file.is_relative_to(docs) else found[0]
        return f"[{found['words']}]({Path(os.path.relpath(docs / shown, folder)).as_posix()}{found['place'] or ''})"

    source[0] = LINK.sub(rewritten, source[0])
