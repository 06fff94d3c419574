"""The machine code of formulas for a wheel: numba compiles it here, so that nobody else has to."""

import sys
import sysconfig
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class MachineCode(BuildHookInterface[Any]):
    """Object files of all entries for this kind of machine. An editable install has none: it compiles what changes."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        if version == "editable":
            return
        sys.path.insert(0, self.root)
        from analytic.numerics.machine_code import ENTRIES, OBJECTS, build_process, families

        made = Path(self.directory) / "objects"
        made.mkdir(parents=True, exist_ok=True)
        # The first entry takes as long as all others.
        runs = [build_process(names, families(), made) for names in (ENTRIES[:1], ENTRIES[1:])]
        statuses = [run.wait() for run in runs]
        if any(statuses):
            raise RuntimeError("formulas did not compile: see above")
        for file in made.glob("*.code"):
            build_data["force_include"][str(file)] = (OBJECTS / file.name).relative_to(self.root).as_posix()
        build_data["pure_python"] = False
        build_data["tag"] = f"py3-none-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"
