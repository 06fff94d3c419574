"""Modules of this installation in processes of their own.

They import from where this process does, and nothing from the working folder: a file there may bear the name of any
module, and would run.
"""

import os
import sys
from pathlib import Path

MODULE = (sys.executable, "-P", "-m")  # begins the command of a module


def environment() -> dict[str, str]:
    """Of such a process."""
    return {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, (str(Path(__file__).parents[1]), *sys.path)))}
