"""Designations as people write them, what their suffixes mean, and those of other kinds of bearings."""

import pytest

from analytic.catalog.bearing_rows import bearing_names, find_bearing
from analytic.catalog.designation import other_kind
from tests.refusals import refused

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
        ("6205 CNL", "CN"),
        ("6205 C2H", "C2"),
        ("6205 P63", "C3"),
        ("6205ZZCM", "CN"),
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
        ("6205 CM", "taken as CN"),
        ("6205 C1", "CN is taken: give the length as bearing.clearance"),
        ("6205 K", "tapered bore"),
        ("W 6205", "stainless steel"),
        ("6205 C2 C4", "C2, C4"),
        ("7205C C3", "deep groove"),
        ("7008C DB", "matched set"),
        ("7208 B", "inner design E"),
    ],
)
def test_what_is_ignored_is_said(text: str, word: str) -> None:
    assert any(word in warning for warning in find_bearing(text).warnings)


@pytest.mark.parametrize(
    ("text", "sign"),
    [
        *(("6205/HC5", "HC5"), ("6205 HC", "HC"), ("HC6205", "HC"), ("HC 6205-2RS/C3", "HC"), ("6205-HYB", "HYB")),
        *(("7014C/HC", "HC"), ("7014C SN24 P4", "SN24"), ("5S-7014C", "5S"), ("HCB7014-C-T-P4S", "HCB")),
        *(("3NC6205", "3NC"), ("XCB 7014 C", "XCB"), ("SNFA EX 25/NS 7CE1", "NS"), ("HY S 6205 C TA", "HY")),
    ],
)
def test_ceramic_balls_are_of_silicon_nitride(text: str, sign: str) -> None:
    bearing = find_bearing(text)
    origin = bearing.origins["ball_material"]
    assert (bearing.ball_material, origin.status) == ("Si3N4", "derived")
    assert origin.source == f"{sign} of the designation"
    assert not any("silicon" in warning or "understood" in warning for warning in bearing.warnings)


@pytest.mark.parametrize(
    "text",
    [
        *("628/8", "628/8-2Z", "628/8ZZ", "W 628/8", "SKF 628/8-2RS1/C3", "638/8", "627/7-2Z", "NTN 628/8ZZ"),
        *("6202/15.875", "6202/15,875-2RS", "6202-2RS/16", "6203-12", "6203 2RS 5/8", "6004/22", "6205/24C3", "607/8"),
    ],
)
def test_a_bore_is_no_suffix(text: str) -> None:
    refused(lambda: find_bearing(text), "is not in the catalogue; nearest: ")


@pytest.mark.parametrize(
    ("text", "bore", "seals"),
    [
        *(("62/28", 28, None), ("60/28-2RS", 28, "2RS"), ("62/22 2Z/C3", 22, "2Z"), ("63/32LLU", 32, "LLU")),
        *(("6205/2RS", 25, "2RS"), ("6205/2ZC3", 25, "2Z"), ("628/2Z", 8, "2Z"), ("6205/5K", 25, None)),
    ],
)
def test_a_number_after_a_slash_may_be_a_bore_of_the_catalogue_or_begin_a_suffix(
    text: str, bore: int, seals: str | None
) -> None:
    bearing = find_bearing(text)
    assert bearing.bore == pytest.approx(bore / 1e3, rel=1e-12)  # a division
    assert [suffix.text for suffix in bearing.seal_suffixes] == ([] if seals is None else [seals])


@pytest.mark.parametrize(
    ("designation", "kind", "remedy"),
    [
        ("nu205", "cylindrical roller", "6205"),
        ("NUP 2208 ECP", "cylindrical roller", "6205"),
        ("22210", "spherical roller", "6205"),
        ("SKF 23040 CC/W33", "spherical roller", "6205"),
        ("51105", "thrust ball", 'kind = "thrust"'),
        ("FAG 52207", "thrust ball bearing with two rows", 'kind = "thrust"'),
        ("29412 E", "thrust roller", "6205"),
        ("1205", "self-aligning ball", "6205"),
        ("2306 ETN9", "self-aligning ball", "6205"),
        ("30205", "tapered roller", "6205"),
        ("32008 X", "tapered roller", "6205"),
        ("LM11949", "tapered roller", "6205"),
        ("NA4900", "needle roller", "6205"),
        ("HK 2016", "needle roller", "6205"),
        ("QJ 208", "four-point contact", "35 deg"),
        ("3205 A", "angular contact ball bearing with two rows", "[arrangement]"),
        ("4206", "deep groove ball bearing with two rows", "ball_count"),
        ("UC205", "insert", "ball_diameter"),
        ("R8", "inch size", "ball_diameter"),
        ("C 2205", "toroidal roller", "6205"),
        ("LM20UU", "linear ball", "6205"),
    ],
)
def test_another_kind_is_named_with_its_remedy(designation: str, kind: str, remedy: str) -> None:
    refused(lambda: find_bearing(designation), repr(designation), kind, remedy)


def test_no_bearing_of_the_catalogue_is_another_kind() -> None:
    plain = [name.replace(" ", "").partition("GMN")[2] or name.replace(" ", "") for name in bearing_names()]
    taken = [name for name in plain if other_kind(name.removeprefix("SNFA")) is not None]
    assert len(plain) > 900
    assert [name for name in taken if name[0] in "67"] == []


@pytest.mark.parametrize("beside", ["DGBB {}", "deep groove ball bearing {}", "{} Rillenkugellager", "Bearing: {}"])
@pytest.mark.parametrize("number", ["6205-2RS C3", "SKF 6205-2RSH/C3"])
def test_words_for_the_kind_say_nothing_more(beside: str, number: str) -> None:
    plain, found = find_bearing(number), find_bearing(beside.format(number))
    assert found == plain
    assert found.clearance_group == "C3"
