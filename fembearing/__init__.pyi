from .check.contact.load_series import LoadSeries as LoadSeries
from .check.contact.load_series import solve_load_series as solve_load_series
from .check.contact.solution import ContactSolution as ContactSolution
from .check.contact.solution import solve_contact as solve_contact
from .check.measured.comparison import MeasuredComparison as MeasuredComparison
from .check.measured.comparison import compare_measured as compare_measured
from .check.validation import Validation as Validation
from .formats.choice import Exported as Exported
from .formats.choice import export as export
from .production import SceneTorque as SceneTorque
from .production import friction_torque as friction_torque
from .production import load_scene as load_scene
from .production import predict as predict
from .production import torque_function as torque_function
from .production import torque_of_scene as torque_of_scene
from .report.figures.bearing import draw_bearing as draw_bearing
from .report.folder import validate as validate
from .report.sections.headline import Headline as Headline
from .report.sections.headline import torque_headline as torque_headline
from .report.torque_file import torque_content as torque_content
from .sweep.run import Sweep as Sweep
from .sweep.run import run_sweep as run_sweep

__version__: str
