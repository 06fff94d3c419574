"""A brand of oil or grease leads in one line to what a scene takes in its place."""

import pytest

from analytic import catalog, lubricant
from analytic.scenefile.brand import CLASSES, instead_of_brand
from tests.refusals import refused


@pytest.mark.parametrize(
    ("brand", "words"),
    [
        ("Mobil SHC 626", '"ISO VG 68 PAO"'),
        ("Mobil DTE 25", '"ISO VG 46"'),
        ("Mobil DTE 10 Excel 46", '"ISO VG 46"'),
        ("Mobil DTE Heavy Medium", '"ISO VG 68"'),
        ("Shell Tellus S2 M 46", '"ISO VG 46"'),
        ("shell omala s4 gx 220", '"ISO VG 220"'),
        ("Fuchs Renolin B 15 VG 46", '"ISO VG 46"'),
        ("Mobil Velocite No. 10", '"ISO VG 22"'),  # not class 10
        ("Fuchs Renolin B 15", "is a brand of oil:"),  # of VG 46, which its name does not say
        ("Mobil Glygoyle 22", "is a brand of oil:"),  # far from VG 22
        ("Mobil 1 5W-30", "is a brand of oil:"),
        ("Klübersynth", "is a brand of oil:"),
        ("Klüberspeed BF 72-22", "base oil"),
        ("Isoflex NBU 18", "base oil"),
        ("Shell Gadus S2 V220 2", "base oil"),
        ("LGMT 2", 'supply = "grease"'),
    ],
)
def test_a_brand_leads_to_a_class_or_to_its_data_sheet(brand: str, words: str) -> None:
    refused(lambda: lubricant(brand), "lubricant.name", words, "data sheet")
    if "VG" not in words:
        refused(lambda: lubricant(brand), "... cSt at 40 degC")


def test_the_classes_are_in_the_catalog_and_other_names_are_no_brands() -> None:
    assert instead_of_brand("olive oil") is None
    known = {catalog.find("oils", f"ISO VG {grade}") for grade in CLASSES.values()}
    assert None not in known  # what a message names can be given


@pytest.mark.parametrize("part", ["Isoflex NBU 15", "Klüber Isoflex NBU 15", "isoflex nbu"])
def test_a_part_of_a_listed_name_leads_to_it(part: str) -> None:
    refused(lambda: lubricant(part), repr(part), "give 'Klueber Isoflex NBU15'")


@pytest.mark.parametrize("keys", [{}, {"temperature": "70 degC"}])
def test_a_kinematic_viscosity_beside_a_name_needs_its_temperature(keys: dict[str, str]) -> None:
    refused(lambda: lubricant("vg68", viscosity="46 cSt", **keys), "'46 cSt' has no temperature", '"46 cSt at 40 degC"')
    assert lubricant("vg68", viscosity="46 cSt at 70 C", temperature="70 C").temperature == pytest.approx(343.15)
