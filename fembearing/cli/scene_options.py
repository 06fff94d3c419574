"""The options that say what the scene of a bearing of the catalogue has, and the one that sets any key of a scene."""

from typing import Annotated, Any

import typer

from analytic.scenefile.choice import USUAL
from fembearing.cli.added_options import given

OPTIONS: dict[str, Any] = {  # by the fields of a choice
    "axial_load": Annotated[str | None, typer.Option(help='Axial load, for example "500 N".')],
    "radial_load": Annotated[
        str | None,
        typer.Option(help='Radial load, for example "5 kN" (default without any load: a light load for the bearing).'),
    ],
    "speed": Annotated[str | None, typer.Option(help=f"Speed of the inner ring (default: {USUAL.speed}).")],
    "oil": Annotated[
        str | None,
        typer.Option(help="Name of the oil, see `fembearing list oils` (default: by size, speed and temperature)."),
    ],
    "temperature": Annotated[str | None, typer.Option(help=f"Oil temperature (default: {USUAL.temperature}).")],
    "supply": Annotated[
        str | None,
        typer.Option(help="Oil supply: oil_bath, oil_jet, oil_spot or grease (default: by bearing and oil)."),
    ],
}
SETTINGS: dict[str, Any] = {
    "settings": Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            metavar="KEY=VALUE",
            help="Key of the scene with a new value, for example lubricant.supply=grease; one option for each key.",
        ),
    ]
}


def given_options() -> dict[str, str]:
    """The texts of the options that are given."""
    return given(OPTIONS)


def given_settings() -> dict[str, str]:
    """The texts of --set by key. Raises InputError for one that is no "key=value"."""
    from analytic.scenefile.setting import typed_settings

    return typed_settings(given(SETTINGS).get("settings", []))
