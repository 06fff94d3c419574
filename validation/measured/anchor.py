"""Numbers that the model is compared with, beside its own: what they are, table and figure."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from analytic.scene import Array
from validation.study import Row, figure, markdown, numbers, published, read, save, write

COLOURS = {"measured": "C0", "second hand": "C2", "maker's formula": "C1", "formula": "0.5", "trend": "C4"}
HEADS = ("what", "from", "kind", "theirs", "ours", "E, %", "u_val, %", "beyond 2 u_val", "what it is worth")
RANGES = [f"{name}_{end}" for name in ("theirs", "ours", "E_percent", "u_val_percent") for end in ("low", "high")]
COLUMNS = ("what", "source", "kind", "unit", "points", *RANGES, "beyond_2_u_val", "worth")


@cache
def _words() -> dict[str, Row]:
    return {row.pop("key"): row for row in read(Path(__file__).with_name("compared.csv"))}


@dataclass(frozen=True, kw_only=True, eq=False)
class Anchor:
    """Points of one source; theirs, ours and uncertainty broadcast, in the unit shown."""

    what: str
    source: str
    kind: str
    unit: str
    worth: str  # what the comparison is worth
    theirs: ArrayLike  # D
    ours: ArrayLike  # S
    uncertainty: ArrayLike | None  # u_val, standard; None: none can be stated

    @property
    def error(self) -> Array:
        """E over D, at every point that both have."""
        ratio = np.ravel(np.asarray(self.ours) / np.asarray(self.theirs)) - 1
        return ratio[np.isfinite(ratio)]

    @property
    def relative_uncertainty(self) -> Array | None:
        """u_val over D."""
        if self.uncertainty is None:
            return None
        return np.ravel(np.broadcast_to(np.asarray(self.uncertainty) / np.asarray(self.theirs), np.shape(self.ours)))

    @property
    def missed(self) -> int | None:
        """Points with abs(E) above 2 u_val; None without u_val."""
        uncertainty = self.relative_uncertainty
        return None if uncertainty is None else int(np.sum(np.abs(self.error) > 2 * uncertainty))

    @property
    def place(self) -> tuple[int, float]:
        """In the table: those beyond 2 u_val, those without u_val from the largest ratio on, and those that hold."""
        group = 1 if self.missed is None else 0 if self.missed else 2
        return group, -float(np.max(np.abs(np.log1p(self.error))))


def anchor(
    key: str, *, theirs: ArrayLike, ours: ArrayLike, uncertainty: ArrayLike | None = None, **words: object
) -> Anchor:
    """A row of compared.csv with its numbers; words : for the braces in it"""
    told = {name: text.format(**words) for name, text in _words()[key].items()}
    return Anchor(**told, theirs=theirs, ours=ours, uncertainty=uncertainty)


def published_columns(name: str) -> dict[str, Array]:
    """The columns of a file of numbers alone, NaN where a cell is empty."""
    rows = published(name)
    return {key: numbers(rows, key) for key in rows[0]}


def anchors_page(anchors: Sequence[Anchor]) -> Iterator[str]:
    """anchors.md, in Markdown; every number in it is computed."""
    yield from ("# All anchors", "")
    yield (
        "Ranges over the points of a source, E = ours - theirs over theirs, u_val standard. First what is missed by "
        "more than 2 u_val; then what has no stated uncertainty, from the largest ratio on; then what is within. "
        "Q D: load times ball diameter. Nothing is fitted to what it is compared with here, and none of these "
        "comparisons validates the torque of a whole bearing."
    )
    yield ""
    yield from markdown(HEADS, map(_cells, anchors))
    yield from ("", "![Ours over theirs for every number that the model is compared with](anchors.png)")


def _cells(each: Anchor) -> tuple[str, ...]:
    unit = "" if each.unit == "1" else f" {each.unit}"
    error, u_val = 100 * each.error, each.relative_uncertainty
    judged = ("-", "-") if u_val is None else (_ends(100 * u_val, ".1f"), f"{each.missed} of {error.size}")
    values = f"{_ends(each.theirs)}{unit}", f"{_ends(each.ours)}{unit}", _ends(error, "+.1f")
    return each.what, each.source, each.kind, *values, *judged, each.worth


def _ends(values: ArrayLike, form: str = ".4g") -> str:
    return " to ".join(dict.fromkeys(f"{end:{form}}" for end in (np.nanmin(values), np.nanmax(values))))


def write_anchors(anchors: Iterable[Anchor], path: Path) -> None:
    """One row for each anchor; ranges over its points, E and u_val over theirs."""
    rows = []
    for each in anchors:
        u_val = each.relative_uncertainty
        found = [each.theirs, each.ours, 100 * each.error] + ([] if u_val is None else [100 * u_val])
        ends = (float(end) for values in found for end in (np.nanmin(values), np.nanmax(values)))
        row = {name: getattr(each, name) for name in ("what", "source", "kind", "unit", "worth")}
        row |= {"points": each.error.size, **dict(zip(RANGES, ends, strict=False)), "beyond_2_u_val": each.missed}
        rows.append(row)
    write(rows, path, COLUMNS, form=".4g")


def draw_anchors(anchors: Sequence[Anchor], path: Path) -> None:
    drawn = figure(11, 14)
    axes = drawn.subplots()
    for place, each in enumerate(reversed(anchors)):
        ratio, u_val = 1 + each.error, each.relative_uncertainty
        if u_val is not None:
            axes.barh(place, 4 * u_val.max(), left=1 - 2 * u_val.max(), height=0.8, color="0.88")
        axes.plot([ratio.min(), ratio.max()], [place] * 2, "|-", color=COLOURS[each.kind], lw=3, solid_capstyle="butt")
        if each.missed:
            axes.plot(ratio[np.argmax(np.abs(each.error))], place, "kx", ms=7)
    names = [f"{each.what}\n{each.source} ({each.kind})" for each in reversed(anchors)]
    axes.set_yticks(range(len(anchors)), names, fontsize=6)
    axes.set_ylim(-0.7, len(anchors) - 0.3)
    axes.axvline(1, color="k", lw=0.8)
    ticks = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5]
    axes.set(xscale="log", xlabel="ours over theirs; grey: 2 u_val; cross: missed")
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.minorticks_off()
    axes.grid(visible=True, axis="x", color="0.9")
    axes.set_axisbelow(True)
    save(drawn, path, dpi=110)
