"""The lines in which the catalogue describes its oils."""

import pytest

from analytic import catalog


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("NSK MTE", "grease, base oil not known, 23 mm2/s at 40 degC"),
        ("ISO VG 46 mineral", "oil, mineral, 46 mm2/s at"),
    ],
)
def test_of_a_grease_the_oil_is_its_base_oil(name: str, words: str) -> None:
    assert catalog.description("oils", name).startswith(words)
