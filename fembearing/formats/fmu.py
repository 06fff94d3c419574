"""The torque map as a functional mock-up unit, FMI 2.0 for co-simulation [FMI2022], which needs no Python.

The table is a part of the compiled library; `fmu.c` draws straight lines in it along each axis. Inputs are the axes
with more than one value, outputs the torque, both ends of its 95 % interval, the power lost, and which input is beyond
the table. There the last torques of the table hold, and the unit logs a warning whenever an input leaves it.
"""

import hashlib
import shutil
import struct
import subprocess
import sys
import zipfile
from importlib.resources import files
from math import prod
from pathlib import Path
from tempfile import TemporaryDirectory
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from analytic.errors import InputError
from analytic.progress import Progress
from analytic.scene import Array
from analytic.scenefile.read import SceneByTemperature
from fembearing.formats.axes import SHOWN, Axes, axes_in_words
from fembearing.formats.interpolation import table_of_motion
from fembearing.formats.torque_map import TorqueMap, from_standstill

COMPILERS = ("cc", "gcc", "clang")
OPTIONS = ("-std=c99", "-O2", "-shared", "-fPIC", "-fvisibility=hidden")
NAME = "bearing_friction"  # of the library in the unit
SYSTEMS = {"linux": ("linux", ".so"), "darwin": ("darwin", ".dylib"), "win32": ("win", ".dll")}
MOST = 12_000  # nodes: the unit stays below 1 MB
UNITS = {"speed": "rad/s", "axial_load": "N", "radial_load": "N", "temperature": "K"}
BASES = {  # of SI, in each unit
    "rad/s": {"rad": "1", "s": "-1"},
    "N": {"kg": "1", "m": "1", "s": "-2"},
    "K": {"K": "1"},
    "N.m": {"kg": "1", "m": "2", "s": "-2"},
    "W": {"kg": "1", "m": "2", "s": "-3"},
}
MEANINGS = {
    "speed": "of the inner ring, of either sign",
    "axial_load": "along the axis",
    "radial_load": "across the axis",
    "temperature": "of the oil at the inlets",
}
OUTPUTS = {  # in the order of fmu.c
    "low": ("N.m", "lower end of the 95 % interval of the torque"),
    "torque": ("N.m", "friction torque, a magnitude that opposes the speed"),
    "high": ("N.m", "upper end of the 95 % interval of the torque"),
    "power": ("W", "lost by friction"),
}


def write_fmu(given: SceneByTemperature, axes: Axes, file: Path, progress: Progress) -> tuple[str, ...]:
    """Write the unit. Raises InputError without a C compiler, and for a table that is too large."""
    compiler = next(filter(None, map(shutil.which, COMPILERS)), None)
    if compiler is None:
        raise InputError(f"an FMU needs a C compiler, {', '.join(COMPILERS)}, and none is there; install one")
    sizes = [values.size for values in from_standstill(axes).values()]
    if (nodes := prod(sizes)) > MOST:
        counts = " x ".join(map(str, sizes))
        raise InputError(f"{counts} = {nodes} nodes are more than the {MOST} that an FMU below 1 MB takes; give fewer")
    found, error = table_of_motion(given, axes, progress)
    source = files("fembearing.formats").joinpath("fmu.c").read_text("utf-8")
    table = _table(found)
    guid = hashlib.sha256((source + table).encode()).hexdigest()[:32]
    table = f'#define GUID "{guid}"\n{table}'
    with TemporaryDirectory() as folder:
        library = _compiled(compiler, {"fmu.c": source, "table.h": table}, Path(folder))
    name, ending = SYSTEMS.get(sys.platform, (sys.platform, ".so"))
    place = f"binaries/{name}{8 * struct.calcsize('P')}/{NAME}{ending}"
    contents = {
        "modelDescription.xml": _description(found, guid, error),
        place: library,
        "sources/fmu.c": source.encode(),
        "sources/table.h": table.encode(),
    }
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as unit:
        for path, content in contents.items():
            unit.writestr(zipfile.ZipInfo(path), content, zipfile.ZIP_DEFLATED)  # the same bits at every date
    return (error,)


def _table(found: TorqueMap) -> str:
    """The table as C."""
    axes = found.axes
    counts = ", ".join(str(values.size) for values in axes.values())
    nodes = ", ".join(_numbers(values) for values in axes.values())
    parts = ",\n".join(f"{{{_numbers(torque.ravel())}}}" for torque in found.torque)
    outside = [f'"{words}: the torque at its end holds, SI units are expected"' for words in _beyond(axes).values()]
    return (
        f"#define AXES {len(axes)}\n#define SIZE {found.nominal.size}\n"
        f"static const int COUNTS[AXES] = {{{counts}}};\nstatic const double NODES[] = {{{nodes}}};\n"
        f"static const char *const OUTSIDE[AXES] = {{{', '.join(outside)}}};\n"
        f"static const double TABLE[3][SIZE] = {{\n{parts}}};\n"
    )


def _beyond(axes: Axes) -> dict[str, str]:
    """That an axis is left, with its ends."""
    ends = {name: " to ".join(SHOWN[name].written(float(end), ".6g") for end in axes[name][[0, -1]]) for name in axes}
    return {name: f"{name} is outside its table, {words}" for name, words in ends.items()}


def _numbers(values: Array) -> str:
    return ", ".join(repr(value) for value in values.tolist())


def _compiled(compiler: str, sources: dict[str, str], folder: Path) -> bytes:
    """The shared library. Raises InputError where the compiler fails, with its first line."""
    for name, text in sources.items():
        (folder / name).write_text(text, "utf-8")
    library = folder / "library"
    command = [compiler, *OPTIONS, "-o", str(library), str(folder / "fmu.c")]
    ended = subprocess.run(command, capture_output=True, check=False, text=True)
    if ended.returncode or not library.exists():
        first = next(iter(ended.stderr.splitlines()), f"status {ended.returncode}")
        raise InputError(f"the C compiler {compiler!r} fails: {first}; repair it, or install another one")
    return library.read_bytes()


def _description(found: TorqueMap, guid: str, error: str) -> bytes:
    """modelDescription.xml."""
    words = (
        f"Friction torque of {found.scene.bearing.name} by fembearing: {axes_in_words(found.axes)}; {error}. At speed "
        "0 the torque is that at which the bearing begins to turn. Beyond the table the torque at its end holds."
    )
    root = Element(
        "fmiModelDescription",
        fmiVersion="2.0",
        modelName=NAME,
        guid=guid,
        description=words,
        generationTool="fembearing",
        variableNamingConvention="flat",
        numberOfEventIndicators="0",
    )
    unit = SubElement(
        root,
        "CoSimulation",
        modelIdentifier=NAME,
        canHandleVariableCommunicationStepSize="true",
        canNotUseMemoryManagementFunctions="true",
        canGetAndSetFMUstate="true",
        canSerializeFMUstate="true",
    )
    SubElement(SubElement(unit, "SourceFiles"), "File", {"name": "fmu.c"})
    units = SubElement(root, "UnitDefinitions")
    for name, bases in BASES.items():
        SubElement(SubElement(units, "Unit", name=name), "BaseUnit", bases)
    variables = SubElement(root, "ModelVariables")
    for name, values in found.axes.items():
        kind = ("constant", "local") if values.size == 1 else ("continuous", "input")
        start = {"start": repr(float(values[values.size // 2]))}
        _add_variable(variables, name, kind, {"unit": UNITS[name]} | start, MEANINGS[name])
    for name, (unit_name, meaning) in OUTPUTS.items():
        _add_variable(variables, name, ("continuous", "output"), {"unit": unit_name}, meaning)
    left = [f"{number}: {words}" for number, words in enumerate(_beyond(found.axes).values(), start=1)]
    inputs = [place for place, values in enumerate(found.axes.values()) if values.size > 1]
    meaning = "; ".join(["0: every input lies in the table", *(left[place] for place in inputs)])
    _add_variable(variables, "outside", ("discrete", "output"), None, meaning)
    structure, count = SubElement(root, "ModelStructure"), len(found.axes)
    known = " ".join(str(1 + place) for place in inputs)
    for part in ("Outputs", "InitialUnknowns"):
        unknowns = SubElement(structure, part)
        for place in range(len(OUTPUTS) + 1):
            SubElement(unknowns, "Unknown", index=str(1 + count + place), dependencies=known)
    ElementTree.indent(root)
    return ElementTree.tostring(root, "utf-8", xml_declaration=True)


def _add_variable(
    variables: Element, name: str, kind: tuple[str, str], real: dict[str, str] | None, meaning: str
) -> None:
    """kind : variability and causality;  real : attributes of its type; None: an integer"""
    variability, causality = kind
    attributes = {
        "name": name,
        "valueReference": str(len(variables)),
        "description": meaning,
        "causality": causality,
        "variability": variability,
    }
    variable = SubElement(variables, "ScalarVariable", attributes)
    SubElement(variable, "Integer" if real is None else "Real", real or {})
