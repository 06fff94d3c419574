"""The machine code of formulas for a wheel: numba compiles it here, so that nobody else has to."""

import platform
import sys
import sysconfig
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class MachineCode(BuildHookInterface[Any]):
    """Object files of all entries for this kind of machine. An editable install has none: it compiles what changes."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        if version == "editable":
            return
        sys.path.insert(0, self.root)
        from analytic.numerics.machine_code import ENTRIES, OBJECTS, build_process, families

        self.scratch = TemporaryDirectory()
        made = Path(self.scratch.name)
        # The first entry takes as long as all others.
        runs = [build_process(names, families(), made) for names in (ENTRIES[:1], ENTRIES[1:])]
        statuses = [run.wait() for run in runs]
        if any(statuses):
            raise RuntimeError("formulas did not compile: see above")
        for file in made.glob("*.code"):
            build_data["force_include"][str(file)] = (OBJECTS / file.name).relative_to(self.root).as_posix()
        build_data["pure_python"] = False
        # The code is that of one machine, though a Python for Macs may be for both kinds.
        system = sysconfig.get_platform().replace("universal2", platform.machine())
        build_data["tag"] = f"py3-none-{system.replace('-', '_').replace('.', '_')}"

    def finalize(self, version: str, build_data: dict[str, Any], artifact_path: str) -> None:  # noqa: ARG002
        if version != "editable":
            self.scratch.cleanup()
