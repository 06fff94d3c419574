"""What to give in place of a maker's brand: the class of ISO 3448 that its name says, or the numbers of its data sheet.

The classes are those that the makers' product data sheets print, as commonly known; none was read for them. No other
property of a brand is known here.
"""

import re

from analytic import catalog

# By the beginning of names with another number than the class, or with none.
CLASSES = {
    **{f"mobildte{number}": grade for number, grade in ((21, 10), (22, 22), (24, 32), (25, 46), (26, 68), (27, 100))},
    "mobildtelight": 32,
    "mobildtemedium": 46,
    "mobildteheavymedium": 68,
    "mobildteheavy": 100,
    **{f"mobilshc{number}": grade for number, grade in ((624, 32), (625, 46), (626, 68), (627, 100), (629, 150))},
    **{f"mobilshc{number}": grade for number, grade in ((630, 220), (632, 320), (634, 460), (636, 680))},
    "mobilvelociteno3": 2,
    "mobilvelociteno6": 10,
    "mobilvelociteno10": 22,
}
OF_PAO = "mobilshc6"
NUMBERED = (  # families whose names end with the class
    *("tellus", "morlina", "omala", "corena", "hyspin", "nutoh", "teresso", "azolla", "randohd", "energolhlp"),
    *("mobilgear600xp", "dte10excel"),
)
OILS = (*NUMBERED, "mobil", "shell", "castrol", "esso", "texaco", "chevron", "fuchs", "total", "aral", "kluber")
GREASES = (
    *(
        "isoflex",
        "gadus",
        "lgmt",
        "lgep",
        "lghp",
        "lglt",
        "lgwa",
        "lgev",
        "lgem",
        "lget",
        "lgfp",
        "polyrex",
        "mobilith",
    ),
    *("mobilux", "mobilgrease", "alvania", "multemp", "krytox", "arcanol", "asonic", "barrierta", "kluberquiet"),
    *("kluberplex", "kluberspeed", "turmogrease", "beacon", "petamo"),
)
# Oils of one grade of SAE J300 and J306, with the class of ISO 3448 that has about their viscosity at 40 degC.
SAE = {"10": 32, "10w": 32, "20": 68, "30": 100, "40": 150, "50": 220, "90": 220, "140": 460}
ONE_GRADE = re.compile(r"sae(\d+w?)")  # without spaces and hyphens
TWO_GRADES = re.compile(r"(?:sae)?\d+w\d+")
SHORTEST = 5  # letters and digits of a part of a name of the catalog
BY_SHEET = 'viscosity = ["... cSt at 40 degC", "... cSt at 100 degC"] and base_oil = "mineral", "PAO" or another'


def instead_of_brand(given: str) -> str | None:
    """What to give for this name; None: it is no brand that is known here."""
    whole = catalog.spelling(given.casefold().replace("ü", "ue"))
    listed = [each for each in catalog.oil_names() if len(whole) > SHORTEST and whole in catalog.spelling(each)]
    if listed:
        return f"is listed by another name: give {' or '.join(map(repr, listed))}"
    name = re.sub(r"[\W_]", "", given.casefold()).replace("ü", "u").replace("klue", "klu")
    if (one := ONE_GRADE.fullmatch(name)) and one[1] in SAE:
        near = f"ISO VG {SAE[one[1]]}"
        return f'is a grade of SAE near {near}: give "{near}", or, from its data sheet, {BY_SHEET}'
    if TWO_GRADES.fullmatch(name):
        return f"is a multigrade of SAE, which no class of ISO VG replaces: give, from its data sheet, {BY_SHEET}"
    if any(brand in name for brand in GREASES):
        return f'is a brand of grease: give, from its data sheet, {BY_SHEET} of its base oil, and supply = "grease"'
    if name.endswith("grease"):
        return f'is not an oil: give, from its data sheet, {BY_SHEET} of its base oil, and supply = "grease"'
    if not any(brand in name for brand in OILS):
        return None
    grade = _class_of(name)
    if grade is None:
        return f"is a brand of oil: give, from its data sheet, {BY_SHEET}"
    kind = " PAO" if name.startswith(OF_PAO) else ""
    return f'is a brand of ISO VG {grade}: give "ISO VG {grade}{kind}", or, from its data sheet, {BY_SHEET}'


def _class_of(name: str) -> int | None:
    for brand, grade in CLASSES.items():
        if re.match(rf"{brand}(?!\d)", name):
            return grade
    number = re.search(r"vg(\d+)", name)
    if number is None and any(family in name for family in NUMBERED):
        number = re.search(r"(?<!\d)(22|32|46|68|100|150|220|320|460|680)$", name)
    return None if number is None else int(number[1])
