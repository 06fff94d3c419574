"""The docstrings of what users call have the sections that numpydoc renders, by numpydoc's own checks."""

import inspect
from types import FunctionType

from numpydoc.validate import validate

from docs.extensions.public import exported, public_classes

CHECKS = {  # the others are about style
    *("GL06", "GL07", "GL08"),  # sections, and that there is a docstring
    "SS01",  # a summary
    *("PR01", "PR02", "PR03", "PR07", "PR10"),  # each parameter, in order, described
    *("RT01", "RT03"),  # what is returned
}


def test_exported_functions_and_public_methods_have_all_sections() -> None:
    called = [f"{one.__module__}.{one.__qualname__}" for one in exported() if isinstance(one, FunctionType)]
    for kind in public_classes():
        for name, member in vars(kind).items():
            takes = isinstance(member, FunctionType) and len(inspect.signature(member).parameters) > 1
            if takes and not name.startswith("_"):
                called.append(f"{kind.__module__}.{kind.__qualname__}.{name}")
    assert len(called) > 40
    found = {name: [code for code, _ in validate(name)["errors"] if code in CHECKS] for name in called}
    assert {name: codes for name, codes in found.items() if codes} == {}
