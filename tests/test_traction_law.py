"""The example of an own law of traction, as a user installs and runs it."""

import json
import os
import subprocess
import sys
from pathlib import Path

from tests.traction_packages import EXAMPLE, install_example

ROOT = Path(__file__).resolve().parents[1]
SQUALANE = str(EXAMPLE / "squalane.toml")


def torque(folder: Path, *options: str) -> subprocess.CompletedProcess[str]:
    """`fembearing torque` of the example's scene, in a process that finds the packages of a folder."""
    paths = os.pathsep.join(filter(None, (str(folder), str(ROOT), os.environ.get("PYTHONPATH"))))
    return subprocess.run(
        [sys.executable, "-m", "fembearing", "torque", SQUALANE, *options],
        env=os.environ | {"PYTHONPATH": paths},
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )


def test_the_example_computes_with_its_law_and_names_it(command, tmp_path: Path) -> None:
    install_example(tmp_path)
    done = torque(tmp_path, "--details", "--out", "own.json")
    assert done.returncode == 0, done.stderr
    assert "Law of traction: carreau-squalane of carreau-law 0.1.0, SHA-256" in " ".join(done.stdout.split())
    other = ("--set", "lubricant.traction=eyring_sinh", "--out", str(tmp_path / "eyring.json"))
    assert command("torque", SQUALANE, *other).status == 0
    found, eyring = (json.loads((tmp_path / f"{name}.json").read_text("utf-8")) for name in ("own", "eyring"))
    law = found["run"]["scene_content"]["lubricant"]["traction"]
    assert law.keys() == {"name", "sha256", "distribution", "version"}
    assert (law["name"], law["distribution"], law["version"]) == ("carreau-squalane", "carreau-law", "0.1.0")
    words = f"carreau-squalane of carreau-law 0.1.0, SHA-256 {law['sha256'][:12]}"
    assert found["provenance"]["traction"] == words
    assert found["run"]["scene_sha256"] != eyring["run"]["scene_sha256"]
    totals = [one["points"][0]["torque_total"] for one in (found, eyring)]
    assert abs(totals[0] / totals[1] - 1) > 1e-3


def test_without_the_package_its_law_is_refused_in_one_line(command) -> None:
    done = command("torque", SQUALANE)
    assert (done.status, done.out) == (2, "")
    assert "lubricant.traction = 'carreau-squalane' is not a law of traction" in done.err
    assert len(done.err.strip().splitlines()) == 1
