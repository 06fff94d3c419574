"""Laws of traction that installed packages offer, by entry points of the group "fembearing.traction"."""

from collections.abc import Callable
from functools import cache
from importlib.metadata import EntryPoint, entry_points
from typing import cast, get_args

from analytic.errors import InputError
from analytic.oil.own_law import in_words, own_traction
from analytic.scene import OwnTraction, Traction

GROUP = "fembearing.traction"
BUILT_IN: tuple[str, ...] = get_args(Traction)


def installed_laws() -> dict[str, list[EntryPoint]]:
    """The laws that installed packages offer, by their names; a name that two packages offer has two entries."""
    found: dict[str, list[EntryPoint]] = {}
    for entry in entry_points(group=GROUP):
        found.setdefault(entry.name, []).append(entry)
    return dict(sorted(found.items()))


@cache
def installed_law(name: str) -> OwnTraction:
    """The law of that name. Raises InputError for a name that no package offers, or several do, and as `own_traction`.

    A package that cannot be imported is refused too, with the reason. A sweep reads many scenes with one law, so a
    process makes its table once.
    """
    entries = installed_laws().get(name, [])
    if len(entries) != 1:
        owners = ", ".join(_owner(entry) for entry in entries)
        reason = f"is offered by {owners}; remove all but one" if entries else f"is offered by no package as {GROUP}"
        raise InputError(f"law of traction {name} {reason}")
    (entry,) = entries
    try:
        function = entry.load()
    except Exception as problem:  # whatever the package raises on import is the user's to see
        raise InputError(
            f"law of traction {name}: {_owner(entry)} does not load {entry.value}: {in_words(problem)}; correct the "
            "package or remove it"
        ) from problem
    if not callable(function):
        raise InputError(
            f"law of traction {name}: {entry.value} of {_owner(entry)} is {type(function).__name__}; give a function "
            "f(x)"
        )
    owner, law = entry.dist, cast(Callable[[float], float], function)
    return own_traction(
        name, law, distribution="" if owner is None else owner.name, version="" if owner is None else owner.version
    )


def _owner(entry: EntryPoint) -> str:
    return "an unnamed package" if entry.dist is None else f"{entry.dist.name} {entry.dist.version}"
