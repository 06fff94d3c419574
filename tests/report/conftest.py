"""The pictures of the checked scene, and a result made by hand: each number in it is known and unlike all others."""

from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from analytic.effects import Effect, Effects
from analytic.limits import LimitNumbers
from analytic.result import FrictionTorque, TorqueParts
from analytic.scene import Operation
from analytic.scenefile.read import parse_scene
from analytic.torque import friction_torque
from fembearing.check.cage_record import CageRecord, record_cage
from fembearing.check.comparison import compared_with, verdict_on, worst
from fembearing.check.contact.hertz import CorrectedHertz
from fembearing.check.contact.solution import ContactSolution, MeshCost
from fembearing.check.cost.scene_cost import contact_ladder_of
from fembearing.check.torque_change import FittedChange, TorqueChange
from fembearing.check.validation import Validation
from fembearing.fem.measure import Quantities
from fembearing.grid_convergence import Estimate
from fembearing.provenance import provenance_of
from fembearing.report.pictures.creep import CreepPicture, creep_pictures
from fembearing.report.pictures.draw import Picture, draw_pictures
from fembearing.report.report import Report, report_of
from tests.analytic.scenefile.scene_texts import MOVING
from tests.analytic.specimens import present
from tests.report.pictures.odd_contacts import OddPicture, odd_pictures

pytest.register_assert_rewrite("tests.report.pictures.picture_reader")  # its assertions show their values


@pytest.fixture(scope="session")
def odd(
    checked: Validation, cut_contact: ContactSolution, tmp_path_factory: pytest.TempPathFactory
) -> dict[str, OddPicture]:
    """Pictures that are drawn with `pictures`: VTK takes seconds to start."""
    return odd_pictures(checked, cut_contact, tmp_path_factory.mktemp("odd"))


@pytest.fixture(scope="session")
def slipping(checked: Validation, tmp_path_factory: pytest.TempPathFactory) -> dict[Path, CreepPicture]:
    """Pictures of friction by their files, drawn with `pictures` too."""
    folder = tmp_path_factory.mktemp("creep")
    return {folder / each.file: each for each in creep_pictures(checked.creep[0], folder)}


@pytest.fixture(scope="session")
def pictures(
    checked: Validation,
    odd: dict[str, OddPicture],
    slipping: dict[Path, CreepPicture],
    tmp_path_factory: pytest.TempPathFactory,
) -> list[Picture]:
    """The pictures of its contacts, drawn by VTK."""
    others = [each.job for each in (*odd.values(), *slipping.values())]
    drawn, trouble = draw_pictures(checked.contacts, tmp_path_factory.mktemp("vtk"), besides=others)
    assert trouble is None
    return drawn


@pytest.fixture(scope="session")
def odd_by_vtk(odd: dict[str, OddPicture], pictures: list[Picture]) -> dict[str, Picture]:
    assert pictures
    return {name: each.picture for name, each in odd.items()}


class Given(NamedTuple):
    """One quantity of a contact; SI, uncertainties relative."""

    hertz: float
    values: tuple[float, float, float]  # coarse to fine
    order: float | None
    limit: float | None
    mesh: float
    domain: float


# Three of these change their star or verdict without the domain's share: a of the inner race, K of the outer race,
# p0 of the seat.
INNER = {
    "semi_axis_rolling": Given(0.1176e-3, (0.126e-3, 0.1212e-3, 0.1195e-3), 2.7, 0.12e-3, 0.0195, 0.0055),
    "semi_axis_transverse": Given(0.968e-3, (0.792e-3, 0.8624e-3, 0.89e-3), 1.4, 0.88e-3, 0.017, 0.006),
    "peak_pressure": Given(1.785e9, (1.87e9, 1.734e9, 1.69e9), 4.2, 1.7e9, 0.012, 0.007),
    "approach": Given(5.3295e-6, (4.4e-6, 5.06e-6, 5.5e-6), 3.6, 5.225e-6, 0.011, 0.003),
    "stiffness": Given(24.25e9, (32.5e9, 27.5e9, 25e9), None, None, 0.014, 0.002),
}
OUTER = {
    "semi_axis_rolling": Given(0.1414e-3, (0.15e-3, 0.143e-3, 0.139e-3), 2.9, 0.14e-3, 0.0123, 0.0044),
    "semi_axis_transverse": Given(0.78e-3, (0.69e-3, 0.74e-3, 0.755e-3), 1.8, 0.75e-3, 0.0271, 0.0035),
    "peak_pressure": Given(1.568e9, (1.75e9, 1.65e9, 1.58e9), 4.7, 1.6e9, 0.0011, 0.0022),
    "approach": Given(6.08e-6, (7.1e-6, 6.5e-6, 6.3e-6), 3.3, 6.4e-6, 0.008, 0.001),
    "stiffness": Given(22.8e9, (27.1e9, 25.3e9, 23.5e9), 2.2, 24e9, 0.0301, 0.0402),
}
SEAT = {
    "semi_axis_rolling": Given(0.3131e-3, (0.33e-3, 0.32e-3, 0.305e-3), 1.9, 0.31e-3, 0.0013, 0.0017),
    "semi_axis_transverse": Given(0.3168e-3, (0.35e-3, 0.34e-3, 0.315e-3), 2.1, 0.32e-3, 0.0016, 0.0019),
    "peak_pressure": Given(0.1372e9, (0.16e9, 0.15e9, 0.135e9), 2.4, 0.14e9, 0.0287, 0.0110),
    "approach": Given(0.609e-6, (0.55e-6, 0.57e-6, 0.584e-6), 3.1, 0.58e-6, 0.0029, 0.0038),
    "stiffness": Given(60.8e9, (70e9, 66e9, 63e9), 3.4, 64e9, 0.0031, 0.0042),
}
SHEET = {
    "semi_axis_rolling": Given(0.3131e-3, (0.324e-3, 0.322e-3, 0.3205e-3), 2.3, 0.321e-3, 0.0007, 0.0),
    "semi_axis_transverse": Given(0.3168e-3, (0.326e-3, 0.325e-3, 0.3225e-3), 2.5, 0.323e-3, 0.0009, 0.0),
    "peak_pressure": Given(0.1372e9, (0.134e9, 0.133e9, 0.13e9), 2.6, 0.131e9, 0.0026, 0.0),
    "approach": Given(0.609e-6, (0.81e-6, 0.85e-6, 0.88e-6), 2.8, 0.87e-6, 0.0033, 0.0),
    "stiffness": Given(60.8e9, (43e9, 41e9, 39e9), 3.2, 39.52e9, 0.0057, 0.0),
}

CORRECTED = CorrectedHertz(  # of the inner race
    quantities=Quantities(
        semi_axis_rolling=0.1203e-3,
        semi_axis_transverse=0.8778e-3,
        peak_pressure=1.7085e9,
        approach=5.2198e-6,
        stiffness=25.05e9,
    ),
    uncertainty={
        "semi_axis_rolling": 0.0021,
        "semi_axis_transverse": 0.0032,
        "peak_pressure": 0.0023,
        "approach": 0.0054,
        "stiffness": 0.0081,
    },
)


def contact_made(
    solution: ContactSolution,
    given: dict[str, Given],
    *,
    load: float,
    unknowns: tuple[int, int, int],
    seconds: tuple[float, float, float],
    corrected: CorrectedHertz | None = None,
    valid: bool = True,
) -> ContactSolution:
    """The solution with these numbers in place of its own, on meshes of the levels 2, 3 and 5."""
    meshes = [
        replace(
            solution.meshes[-1],
            level=level,
            unknowns=unknowns[number],
            seconds=seconds[number],
            quantities=Quantities(**{name: part.values[number] for name, part in given.items()}),
        )
        for number, level in enumerate((2, 3, 5))
    ]
    judged, quantities = solution.numbers.judged, {}
    for name, part in given.items():
        study = Estimate(
            values=part.values,
            order=part.order,
            richardson=part.limit,
            mesh=part.mesh,
            domain=part.domain,
            settled=part.order is not None,
            grid_convergence_index=None if part.order is None else 3 * part.mesh,
        )
        verdict = verdict_on(part.hertz, study, tolerance=0.05, valid=valid) if judged else "shown"
        quantities[name] = compared_with(study, part.hertz, verdict=verdict)
    fitted = {} if corrected is None else vars(corrected.quantities)
    numbers = replace(
        solution.numbers,
        load=load,
        tolerance=0.05,
        quantities=quantities,
        verdict=worst(each.verdict for each in quantities.values()),
        method="finite elements on three meshes",
        meshes=tuple(MeshCost(level=each.level, unknowns=each.unknowns, seconds=each.seconds) for each in meshes),
        refinement="levels",
        seconds=sum(seconds),
        warnings=(),
        corrected=corrected,
        interpolation_error={name: value / quantities[name].reference - 1 for name, value in fitted.items()},
    )
    contact = replace(solution.contact, load=load)
    return replace(solution, numbers=numbers, contact=contact, meshes=tuple(meshes))


def torque_made(torque: FrictionTorque, *, angle: list[float], total: list[float]) -> FrictionTorque:
    """Three operating points at 150, 300 and 600 rpm; no contact was solved at the ball load of the first."""
    return replace(
        torque,
        contact_angle=np.array(angle),
        ball_load=np.array([250.0, 371.0, 372.0]),
        inner=replace(torque.inner, load=np.array([249.0, 370.0, 371.0])),
        outer=replace(torque.outer, load=np.array([250.0, 371.0, 372.0])),
        numerical_uncertainty=np.array([0.011, 0.012, 0.013]),
        model_uncertainty=np.array([0.21, 0.22, 0.23]),
        limits=LimitNumbers(
            peak_pressure=np.array([[1.72e9, 1.78e9, 1.76e9], [1.53e9, 1.56e9, 1.57e9]]),
            cut_off=np.array([[0.0, 0.012, 0.031], [0.0, 0.0, 0.002]]),
            knows_shoulder=np.array([True, False]),
            sliding_number=np.array([[0.11, 0.12, 0.17], [0.09, 0.13, 0.1]]),
            cage_grip=np.array([0.21, 0.43, 0.37]),
        ),
        radial_load=np.zeros(3),
        moment=np.zeros(3),
        torque=TorqueParts(
            total=np.array(total),
            race=np.array(total),
            spin=np.array([17.1e-3, 22.5e-3, 27e-3]),
            conformity=np.array([11.4e-3, 14.3e-3, 19e-3]),
            hysteresis=np.array([2.5e-3, 3.2e-3, 4e-3]),
        ),
        effects=Effects(
            lambda: {
                "spin": Effect(name="spin", decision="on", share=0.562, reason="asked for", share_is="part"),
                "rolling": Effect(name="rolling", decision="off", share=None, reason="nobody knows it"),
            }
        ),
    )


@pytest.fixture(scope="session")
def made(checked: Validation) -> Validation:
    """A result with every verdict; none of its numbers comes from the solver."""
    inner, outer, seat, sheet = checked.contacts
    torque, change = checked.torque, checked.torque_change
    assert torque is not None
    assert change is not None
    speeds, loads = np.pi * np.array([5.0, 10.0, 20.0]), np.array([700.0, 900.0, 910.0])
    scene = replace(checked.scene, operation=Operation(axial_load=loads, inner_speed=speeds), tolerance=0.05)
    solved = friction_torque(scene)
    own = torque_made(solved, angle=[0.281, 0.3012, 0.3031], total=[31e-3, 40e-3, 50e-3])
    contacts = (
        contact_made(
            inner, INNER, load=371.5, unknowns=(1200, 9500, 31000), seconds=(0.25, 1.5, 7.0), corrected=CORRECTED
        ),
        contact_made(outer, OUTER, load=368.5, unknowns=(1300, 8700, 29000), seconds=(0.32, 1.7, 6.0), valid=False),
        contact_made(seat, SEAT, load=28.5, unknowns=(1400, 9900, 41000), seconds=(0.43, 2.1, 8.0)),
        contact_made(sheet, SHEET, load=28.5, unknowns=(1600, 9100, 43000), seconds=(0.51, 2.6, 9.0)),
    )
    production = torque_made(solved, angle=[0.282, 0.3013, 0.3032], total=[34e-3, 42e-3, 53e-3])
    return replace(
        checked,
        scene=scene,
        provenance=provenance_of(scene),
        contacts=contacts,
        ladders=tuple(contact_ladder_of(contact) for contact in contacts if contact.numbers.judged),
        torque=replace(torque, scene=scene, friction=production, interval=None),
        torque_change=TorqueChange(
            production=production,
            own=own,
            corrected=torque_made(solved, angle=[0.279, 0.2998, 0.3019], total=[33e-3, 41e-3, 48.5e-3]),
            uncertainties={"total": 0.0137, "spin": 0.021, "contact_angle": 0.0019},
            fitted=FittedChange(
                torque=torque_made(solved, angle=[0.278, 0.2996, 0.3017], total=[30.5e-3, 39.2e-3, 48.7e-3]),
                relative=np.array([np.nan, -0.0213, -0.0267]),
                uncertainty=np.array([np.nan, 0.0031, 0.0043]),
                warnings=(),
            ),
            verdict="undecided",
        ),
        creep=tuple(replace(each, place=0) for each in checked.creep),
        seconds=43.21,
    )


@pytest.fixture(scope="session")
def document(made: Validation) -> Report:
    """The document of `made`."""
    return report_of(made)


@pytest.fixture(scope="session")
def record() -> CageRecord:
    """A cage at rest: below the middle, a little to the right."""
    scene = parse_scene(MOVING, origin="here")
    return present(record_cage(scene, friction_torque(scene), 0))
