"""The finite-element reference of a contact: as many meshes as its accuracy asks for, and what they say together."""

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace

from analytic.scene import Contact
from fembearing.compare.contact.mesh_seconds import about, predicted_seconds
from fembearing.compare.contact.uncertainty import FINEST, HALF, LEAST, UNSTEADY, Estimate, estimate
from fembearing.fem.solution import MeshSolution, fitted_solution, solve_on_mesh
from fembearing.mesh.recipe import Recipe
from fembearing.progress import Progress

Estimates = dict[str, Estimate]

# With which power of the cells a quantity's error falls: an approach is an energy and gains twice the order of
# quadratic cells; semi-axes gain 3 on cells that follow the edge. Peak pressure has no steady one.
FORMAL_ORDERS: dict[str, float | None] = {
    "semi_axis_rolling": 3.0,
    "semi_axis_transverse": 3.0,
    "peak_pressure": None,
    "approach": 4.0,
    "stiffness": 4.0,
}
COMPARED = ("semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach")  # stiffness follows from the last
# Relative: the strip beside a shoulder cuts cells; a third level is 2.6 % off boundary elements at most, over three
# shoulders (validation/benchmarks/calibrations.py).
STRIP_LEAST = 0.03
# A level costs about a quarter of the next, and its mesh serves the next one's interval: it is tried unless foretold to
# miss by more than this. The peak pressure, whose error changes sign, is foretold up to twice too uncertain.
WORTH_A_TRY = 2.0
# With which power of a block's size the effect of its far boundary fades: tests/compare/contact/test_discrepancy.py foretells a
# block 2.5 times as large from one 1.5 times as large. A pocket's seat is a cavity and no half space: its approach runs
# on with the logarithm of the size.
FADING = 2.0
ENDLESS_IN_A_SEAT = ("approach", "stiffness")


@dataclass(frozen=True, kw_only=True, eq=False)
class Reference:
    """Meshes from coarse to fine, and each quantity with its uncertainty."""

    meshes: tuple[MeshSolution, ...]
    estimates: Estimates
    shoulder: Estimates  # keyed by the names of `ShoulderLoad`; empty where the contact ends before the shoulder


def solve_reference(
    contact: Contact,
    *,
    recipe: Recipe,
    accuracy: float,
    watched: Sequence[str] = COMPARED,
    is_open: Callable[[Estimates], bool] = lambda _: False,
    progress: Progress,
) -> Reference:
    """Solve `contact` on three levels of `recipe` or more.

    accuracy : asked of the watched quantities, relative half-width
    watched : names of quantities
    is_open : whether what the meshes say is not yet enough, although the accuracy is reached
    The first two levels predict which one holds the accuracy; where it does not, finer ones follow.
    """
    progress(0.0, f"{contact.pair}: size of the contact")
    second = fitted_solution(contact, recipe=recipe)
    progress(0.2, f"{contact.pair}: far boundary")
    boundary = _far_boundary(second, recipe=recipe)
    first = solve_on_mesh(contact, recipe=recipe, level=recipe.levels[0], semi_axes=second.pair.semi_axes)
    meshes, estimates = [first, second], {}
    allowed = {name: max(accuracy - boundary[name].domain, boundary[name].domain / 2) for name in watched}
    predicted = _predicted_level(meshes, recipe=recipe, allowed=allowed)
    finer = [level for level in recipe.levels if level >= predicted]
    for number, level in enumerate(finer):
        expected = about(predicted_seconds(level, known=meshes[-1]))
        progress(0.3 + 0.7 * number / len(finer), f"{contact.pair}: level {level}, {expected}")
        meshes.append(solve_on_mesh(contact, recipe=recipe, level=level, semi_axes=second.pair.semi_axes))
        estimates = {name: replace(part, **vars(boundary[name])) for name, part in estimates_of(meshes).items()}
        holds = all(estimates[name].mesh <= limit for name, limit in allowed.items())
        if holds and (second.shoulder is not None or not is_open(estimates)):
            break
    shoulder = {name: part for name, part in estimates.items() if name not in FORMAL_ORDERS}
    return Reference(
        meshes=tuple(meshes), estimates={name: estimates[name] for name in FORMAL_ORDERS}, shoulder=shoulder
    )


def estimates_of(meshes: Sequence[MeshSolution]) -> Estimates:
    """Each quantity from two meshes or more, coarse to fine, without what the far boundary does.

    A contact cut off at a shoulder ends in pressure without bound: no order is relied on.
    """
    sizes = [1 / mesh.level for mesh in meshes]
    table = [measured(mesh) for mesh in meshes]
    singular = meshes[-1].shoulder is not None
    found = {}
    for name in table[-1]:
        values = [row[name] for row in table]
        if not any(values):  # the centroid between two shoulders
            found[name] = Estimate(values=tuple(values), order=None, richardson=None, mesh=0.0)
        else:
            order = None if singular else FORMAL_ORDERS[name]
            found[name] = estimate(values, sizes, formal_order=order, singular=singular)
        if name.startswith("strip"):
            found[name] = replace(found[name], mesh=max(found[name].mesh, STRIP_LEAST))
    return found


def measured(mesh: MeshSolution) -> dict[str, float]:
    """All that is read off a solved mesh, what the shoulder carries included."""
    return asdict(mesh.quantities) | ({} if mesh.shoulder is None else asdict(mesh.shoulder))


def _predicted_level(meshes: Sequence[MeshSolution], *, recipe: Recipe, allowed: dict[str, float]) -> int:
    """The coarsest level from the third on whose mesh uncertainty may be no more than allowed; else the finest."""
    coarse, fine = meshes
    if fine.shoulder is not None:  # no order to predict with
        return recipe.levels[2]
    for level in recipe.levels[2:-1]:
        for name, limit in allowed.items():
            formal = FORMAL_ORDERS[name]
            order = formal or UNSTEADY
            change = abs(getattr(coarse.quantities, name) / getattr(fine.quantities, name) - 1)
            error = change / ((fine.level / coarse.level) ** order - 1) * (fine.level / level) ** order
            if (HALF * error if formal else error + LEAST) + FINEST > WORTH_A_TRY * limit:
                break
        else:
            return level
    return recipe.levels[-1]


@dataclass(frozen=True, kw_only=True)
class Boundary:
    """The fields of an `Estimate` that the size of the meshed region sets."""

    beyond: float = 0.0
    domain: float = 0.0


def _far_boundary(mesh: MeshSolution, *, recipe: Recipe) -> dict[str, Boundary]:
    """What the far boundary of a block still does to each quantity.

    Half spaces end in their own displacement, exact to the second moments of the pressure; a sheet has no such
    boundary: nothing.
    """
    if not has_boundary(mesh, recipe=recipe):
        return dict.fromkeys(measured(mesh), Boundary())
    larger = solve_on_mesh(
        mesh.contact, recipe=recipe, level=mesh.level, semi_axes=mesh.pair.semi_axes, extended=True, upper=mesh.upper
    )
    return boundary_effect(mesh, larger)


def has_boundary(mesh: MeshSolution, *, recipe: Recipe) -> bool:
    """Whether the lower body ends in a displacement that it has only about."""
    return recipe.geometry != "hertzian" and mesh.pair.lower.far.size > 0


def boundary_effect(mesh: MeshSolution, larger: MeshSolution) -> dict[str, Boundary]:
    """What the far boundary does to each quantity, from a block with more cells all round.

    That shows a part of it. The rest follows from the power with which it fades, and half of the whole is left as
    uncertainty; the approach into a seat is left as it is and uncertain as if it faded as one over the size.
    """
    size, further = (float(part.pair.lower.mesh.doflocs[0].max()) for part in (mesh, larger))
    before, after = measured(mesh), measured(larger)
    found = {}
    for name, value in before.items():
        change = after[name] / value - 1 if value else 0.0
        if mesh.contact.pair == "pocket" and name in ENDLESS_IN_A_SEAT:
            found[name] = Boundary(domain=abs(change) / (1 - size / further))
        else:
            whole = change / (1 - (size / further) ** FADING)
            found[name] = Boundary(beyond=whole, domain=abs(whole) / 2)
    return found
