"""The table [assumed] of a scene file: inputs that it gives although nobody knows them, each with its source."""

from typing import TYPE_CHECKING, Annotated

from pydantic import Field

from analytic.inputs import ASSUMABLE, known_inputs
from analytic.scene import Scene
from analytic.scenefile.table import Table, Text, given_paths, table_of_paths

Source = Annotated[Text, Field(description="say in words where the value comes from")]

if TYPE_CHECKING:  # its fields follow from ASSUMABLE

    class AssumedTable(Table):
        pass

else:
    AssumedTable = table_of_paths("assumed", dict.fromkeys(ASSUMABLE, (Source | None, None)))


def given_assumptions(table: Table, scene: Scene) -> tuple[dict[str, str], list[tuple[str, str]]]:
    """Sources by key, and (key, problem) for those of an input that the scene does not have."""
    sources: dict[str, str] = dict(given_paths(table))
    known = known_inputs(scene)
    problem = "is of an input that this scene does not have; leave it out"
    return sources, [(f"assumed.{key}", problem) for key in sources if key not in known]
