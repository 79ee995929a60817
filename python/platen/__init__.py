"""Contact laws for plastic particles: material, virtual press, law with its error, arrays of contacts.

    granule = platen.Material.load("mcc-ph-200")
    law = granule.predict()                       # at once; granule.derive() presses
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
from ._material import Material, dpc, drucker_prager, elastic, materials, mohr_coulomb, vmdc, von_mises
from ._measured import Calibration, Measurement, calibrate, fit, import_curve
from ._press import ZONES, Curve, Press, press
from ._study import Study, StudyStatus

__all__ = [
    "BRANCHES", "CALIBRATED_LAWS", "QUANTITIES", "ZONES",
    "Calibration", "Comparison", "Contact", "ConvergenceError", "Curve", "Error", "InvalidInput", "IoError", "Law", "LawError",
    "LawInfo", "Material", "Measurement", "Press", "Response", "State", "Study", "StudyStatus", "Validity", "Warning",
    "calibrate", "compare", "dpc", "drucker_prager", "elastic", "engine", "fit", "import_curve", "law", "laws", "materials",
    "mohr_coulomb", "press", "vmdc", "von_mises", "__version__",
]  # fmt: skip
