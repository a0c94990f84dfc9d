"""Many runs that differ in some values: a table of parameters, all cores, one result."""

from softcat_sym.ensemble.ensemble import Ensemble
from softcat_sym.ensemble.many import simulate_many
from softcat_sym.ensemble.progress import MembersBar, MembersProgress

__all__ = ["Ensemble", "MembersBar", "MembersProgress", "simulate_many"]
