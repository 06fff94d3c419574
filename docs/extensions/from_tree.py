"""Pages of the reference that are made from the tree before the others are read. They are not kept in git."""

from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

from docs.extensions.api_page import api_page
from docs.extensions.commands_page import commands_page
from docs.extensions.json_page import json_page
from docs.extensions.keys_page import keys_page

PAGES = {"options": commands_page, "keys": keys_page, "json": json_page, "api": api_page}


def setup(app: Sphinx) -> dict[str, Any]:
    app.connect("config-inited", write_pages)  # before Sphinx and autosummary look for pages
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def write_pages(app: Sphinx, _config: object) -> None:
    for name, made in PAGES.items():
        file = Path(app.srcdir) / "reference" / f"{name}.md"
        text = made()
        if not file.exists() or file.read_text("utf-8") != text:  # an unchanged page is not read again
            file.write_text(text, "utf-8")
