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
from typing import Any

from fembearing.report.page.template import filled, source_of


def view_page(numbers: dict[str, Any]) -> str:
    """The page;  numbers : of `fembearing.report.pictures.render_view`"""
    return filled("view.html", scene=numbers, script=script_hash())


@cache
def script_hash() -> str:
    """The source of the only script that a page may run, as policies name it."""
    script = source_of("view.html").rpartition("<script>")[2].partition("</script>")[0]
    return f"'sha256-{base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()}'"
