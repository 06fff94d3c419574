"""Commands where something is missing: memory, room, permission, a home, a locale, a stream, or a file that ends.

Each combination of a situation and a command must end with a result, or in one line with the status that says what was
missing; and what it was to write is whole or absent.
"""

import os
import resource
import shutil
import tempfile
from collections.abc import Callable, Generator, Iterator
from dataclasses import dataclass, replace
from functools import partial
from itertools import product
from pathlib import Path
from typing import NamedTuple

from analytic.writing import HIDDEN
from validation.stress.commands import FOLDER, FREE, Limits, fault_of, run
from validation.stress.damage import INPUTS

UNPRIVILEGED = ("setpriv", "--bounding-set", "-dac_override,-dac_read_search")  # permissions hold for root too
SLOWEST = 30.0  # s of the processor: where compiled formulas cannot be kept, they are compiled
COMMANDS = {
    "torque": ("torque", "scene.toml"),
    "torque --json": ("torque", "scene.toml", "--json"),
    "torque --out": ("torque", "scene.toml", "--out", "out"),
    "sweep": ("sweep", "grid.toml", "--out", "out", "--workers", "1"),
    "init": ("init", "6206", "--out", "out.toml"),
}
WRITING = ("torque --out", "sweep", "init")
READING = {"scene.toml": "torque", "grid.toml": "sweep", "map.csv": "torque"}
ENVIRONMENTS: dict[str, dict[str, str | None]] = {
    "no home": {"HOME": None, "XDG_CACHE_HOME": None},
    "a home that is not there": {"HOME": "/nowhere", "XDG_CACHE_HOME": None},
    "no temporary folder": {"TMPDIR": "/nowhere"},
    "the C locale": {"LC_ALL": "C", "LANG": None, "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"},
}
MOUNTED = "mkdir full && mount -t tmpfs -o size=60M none full && cp *.toml full && cd full"
FILLED = 'head -c "$(($(df --output=avail -B1 . | tail -n 1) - left))" /dev/zero >filling'


@dataclass(frozen=True)
class Situation:
    """What a command finds."""

    name: str
    limits: Limits = FREE
    statuses: tuple[int, ...] = (0, 1, 3)  # that may come of it, beside those of a result
    commands: tuple[str, ...] = tuple(COMMANDS)
    prepare: Callable[[Path], object] = lambda _: None
    needs_root: bool = False


class Ended(NamedTuple):
    """How a command ended in a situation."""

    situation: str
    command: str
    outcome: str  # its status, or why it was not run
    fault: str  # "" where there is none


def shell(words: str) -> Limits:
    """Started by a shell; words : a command line in which $0 and $@ are the command."""
    return Limits(before=("sh", "-c", words))


def situations() -> Iterator[Situation]:
    for size in (150, 300, 450, 600, 800):
        of_addresses = Limits(sizes={resource.RLIMIT_AS: size * 10**6})
        yield Situation(f"{size} MB of addresses", of_addresses, (0, 1, 3, 71, 127, 1))
    for size in (0, 1000, 20_000):
        yield Situation(f"files of {size} bytes at most", Limits(sizes={resource.RLIMIT_FSIZE: size}), (0, 1, 3, 74))
    for size in (0, 8_000, 100_000):
        full = ("unshare", "-m", "sh", "-c", f'{MOUNTED} && left={size} && {FILLED} && exec "$0" "$@"')
        yield Situation(f"{size} bytes left on the disk", Limits(before=full), (0, 1, 3, 74), WRITING, needs_root=True)
    yield Situation("output on a full device", shell('"$0" "$@" >/dev/full'), (74,))
    yield Situation("complaints on a full device", shell('"$0" "$@" 2>/dev/full'))
    piped = shell('{ "$0" "$@"; echo $? >status; } | true; exit $(cat status)')
    yield Situation("a reader that goes away", piped, (0, 1, 3, 141))
    bound = UNPRIVILEGED if os.getuid() == 0 else ()
    yield Situation(
        "a folder that is not ours", Limits(before=bound), (2, 74), WRITING, lambda place: place.chmod(0o555)
    )
    for name, environment in ENVIRONMENTS.items():
        yield Situation(name, Limits(environment=environment))
    for number, stream in enumerate(("input", "output", "error")):
        yield Situation(f"standard {stream} closed", Limits(closed=(number,)), (74,) if number == 1 else (0, 1, 3))
    yield Situation("all streams closed", Limits(closed=(0, 1, 2)), (74,))
    yield Situation("a working folder that is gone", shell('mkdir gone; cd gone; rmdir ../gone; "$0" "$@"'), (2, 74))
    for (file, command), (kind, prepare) in product(READING.items(), ODD_FILES.items()):
        yield Situation(f"{file}: {kind}", FREE, (2,), (command,), partial(odd, file=file, prepare=prepare))


def torn(path: Path) -> str:
    """What is left of an output that is not whole; a whole one may be there whose announcement failed."""
    if not path.exists() or (path / "sweep.json").exists():  # a sweep grows
        return ""
    if path.is_dir():
        lacking = FOLDER - {each.name for each in path.iterdir()}
        return f"{path.name} lacks {', '.join(lacking)}" if lacking else ""
    return "" if "#rolling" in path.read_text("utf-8")[-500:] else f"half of {path.name}"


def odd(place: Path, file: str, prepare: Callable[[Path], object]) -> None:
    """Put something odd in the place of a file."""
    path = place / file
    path.unlink(missing_ok=True)
    prepare(path)
    if file == "map.csv":
        table = '[surface]\nheight_map = { path = "map.csv", spacing = "2 um" }\n[lubricant]\nname = "ISO VG 46"\n'
        scene = (INPUTS / "scene.toml").read_text("utf-8").replace("coefficient = 0.09\n", "")
        (place / "scene.toml").write_text(scene + table, "utf-8")


ODD_FILES: dict[str, Callable[[Path], object]] = {
    "missing": lambda _: None,
    "a folder": lambda path: path.mkdir(),
    "a pipe that nobody writes": lambda path: os.mkfifo(path),
    "a device that never ends": lambda path: path.symlink_to("/dev/zero"),
    "a link to itself": lambda path: path.symlink_to(path.name),
    "3 GB of nothing": lambda path: (path.touch(), os.truncate(path, 3 * 10**9)),
    "empty": lambda path: path.write_bytes(b""),
}


def ended(*, every: int = 1) -> Generator[Ended]:
    """Every command in every situation; every : take only every so many of them."""
    number = 0
    for situation in situations():
        for command in situation.commands:
            number += 1
            if number % every:
                continue
            if situation.needs_root and os.getuid() != 0:
                yield Ended(situation.name, command, "not run: needs to mount a disk", "")
                continue
            with tempfile.TemporaryDirectory() as folder:
                place = Path(folder) / "place"
                place.mkdir()
                Path(folder).chmod(0o755)
                for name in ("scene.toml", "grid.toml"):
                    shutil.copy(INPUTS / name, place)
                yield _ended(situation, command, place)


def _ended(situation: Situation, command: str, place: Path) -> Ended:
    situation.prepare(place)
    done = run(COMMANDS[command], place, situation.limits)
    if 2 in situation.limits.closed:
        done = replace(done, err="fembearing: what nobody can read\n")
    fault = fault_of(done, allowed=situation.statuses, slowest=SLOWEST)
    if not fault and done.status not in (0, 1, 3):
        fault = torn(place / "out") or torn(place / "out.toml")
    hidden = [path.name for path in place.rglob(f"{HIDDEN}*")]
    if not fault and hidden:
        fault = f"{', '.join(hidden)} is left"
    return Ended(situation.name, command, f"status {done.status}", fault)
