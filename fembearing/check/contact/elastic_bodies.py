"""The elastic bodies of film and friction: two half spaces, or ball and race of true shape by finite elements."""

from typing import Literal

from analytic.scene import Contact
from fembearing.check.contact.scene_contact import recipe_of
from fembearing.fem.compliance import PairCompliance, whole_compliance
from fembearing.fem.guess import expected_semi_axes

Compliance = Literal["half-space", "meshed"]


def meshed_pair(contact: Contact) -> PairCompliance:
    """The compliance of a ball on its race for pressure and tractions, from the first level of their recipe.

    Raises InputError as `whole_compliance`.
    """
    recipe = recipe_of("real", pair=contact.pair)
    semi_axes = expected_semi_axes(contact, geometry=recipe.geometry)
    return whole_compliance(contact, recipe=recipe, level=recipe.levels[0], semi_axes=semi_axes)
