"""The torque of ordinary bearings beside makers' formulas: python validation/ordinary/run.py [--out FOLDER]

Each row is one command of fembearing torque, whose result in JSON fills it; ordinary.md goes into this folder. Makers'
formulas are fits to unpublished tests: none is a measured torque of these bearings.
"""

import json
import shlex
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from validation.study import Out, markdown, run, write_text

HERE = Path(__file__).parent
PLAIN = '--speed 1500rpm --oil "ISO VG 46" --temperature 70C'
PAIR = '--set arrangement.kind=O --set "arrangement.preload=300 N"'
CASES = (
    ("6206 radial", f"6206 --radial-load 2kN {PLAIN}"),
    ("6206 radial and axial", f"6206 --radial-load 1kN --axial-load 300N {PLAIN}"),
    ("6204-2RS, sealed", "6204-2RS --speed 10000rpm --radial-load 0.3kN"),
    ("6309 in a motor", "6309 --radial-load 3kN --speed 2900rpm"),
    ("7208B pair", f"7208B --axial-load 2kN --radial-load 2kN --speed 1500rpm {PAIR}"),
    ("7014C pair, spindle", f"7014C --speed 12000rpm --supply grease {PAIR}"),
    ("608", "608 --radial-load 30N --speed 3000rpm"),
    ("51105, thrust", str(HERE / "51105.toml")),
    ("6206 at a cold start", '6206 --radial-load 2kN --speed 1500rpm --oil "ISO VG 68" --temperature=-20C'),
)


def computed(words: str) -> dict[str, Any]:
    """What `fembearing torque ... --json` gives; its status may say that the verdict is not a pass."""
    command = [sys.executable, "-m", "fembearing", "torque", *shlex.split(words), "--json"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if not done.stdout:
        raise RuntimeError(done.stderr)
    return json.loads(done.stdout)


def rows() -> Iterator[tuple[str, ...]]:
    """Of each case its name, torque, interval, makers' torques and verdict."""
    for name, words in CASES:
        found = computed(words)
        point = found["points"][0]
        ends = [point[name] for name in ("interval_low", "interval_high") if point.get(name) is not None]
        interval = " to ".join(f"{1e3 * end:.3g}" for end in ends) or "not known"
        band = (found["makers"] or {}).get("torque") or {}
        held = {maker: value[0] for maker, value in band.items() if value[0] is not None}
        makers = ", ".join(f"{maker} {1e3 * value:.3g}" for maker, value in held.items()) or "no formula"
        yield name, f"{1e3 * point['torque_total']:.3g}", interval, makers, found["standing"]["word"]


def main(out: Out = HERE) -> None:
    write_text(out / "ordinary.md", markdown(("case", "torque, N mm", "95 %", "makers, N mm", "verdict"), rows()))


if __name__ == "__main__":
    run(main)
