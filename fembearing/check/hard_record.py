"""The record of the last run of the hard cases (`validation/hard`), which ships with the package."""

import json
from collections import Counter
from dataclasses import dataclass
from functools import cache
from pathlib import Path

RECORD = Path(__file__).with_name("hard_cases.json")


@dataclass(frozen=True, kw_only=True)
class HardRecord:
    """How many hard cases ended in which way, and when."""

    date: str  # of the run, year-month-day
    fembearing: str  # version
    model_version: int  # number of the model version
    right: int  # count of cases
    refused: int  # count of cases, refused as they should be
    wrong: int  # count of cases


@cache
def last_run() -> HardRecord:
    """The record that ships with this version."""
    content = json.loads(RECORD.read_text("utf-8"))
    count = Counter(each["outcome"] for each in content.pop("outcomes"))
    return HardRecord(right=count["right"], refused=count["refused"], wrong=count["wrong"], **content)
