"""Which ball is solved by finite elements: the heaviest of a scene, as the friction torque loads it."""

from dataclasses import replace

import numpy as np

from analytic.contact.geometry import RACES, Race, race_contact
from analytic.effects.ledger import Choices
from analytic.effects.loads import chosen_balls
from analytic.loads.balls import LoadedBalls
from analytic.scene import Contact, Scene


def balls_of(scene: Scene) -> LoadedBalls:
    """The loaded balls at every operating point, with Hertz's contacts. Raises InputError as friction_torque does."""
    plain = replace(scene, effects={**scene.effects, "finite_geometry": "off"})
    operation = plain.operation.as_series()
    balls, _ = chosen_balls(plain, operation, Choices(plain, operation.axial_load.size), correction=None)
    return balls


def heaviest_contact(scene: Scene, race: Race) -> Contact:
    """The ball that presses hardest at any operating point, on one of its races: its own load and angle there.

    Raises InputError as balls_of, and for a contact beyond its shoulder.
    """
    balls = balls_of(scene)
    largest = balls.load.max(axis=0)
    place = (RACES.index(race), *np.unravel_index(np.argmax(largest), largest.shape))
    return race_contact(
        scene.bearing,
        race,
        contact_angle=float(abs(balls.contact_angle[place])),
        ball_load=float(balls.load[place]),
    )
