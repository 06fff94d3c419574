"""The finite-element reference of a contact, by the cheapest way that holds."""

from collections.abc import Callable, Sequence

from analytic.progress import Progress
from analytic.scene import Contact
from fembearing.check.contact.mesh_refinement import COMPARED, Estimates, Reference, solve_by_levels
from fembearing.check.contact.twin_refinement import solve_by_twin
from fembearing.mesh.recipe import Recipe


def solve_reference(
    contact: Contact,
    *,
    recipe: Recipe,
    accuracy: float,
    quantities: Sequence[str] = COMPARED,
    undecided: Callable[[Estimates], bool] = lambda _: False,
    progress: Progress,
) -> Reference:
    """Solve `contact` on as many levels of `recipe` as the accuracy needs.

    accuracy : required of the quantities, relative half-width
    quantities : names of those that must reach the accuracy
    undecided : whether a finer mesh is needed although the accuracy is reached
    Contacts of true shape have a twin on each level. Plain levels follow where the twin does not hold: for the
    idealisation, which would be its own twin, for a sheet, which bends, and where a shoulder cuts the contact off.
    `Reference.refinement` says which was used.
    """
    found = None
    if recipe.geometry == "real":
        found = solve_by_twin(
            contact, recipe=recipe, accuracy=accuracy, quantities=quantities, undecided=undecided, progress=progress
        )
    if found is not None:
        return found
    return solve_by_levels(
        contact, recipe=recipe, accuracy=accuracy, quantities=quantities, undecided=undecided, progress=progress
    )
