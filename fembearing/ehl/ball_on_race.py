"""A ball on a race with oil, from the contact of a scene; `fembearing.ehl.film.numerical_film` solves it."""

from analytic.errors import InputError
from analytic.scene import Contact
from fembearing.ehl.contact import LubricatedContact, Reach
from fembearing.ehl.oil import Oil
from fembearing.ehl.shape import BallOnRace
from fembearing.fem.half_space import contact_modulus

FLOODED = 0.9  # of the ball's radius: oil in a bath fills the gap about up to the ball's outline


def lubricated_contact(
    contact: Contact,
    *,
    oil: Oil | None,
    entrainment_speed: float,
    ahead: float | None = None,
    behind: float | None = None,
) -> LubricatedContact:
    """A ball on a race with oil, as the numerical solution needs it.

    contact : oil ends at the mean distance of both shoulders, and nothing else is taken from them
    oil : at the temperature of the inlet; None, a dry contact, is refused
    entrainment_speed : mean of both surfaces relative to the contact, m/s, of either sign
    ahead, behind : how far the oil reaches in the inlet and in the outlet, m; None: 0.9 of the ball's radius
    The bodies are elastic half spaces with the true circles of ball and race.
    Raises InputError for a pocket, a dry contact, and all that `LubricatedContact` refuses.
    """
    if contact.pair == "pocket":
        raise InputError("a ball slides in its pocket: the numerical film is that of a ball that rolls on a race")
    if oil is None:
        raise InputError("the contact is dry, without a film: give it a lubricant")
    shape = BallOnRace(
        ball_radius=contact.ball_radius, race_radius=contact.rolling_radius, groove_radius=contact.groove_radius
    )
    usual = FLOODED * contact.ball_radius
    shoulders = (contact.shoulder + contact.far_shoulder) / 2
    return LubricatedContact(
        load=contact.load,
        modulus=contact_modulus(contact),
        shape=shape,
        speed=abs(entrainment_speed),
        oil=oil,
        reach=Reach(
            ahead=usual if ahead is None else ahead,
            behind=usual if behind is None else behind,
            side=min(shoulders, shape.outline[1]),
        ),
    )
