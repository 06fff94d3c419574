"""Sentences that quote the comparison with measured torques."""

import csv
from pathlib import Path

from fembearing.report.phrases import MEASURED, MEASURED_RANGE

ROOT = Path(__file__).resolve().parents[2]


def test_the_sentences_quote_the_report() -> None:
    """The range of E/D in README, the report and docs is that of validation/measured/measured.csv."""
    with (ROOT / "validation" / "measured" / "measured.csv").open(encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["rpm"].isdigit()]
    relative = [100 * float(row["E_over_D"]) for row in rows if row["ball_diameter_mm"] in ("3", "6.35")]
    assert len(relative) == 12
    low, high = min(relative), max(relative)
    assert low < 0 < high
    assert f"{-low:.0f} % too low to {high:.0f} % too high" == MEASURED_RANGE
    assert MEASURED_RANGE in MEASURED
    for file in (
        "README.md",
        "docs/measured.md",
        "docs/limits.md",
        "docs/validation.md",
    ):
        assert MEASURED_RANGE in (ROOT / file).read_text(encoding="utf-8"), file
