"""A figure as a file."""

from io import BytesIO
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DOTS = 192  # per inch: twice those of a screen


def png(figure: "Figure") -> bytes:
    """The figure as a file."""
    return _saved(figure, dpi=DOTS, format="png")


def pdf(figure: "Figure") -> bytes:
    """The figure as a file of lines and letters."""
    return _saved(figure, format="pdf")


def svg(figure: "Figure") -> bytes:
    """The figure as a picture of lines and letters, the same in every run."""
    from matplotlib import rc_context

    with rc_context({"svg.hashsalt": "fembearing"}):
        return _saved(figure, format="svg", metadata={"Date": None})


def _saved(figure: "Figure", **how: Any) -> bytes:
    content = BytesIO()
    figure.savefig(content, **how)
    return content.getvalue()
