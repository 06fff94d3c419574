"""The options that say what the scene of a bearing of the catalogue has, and the one that sets any key of a scene."""

from typing import Annotated, Any

import typer

from analytic.scenefile.choice import USUAL
from fembearing.cli.added_options import given

OPTIONS: dict[str, Any] = {  # by the fields of a choice
    "axial_load": Annotated[str | None, typer.Option(help='For example "500 N".')],
    "radial_load": Annotated[
        str | None, typer.Option(help='For example "5 kN"; a light load that suits the bearing without both.')
    ],
    "speed": Annotated[str | None, typer.Option(help=f"Of the inner ring; {USUAL.speed} without it.")],
    "oil": Annotated[
        str | None, typer.Option(help=f"Name of the oil, of `fembearing list oils`; {USUAL.oil} without it.")
    ],
    "temperature": Annotated[str | None, typer.Option(help=f"Of the oil; {USUAL.temperature} without it.")],
    "supply": Annotated[str | None, typer.Option(help="oil_bath, oil_jet, oil_spot or grease; by the oil without it.")],
}
SETTINGS: dict[str, Any] = {
    "settings": Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            metavar="KEY=VALUE",
            help="A key of the scene with another value, as lubricant.supply=grease. Several: one option for each.",
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
