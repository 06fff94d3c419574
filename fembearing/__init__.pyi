from .formats.choice import Exported as Exported
from .formats.choice import export as export
from .report.drawing import draw_bearing as draw_bearing
from .report.folder import validate as validate
from .sweep.run import Sweep as Sweep
from .sweep.run import run_sweep as run_sweep
from .verify.contact.discrepancy import ContactSolution as ContactSolution
from .verify.contact.discrepancy import solve_contact as solve_contact
from .verify.contact.load_series import LoadSeries as LoadSeries
from .verify.contact.load_series import solve_load_series as solve_load_series
from .verify.measured.comparison import MeasuredComparison as MeasuredComparison
from .verify.measured.comparison import compare_measured as compare_measured
from .verify.validation import Validation as Validation

__version__: str
