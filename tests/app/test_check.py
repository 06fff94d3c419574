"""A check in another process: it reports its progress, ends on request, and leaves no file and no process."""

import os
import time

import pytest

from analytic.scenefile.template import scene_text
from fembearing.app.check import CHECKS, Check

LONGEST = 120.0  # s, for machines that do much else


def until_it_ends(check: Check) -> None:
    begin = time.monotonic()
    while not check.has_ended:
        assert time.monotonic() - begin < LONGEST
        time.sleep(0.05)
        check.look()


def test_a_refused_scene_has_its_reason() -> None:
    check = Check(text=scene_text("6206").replace("1000 rpm", "1000 kg"))
    check.start()
    until_it_ends(check)
    assert check.problem.startswith("scene: operation.inner_speed = '1000 kg'")
    check.close()


def test_a_closed_check_leaves_no_process_and_no_file() -> None:
    check = Check(text=scene_text("6206"))
    check.start()
    assert CHECKS[check.token] is check
    number, room = check._process.pid, check.folder.parent
    begin = time.monotonic()
    while check.share == 0.0 and time.monotonic() - begin < LONGEST:
        time.sleep(0.05)
        check.look()
    assert check.step  # it has said where it is
    check.close()
    with pytest.raises(ProcessLookupError):
        os.kill(number, 0)
    assert not room.exists()
    assert check.token not in CHECKS


def test_a_process_that_dies_is_told() -> None:
    check = Check(text=scene_text("6206"))
    check.start()
    check._process.kill()
    until_it_ends(check)
    assert "ended with status -9; start it again" in check.problem
    check.close()


@pytest.mark.nightly
def test_a_check_writes_the_report() -> None:
    check, shares = Check(text=scene_text("6206")), [0.0]
    check.start()
    while not check.has_ended:
        time.sleep(0.05)
        check.look()
        shares.append(check.share)
    assert check.problem == ""
    assert shares == sorted(shares)
    files = {each.name for each in check.folder.iterdir()}
    assert {"report.html", "report.json", "inner-real-pressure.png"} <= files
    assert check.report is not None
    assert {picture.file for picture in check.report.pictures} <= files
    check.close()
