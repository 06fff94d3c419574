"""The pictures that the pages show of their own commands: `python docs/page_pictures.py [PAGE ...]` makes them again.

It runs the commands of a page in an empty folder, as the tests do, and copies what they wrote into docs/pictures.
"""

import sys
import tempfile
from pathlib import Path

from PIL import Image

DOCS = Path(__file__).resolve().parent
sys.path.insert(0, str(DOCS.parent))  # tests.executed_pages

PICTURES: dict[str, dict[str, str]] = {  # of a page: what its commands write, and its name in docs/pictures
    "how-to/bearing.md": {"drawing-of-my-6305.svg": "drawing-6305.svg"},
    "how-to/cage.md": {"motion-of-my-cage/1-cage-forces.png": "cage-forces.png"},
    "how-to/compare-with-measurements.md": {"comparison/compare.png": "compare-3mm.png"},
    "how-to/duty-cycle.md": {"losses/duty.png": "duty-6206.png"},
    "how-to/loads.md": {"loads.svg": "torque-loads.svg"},
    "how-to/oil.md": {"data_sheet.svg": "torque-data-sheet.svg"},
    "how-to/roughness.md": {"profile.svg": "torque-profile.svg"},
    "tutorials/contact.md": {"pressure.svg": "contact-pressure.svg"},
    "tutorials/film.md": {"film-of-the-inner-race/film.png": "6205-inner-film.png"},
    "tutorials/friction.md": {"friction-of-my-bearing/inner-creep.png": "6205-inner-creep.png"},
    "tutorials/map.md": {"map-of-my-bearing/maps/torque_total.png": "map-6206.png"},
    "tutorials/report.md": {
        "drawing-of-6206.svg": "drawing-6206.svg",
        "torque-of-my-bearing/interval.png": "interval-6206.png",
    },
    "tutorials/torque.md": {"torque-of-6206.png": "torque-over-speed.png"},
}


def _copy(made: Path, kept: Path) -> None:
    """A PNG with 256 colours, which are enough on a page and a third of the size; any other file as it is."""
    if made.suffix != ".png":
        kept.write_bytes(made.read_bytes())
        return
    with Image.open(made) as picture:
        picture.convert("RGB").quantize(256).save(kept, optimize=True)


def main(pages: list[str]) -> None:
    from tests.executed_pages import run_in

    for page in pages or PICTURES:
        with tempfile.TemporaryDirectory() as folder:
            list(run_in(Path(folder), DOCS / page))
            for made, name in PICTURES[page].items():
                _copy(Path(folder) / made, DOCS / "pictures" / name)


if __name__ == "__main__":
    main(sys.argv[1:])
