"""A command in whose writing something happens at one step: python victim.py STEP WHAT STEPS SOLVED COMMAND...

STEP : number of the step at which it happens, from 0; WHAT : "kill", "term" or "full"; STEPS : file to which the name
of each step is added; SOLVED : file with the solved contacts of `validate`, pickled by us a moment before, or "-".
"""

import errno
import os
import pickle
import signal
import sys
from pathlib import Path
from typing import Any

from analytic import writing
from fembearing import cli


def main() -> None:
    number, what, steps, solved, *command = sys.argv[1:]
    count = -1

    def at_step(step: str, path: Path) -> None:
        nonlocal count
        count += 1
        with open(steps, "a", encoding="utf-8") as file:
            file.write(f"{step} {path.name}\n")
        if count != int(number):
            return
        if what == "kill":
            os.kill(os.getpid(), signal.SIGKILL)
        elif what == "term":
            os.kill(os.getpid(), signal.SIGTERM)
        else:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    writing.at_step = at_step
    if solved != "-":
        from fembearing.report import folder

        contacts = pickle.loads(Path(solved).read_bytes())

        def check_scene(*_: Any, **__: Any) -> Any:
            return contacts

        folder.check_scene = check_scene
    sys.argv = ["fembearing", *command]
    cli.main()


if __name__ == "__main__":
    main()
