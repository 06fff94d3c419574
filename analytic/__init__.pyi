from .contact.hertz import hertz_contact as hertz_contact
from .loads.finite_geometry import thrust_correction as thrust_correction
from .loads.ring import ring_equilibrium as ring_equilibrium
from .loads.thrust import thrust_equilibrium as thrust_equilibrium
from .scenefile.by_name import lubricant as lubricant
from .scenefile.by_name import material as material
from .scenefile.read import load_scene as load_scene
from .torque import friction_torque as friction_torque

__version__: str
