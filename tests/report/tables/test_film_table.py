"""The table of the film of a ball, by cells that are worked out by hand."""

from typing import Any

import numpy as np

from fembearing.check.comparison import Comparison, compared
from fembearing.check.film.scene_film import FilmNumbers
from fembearing.ehl.contact import Reach
from fembearing.grid_convergence import Estimate
from fembearing.quantities import INCH_POUND
from fembearing.report.tables.film import film_table

RPM = np.pi / 30  # rad/s


def quantity(formula: float, production: float, numerical: float, uncertainty: float, order: Any = 2.13) -> Comparison:
    study = Estimate(values=(numerical,), order=order, richardson=None, mesh=uncertainty / numerical)
    return compared(production, numerical, uncertainty, formula=formula, study=study)


FILM = FilmNumbers(
    pair="outer",
    load=371.5,
    inner_speed=600 * RPM,
    entrainment_speed=0.87,
    viscosity=0.043,
    pressure_viscosity=1.9e-8,
    reach=Reach(ahead=3.4e-3, behind=2.7e-3, side=3.1e-3),
    loading=214.0,
    thickening=6.7,
    ellipticity=0.124,
    quantities={
        "central_film": quantity(0.52e-6, 0.55e-6, 0.5e-6, 0.02e-6),
        "minimum_film": quantity(0.29e-6, 0.294e-6, 0.3e-6, 0.009e-6, order=None),
        "rolling_force": quantity(3.6e-3, 2.25e-3, 3e-3, 0.6e-3),
        "pressure_centre": quantity(8.2e-6, 8e-6, 8e-6, 0.0),
    },
    dissipated_force=3.9e-3,
    verdict="undecided",
    tolerance=0.05,
    seconds=12.34,
    warnings=(),
)


def test_each_quantity_has_its_difference_with_a_star_beyond_the_uncertainty() -> None:
    table = film_table(FILM)
    assert table.groups[0].rows == [
        ["central film, um", "0.52", "0.55", "0.5", "+10.0% *", "4.0%", "2.1"],
        ["minimum film, um", "0.29", "0.294", "0.3", "-2.0%  ", "3.0%", "none"],
        ["rolling force, mN", "3.6", "2.25", "3", "-25.0% *", "20.0%", "2.1"],
        ["pressure centre, um", "8.2", "8", "8", "+0.0%  ", "0.0%", "2.1"],
    ]
    assert table.label == "Film on the outer race: 371.5 N, inner ring at 600 rpm"
    words = " ".join(table.notes)
    assert "oil reaches 3.4 mm ahead and 2.7 mm behind" in words
    assert "differs by +30.0%. 12.3 s" in words  # 3.9 of 3 mN


def test_a_rolling_force_in_pounds_has_no_thousandths() -> None:
    names, formulas = zip(*(row[:2] for row in film_table(FILM, INCH_POUND).groups[0].rows), strict=True)
    assert names == ("central film, uin", "minimum film, uin", "rolling force, lbf", "pressure centre, uin")
    assert formulas[2] == "0.0008093"  # 3.6 mN of 4.4482 N
