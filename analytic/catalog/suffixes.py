"""What the letters behind a bearing number mean: seals, cage, clearance, precision. Makers use letters differently.

Source: makers' and dealers' lists of suffixes, [Suffixes].
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from typing import Literal

SuffixKind = Literal["seals", "clearance", "ceramic", "ignored", "warned", "refused"]
SealContact = Literal["rubs", "rubs lightly", "none"]
LONGEST = 8  # characters of a suffix
SEPARATORS = re.compile(r"[\s\-./_,+]+")


@dataclass(frozen=True, kw_only=True)
class Suffix:
    """One group of letters behind a bearing number."""

    text: str  # in capitals
    kind: SuffixKind  # what follows from it
    meaning: str


_SHIELD = "sheet-metal shield that does not touch"
_CONTACT = "rubber seal that rubs"
_LIGHT = "rubber seal that rubs lightly"
_FREE = "rubber seal that does not touch"
_BOTH, _ONE = "on both sides", "on one side"
_CERAMIC = "balls of silicon nitride"

# (pattern, kind, meaning) for every bearing. A digit 2 or a doubled letter in front means both sides.
_COMMON: tuple[tuple[str, SuffixKind, str], ...] = (
    (r"ZZ[AES]?|2Z[NRS]?", "seals", f"{_SHIELD}, {_BOTH}"),
    (r"Z[NR]?", "seals", f"{_SHIELD}, {_ONE}"),
    (r"2RS[1-9HR]?|2HRS|DDU|LLU[AN]?|2NSE|EE|2LS|PP", "seals", f"{_CONTACT}, {_BOTH}"),
    (r"RS[1-9HR]?|HRS|DU|LU|NSE", "seals", f"{_CONTACT}, {_ONE}"),
    (r"DD", "seals", f"{_CONTACT}, {_BOTH} (shields with some makers)"),
    (r"2RSL|2RST|2RD|DDW|LLH|2ELS", "seals", f"{_LIGHT}, {_BOTH}"),
    (r"RSL|RST|RD|DW|LH|ELS", "seals", f"{_LIGHT}, {_ONE}"),
    (r"2RZ|2RU|VV|LLB|2BRS|2RSD", "seals", f"{_FREE}, {_BOTH}"),
    (r"RZ|RU|V|LB|BRS|RSD", "seals", f"{_FREE}, {_ONE}"),
    (r"C[2345]|CN", "clearance", "group of radial clearance"),
    (r"C[2345N][HLMP]", "clearance", "part of a group of radial clearance, taken as the whole group"),
    (r"P[654][2345]", "clearance", "precision class, and group of radial clearance"),
    (r"CM", "warned", "motor clearance, narrower than CN and within it; taken as CN"),
    (r"TN9?|TNH|TNG[HN]?|TVP[1-9]?|TVPB?|TVH|TV|TYN?A?|T2X?|T", "ignored", "cage of polyamide or another plastic"),
    (r"T[AB]|TR|T1", "ignored", "cage of fabric-reinforced phenolic resin"),
    (r"M[ABPST]?|MPS|MPA|L1", "ignored", "machined brass cage"),
    (r"J[0-9NWR]?|JP", "ignored", "pressed steel cage"),
    (r"JEM", "ignored", "pressed steel cage, polyurea grease"),
    (r"Y[AB]?", "ignored", "pressed brass cage"),
    (r"F1?", "ignored", "machined steel cage"),
    (r"P(?:0|[24-6][AS]?|6X|A9[AB]?|N)|PA[579]A?|ABEC[13579]|A7?/9", "ignored", "precision class"),
    (r"N[RS]?[1-9]?|NB", "ignored", "snap-ring groove in the outer ring"),
    (r"S[0-4]", "ignored", "rings stabilised for high temperature"),
    (r"QE[56]?|Q[56]|E[QM]Q?|EMQ|Z[1-4]V?[1-4]?|V[1-4]", "ignored", "limits of noise and vibration"),
    (r"VL\d{4}", "ignored", "electric insulation on a ring"),
    (
        r"(?:MT|HT|LT|LHT|VT|GE|GJ|WT|GWP|GWM)[0-9NFBHJC]*|NS7S?|PS2S?|AS2S?|SRL|ENS|5K|LX\d\d|L\d{3}",
        "ignored",
        "grease",
    ),
    (r"K(?:12|30)?", "warned", "tapered bore; the grooves are taken to be those of the cylindrical bore"),
    (r"HC\d?|HQ1?|HYB(?:RID)?|SN24|SI3N4|CERAMIC", "ceramic", _CERAMIC),
    (r"W64[A-Z]?|L4B|SO", "warned", "solid oil or coating: its friction is not computed"),
    (
        r"HV\d?|HN\d|SS|VA201|VA208|VA228",
        "warned",
        "rings or cage for special conditions; other clearance and friction",
    ),
)
_DEEP_GROOVE: tuple[tuple[str, SuffixKind, str], ...] = (
    (
        r"C[16]|MC[1-6]|CT|CG",
        "warned",
        "a radial clearance that ISO 5753-1 does not have; CN is taken: give the length as bearing.clearance",
    ),
    (r"ETN9?", "refused", "reinforced ball set with other balls"),
    (r"[ABCDEHRX]", "refused", "changed inner design, which may have other balls"),
)
_ANGULAR_CONTACT: tuple[tuple[str, SuffixKind, str], ...] = (
    (r"P", "ignored", "cage of polyamide"),
    (r"E", "ignored", "reinforced ball set"),
    (r"D[BFT][ABD]?|DBD|DFD|TBT|QBC|QFC", "warned", "matched set; the bearing is one of them"),
    (r"[SDTQ]?U[LMHA]?|C[ABC]|G[ABCD]?|SU[LMH]", "ignored", "ground for pairing"),
    (r"EL|[LH]|C[789]|GL|GN|GM|GH", "warned", "preload class of a matched set; preload is not computed from it"),
    (r"C[16]|MC[1-6]|CT|CG", "warned", "a radial clearance; ignored, as it follows from the contact angle"),
    (r"CE1|7CE1", "ignored", "phenolic cage, 15 degrees"),
    (r"7?CE[23]", "refused", "another contact angle than the printed 15 degrees"),
    (r"V1V?", "ignored", "accuracy of the maker"),
    (r"NS", "ceramic", _CERAMIC),
)
PREFIXES: dict[str, tuple[SuffixKind, str]] = {
    "W": ("warned", "stainless steel; its balls are taken to be those of the bearing of bearing steel"),
    "SS": ("warned", "stainless steel; its balls are taken to be those of the bearing of bearing steel"),
    "S": ("warned", "stainless steel; its balls are taken to be those of the bearing of bearing steel"),
    **dict.fromkeys(("HC", "HCB", "HCS", "HCRS", "HY", "XC", "XCB", "XCS", "3NC", "5S"), ("ceramic", _CERAMIC)),
    "F": ("warned", "flange on the outer ring; its structure is not that of the plain ring"),
    "E2.": ("refused", "an energy-saving inner design, which may have other balls"),
}


@cache
def _suffix(text: str, angular: bool) -> Suffix | None:
    for pattern, kind, meaning in (_ANGULAR_CONTACT if angular else _DEEP_GROOVE) + _COMMON:
        if re.fullmatch(pattern, text):
            return Suffix(text=text, kind=kind, meaning=meaning)
    return None


def _split(text: str, angular: bool) -> list[Suffix] | None:
    """The longest known suffixes that make up this text without a gap; None: there are none."""
    if not text:
        return []
    for length in range(min(len(text), LONGEST), 0, -1):
        first = _suffix(text[:length], angular)
        rest = None if first is None else _split(text[length:], angular)
        if first is not None and rest is not None:
            return [first, *rest]
    return None


def read_suffixes(text: str, *, angular: bool) -> tuple[list[Suffix], list[str]]:
    """(known suffixes, texts that are not understood) of what stands behind a bearing number, in capitals.

    angular : whether the number is that of an angular contact bearing, where some letters mean something else
    """
    known: list[Suffix] = []
    unknown: list[str] = []
    for part in filter(None, SEPARATORS.split(text)):
        suffixes = _split(part, angular)
        letters = [suffix for suffix in suffixes or () if len(suffix.text) == 1]
        if suffixes is None or (len(letters) > 1 and any(letter.kind == "refused" for letter in letters)):
            unknown.append(part)  # nor is a row of single letters, one of them of many meanings, understood
        else:
            known += suffixes
    return known, unknown


def begins_with_a_number(part: str, *, angular: bool) -> bool:
    """Whether a part that is not understood is a number alone, or one in front of known suffixes, as 8ZZ: a size."""
    digits = re.match(r"\d+", part)
    return digits is not None and _split(part[digits.end() :], angular) is not None


def clearance_of(suffixes: list[Suffix]) -> Iterator[str]:
    """The group of ISO 5753-1 that each of the suffixes names."""
    for suffix in suffixes:
        if suffix.text == "CM":
            yield "CN"
        elif suffix.kind == "clearance" and suffix.text[0] == "P":
            yield f"C{suffix.text[2]}"
        elif suffix.kind == "clearance":
            yield suffix.text[:2]


def seal_contact(seals: Suffix) -> SealContact:
    """Whether the seals that a suffix names touch the inner ring."""
    if seals.meaning.startswith(_LIGHT):
        return "rubs lightly"
    return "rubs" if seals.meaning.startswith(_CONTACT) else "none"


def seal_sides(seals: Suffix) -> int:
    """On how many sides of the bearing the suffix puts seals, 1 or 2."""
    return 2 if _BOTH in seals.meaning else 1
