"""Every hard case: right, refused or wrong. python -m validation.hard.run [--write]

--write stores the record that reports cite, fembearing/check/hard_cases.json.
"""

import argparse
import json
from collections import Counter
from datetime import UTC, datetime
from importlib.metadata import version

from rich.console import Console
from rich.progress import track

from analytic.torque import MODEL_VERSION
from fembearing.check.hard_record import RECORD
from fembearing.plain_types import plain
from validation.hard.case import outcome_of
from validation.hard.table import HARD_CASES


def main() -> int:
    """Print every case, and the counts; the status is 1 where one is wrong."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true", help="store the record that reports cite")
    write = parser.parse_args().write
    progress = Console(stderr=True)
    outcomes = [outcome_of(case) for case in track(HARD_CASES, "hard cases", console=progress)]
    out = Console(highlight=False, soft_wrap=True, markup=False)
    for each in outcomes:
        out.print(f"{each.outcome:8}{each.case}" + (f": {each.detail}" if each.outcome == "wrong" else ""))
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
    return int(count["wrong"] > 0)


if __name__ == "__main__":
    raise SystemExit(main())
