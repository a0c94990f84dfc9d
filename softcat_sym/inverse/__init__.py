"""From measurements to constants of a law."""

from softcat_sym.inverse.candidate import Candidate
from softcat_sym.inverse.flow_curve import FlowCurve, read_flow_curve
from softcat_sym.inverse.flow_curve_fit import FlowCurveFit, fit_flow_curve
from softcat_sym.inverse.handing_on import fitted_scene

__all__ = ["Candidate", "FlowCurve", "FlowCurveFit", "fit_flow_curve", "fitted_scene", "read_flow_curve"]
