"""Independent truth: closed forms and finite elements, to judge the filament by."""

from softcat_sym.reference.element_run import ElementRun
from softcat_sym.reference.elements import run_elements
from softcat_sym.reference.mesh import Mesh
from softcat_sym.reference.supports import Clamp

__all__ = ["Clamp", "ElementRun", "Mesh", "run_elements"]
