"""fembearing checks the closed forms of ball-bearing contact against finite elements.

import analytic, fembearing
scene = analytic.load_scene("bearing.toml")
contact = fembearing.solve_contact(scene, pair="inner")
result = fembearing.validate(scene)
"""

from importlib.metadata import version

from fembearing.compare.discrepancy import ContactSolution, solve_contact
from fembearing.compare.validation import Validation, validate

__all__ = ["ContactSolution", "Validation", "__version__", "solve_contact", "validate"]

__version__ = version("fembearing")
