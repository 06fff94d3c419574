"""A contact to turn in the browser: one page with our script and the numbers of a mesh, which fetches nothing.

The page, templates/view.html, draws the loaded faces of both bodies by WebGL. Its vertices are the nodes of the finest
mesh, not deformed, so that no value in it is interpolated.
It has its own script because the exports that exist are five times as heavy or more, and the one of VTK asks a host for
icons when it is opened. The browser runs no other script: the policies of this page, and of the report that holds it,
name the script by its hash.
"""

import base64
import hashlib
from functools import cache

from fembearing.report.document.view import View, read_view
from fembearing.report.page.template import filled, source_of

BEGIN, END = '<script id="scene" type="application/json">', "</script>"


def view_page(view: View) -> str:
    """The page."""
    return filled("view.html", scene=view.model_dump(), script=script_hash())


@cache
def script_hash() -> str:
    """The source of the only script that a page may run, as policies name it."""
    script = source_of("view.html").rpartition("<script>")[2].partition(END)[0]
    return f"'sha256-{base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()}'"


def remade(page: bytes) -> str | None:
    """The page again from the numbers in it, whoever wrote it; None where it holds no view."""
    numbers = page.decode("utf-8", "replace").partition(BEGIN)[2].partition(END)[0]
    view = read_view(numbers)
    return None if view is None else view_page(view)
