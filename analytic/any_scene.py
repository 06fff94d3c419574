"""The scene that a public function works on: given itself, or by the name of a file or a bearing."""

import os

from analytic.scene import Scene
from analytic.scenefile.choice import SceneOptions, require_nothing_beside


def scene_by(scene: Scene | str | os.PathLike[str], given: SceneOptions) -> Scene:
    """The scene itself, or the one that `analytic.load_scene` reads by a name and what is given beside it.

    Raises InputError as that, and for anything given beside a Scene.
    """
    if not isinstance(scene, Scene):
        from analytic.scenefile.read import load_scene  # with pydantic: only who asks for it pays

        return load_scene(scene, **given)
    require_nothing_beside(given)
    return scene
