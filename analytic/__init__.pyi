from .contact.hertz import hertz_contact as hertz_contact
from .function import torque_function as torque_function
from .loads.finite_geometry import thrust_correction as thrust_correction
from .loads.ring import ring_equilibrium as ring_equilibrium
from .loads.thrust import thrust_equilibrium as thrust_equilibrium
from .mounting.clearance import Mounting as Mounting
from .mounting.clearance import mounted as mounted
from .prediction.prediction import predict as predict
from .scene import Cage as Cage
from .scene import ContactAngle as ContactAngle
from .scene import Scene as Scene
from .scenefile.by_name import bearing as bearing
from .scenefile.by_name import lubricant as lubricant
from .scenefile.by_name import material as material
from .scenefile.by_name import operation as operation
from .scenefile.by_name import surfaces as surfaces
from .scenefile.read import load_scene as load_scene
from .torque import friction_torque as friction_torque
from .verdicts import physical_checks as physical_checks

__version__: str
