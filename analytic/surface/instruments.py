"""Height maps in the files of profilometers and microscopes, by SurfaceTopography, in a process of its own.

Its readers trust the sizes that a file states. A file from elsewhere can therefore cost them any memory and time; in a
process with limits this ends as a refusal. The package is an extra, as it brings a dozen others.
"""

import json
import os
import subprocess
import sys
from contextlib import suppress
from pathlib import Path
from zipfile import ZipFile, is_zipfile

import numpy as np

from analytic.errors import InputError, require_packages
from analytic.processes import MODULE, environment
from analytic.reading import require_deflated, require_regular
from analytic.surface.map_data import MapData, require_matrix
from analytic.words import plain

LARGEST = 300_000_000  # bytes of a file, and of what it unpacks to
MOST_MEMORY, PATIENCE = 3_000_000_000, 60  # bytes and s of the process; a large map takes 1 GB and some seconds
AGAIN = "save it as .x3p, or heights in m as .npy"
# Ending -> format, as SurfaceTopography names it. Lists of points, line scans and files that may hold anything, as .mat
# and .h5, have no place here.
FORMATS = {
    **dict.fromkeys((".vk3", ".vk4", ".vk6", ".vk7"), "vk"),  # Keyence
    **{ending: ending[1:] for ending in (".al3d", ".datx", ".frt", ".gwy", ".lext", ".mnt", ".nms", ".opd", ".opdx")},
    **{ending: ending[1:] for ending in (".os3d", ".plu", ".plux", ".sdf", ".sur", ".zmg", ".zon")},
    ".apx": "plu",
    ".bcr": "bcr",
    ".bcrf": "bcr",
    ".nid": "ezd",
    ".spm": "di",
}
METROPRO = "metropro", b"\x88\x1b\x03"  # Zygo's .dat, and how it begins; other files of this ending are text


def instrument_map(path: str | os.PathLike[str], kind: str = "") -> MapData:
    """The first map of heights in the file of an instrument.

    kind : format as SurfaceTopography names it, if the ending does not say it
    Raises InputError for a file that cannot be read, MissingPackageError without SurfaceTopography.
    """
    require_regular(path, most=LARGEST, remedy="give the path of a height map")
    require_packages("its format", "SurfaceTopography")
    command = [*MODULE, __name__, os.path.abspath(path), kind or FORMATS[Path(path).suffix.lower()]]
    around = environment() | {"OPENBLAS_NUM_THREADS": "1"}  # each thread reserves memory
    try:
        ended = subprocess.run(
            command, capture_output=True, check=False, timeout=PATIENCE, env=around, cwd=Path(__file__).parent
        )
    except subprocess.TimeoutExpired as problem:
        raise InputError(f"was not read within {PATIENCE} s; {AGAIN}") from problem
    head, _, content = ended.stdout.partition(b"\n")
    if ended.returncode != 0:
        reason = ended.stderr.decode("utf-8", "replace").strip().rpartition("\n")[2][:120]
        raise InputError(f"cannot be read: {plain(reason)}; {AGAIN}")
    found = json.loads(head)
    if "problem" in found:
        raise InputError(found["problem"])
    heights = np.frombuffer(content).reshape(found["shape"]).copy()
    return MapData(heights, tuple(found["spacings"]), tuple(found["doubts"]))


def _limit_memory() -> None:
    with suppress(ImportError, OSError, ValueError):  # Windows has no such limit, and macOS keeps none
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))


def _read(path: str, kind: str) -> MapData:
    """The map, in the process with limits."""
    from SurfaceTopography import open_topography  # pyright: ignore[reportMissingImports]

    if is_zipfile(path):
        with ZipFile(path) as archive:  # never gives more than it says
            require_deflated(archive)
            if sum(part.file_size for part in archive.infolist()) > LARGEST:
                raise InputError(f"unpacks to more than {LARGEST // 1_000_000} MB; {AGAIN}")
    with open_topography(path, format=kind) as reader:
        maps = [channel for channel in reader.channels if channel.dim == 2 and channel.data_kind.value == "height"]
        if not maps:
            raise InputError(f"has no map of heights; {AGAIN}")
        first = maps[0]
        require_matrix(tuple(reversed(first.nb_grid_pts)))
        if first.unit is None or first.physical_sizes is None:
            raise InputError(f"says no unit or no size of its map; {AGAIN}")
        doubts = [f"its file has {len(maps)} maps of heights, and the first counts, {plain(first.name)}"]
        topography = first.topography().to_unit("m")
        heights = np.ma.filled(np.ma.asarray(topography.heights(), dtype=np.float64), np.nan)  # x first
        along_x, along_y = topography.pixel_size
        return MapData(heights.T, (float(along_x), float(along_y)), tuple(doubts if len(maps) > 1 else ()))


def _serve(path: str, kind: str) -> None:
    """Write a line of JSON, and the heights behind it."""
    out, sys.stdout = sys.stdout.buffer, sys.stderr  # where the package may print
    try:
        found = _read(path, kind)
        head = {"shape": found.heights.shape, "spacings": found.spacings, "doubts": found.doubts}
        content = np.ascontiguousarray(found.heights).tobytes()
    except InputError as problem:
        head, content = {"problem": str(problem)}, b""
    except Exception as problem:  # the package raises different ones, depending on the damage
        reason = " ".join(str(problem).split())[:120] or type(problem).__name__
        head, content = {"problem": f"cannot be read: {plain(reason)}; {AGAIN}"}, b""
    out.write(json.dumps(head).encode() + b"\n" + content)


if __name__ == "__main__":
    _limit_memory()
    _serve(*sys.argv[1:])
