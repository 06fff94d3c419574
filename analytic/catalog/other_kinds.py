"""What a designation names that the catalogue does not have: bearings of another kind, by their letters or series.

The series are those of DIN 623-1 and of makers' catalogues, as commonly known; no page was read for them.
"""

import re

ONE_ROW = "fembearing computes ball bearings of one row; give one of those, for example 6205 or 7208B"
BY_HAND = "give its dimensions by hand in [bearing]: ball_count, ball_diameter, pitch_diameter, conformity"
PAIR = f"{BY_HAND} of one row, and an [arrangement] of two"
THRUST = 'the catalogue does not have its balls: give kind = "thrust", ball_count, ball_diameter, pitch_diameter and '
THRUST += "conformity in [bearing], with bore_diameter, outside_diameter and static_load_rating for makers' formulas"
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


def other_kind(name: str) -> str | None:
    """The kind of bearing and what to give in its place; None for a name that says neither.

    name : in capitals, without maker, spaces, hyphens and points
    """
    for pattern, kind, remedy in _KINDS:
        if re.match(pattern, name):
            return f"is {kind} by its designation; {remedy}"
    return None
