"""Film and rolling force of a smooth, isothermal ball on a race, in closed form and as the torque takes them."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from analytic.contact.geometry import Race
from analytic.contact.rolling_contact import ContactNumbers, RollingContact, deformed_radius
from analytic.oil.asymptotes import Inflow
from analytic.oil.ehl_fit import Regime, covered, film_correction, fitted_force, regime_of
from analytic.oil.film import central_film, minimum_ratio
from analytic.oil.inlets import oil_supply
from analytic.oil.rolling import RollingResistance, houpert_rolling, hydrodynamic_rolling
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
    def smooth(self) -> RollingContact:
        """The contact as formulas take it."""
        (a, b), (rolling, transverse) = self.problem.semi_axes, self.problem.shape.radii
        contact = self.contact
        return RollingContact(
            load=contact.load,
            semi_axis_rolling=a,
            semi_axis_transverse=b,
            curvature_rolling=1 / rolling,
            curvature_transverse=1 / transverse,
            modulus=self.problem.modulus,
            deformed_radius=deformed_radius(groove_radius=contact.groove_radius, ball_diameter=2 * contact.ball_radius),
            rolling_rate=1.0,
        )

    @cached_property
    def inflow(self) -> Inflow:
        """The oil as it enters."""
        oil = self.problem.oil
        return Inflow(self.problem.speed, oil.viscosity, oil.pressure_viscosity, oil.compressible, np.inf)

    @cached_property
    def numbers(self) -> ContactNumbers:
        """The contact as compiled formulas take it."""
        return ContactNumbers._make([*(float(each) for each in self.smooth.fields[:8]), 1.0])

    @property
    def regime(self) -> Regime:
        """Moes's numbers."""
        return regime_of(self.numbers, self.inflow)

    @property
    def share(self) -> float:
        """Of the fit in the rolling force, 0 to 1."""
        assert self.scene.lubricant is not None
        return covered(self.regime) if self.scene.lubricant.rolling_formula == "numerical" else 0.0

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

    def model_force(self) -> float:
        """Rolling force as the torque takes it, N."""
        assert self.scene.lubricant is not None
        if self.scene.lubricant.rolling_formula == "houpert":
            closed = houpert_rolling(
                self.smooth,
                viscosity=self.inflow.viscosity,
                pressure_viscosity=self.inflow.pressure_viscosity,
                entrainment_speed=self.inflow.speed,
            )
        else:
            closed = self.resistance()
        force, share = float(closed.force), self.share
        if share == 0:
            return force
        supply = oil_supply(
            self.scene.bearing, self.scene.lubricant, self.pair, contact_angle=self.contact.contact_angle
        )
        return force + share * (fitted_force(self.numbers, self.inflow, self.regime, supply) - force)
