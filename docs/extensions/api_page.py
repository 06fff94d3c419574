"""The page of the Python API, from what the packages export."""

import analytic
import fembearing

HEAD = """\
# Python API

Made from the docstrings of what the two packages export. Numbers are SI. [From Python](../python.md) shows how the
parts go together.
"""
SUMMARY = """\
## `{package}`

{about}

```{{eval-rst}}
.. currentmodule:: {package}

.. autosummary::
   :toctree: api

{names}
```
"""


def api_page() -> str:
    """The page in Markdown."""
    return "\n".join([HEAD, *map(summary, (analytic, fembearing))])


def summary(package: object) -> str:
    names = "\n".join(f"   {name}" for name in package.__all__)  # type: ignore[attr-defined]
    about = (package.__doc__ or "").partition("\n")[0]
    return SUMMARY.format(package=package.__name__, about=about, names=names)  # type: ignore[attr-defined]
