"""Every hard case: right, refused or wrong. python -m validation.hard.run [--write]"""

import json
import sys
from collections import Counter
from datetime import UTC, datetime
from importlib.metadata import version
from typing import Annotated

import typer
from rich.progress import track

from analytic.torque import MODEL_VERSION
from fembearing.check.hard_record import RECORD
from fembearing.plain_types import plain
from validation.hard.table import HARD_CASES, outcome_of
from validation.study import out, progress, run


def main(
    write: Annotated[bool, typer.Option("--write", help=f"Store {RECORD.name}, which reports cite.")] = False,
) -> None:
    """Print every case, and the counts; the status is 1 where one is wrong."""
    outcomes = [outcome_of(case) for case in track(HARD_CASES, "hard cases", console=progress)]
    for each in outcomes:
        words = f"{each.outcome:8}{each.case}" + (f": {each.detail}" if each.outcome == "wrong" else "")
        out.print(words, soft_wrap=True)
    count = Counter(each.outcome for each in outcomes)
    out.print(
        f"{len(outcomes)} hard cases: {count['right']} right, {count['refused']} refused as they should be, "
        f"{count['wrong']} wrong"
    )
    if write:
        record = {
            "date": f"{datetime.now(UTC):%Y-%m-%d}",
            "fembearing": version("fembearing"),
            "model_version": MODEL_VERSION,
            "outcomes": plain(outcomes),
        }
        RECORD.write_text(json.dumps(record, indent=1) + "\n", "utf-8")
    sys.exit(int(count["wrong"] > 0))


if __name__ == "__main__":
    run(main)
