"""An object file as one block of code that works at any page of memory.

LLVM writes ELF, whose sections refer to one another by distances. Here they are laid out one after the other and the
distances filled in. A function of the C library is called through a stub at the end of the block: it jumps to the
address behind it, which whoever loads the block puts there. Tables of addresses have those from the start of the block;
whoever loads it adds its place.

The relocations are those of the processors' supplements to ELF: S + A is the place that is meant, P the place that
refers to it.
"""

import json
import struct
from collections.abc import Callable
from io import BytesIO
from typing import Any, NamedTuple

from elftools.elf.elffile import ELFFile

from analytic.numerics.machine_code import ADDRESS, STUB

PAGE = 4096  # bytes, of which the distances of AArch64 count; the pages of a machine are multiples of it
UNWINDING = ".eh_frame"  # nothing raises
SETTLED = ".data.rel.ro"  # does not change once it is loaded
WHOLE = {"EM_X86_64": 1, "EM_AARCH64": 257}  # the relocation that is an address
JUMPS = {  # jump to the address 8 bytes on
    "EM_X86_64": bytes.fromhex("ff2502000000 9090"),
    "EM_AARCH64": bytes.fromhex("50000058 00021fd6"),
}


class Place(NamedTuple):
    """What a relocation says, in bytes from the start of the block."""

    meant: int  # S + A
    own: int  # P
    word: int  # the 32 bits that are there

    @property
    def distance(self) -> int:
        return self.meant - self.own

    def branch(self) -> int:
        return self.word | (self.distance >> 2) & 0x3FFFFFF

    def page(self) -> int:
        pages = self.meant // PAGE - self.own // PAGE
        return self.word | (pages & 3) << 29 | (pages >> 2 & 0x7FFFF) << 5

    def in_page(self, shift: int) -> int:
        return self.word | self.meant % PAGE >> shift << 10


RELOCATIONS: dict[str, dict[int, Callable[[Place], int]]] = {  # by their numbers
    "EM_X86_64": dict.fromkeys((2, 4), lambda place: place.distance),
    "EM_AARCH64": {
        261: lambda place: place.distance,
        275: Place.page,
        **dict.fromkeys((282, 283), Place.branch),
        **{
            number: lambda place, shift=shift: place.in_page(shift)
            for number, shift in ((277, 0), (278, 0), (284, 1), (285, 2), (286, 3), (299, 4))
        },
    },
}


def linked(code: bytes, name: str) -> bytes:
    """A line of JSON on the block, `Head` of `machine_code`, then the block;  name : of the function that is called.

    code : an object file
    Raises RuntimeError for what a block cannot have: data that change, and other relocations.
    """
    file: Any = ELFFile(BytesIO(code))
    machine = file["e_machine"]
    block, starts = bytearray(), {}
    for number, section in enumerate(file.iter_sections()):
        if section["sh_flags"] & 2 and section["sh_size"] and section.name != UNWINDING:
            if section["sh_flags"] & 1 and not section.name.startswith(SETTLED):
                raise RuntimeError(f"{name} has data that change, in {section.name}")
            block += bytes(-len(block) % section["sh_addralign"])
            starts[number] = len(block)
            block += section.data()
    symbols = [*file.get_section_by_name(".symtab").iter_symbols()]
    called = [each.name for each in symbols if each["st_shndx"] == "SHN_UNDEF" and each.name]
    block += bytes(-len(block) % STUB)
    stubs = {each: len(block) + number * STUB for number, each in enumerate(called)}
    block += (JUMPS[machine] + bytes(ADDRESS)) * len(called)

    def start_of(symbol: Any) -> int:
        return stubs[symbol.name] if symbol.name in stubs else starts[symbol["st_shndx"]] + symbol["st_value"]

    addresses = []
    for table in file.iter_sections("SHT_RELA"):
        if (start := starts.get(table["sh_info"])) is None:
            continue
        for each in table.iter_relocations():
            own, kind = start + each["r_offset"], each["r_info_type"]
            meant = start_of(symbols[each["r_info_sym"]]) + each["r_addend"]
            if kind == WHOLE[machine]:
                struct.pack_into("<Q", block, own, meant)
                addresses.append(own)
                continue
            if kind not in RELOCATIONS[machine]:
                raise RuntimeError(f"{name} has a relocation of kind {kind}, which no block has")
            (word,) = struct.unpack_from("<I", block, own)
            value = RELOCATIONS[machine][kind](Place(meant, own, word))
            struct.pack_into("<I", block, own, value & 0xFFFFFFFF)
    start = start_of(next(each for each in symbols if each.name == name))
    return json.dumps({"start": start, "called": called, "addresses": addresses}).encode() + b"\n" + block
