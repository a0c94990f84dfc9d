"""How accurate an answer is, found on the run itself, and what makes it as accurate as was asked."""

from softcat_sym.accuracy.deviation import Deviation, Judge
from softcat_sym.accuracy.error_estimate import ErrorEstimate
from softcat_sym.accuracy.estimating import as_accurate_as_asked, frames_of_first, periods_of
from softcat_sym.accuracy.resolution import Resolution, resolution_of

__all__ = [
    "Deviation",
    "ErrorEstimate",
    "Judge",
    "Resolution",
    "as_accurate_as_asked",
    "frames_of_first",
    "periods_of",
    "resolution_of",
]
