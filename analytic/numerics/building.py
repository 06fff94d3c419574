"""The machine code of entries, made by numba and LLVM. Nothing else of the package loads a compiler.

python -m analytic.numerics.building FOLDER FAMILY ... of ENTRY ...
"""

import gc
import sys
from collections.abc import Iterable
from inspect import signature
from pathlib import Path
from pkgutil import resolve_name
from typing import Any

import llvmlite.binding as llvm
import numba

from analytic.numerics.linking import linked
from analytic.numerics.machine_code import OF_C, Entry, arguments, digest, file_name, symbol

# Functions that numba calls where a formula has raised, which none does, and what they do
NEVER = ("numba_", "NRT_MemInfo_call_dtor", "NRT_Free", "Py")
TRAP = "{} {{\n call void @llvm.trap()\n unreachable\n}}\ndeclare void @llvm.trap()"


def build(names: Iterable[str], families: Iterable[str], folder: Path) -> None:
    """Write the files of entries into a folder, by numba. Raises OSError where it takes none."""
    gc.disable()  # what the compiler makes is much, and stays
    for entry in map(resolve_name, names):
        text, made = _assembly(entry)
        for family in families:
            code = linked(_object(text, made, symbol(entry), family), symbol(entry))
            (folder / file_name(entry, family)).write_bytes(digest(code) + code)


def _assembly(entry: Entry) -> tuple[str, str]:
    """What LLVM compiles, and the name of its function, which takes flat arguments."""
    typed: Any = numba  # it has no types
    flat, taken = arguments(entry)
    names, call = ", ".join(name for name, _ in flat), f"function({', '.join(taken)})"
    here = {type(each).__name__: type(each) for each in entry.layout().values() if hasattr(each, "_fields")}
    here |= {"function": entry.inside, "carray": typed.carray}
    returns = signature(entry.function).return_annotation is int
    exec(f"def flat({names}):\n    " + (f"return {call}" if returns else f"{call}\n    return 0"), here)
    numbers = {float: typed.float64, int: typed.int64}
    kinds = (numbers.get(kind) or typed.types.CPointer(typed.from_dtype(kind)) for _, kind in flat)
    made: Any = typed.cfunc(typed.int64(*kinds), error_model="numpy", nogil=True)(here["flat"])
    return made.inspect_llvm(), made.native_name


def _object(text: str, made: str, name: str, family: str) -> bytes:
    """An object file, of which others see one function, by its name; made : what it is called in the text"""
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    module = llvm.parse_assembly(text)
    for function in list(module.functions):
        if function.name == made:
            function.name = name
        elif not function.is_declaration:
            function.linkage = "internal"
        elif function.name.startswith(NEVER):
            head = str(function).partition("\n")[0].replace("declare", "define").partition(" #")[0]
            module.link_in(llvm.parse_assembly(TRAP.format(head)))
        elif not function.name.startswith("llvm.") and function.name not in OF_C:
            raise RuntimeError(f"{name} calls {function.name}: formulas of an entry make no arrays and raise nothing")
    module.triple = llvm.get_process_triple() + ("" if sys.platform == "linux" else "-elf")  # a block is made of ELF
    target = llvm.Target.from_triple(module.triple)
    machine = target.create_target_machine(cpu=family, opt=3, reloc="pic", codemodel="small")
    passes = llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(speed_level=3))
    rotated = llvm.newpassmanagers.create_new_module_pass_manager()  # loops that the next passes can vectorise
    rotated.add_loop_rotate_pass()
    rotated.add_instruction_combine_pass()
    rotated.add_jump_threading_pass()
    rotated.run(module, passes)
    for _ in range(2):  # once more for what the first time has inlined: a third faster
        passes.getModulePassManager().run(module, passes)
    return machine.emit_object(module)


if __name__ == "__main__":
    end = sys.argv.index("of")
    build(sys.argv[end + 1 :], sys.argv[2:end], Path(sys.argv[1]))
