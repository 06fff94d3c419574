"""What a numerical film is written to: film.json and film.png."""

import json
from pathlib import Path
from typing import Any

from analytic.writing import write
from fembearing.check.film.scene_film import FilmNumbers, RaceFilm
from fembearing.plain_types import document


def write_film(film: RaceFilm, folder: Path) -> None:
    """Write the numbers with the caption of the picture, and the picture, into a folder."""
    from fembearing.check.film.figure import CAPTION
    from fembearing.report.figures.style import png

    write(folder / "film.png", png(film.plot()))
    content = film_content(film.numbers) | {"picture": {"file": "film.png", "caption": CAPTION}}
    write(folder / "film.json", json.dumps(content, indent=1, allow_nan=False).encode())


def film_content(numbers: FilmNumbers) -> dict[str, Any]:
    """What film.json and `film --json` hold, SI."""
    return document("film", numbers)
