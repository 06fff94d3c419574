from .contact.hertz import hertz_contact as hertz_contact
from .discs import traction_coefficient as traction_coefficient
from .errors import InputError as InputError
from .function import torque_function as torque_function
from .oil.own_law import own_traction as own_traction
from .prediction.duty import DutyCycle as DutyCycle
from .prediction.duty import duty_cycle as duty_cycle
from .prediction.prediction import Prediction as Prediction
from .prediction.prediction import predict as predict
from .prediction.steady import steady_scene as steady_scene
from .result import FrictionTorque as FrictionTorque
from .scene import Cage as Cage
from .scene import ContactAngle as ContactAngle
from .scene import Scene as Scene
from .scene_torque import torque_of_scene as torque_of_scene
from .scenefile.parts import bearing as bearing
from .scenefile.parts import lubricant as lubricant
from .scenefile.parts import material as material
from .scenefile.parts import operation as operation
from .scenefile.parts import surfaces as surfaces
from .scenefile.read import load_scene as load_scene
from .scenefile.read import parse_scene as parse_scene
from .scenefile.template import scene_text as scene_text
from .torque import friction_torque as friction_torque
from .verdicts import physical_checks as physical_checks

__version__: str
