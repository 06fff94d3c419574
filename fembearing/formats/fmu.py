"""The torque map as a functional mock-up unit, FMI 2.0 for co-simulation [FMI2022], which needs no Python.

The table is a part of the compiled library; `fmu.c` draws straight lines in it along each axis. Inputs are the axes
with more than one value, outputs the torque, both ends of its 95 % interval, and the power lost. An input beyond the
table is an error of the unit: nothing is known there.
"""

import hashlib
import shutil
import struct
import subprocess
import sys
import zipfile
from importlib.resources import files
from pathlib import Path
from tempfile import TemporaryDirectory
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from analytic.errors import InputError
from analytic.progress import Progress, part_of
from analytic.scene import Array
from analytic.scenefile.read import SceneByTemperature
from fembearing.formats.axes import SHOWN, Axes, axes_in_words
from fembearing.formats.interpolation import table_error
from fembearing.formats.torque_map import TorqueMap, from_standstill, mapped_torque

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
    axes = from_standstill(axes)
    nodes = 1
    for values in axes.values():
        nodes *= values.size
    if nodes > MOST:
        counts = " x ".join(str(values.size) for values in axes.values())
        raise InputError(f"{counts} = {nodes} nodes are more than the {MOST} that an FMU below 1 MB takes; give fewer")
    found = mapped_torque(given, axes, progress=part_of(progress, 0.0, 0.8))
    progress(0.8, "error of the table")
    error = table_error(found)
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
    return (f"the table differs from the torque by up to {100 * error:.2g} % between its nodes",)


def _table(found: TorqueMap) -> str:
    """The table as C."""
    axes = found.axes
    counts = ", ".join(str(values.size) for values in axes.values())
    nodes = ", ".join(_numbers(values) for values in axes.values())
    parts = ",\n".join(f"{{{_numbers(torque.ravel())}}}" for torque in found.torque)
    outside = []
    for name, values in axes.items():
        low, high = (SHOWN[name].written(float(end), ".6g") for end in values[[0, -1]])
        outside.append(f'"{name} is outside its table, {low} to {high}; SI units are expected"')
    return (
        f"#define AXES {len(axes)}\n#define SIZE {found.nominal.size}\n"
        f"static const int COUNTS[AXES] = {{{counts}}};\nstatic const double NODES[] = {{{nodes}}};\n"
        f"static const char *const OUTSIDE[AXES] = {{{', '.join(outside)}}};\n"
        f"static const double TABLE[3][SIZE] = {{\n{parts}}};\n"
    )


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


def _description(found: TorqueMap, guid: str, error: float) -> bytes:
    """modelDescription.xml."""
    words = (
        f"Friction torque of {found.scene.bearing.name} by fembearing: {axes_in_words(found.axes)}. Between its nodes "
        f"the table differs from the computed torque by up to {100 * error:.2g} %. At speed 0 the torque is that at "
        "which the bearing begins to turn. An input outside the table is an error."
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
    structure, count = SubElement(root, "ModelStructure"), len(found.axes)
    inputs = " ".join(str(1 + place) for place, values in enumerate(found.axes.values()) if values.size > 1)
    for part in ("Outputs", "InitialUnknowns"):
        unknowns = SubElement(structure, part)
        for place in range(len(OUTPUTS)):
            SubElement(unknowns, "Unknown", index=str(1 + count + place), dependencies=inputs)
    ElementTree.indent(root)
    return ElementTree.tostring(root, "utf-8", xml_declaration=True)


def _add_variable(variables: Element, name: str, kind: tuple[str, str], real: dict[str, str], meaning: str) -> None:
    """kind : variability and causality;  real : attributes of its type"""
    variability, causality = kind
    attributes = {
        "name": name,
        "valueReference": str(len(variables)),
        "description": meaning,
        "causality": causality,
        "variability": variability,
    }
    SubElement(SubElement(variables, "ScalarVariable", attributes), "Real", real)
