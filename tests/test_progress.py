"""Progress of a part of the work, as a share of the whole."""

import pytest

from analytic.progress import part_of


def test_a_part_runs_from_its_begin_to_its_end_also_within_a_part() -> None:
    seen: list[tuple[float, str]] = []
    half = part_of(lambda share, step: seen.append((share, step)), 0.5, 0.9)
    fifth = part_of(half, 0.2, 0.4)
    for share in (0.0, 0.25, 1.0):
        fifth(share, f"at {share}")
    assert [step for _, step in seen] == ["at 0.0", "at 0.25", "at 1.0"]
    assert [share for share, _ in seen] == pytest.approx([0.58, 0.6, 0.66])  # 0.5 + 0.4 (0.2 + 0.2 share)
