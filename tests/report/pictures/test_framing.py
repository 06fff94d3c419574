"""Where a contact lies in its picture: sizes worked out by hand from the room that is kept around it."""

import pytest

from fembearing.report.pictures.framing import frame_of, round_length


@pytest.mark.parametrize(
    ("rolling", "transverse", "expected"),
    [
        # Long: 1400 pixels hold 2.6 semi-axes of 2 mm; 3.4 of 0.21 mm are then 192 high, between 76 and 120 pixels.
        (0.21e-3, 2e-3, (1400 / 5.2e-3, 1400, 76 + 192 + 120, 76 + 96, False, 5e-4)),
        # Rounder: 640 pixels hold 3.4 semi-axes of 0.4 mm; 2.6 of 0.9 mm are then 1101 wide.
        (0.9e-3, 0.4e-3, (640 / 1.36e-3, 1101, 76 + 640 + 120, 76 + 320, True, 5e-4)),
        # Nearly round: 2.6 semi-axes of 0.041 mm are 533 wide, less than title and colours need.
        (0.041e-3, 0.04e-3, (640 / 0.136e-3, 760, 76 + 640 + 120, 76 + 320, True, 5e-5)),
        # Round but for less than a thousandth: as if it were longer across.
        (0.0400001e-3, 0.04e-3, (640 / 0.136e-3, 760, 76 + 640 + 120, 76 + 320, False, 5e-5)),
    ],
)
def test_a_frame_is_as_large_as_the_room_around_its_contact(
    rolling: float, transverse: float, expected: tuple[float, int, int, float, bool, float]
) -> None:
    frame = frame_of(semi_axis_rolling=rolling, semi_axis_transverse=transverse)
    scale, width, height, top, horizontal, bar = expected
    assert (frame.width, frame.height, frame.centre) == (width, height, (width / 2, top))
    assert frame.rolling_is_horizontal == horizontal
    # sums of a few roundings; the bar is the longest round one within 260 pixels
    assert (frame.scale, frame.bar) == (pytest.approx(scale, rel=1e-12), pytest.approx(bar, rel=1e-12))


@pytest.mark.parametrize(
    ("most", "expected"), [(0.3, 0.2), (7e-5, 5e-5), (19.0, 10.0), (2.0, 2.0), (4.99e3, 2e3), (50.0, 50.0)]
)
def test_a_round_length_is_the_longest_that_fits(most: float, expected: float) -> None:
    assert round_length(most) == pytest.approx(expected, rel=1e-12)  # powers of ten are rounded
