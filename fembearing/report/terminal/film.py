"""The film of a ball on a race for a terminal of 80 characters."""

from rich.console import Console

from fembearing.report.tables.film import film_notes, film_table
from fembearing.report.terminal.table import printed
from fembearing.verify.film.scene_film import FilmNumbers


def print_film(out: Console, film: FilmNumbers) -> None:
    """Print each quantity by formula and by numerical solution."""
    out.print(printed(film_table(film)))
    out.print("\n".join(film_notes(film)) + "\n", style="dim", markup=False)
