"""What a numerical film is written to: film.json and film.png."""

import json
from pathlib import Path

from analytic.writing import write
from fembearing.verify.film.scene_film import RaceFilm


def write_film(film: RaceFilm, folder: Path) -> None:
    """Write the numbers with the caption of the picture, and the picture, into a folder."""
    from fembearing.report.figures.film import CAPTION, film_figure
    from fembearing.report.figures.style import png

    write(folder / "film.png", png(film_figure(film)))
    content = film.to_json() | {"picture": {"file": "film.png", "caption": CAPTION}}
    write(folder / "film.json", json.dumps(content, indent=1, allow_nan=False).encode())
