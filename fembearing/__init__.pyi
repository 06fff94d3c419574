from .formats.choice import Exported as Exported
from .formats.choice import export as export
from .report.drawing import draw_bearing as draw_bearing
from .report.folder import validate as validate
from .report.headline import Headline as Headline
from .report.headline import torque_headline as torque_headline
from .report.torque_file import torque_content as torque_content
from .sweep.run import Sweep as Sweep
from .sweep.run import run_sweep as run_sweep
from .verify.contact.discrepancy import ContactSolution as ContactSolution
from .verify.contact.discrepancy import solve_contact as solve_contact
from .verify.contact.load_series import LoadSeries as LoadSeries
from .verify.contact.load_series import solve_load_series as solve_load_series
from .verify.measured.comparison import MeasuredComparison as MeasuredComparison
from .verify.measured.comparison import compare_measured as compare_measured
from .verify.torque.scene_torque import SceneTorque as SceneTorque
from .verify.torque.scene_torque import torque_of_scene as torque_of_scene
from .verify.validation import Validation as Validation

__version__: str
