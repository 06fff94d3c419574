"""`fembearing warmup`."""

import typer

from fembearing.cli.status import DONE, NO_STORAGE

SCENES = ("6205-dry", "paper_6205", "6206")  # dry, oiled with a cage, and as `fembearing init` writes one


def warmup() -> None:
    """Compile the formulas in advance, for a quick start of later commands."""
    from analytic.numerics.compilation import kept_in
    from analytic.scenefile.read import load_scene
    from fembearing.cli.console import out, shown_progress
    from fembearing.verify.torque.scene_torque import torque_of_scene

    folder = kept_in()
    if folder is None:
        raise typer.Exit(NO_STORAGE)  # why is said
    with shown_progress() as progress:
        for number, name in enumerate(SCENES):
            progress(number / len(SCENES), f"formulas of {name}")
            torque_of_scene(load_scene(name))
    out.tell(f"formulas are kept in {folder}")
    raise typer.Exit(DONE)
