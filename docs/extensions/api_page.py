"""The page of the Python API, from what the two packages export."""

import analytic
import fembearing
from docs.extensions.public import exported, public_classes

HEAD = """\
# Python API

Made from the docstrings of what the two packages export, and of the classes that it takes and returns. Numbers are SI.
[From Python](../python.md) shows how the parts go together.
"""
SUMMARY = """\
## {heading}

{about}

```{{eval-rst}}
.. autosummary::
   :toctree: api

{names}
```
"""


def api_page() -> str:
    """The page in Markdown."""
    parts = [
        (f"`{package.__name__}`", first_line(package), [f"{package.__name__}.{name}" for name in package.__all__])
        for package in (analytic, fembearing)
    ]
    known = set(exported())
    others = [f"{each.__module__}.{each.__qualname__}" for each in public_classes() if each not in known]
    parts.append(("What they take and return", "Nobody has to import these to use the packages.", sorted(others)))
    return "\n".join([HEAD, *(section(*part) for part in parts)])


def first_line(package: object) -> str:
    return (package.__doc__ or "").partition("\n")[0]


def section(heading: str, about: str, names: list[str]) -> str:
    listed = "\n".join(f"   {name}" for name in names)
    return SUMMARY.format(heading=heading, about=about, names=listed)
