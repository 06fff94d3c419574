"""Designations as people write them, and what their suffixes mean."""

import pytest

from analytic.catalog.bearing_rows import find_bearing

SPELLINGS = {
    "NSK 6206": ("NSK 6206-2RS/C3", "6206-2RS1/C3 NSK explorer", "6206 nsk/C3"),
    "6206": ("6206", " 6206 ", "6206-", "6206/"),
    "NSK 6310": ("NSK 6310", "6310 NSK", "nsk6310", "Nsk-6310", "6310 (NSK)", "NSK 6310 NSK"),
    "6804": ("6804", "61804", "61804-2RS1"),
    "6905": ("6905", "61905", "61905 2RZ"),
    "16010": ("16010", "16010-2Z", "16010/c3"),
    "62/28": ("62/28", "62-28", "62/28-2RS", "62/28 C3"),
    "608": ("608", "608-2Z", "6082RS", "608ZZ", "608/C3"),
    "6230": ("6230", "62302RS", "6230-C3"),
    "6205R": ("6205R", "6205R-2RS"),
    "6205": ("6205", "6205RS", "6205RZ", "6205-RZ", "6205 RS1"),
    "7208 BEP": ("7208 BEP", "7208BEP", "7208-BE-P", "7208 BECBP", "7208becbm"),
    "7008C": ("7008C", "7008 C", "7008C DB", "7008CTYNDBLP4", "7008-C"),
    "7210A5": ("7210A5", "7210 A5 TR", "7210a5su"),
    "7210A": ("7210A", "7210 A", "7210AM"),
    "GMN S 6205 C TA": ("GMN S 6205 C TA", "gmn s6205cta", "S 6205 C TA GMN", "GMN S6205-C-TA P4"),
    "SNFA EX 25": ("SNFA EX 25", "snfa ex25", "EX 25", "SNFA EX 25 7CE1"),
    "SNFA E 200/100": ("SNFA E 200/100", "E200/100"),
}


@pytest.mark.parametrize(
    ("expected", "text"), [(name, text) for name, texts in SPELLINGS.items() for text in texts], ids=str
)
def test_one_bearing_has_many_spellings(expected: str, text: str) -> None:
    assert find_bearing(text).designation == expected


@pytest.mark.parametrize(
    ("text", "group"),
    [
        ("6205", None),
        ("6205/C3", "C3"),
        ("6205-2RSC3", "C3"),
        ("6205 2Z C2", "C2"),
        ("6205ZZ-C4", "C4"),
        ("6205 C5", "C5"),
        ("6205 CN", "CN"),
        ("6205 CNL", "CN"),
        ("6205 C2H", "C2"),
        ("6205 P63", "C3"),
        ("6205 P5", None),
        ("6205ZZCM", "CN"),
        ("7205C", None),
        ("7205C C3", None),
    ],
)
def test_the_suffix_names_the_clearance_group(text: str, group: str | None) -> None:
    assert find_bearing(text).clearance_group == group


@pytest.mark.parametrize(
    ("suffixes", "rubs", "sides"),
    [
        ("2RS1 2RSH 2RSR DDU LLU 2RSL DDW LLH", True, "both sides"),
        ("RS", True, "one side"),
        ("2RZ VV LLB ZZ 2Z", False, "both sides"),
        ("RZ Z", False, "one side"),
    ],
)
def test_seals_and_shields(suffixes: str, rubs: bool, sides: str) -> None:
    for suffix in suffixes.split():
        seals = find_bearing(f"6207-{suffix}").seals
        assert seals is not None, suffix
        assert ("rubs" in seals, sides in seals) == (rubs, True), suffix
        assert find_bearing(f"6207{suffix}").seals == seals  # the same without a hyphen


@pytest.mark.parametrize("suffix", ["TN9", "M", "MA", "J", "TVP", "TVH", "P6", "P5", "N", "NR", "S1", "VL0241", "Q6"])
def test_cages_precision_and_others_are_understood_and_change_nothing(suffix: str) -> None:
    plain, bearing = find_bearing("6312"), find_bearing(f"6312 {suffix}")
    assert suffix in bearing.suffixes
    assert (bearing.ball_count, bearing.ball_diameter, bearing.warnings) == (
        plain.ball_count,
        plain.ball_diameter,
        plain.warnings,
    )


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("6205 QXJ77", "QXJ77: suffix not understood"),
        ("6205 XYZ", "XYZ: suffix not understood"),
        ("6205 CM", "taken as CN"),
        ("6205 C1", "CN is taken: give the length as bearing.clearance"),
        ("7205C C1", "follows from the contact angle"),
        ("6205 K", "tapered bore"),
        ("6205/HC5", "bearing.ball_material"),
        ("W 6205", "stainless steel"),
        ("6205 C2 C4", "C2, C4"),
        ("7205C C3", "deep groove"),
        ("7008C DB", "matched set"),
        ("7208 B", "inner design E"),
    ],
)
def test_what_is_ignored_is_said(text: str, word: str) -> None:
    assert any(word in warning for warning in find_bearing(text).warnings)


def test_every_suffix_of_a_long_designation_is_explained() -> None:
    bearing = find_bearing("SKF 6205-2RSH/C3GJN TN9")
    assert {"2RSH", "TN9"} <= bearing.suffixes.keys()
    assert bearing.designation == "SKF 6205"
