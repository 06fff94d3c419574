"""The scene that a public function works on: given itself, or by the name of a file or a bearing."""

import os

from analytic.given import SceneOptions
from analytic.scene import Scene


def scene_by(scene: Scene | str | os.PathLike[str], given: SceneOptions) -> Scene:
    """The scene itself, or the one that `analytic.load_scene` reads by a name and what is given beside it.

    Raises InputError as that, and for anything given beside a Scene.
    """
    from analytic.scenefile.read import load_by_temperature  # only who asks for it pays

    return scene if isinstance(scene, Scene) and not given else load_by_temperature(scene, **given).fixed
