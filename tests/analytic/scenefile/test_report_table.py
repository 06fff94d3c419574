"""The table [report]: kept as it is written, refused by its key, and without any effect on numbers."""

from analytic.scene import ReportDetails
from analytic.torque import friction_torque
from fembearing.provenance import provenance_of
from tests.analytic.scenefile.scene_texts import MINE, scene

SIGNED = MINE + '[report]\nauthor = "A. <b>Noether</b>"\nchecker = "E. B."\nrevision = "C"\ndate = "2026-03-01"\n'


def test_names_are_kept_as_they_are_written() -> None:
    assert scene(SIGNED).report == ReportDetails(
        author="A. <b>Noether</b>", checker="E. B.", revision="C", date="2026-03-01"
    )
    assert scene(MINE).report == ReportDetails()
    assert scene(MINE + '[report]\nunits = "inch"\n').report == ReportDetails(units="inch")


def test_a_signature_changes_neither_torque_nor_hash() -> None:
    signed, blank = scene(SIGNED), scene(MINE)
    assert friction_torque(signed).torque.total == friction_torque(blank).torque.total
    first, second = provenance_of(signed), provenance_of(blank)
    assert first.scene_sha256 == second.scene_sha256
    assert "report" not in first.scene_content
