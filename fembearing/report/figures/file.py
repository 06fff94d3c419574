"""A figure as a file."""

from io import BytesIO

from matplotlib.figure import Figure

DOTS = 110  # per inch


def png(figure: Figure) -> bytes:
    """The figure as a file."""
    content = BytesIO()
    figure.savefig(content, dpi=DOTS, format="png")
    return content.getvalue()
