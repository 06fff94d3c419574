"""The user's own defaults: author, checker and units of every scene that does not say them.

The file is config.toml in the platform's folder for settings, or the one that FEMBEARING_CONFIG names.
"""

import os
import sys
from pathlib import Path
from typing import Any

FILE = "FEMBEARING_CONFIG"  # of the environment
KEYS = ("author", "checker", "units")  # of a scene's [report]


def config_file() -> Path:
    """The file, whether it exists or not."""
    folders = {"darwin": "~/Library/Application Support", "win32": "~/AppData/Roaming"}.get(sys.platform, "~/.config")
    usual = os.path.join(os.environ.get("XDG_CONFIG_HOME") or folders, "fembearing", "config.toml")
    return Path(os.path.expanduser(os.environ.get(FILE) or usual))


def own_details() -> dict[str, Any]:
    """What the file says, by keys of [report]; nothing where there is no file and none is named.

    Raises InputError for a file that cannot be read, an unknown key, and a value that [report] does not take.
    """
    path = config_file()
    if FILE not in os.environ and not path.is_file():
        return {}
    from analytic.errors import InputError
    from analytic.scenefile.keys import scene_key
    from analytic.scenefile.text import parse_text, read_text
    from analytic.words import plain

    origin = plain(str(path))
    details = parse_text(read_text(path, kind="settings", remedy=f"name another in {FILE}"), origin=origin)
    for key, value in details.items():
        if key not in KEYS:
            raise InputError(f"{origin}: {plain(key)} is an unknown key; give {', '.join(KEYS)}")
        scene_key(f"report.{key}").read_as(f"{origin}: {key}", value)
    return details
