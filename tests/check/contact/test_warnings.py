"""Warnings of a solved contact: on which side of each limit they stand, and what they say."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

from analytic.scene import Contact
from fembearing.check.contact.warnings import near_shoulder, solve_warnings
from fembearing.fem.measure import Quantities
from fembearing.grid_convergence import Estimate

SOLVED = Quantities(
    semi_axis_rolling=0.12e-3, semi_axis_transverse=0.7e-3, peak_pressure=2.1e9, approach=6.2e-6, stiffness=2.4e10
)


def mesh(contact: Contact, *, shoulder: Any = None, **changed: float) -> Any:
    return SimpleNamespace(contact=contact, level=3, shoulder=shoulder, quantities=replace(SOLVED, **changed))


def estimates(*, settled: bool = True, **uncertain: float) -> dict[str, Estimate]:
    """Of two quantities, with these uncertainties: 0.8 of each from the meshes, 0.6 from the block."""
    return {
        name: Estimate(
            values=(1.3,), order=None, richardson=None, mesh=0.8 * share, domain=0.6 * share, settled=settled
        )
        for name, share in ({"approach": 1e-4, "peak_pressure": 1e-4} | uncertain).items()
    }


def warnings(*solved: Any, **how: Any) -> tuple[str, ...]:
    usual: dict[str, Any] = {"accuracy": 0.02, "quantities": ("approach", "peak_pressure"), "thin": False}
    return tuple(solve_warnings(solved, **(usual | how)))


def test_a_contact_is_near_its_shoulder_within_a_twentieth_or_where_it_is_cut_off(
    contacts: dict[str, Contact],
) -> None:
    for distance, near in ((1.06, False), (1.04, True), (0.7, True)):
        contact = replace(contacts["inner"], shoulder=distance * 0.7e-3)
        assert near_shoulder(mesh(contact), contact) == near
    far = replace(contacts["inner"], shoulder=3 * 0.7e-3)
    assert near_shoulder(mesh(far, shoulder=SimpleNamespace()), far)


@pytest.mark.parametrize(
    ("shoulder", "words"), [(None, "peak pressure 4.3 GPa"), (SimpleNamespace(), "the pressure at y = 0, 4.3 GPa")]
)
def test_steel_yields_above_its_static_limit_from_the_least_load_on(
    contacts: dict[str, Contact], shoulder: Any, words: str
) -> None:
    solved = [
        (mesh(replace(contacts["inner"], load=load), peak_pressure=peak, shoulder=shoulder), estimates())
        for load, peak in ((870.0, 4.6e9), (640.0, 4.3e9), (520.0, 4.1e9))
    ]
    (message,) = warnings(*solved)
    assert message.startswith(f"inner: {words} at 640 N is above the static limit, 4.2 GPa, of bearing steel")
    assert warnings(solved[2]) == ()
