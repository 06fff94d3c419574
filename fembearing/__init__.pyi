from .compare.contact.discrepancy import ContactSolution as ContactSolution
from .compare.contact.discrepancy import solve_contact as solve_contact
from .compare.contact.load_series import LoadSeries as LoadSeries
from .compare.contact.load_series import solve_load_series as solve_load_series
from .compare.validation import Validation as Validation
from .report.folder import validate as validate
from .sweep.run import Sweep as Sweep
from .sweep.run import run_sweep as run_sweep

__version__: str
