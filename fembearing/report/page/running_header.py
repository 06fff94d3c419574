"""The line that stands over every printed page, as texts of a style sheet."""

from typing import NamedTuple

from fembearing.report.report import Report

LONGEST_NAME, LONGEST_DATE = 60, 20  # letters of what the scene says that fit beside the rest
SHORT_HASH, DAY = 12, 10  # letters; the day of a date and time


class RunningHeader(NamedTuple):
    """Its three texts, each as a string of CSS."""

    left: str
    middle: str
    right: str


def header_of(document: Report) -> RunningHeader:
    """Scene, hash and date."""
    origin, details = document.provenance, document.report
    name = origin.scene if len(origin.scene) <= LONGEST_NAME else f"{origin.scene[:LONGEST_NAME]}..."
    revision = f"revision {details.revision[:LONGEST_DATE]}, " if details.revision else ""
    return RunningHeader(
        left=css_string(name),
        middle=css_string(f"SHA-256 {origin.scene_sha256[:SHORT_HASH]}"),
        right=css_string(f"{revision}{details.date[:LONGEST_DATE] if details.date else origin.date[:DAY]}"),
    )


def css_string(text: str) -> str:
    """A text as a string of CSS in which no letter can end the string or the style sheet."""
    letters = (letter if letter.isalnum() or letter == " " else f"\\{ord(letter):x} " for letter in text)
    return f'"{"".join(letters)}"'
