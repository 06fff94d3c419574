"""Which scene a name means: a file, a scene that ships with the package, or a bearing of the catalogue."""

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from analytic import catalog
from analytic.catalog.bearing_rows import CatalogBearing, find_bearing
from analytic.catalog.designation import begins_as_number
from analytic.errors import InputError
from analytic.scenefile.text import parse_text, read_text
from analytic.words import plain, shown

LONGEST_NAME = 60  # characters of a designation
# What a name ends with that is a file, among them slips of the keyboard: a point also stands in front of a suffix.
EXTENSIONS = (
    *(".toml", ".tml", ".tom", ".tmol", ".txt", ".json", ".yaml", ".yml"),
    *(".ini", ".cfg", ".csv", ".html", ".md"),
)


@dataclass(frozen=True, kw_only=True, eq=False)
class FoundScene:
    """The document of a scene, before it is read; that of a bearing of the catalogue is empty."""

    document: dict[str, Any]
    origin: str  # names it in messages
    folder: Path  # that the paths in the text start from
    bearing: CatalogBearing | None = None  # of the catalogue, whose usual scene it is
    designation: str = ""  # as it was given


def find_scene(name: str | os.PathLike[str], *, folder: Path = Path()) -> FoundScene:
    """The scene that a name means.

    folder : that a relative path starts from

    A file that exists comes first, then a built-in scene, then a bearing of the catalogue, whose scene is the one that
    `fembearing init` writes. A name that ends like one of a file, with .toml or .txt, is a file.
    Raises InputError for a name that is none of these, and for a file that is not TOML.
    """
    if isinstance(name, int | float):  # a designation from Python without its quotes
        raise InputError(f'{name} is a number, not the name of a bearing or a file; write it in quotes: "{name}"')
    if not isinstance(name, str | os.PathLike):
        raise InputError(
            f'{shown(name)} is not the name of a bearing or a file, nor a Scene; give one, for example "6206"'
        )
    given = os.fspath(name)
    path, builtin = folder / given, catalog.names("scenes")
    known = f"built in: {', '.join(builtin)}"
    if given in builtin and not os.path.isfile(path):
        path = catalog.path("scenes", given)
    elif not os.path.isfile(path) and _may_be_a_bearing(given):
        try:
            return FoundScene(
                document={},
                origin=f"scene of {given}",
                folder=folder,
                bearing=find_bearing(given),
                designation=given,
            )
        except InputError as problem:
            if os.path.basename(given) == given or (not path.parent.is_dir() and begins_as_number(given)):
                raise InputError(f"{problem} (no scene file has this name either, nor a scene {known})") from None
    text = read_text(path, kind="scene", remedy=f"give the path of a scene file ({known}), or a bearing as 6206")
    origin = plain(os.fspath(path))
    return FoundScene(document=parse_text(text, origin=origin), origin=origin, folder=path.parent)


def _may_be_a_bearing(name: str) -> bool:
    return 0 < len(name) <= LONGEST_NAME and name.isprintable() and not name.lower().endswith(EXTENSIONS)
