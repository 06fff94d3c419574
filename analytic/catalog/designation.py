"""The designation of a bearing as people write it: maker, number and suffixes, in any case and with any separators.

Designations of bearings of another kind are known by their letters or series: those of DIN 623-1 and of makers'
catalogues, as commonly known; no page was read for them.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass

from analytic.catalog.suffixes import PREFIXES, Suffix, begins_with_a_number, read_suffixes
from analytic.errors import InputError

MAKERS = ("NSK", "SKF", "KOYO", "GMN", "SNFA")  # whose bearings are in the catalogue
_OTHERS = (
    *("FAG", "INA", "SCHAEFFLER", "NTN-SNR", "NTN", "SNR", "NACHI", "TIMKEN", "JTEKT", "NMB", "MINEBEA", "RHP"),
    *("ZKL", "ZVL", "KINEX", "URB", "NKE", "NBC", "EZO", "FBJ", "IJK", "HRB", "ZWZ", "LYC", "FAFNIR", "BARDEN"),
    *("MRC", "STEYR"),
)
_NAME = "|".join(sorted((*MAKERS, *_OTHERS), key=len, reverse=True))
_MAKER_BEFORE = re.compile(rf"({_NAME})(?![A-Z])[\s\-:/]*")
_MAKER_BEHIND = re.compile(rf"[\s\-:/(]*(?<![A-Z])({_NAME})\)?$")
_MAKER_INSIDE = re.compile(rf"(?<![A-Z0-9])({_NAME})(?![A-Z0-9])")
_KIND = re.compile(  # words for what the number says itself
    r"(?<![A-Z0-9])(?:DGBB|ACBB|DEEP[ -]?GROOVE|ANGULAR[ -]?CONTACT|SINGLE[ -]?ROW|BALL|BEARINGS?|TYPE?|ROULEMENT|"
    r"(?:RILLENKUGEL|SCHR(?:Ä|AE)GKUGEL|KUGEL)?LAGER)(?![A-Z0-9])[\s:\-]*"
)
_HYPHEN_FOR_SLASH = re.compile(r"^(6[023]|61[89])\s*[-_]\s*(22|28|32|[4-9])(?!\d)")
_CUT_NUMBER = re.compile(r"\d[\s\-._]+\d")  # 623-2RS is not 6232 RS
_BEHIND_SLASH = re.compile(r"\s*/\s*([^\s\-./_,+]+)")
_FILLER = re.compile(r"[\s\-._]+")
LONGEST = 60  # characters
ONE_ROW = "fembearing computes ball bearings of one row; give one of those, for example 6205 or 7208B"
BY_HAND = "give its dimensions by hand in [bearing]: ball_count, ball_diameter, pitch_diameter, conformity"
PAIR = f"{BY_HAND} of one row, and an [arrangement] of two"
THRUST = (
    'the catalogue does not have its balls: give kind = "thrust", ball_count, ball_diameter, pitch_diameter and '
    "conformity in [bearing], with bore_diameter, outside_diameter and static_load_rating for makers' formulas"
)
FOUR_POINTS = f'under thrust it is one of angular contact: {BY_HAND} and contact_angle = {{ nominal = "35 deg" }}'
# (pattern from the beginning of the designation, kind, remedy); the first that fits counts.
_KINDS: tuple[tuple[str, str, str], ...] = (
    (r"(?:NUP|NJP|NUB|NCF|NNU|NNC|NNF|NU|NJ|NF|NH|NN|RNU|RN|N)\d{3,}", "a cylindrical roller bearing", ONE_ROW),
    (r"(?:RNAO?|NAO?|NKXR?|NKIS?|NKS|NK|HK|BK|HN|SCE|BCE|K)\d{2,}", "a needle roller bearing", ONE_ROW),
    (r"QJF?\d{3,}", "a four-point contact ball bearing", FOUR_POINTS),
    (r"(?:UCP|UCF|UC|SB|SA|UK|YAR|YAT|YET|YEL|GRAE|GYE?)\d{3,}", "an insert bearing", BY_HAND),
    (r"(?:LMH?|LME|LBBR|LBCR|KH)\d{1,2}(?:UU|OP|AJ)?$", "a linear ball bearing", ONE_ROW),
    (r"(?:J?[LHM]{1,2})\d{5,6}", "a tapered roller bearing", ONE_ROW),
    (r"C(?:22|23|3[0-2]|4[01])\d{2}", "a toroidal roller bearing", ONE_ROW),
    (r"R\d{1,2}(?![A-Z0-9])", "a deep groove ball bearing of inch size", BY_HAND),
    (r"51\d{3}", "a thrust ball bearing", THRUST),
    (r"(?:52|53|54)\d{3}", "a thrust ball bearing with two rows or spherical washers", THRUST),
    (r"(?:29[234]|8[179]\d)\d{2}", "a thrust roller bearing", ONE_ROW),
    (r"(?:30[23]|31[3]|32[0239]|33[0-2])\d{2}", "a tapered roller bearing", ONE_ROW),
    (r"(?:20[23]|213|22[23]|23[0-289]|24[0189])(?:\d{2}|/\d{3})", "a spherical roller bearing", ONE_ROW),
    (r"112\d{2}(?!\d)|(?:1[023]|2[23])\d{2}(?!\d)", "a self-aligning ball bearing", ONE_ROW),
    (r"(?:3[23]|5[23])\d{2}(?!\d)", "an angular contact ball bearing with two rows", PAIR),
    (r"4[23]\d{2}(?!\d)", "a deep groove ball bearing with two rows", PAIR),
)


@dataclass(frozen=True, kw_only=True)
class Designation:
    """What a designation says."""

    maker: str | None  # None: not named
    name: str  # of the row in the catalogue
    suffixes: tuple[Suffix, ...]  # a prefix is one of them
    unknown: tuple[str, ...]  # parts that are not understood


def plain_name(text: str) -> str:
    """A designation in capitals without spaces, hyphens and points; a slash stays: 60/22 is not 6022."""
    return _FILLER.sub("", text.upper())


def read_designation(text: str, names: Mapping[str, str]) -> Designation | None:
    """What the text says; None if it names no bearing of the catalogue.

    names : from each way to write a number, as `plain_name` gives it, to the name of its row
    Raises InputError if the text is empty or too long, names two makers, or can be read in two ways.
    """
    given = text.strip().upper()
    if not given or len(given) > LONGEST:
        raise InputError(
            f"bearing {text[:LONGEST]!r} has {len(given)} characters; give 1 to {LONGEST}, for example 6206"
        )
    maker, body = read_maker(given)
    body = _HYPHEN_FOR_SLASH.sub(r"\1/\2", body)
    for prefix in ("", *PREFIXES):
        if not body.startswith(prefix):
            continue
        found = _readings(body[len(prefix) :].lstrip(" -/."), names)
        if prefix:
            kind, meaning = PREFIXES[prefix]
            found = [
                (name, [Suffix(text=prefix, kind=kind, meaning=meaning), *known], odd) for name, known, odd in found
            ]
        if len({name for name, _, _ in found}) > 1:
            both = " or ".join(name for name, _, _ in found)
            raise InputError(f"bearing {text!r} can be {both}; put a hyphen between number and suffix")
        if found:
            name, known, unknown = found[0]
            return Designation(maker=maker, name=name, suffixes=tuple(known), unknown=tuple(unknown))
    return None


def begins_as_number(text: str) -> bool:
    """Whether a text, perhaps a path, begins as a designation does: maker, prefix, and a number of two to five digits.

    Raises InputError as `read_maker`.
    """
    prefixes = "|".join(map(re.escape, PREFIXES))
    return re.match(rf"(?:{prefixes})?[\s\-./]*\d{{2,5}}(?!\d)", read_maker(text.strip().upper())[1]) is not None


def read_maker(text: str) -> tuple[str | None, str]:
    """(maker, number and suffixes) of a designation in capitals, without words for its kind.

    The maker is a word anywhere, or letters at an end, or None.
    """
    rest, named = text, set[str]()
    while match := _MAKER_BEFORE.match(rest):
        named.add(match[1])
        rest = rest[match.end() :]
    while match := _MAKER_BEHIND.search(rest):
        named.add(match[1])
        rest = rest[: match.start()]
    while match := _MAKER_INSIDE.search(rest):
        named.add(match[1])
        rest = f"{rest[: match.start()]} {rest[match.end() :]}"
    if len(named) > 1:
        raise InputError(f"bearing {text!r} names two makers, {' and '.join(sorted(named))}; give one")
    return (named.pop() if named else None), _KIND.sub("", rest).strip()


def _readings(body: str, names: Mapping[str, str]) -> list[tuple[str, list[Suffix], list[str]]]:
    """(row, known suffixes, unknown parts) for every way to cut the text into a number and what stands behind it.

    A way that leaves nothing unknown and whose suffixes all describe the bearing goes before one that does not.
    """
    clear, other_balls, doubtful = [], [], []
    for end in range(len(body), 0, -1):
        name = names.get(plain_name(body[:end])) if body[end - 1].isalnum() else None
        if name is None or _CUT_NUMBER.search(body[:end]):
            continue
        rest = body[end:]
        angular = name[0] != "6" and name[:2] != "16"
        known, unknown = read_suffixes(rest, angular=angular)
        behind = _BEHIND_SLASH.match(rest)
        if behind and behind[1] in unknown and begins_with_a_number(behind[1], angular=angular):
            continue  # a bore, as in 628/8ZZ: another bearing
        if any(part.isdigit() for part in unknown):
            continue  # the same, as in 6202/15.875, 6203-12
        cut_inside = rest[:1].isalnum()  # no separator between number and suffix
        if cut_inside and body[end - 1].isalpha() and name[-1] == "R":
            continue  # the letter belongs to a seal, RS or RZ, and not to the number
        first = re.match(r"[A-Z0-9]*", rest)
        if cut_inside and first and first[0] in unknown and (rest[0].isdigit() or body[end - 1].isalpha()):
            continue  # a longer number, or other letters of the contact angle
        refused = any(suffix.kind == "refused" for suffix in known)
        (doubtful if unknown else other_balls if refused else clear).append((name, known, unknown))
    return clear or other_balls or doubtful[:1]


def other_kind(name: str) -> str | None:
    """The kind of bearing and what to give in its place; None for a name that says neither.

    name : in capitals, without maker, spaces, hyphens and points
    """
    for pattern, kind, remedy in _KINDS:
        if re.match(pattern, name):
            return f"is {kind} by its designation; {remedy}"
    return None
