"""A key such as [Johnson1985] on any page leads to its entry on the page of references."""

import re
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx.util.nodes import make_refnode

PAGE = "references"
KEY = re.compile(r"\[(\w+)\]")
WHERE_NOT = (nodes.literal, nodes.literal_block, nodes.reference, nodes.title, nodes.strong)


def setup(app: Sphinx) -> dict[str, Any]:
    app.connect("doctree-read", name_entries)
    app.add_post_transform(LinkKeys)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def name_entries(app: Sphinx, doctree: nodes.document) -> None:
    """Give each entry of the references its key as a target."""
    if app.env.docname == PAGE:
        for entry in doctree.findall(nodes.strong):
            found = KEY.fullmatch(entry.astext())
            if found:
                entry["ids"].append(found[1].lower())


class LinkKeys(SphinxPostTransform):
    """Make links of the keys in running text."""

    default_priority = 700

    def run(self, **_: Any) -> None:
        known = {entry["ids"][0] for entry in self.env.get_doctree(PAGE).findall(nodes.strong) if entry["ids"]}
        for text in list(self.document.findall(nodes.Text)):
            if not any(isinstance(above, WHERE_NOT) for above in ancestors(text)):
                parts = list(self.linked(text.astext(), known))
                if len(parts) > 1:
                    text.parent.replace(text, parts)

    def linked(self, text: str, known: set[str]) -> Any:
        """The pieces of a text, its known keys as links."""
        end = 0
        for found in KEY.finditer(text):
            if found[1].lower() in known:
                yield nodes.Text(text[end : found.start()])
                builder = self.app.builder
                yield make_refnode(builder, self.env.docname, PAGE, found[1].lower(), nodes.Text(found[0]))
                end = found.end()
        yield nodes.Text(text[end:])


def ancestors(node: nodes.Node) -> Any:
    while node.parent is not None:
        node = node.parent
        yield node
