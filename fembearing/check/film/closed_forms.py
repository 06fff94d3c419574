"""Film and rolling force of a smooth, isothermal ball on a race, in closed form and as the torque takes them."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from analytic.contact.geometry import Race
from analytic.contact.rolling_contact import ContactNumbers, deformed_radius
from analytic.oil.ehl_fit import Regime, film_correction, regime_of
from analytic.oil.film import Inflow, central_film, minimum_ratio
from analytic.oil.inlets import oil_supply
from analytic.oil.lubrication import rolling_force_of
from analytic.oil.rolling import RollingResistance, hydrodynamic_rolling
from analytic.scene import Contact, Scene
from fembearing.ehl.contact import LubricatedContact


@dataclass(frozen=True, kw_only=True, eq=False)
class ClosedForms:
    """The formulas of one contact, SI; its scene has a lubricant."""

    scene: Scene
    pair: Race
    contact: Contact
    problem: LubricatedContact  # what the numerical solution solves

    @cached_property
    def smooth(self) -> ContactNumbers:
        """The contact as formulas take it."""
        (a, b), (rolling, transverse) = self.problem.semi_axes, self.problem.shape.radii
        contact = self.contact
        return ContactNumbers(
            load=contact.load,
            semi_axis_rolling=a,
            semi_axis_transverse=b,
            curvature_rolling=1 / rolling,
            curvature_transverse=1 / transverse,
            modulus=self.problem.modulus,
            deformed_radius=deformed_radius(groove_radius=contact.groove_radius, ball_diameter=2 * contact.ball_radius),
            rolling_rate=1.0,
            entrainment=1.0,
        )

    @cached_property
    def inflow(self) -> Inflow:
        """The oil as it enters."""
        oil = self.problem.oil
        return Inflow(self.problem.speed, oil.viscosity, oil.pressure_viscosity, oil.compressible, np.inf)

    @property
    def regime(self) -> Regime:
        """Moes's numbers."""
        return regime_of(self.smooth, self.inflow)

    def film(self, *, compressible: bool = False) -> float:
        """Central film by [Nijenbanning1994], m."""
        found = central_film(
            self.smooth,
            entrainment_speed=self.inflow.speed,
            viscosity=self.inflow.viscosity,
            pressure_viscosity=self.inflow.pressure_viscosity,
            compressible=compressible,
        )
        return float(found.thickness)

    def model_film(self) -> float:
        """Central film as the torque takes it, m."""
        assert self.scene.lubricant is not None
        film = self.film(compressible=self.inflow.compressible)
        return film * np.exp(film_correction(self.regime)) if self.scene.lubricant.film_formula == "numerical" else film

    def minimum_ratio(self) -> float:
        """Minimum over central film by [Hamrock1977]."""
        found = minimum_ratio(
            self.smooth,
            entrainment_speed=self.inflow.speed,
            viscosity=self.inflow.viscosity,
            pressure_viscosity=self.inflow.pressure_viscosity,
        )
        return float(found)

    def resistance(self) -> RollingResistance:
        """By [Biboulet2010]."""
        return hydrodynamic_rolling(self.smooth, viscosity=self.inflow.viscosity, entrainment_speed=self.inflow.speed)

    def model_force(self) -> tuple[float, float]:
        """Rolling force as the torque takes it, N, and the share of the fit in it, 0 to 1."""
        lubricant = self.scene.lubricant
        assert lubricant is not None
        formula = lubricant.rolling_formula
        supply = oil_supply(self.scene.bearing, lubricant, self.pair, contact_angle=self.contact.contact_angle)
        force, share, _ = rolling_force_of(
            self.smooth, self.inflow, self.regime, supply, formula == "numerical", formula == "houpert"
        )
        return force, share
