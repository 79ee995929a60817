"""Contact laws for plastic particles: material, virtual press, law with its error, arrays of contacts.

    granule = platen.Material.load("mcc-ph-200")
    law = granule.predict()                       # seconds; granule.derive() presses for longer
    contact = law.pair(radius=0.5e-3, partner=law, partner_radius=0.3e-3)
    contact(overlaps).force

SI units everywhere; overlap is the approach of two centres, compression is positive.
"""

from ._comparison import Comparison, compare
from ._contact import BRANCHES, QUANTITIES, Contact, Response, State
from ._core import calibrated_laws as CALIBRATED_LAWS
from ._core import engine
from ._core import version as __version__
from ._errors import ConvergenceError, Error, InvalidInput, IoError, Warning
from ._law import Law, LawError, LawInfo, Validity, law, laws
from ._material import (
    Material,
    dpc,
    drucker_prager,
    elastic,
    keys,
    materials,
    mohr_coulomb,
    vmdc,
    von_mises,
    yield_from_crushing,
    yield_from_hardness,
    yield_from_heckel,
)
from ._measured import Calibration, Measurement, calibrate, fit, import_curve
from ._pool import Beside, Methods, Pool, PoolCheck, Refinement, Sensitivity, Surrogate
from ._press import ZONES, Curve, Press, press
from ._reproduce import Reproduction, reproduce
from ._study import Study, StudyStatus

__all__ = [
    "BRANCHES", "CALIBRATED_LAWS", "QUANTITIES", "ZONES",
    "Beside", "Calibration", "Comparison", "Contact", "ConvergenceError", "Curve", "Error", "InvalidInput", "IoError", "Law",
    "LawError", "LawInfo", "Material", "Measurement", "Methods", "Pool", "PoolCheck", "Press", "Refinement", "Reproduction",
    "Response", "Sensitivity", "State", "Study", "StudyStatus", "Surrogate", "Validity", "Warning",
    "calibrate", "compare", "dpc", "drucker_prager", "elastic", "engine", "fit", "import_curve", "keys", "law", "laws",
    "materials", "mohr_coulomb", "press", "reproduce", "vmdc", "von_mises", "yield_from_crushing", "yield_from_hardness",
    "yield_from_heckel",
    "__version__",
]  # fmt: skip
