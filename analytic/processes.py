"""Modules of this installation in processes of their own, away from files of others in the working folder.

They import from where this process does: a file there may bear the name of any module, and would run.
"""

import os
import runpy
import sys
from contextlib import chdir, suppress
from pathlib import Path

MODULE = (sys.executable, "-P", "-m", "analytic.processes")  # begins the command of a module


def environment() -> dict[str, str]:
    """Of such a process."""
    return {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, (str(Path(__file__).parents[1]), *sys.path)))}


def ignore_settings() -> None:
    """Load matplotlib if the working folder has settings for it, which can have LaTeX run: it reads them once."""
    if os.path.lexists("matplotlibrc"):
        with chdir(Path(__file__).parent), suppress(ImportError):
            import matplotlib  # noqa: F401


if __name__ == "__main__":
    ignore_settings()
    del sys.argv[0]
    runpy.run_module(sys.argv[0], run_name="__main__", alter_sys=True)
