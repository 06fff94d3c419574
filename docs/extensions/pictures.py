"""A text for each small picture of the gallery, which has none by itself."""

import re
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

SMALL = re.compile(r"sphx_glr_(plot_\w+)_thumb\.")


def setup(app: Sphinx) -> dict[str, Any]:
    app.connect("doctree-resolved", describe)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def describe(app: Sphinx, doctree: nodes.document, _page: str) -> None:
    """Give each small picture the title of its example as its text."""
    for picture in doctree.findall(nodes.image):
        found = SMALL.search(picture["uri"])
        if found:
            picture["alt"] = f"Figure of the example: {app.env.titles[f'gallery/{found[1]}'].astext()}"
