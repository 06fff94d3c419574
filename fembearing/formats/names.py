"""Names of files: where a program calls a table by the name of its file, its own words are no names."""

import keyword
import re
import sys
from collections.abc import Mapping
from pathlib import Path

from analytic.errors import InputError

LONGEST = 63  # letters of a name in MATLAB; longer ones are of no use elsewhere
NAME = re.compile(rf"[A-Za-z][A-Za-z0-9_]{{0,{LONGEST - 1}}}")
PACKAGES = (
    "ross numpy scipy pandas plotly kaleido matplotlib pint toml xlrd openpyxl numba llvmlite control ccp CoolProp"
)
# What a name is to the program, and the names that have a meaning already: keywords, modules and packages that the file
# and its program import, built-in types and operators, and what the script itself calls and makes.
TAKEN: Mapping[str, tuple[str, str]] = {
    "modelica": (
        "Modelica package",
        "algorithm and annotation block break class connect connector constant constrainedby der discrete each else "
        "elseif elsewhen encapsulated end enumeration equation expandable extends external false final flow for "
        "function if import impure in initial inner input loop model not operator or outer output package parameter "
        "partial protected public pure record redeclare replaceable return stream then true type when while within "
        "Real Integer Boolean String Clock StateSelect AssertionLevel ExternalObject time Modelica ModelicaServices "
        "Complex abs acos actualStream array asin assert atan atan2 backSample cardinality cat ceil change cos cosh "
        "cross delay diagonal div edge exp fill floor getInstanceName hold homotopy identity inStream integer interval "
        "linspace log log10 matrix max min mod ndims noClock noEvent ones outerProduct pre previous product reinit rem "
        "sample scalar semiLinear shiftSample sign sin sinh size skew smooth spatialDistribution sqrt subSample sum "
        "superSample symmetric tan tanh terminal terminate transpose vector zeros",
    ),
    "simscape": (
        "MATLAB script",
        "break case catch classdef continue else elseif end for function global if otherwise parfor persistent return "
        "spmd switch try while friction struct",
    ),
    "ross": (
        "Python module",
        " ".join([*keyword.kwlist, *sys.stdlib_module_names, "test prettytable methodtools tqdm", PACKAGES]),
    ),
}


def friction_name(text: str) -> str:
    """A name that every format takes, made of a text."""
    return ("friction_" + re.sub(r"[^A-Za-z0-9]+", "_", text).strip("_"))[:LONGEST]


def require_name(to: str, file: Path) -> None:
    """Raises InputError for a file of a format whose program does not take the name."""
    kind, taken = TAKEN.get(to, ("", ""))
    if kind and (not NAME.fullmatch(file.stem) or file.stem in taken.split()):
        raise InputError(
            f"--out {str(file)!r}: {file.stem!r} is no name of a {kind}: letters, digits and _, a letter first, up to "
            f"{LONGEST}, and no word or module that has a meaning there; give for example "
            f"{str(file.with_stem(friction_name(file.stem)))!r}"
        )
