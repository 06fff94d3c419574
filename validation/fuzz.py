"""Reading of damaged files: python validation/fuzz.py [--files 10000] [--seed 0]

Changes scene files, height maps and mesh files at random and reads them. Every file must be read, or refused with a
one-line FembearingError. Anything else is a fault: another exception, a warning, more than 10 s or 1 GB, or an attempt
to run a program, to unpickle, to reach the network or to write. For a scene that is read, the torque at its first point
is computed as well; it must be finite or refused. Files with a fault are kept in the folder `--keep`. Each file has its
own seed, printed with every fault: --seed N --files 1 makes it again. Exit status: 0 no fault, 1 a fault.
"""

import io
import re
import signal
import sys
import tempfile
import warnings
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any

import meshio
import numpy as np
import typer

from analytic import catalog, friction_torque, load_scene
from analytic.errors import FembearingError
from analytic.surface.heightmap import measure, read_height_map
from fembearing.compare.memory import peak_memory, peak_while
from fembearing.mesh.meshfile import read_body

try:
    import resource
except ImportError:  # Windows
    resource = None

ROOT = Path(__file__).parents[1]
ADDRESSES = 8_000_000_000  # bytes, limit of the address space of the process
SLOWEST, LARGEST = 10.0, 1e9  # s, bytes above the memory before
LONGEST = 1000  # characters of an error message
MOST_CHANGES = 4  # in one file
FORBIDDEN = (
    *("os.system", "os.exec", "os.fork", "os.posix_spawn", "subprocess.Popen", "pickle.find_class", "socket.connect"),
)
JUNK = (
    *("nan", "inf", "-inf", "-0.0", "1e400", "1e-400", "0", "-1", "9" * 5000, "true", "[]", "{}", '""', "1_0", "0x10"),
    *('"1 m"', '"1e309 N"', '"-5 N"', '"1 N m N"', '"1 m^9"', '"1 m**9999999"', '"5 degC"', '"7 %"', '"\\u0000"'),
    *("\"__import__('os').system('false') m\"", '"{0.__class__}"', '"../../../etc/passwd"', '"/dev/zero"'),
    *('"on"', '"off"', '"auto"', '"solved"', '"given"', '"1 µm"', '"1 Ω"', '"' + "a" * 300 + '"', "2024-01-01"),
    *("[" * 200, "a." * 40 + "b"),
)
BYTES = (
    *(b"\x00", b"\xff\xfe", b"\xef\xbb\xbf", b"\r", b"\n", b"'''", b'"""'),
    *(b"[", b"]", b"=", b"#", b"{", b"}", b"<", b">"),
)
SCENES = (catalog.path("scenes", "6205-dry"), *sorted((ROOT / "validation" / "scenes").glob("*.toml")))
MESHES = tuple(sorted((ROOT / "meshes" / "reference").glob("*.vtu")))


class TooSlowError(BaseException):
    """The time limit; not an Exception, so that no reader takes it for a broken file."""


class ForbiddenError(BaseException):
    """An action that reading a file must not cause."""


@dataclass(frozen=True)
class Fault:
    """A file that was neither read nor refused properly."""

    kind: str
    seed: int
    problem: str
    content: bytes


def main(
    files: Annotated[int, typer.Option(help="Number of files, all three kinds together.")] = 10_000,
    seed: Annotated[int, typer.Option(help="First seed; each file has its own.")] = 0,
    keep: Annotated[Path, typer.Option(help="Folder for files with a fault; made when needed.")] = Path("fuzz-faults"),
) -> None:
    if resource is not None:  # a file that takes all memory becomes a fault and does not stop the machine
        resource.setrlimit(resource.RLIMIT_AS, (ADDRESSES, ADDRESSES))
    count: Counter[str] = Counter()
    faults = []
    for kind, outcome in fuzzed(range(seed, seed + files)):
        if isinstance(outcome, Fault):
            faults.append(outcome)
            keep.mkdir(parents=True, exist_ok=True)
            (keep / f"{kind}-{outcome.seed}").write_bytes(outcome.content)
            typer.echo(f"seed {outcome.seed}, {kind}: {outcome.problem}")
        else:
            count[f"{kind}: {outcome}"] += 1
    typer.echo(f"seeds {seed} to {seed + files - 1}: " + ", ".join(f"{n} {what}" for what, n in sorted(count.items())))
    typer.echo(f"{len(faults)} faults")
    raise typer.Exit(1 if faults else 0)


def fuzzed(seeds: range) -> Iterator[tuple[str, str | Fault]]:
    """For each seed the kind of file, and "read", "refused" or a fault."""
    kinds: tuple[tuple[str, Callable[[np.random.Generator], tuple[str, bytes]], Callable[[Path], Any]], ...] = (
        ("scene", changed_scene, read_scene),
        ("height map", changed_map, lambda path: measure(read_height_map(path, spacing=2e-6))),
        ("mesh", changed_mesh, lambda path: read_body(path, name="ball")),
    )
    with tempfile.TemporaryDirectory() as folder:
        for seed in seeds:
            rng = np.random.default_rng(seed)
            kind, change, read = kinds[seed % len(kinds)]
            name, content = change(rng)
            path = Path(folder) / name
            path.write_bytes(content)
            problem = outcome(path, read)
            yield kind, problem if problem in ("read", "refused") else Fault(kind, seed, problem, content)


def outcome(path: Path, read: Callable[[Path], Any]) -> str:
    """Read a file: "read", "refused" or the problem."""
    before = peak_memory() or 0
    result, peak = peak_while(lambda: _outcome(path, read))
    return f"{peak} bytes" if peak is not None and peak - before > LARGEST else result


def _outcome(path: Path, read: Callable[[Path], Any]) -> str:
    try:
        with limited():
            read(path)
    except FembearingError as refusal:
        words = str(refusal)
        if "\n" in words or not 0 < len(words) < LONGEST or not words.isprintable():
            return f"an unclear error: {words!r:.300}"
        return "refused"
    except (Exception, TooSlowError, ForbiddenError) as problem:
        return f"{type(problem).__name__}: {' '.join(str(problem).split()):.200}"
    return "read"


def read_scene(path: Path) -> None:
    scene = load_scene(path)
    if scene.has_friction:
        operation = scene.operation
        first = {name: np.atleast_1d(value)[:1] for name, value in vars(operation).items()}
        total = friction_torque(replace(scene, operation=replace(operation, **first))).torque.total
        if not np.isfinite(total).all():
            raise ArithmeticError(f"a torque of {total}")


def changed_scene(rng: np.random.Generator) -> tuple[str, bytes]:
    text = SCENES[rng.integers(len(SCENES))].read_text("utf-8")
    for _ in range(changes(rng)):
        lines = text.splitlines()
        at, other = rng.integers(len(lines), size=2)
        match rng.integers(6):
            case 0:
                lines[at] = re.sub(r"=.*", lambda _: "= " + str(rng.choice(JUNK)), lines[at])
            case 1:
                del lines[at]
            case 2:
                lines.insert(at, lines[other])
            case 3:
                lines[at] = re.sub(r"\d+\.?\d*", lambda _: f"{10 ** rng.uniform(-12, 12):.3g}", lines[at])
            case 4:
                lines[at] = lines[at].replace(str(rng.choice(list(lines[at] or "a"))), str(rng.choice(JUNK)), 1)
            case _:
                return "scene.toml", changed_bytes(text.encode(), rng)
        text = "\n".join(lines) or "a = 1"
    return "scene.toml", text.encode("utf-8", "surrogatepass")


def changed_map(rng: np.random.Generator) -> tuple[str, bytes]:
    heights = 1e-7 * rng.standard_normal((33, 40))
    if rng.random() < 0.5:
        kinds = ("<f8", "<f4", "<i2", "<c16", "<U3", "|O", "|b1")
        given = heights.astype(kinds[rng.integers(len(kinds))])
        file = io.BytesIO()
        np.save(file, given if rng.random() < 0.8 else given[..., None], allow_pickle=True)
        content = bytearray(file.getvalue())
        if rng.random() < 0.5:  # only the header
            content[:128] = changed_bytes(bytes(content[:128]), rng)
            return "map.npy", bytes(content)
        return "map.npy", changed_bytes(bytes(content), rng)
    rows = [",".join(f"{height:.3g}" for height in row) for row in heights]
    for _ in range(changes(rng) - 1):
        cells = rows[rng.integers(len(rows))].split(",")
        cells[rng.integers(len(cells))] = str(rng.choice(JUNK))
        rows[rng.integers(len(rows))] = ",".join(cells)
    content = "\n".join(rows).encode()
    return "map.csv", content if rng.random() < 0.5 else changed_bytes(content, rng)


def changed_mesh(rng: np.random.Generator) -> tuple[str, bytes]:
    chosen = MESHES[rng.integers(len(MESHES))]
    text = chosen.read_text("utf-8")
    match rng.integers(5):
        case 4:  # numbers in the arrays of an intact file
            return "body.vtu", with_changed_arrays(chosen, rng)
        case 0:  # a number in an XML attribute
            places = list(re.finditer(r'"\d+"', text))
            place = places[rng.integers(len(places))]
            text = text[: place.start()] + f'"{10 ** rng.integers(0, 19)}"' + text[place.end() :]
        case 1:  # a tag, or the value of an attribute
            words = list(re.finditer(r"[A-Z][A-Za-z]+\d*", text))
            place = words[rng.integers(len(words))]
            other = words[rng.integers(min(40, len(words)))].group()
            text = text[: place.start()] + other + text[place.end() :]
        case 2:
            head = '<!DOCTYPE a [<!ENTITY b "' + "b" * 1000 + '"><!ENTITY c "' + "&b;" * 1000 + '">]>'
            text = text.replace("<VTKFile", head + "<VTKFile", 1).replace("<Points>", "<Points>&c;", 1)
        case _:
            pass
    return "body.vtu", changed_bytes(text.encode(), rng) if rng.random() < 0.7 else text.encode()


def with_changed_arrays(path: Path, rng: np.random.Generator) -> bytes:
    mesh = meshio.read(path)
    arrays = [mesh.points, mesh.cells[0].data, *mesh.point_data.values()]
    for _ in range(changes(rng)):
        array = arrays[rng.integers(len(arrays))]
        odd = (np.nan, np.inf, 1e300, 0.0) if array.dtype.kind == "f" else (-1, -(10**9), 10**9, 0, array.max())
        array.flat[rng.integers(array.size)] = np.array(odd[rng.integers(len(odd))]).astype(array.dtype)
    with tempfile.TemporaryDirectory() as folder:
        meshio.write(Path(folder) / "body.vtu", mesh)
        return (Path(folder) / "body.vtu").read_bytes()


def changes(rng: np.random.Generator) -> int:
    """The number of changes, mostly one: a file with many errors is refused for the first."""
    return min(int(rng.geometric(0.6)), MOST_CHANGES)


def changed_bytes(content: bytes, rng: np.random.Generator) -> bytes:
    """The content cut, partly doubled, or with some bytes replaced."""
    changed = bytearray(content)
    for _ in range(changes(rng)):
        at = int(rng.integers(len(changed) + 1))
        match rng.integers(5):
            case 0:
                del changed[at:]
            case 1:
                changed[at:at] = BYTES[rng.integers(len(BYTES))]
            case 2:
                changed[at : at + 1] = rng.bytes(1)
            case 3:
                changed[at:at] = changed[at : at + int(rng.integers(1, 60))]
            case _:
                del changed[at : at + int(rng.integers(1, 30))]
    return bytes(changed)


_limiting = False


def _audit(event: str, arguments: tuple[Any, ...]) -> None:
    if _limiting and (event in FORBIDDEN or (event == "open" and _writes(*arguments[:2]))):
        raise ForbiddenError(f"{event} {arguments!r:.100}")


def _writes(path: Any, mode: Any) -> bool:
    """Whether a call of open writes; compiled code of Python itself does not count."""
    return isinstance(mode, str) and any(letter in mode for letter in "wax+") and "__pycache__" not in str(path)


sys.addaudithook(_audit)


@contextmanager
def limited() -> Iterator[None]:
    """Turn warnings into errors, limit the time, and forbid the actions above."""
    global _limiting

    def stop(*_: object) -> None:
        raise TooSlowError(f"more than {SLOWEST:g} s")

    before = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, SLOWEST)
    _limiting = True
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            yield
    finally:
        _limiting = False
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


if __name__ == "__main__":
    typer.run(main)
