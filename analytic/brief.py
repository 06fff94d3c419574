"""Nouns and results that show themselves in one line, or as a table in a notebook."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields
from html import escape
from typing import Any

import numpy as np

LONGEST = 100  # characters of a line
PLAIN = (bool, int, str, float)


class Brief:
    """A base of dataclasses whose `repr` is one line: the name of the class, and what identifies the object."""

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()  # of Generic, which notes the parameters
        cls.__repr__ = Brief.__repr__  # in the class itself, so that @dataclass writes no other

    def _facts(self) -> Iterator[str]:
        """What identifies the object: its words and numbers, and of an array its least and largest value."""
        for field in fields(self):  # pyright: ignore[reportArgumentType]
            value = getattr(self, field.name)
            if isinstance(value, np.ndarray):
                yield f"{field.name}={span(value)}"
            elif isinstance(value, PLAIN) and value != field.default:
                yield f"{field.name}={value if isinstance(value, bool | int | str) else format(value, '.5g')}"

    def __repr__(self) -> str:
        name = type(self).__name__
        line = f"{name}({' '.join(', '.join(self._facts()).split())})"
        return line if len(line) <= LONGEST else f"{line[: LONGEST - 4]}...)"


def span(values: Any, factor: float = 1.0) -> str:
    """The least and the largest of some numbers, or the one that all are; of others how many."""
    known = np.asarray(values)
    if known.dtype.kind not in "fiu" or not known.size:
        return f"{known.size} values"
    low, high = (f"{float(end) * factor:.4g}" for end in (np.min(known), np.max(known)))
    return low if low == high else f"{low} to {high}"


def points_of(series: Mapping[str, Any]) -> str:
    """The operating points of a series in words: how many, their speeds and the loads that are not 0.

    series : inner_speed, rad/s; axial_load, radial_load, N; moment, N m
    """
    count = max(np.size(values) for values in series.values())
    loads = (("axial_load", "N axial"), ("radial_load", "N radial"), ("moment", "N m"))
    words = [f"{span(series[name])} {unit}" for name, unit in loads if np.any(series[name])]
    speed = f"{span(series['inner_speed'], 30 / np.pi)} rpm"
    return ", ".join([f"{count} point{'' if count == 1 else 's'}", speed, *words])


def html_table(head: Sequence[str], rows: Sequence[Sequence[str]], caption: str, notes: Sequence[str] = ()) -> str:
    """Rows of text as an HTML table;  notes : sentences below it"""

    def row(cells: Sequence[str], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{escape(cell)}</{tag}>" for cell in cells) + "</tr>"

    body = "".join(row(cells, "td") for cells in rows)
    below = "".join(f"<p>{escape(note)}</p>" for note in notes)
    heads = f"<caption>{escape(caption)}</caption><thead>{row(head, 'th')}</thead>"
    return f"<table>{heads}<tbody>{body}</tbody></table>{below}"
