"""The comparison with measured torques: its arithmetic by hand, and the sentences that quote it."""

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
    assert all(each < 0 for each in relative)
    low, high = min(map(abs, relative)), max(map(abs, relative))
    assert f"{low:.0f} to {high:.0f} %" == MEASURED_RANGE
    assert MEASURED_RANGE in MEASURED
    for file in (
        "README.md",
        "docs/measured.md",
        "docs/limits.md",
        "docs/validation.md",
        "validation/measured/measured.md",
    ):
        assert MEASURED_RANGE in (ROOT / file).read_text(encoding="utf-8"), file
