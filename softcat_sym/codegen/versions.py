"""What makes the text of generated C: other versions, another text."""

from __future__ import annotations

from importlib.metadata import version
from types import MappingProxyType

VERSIONS = MappingProxyType({package: version(package) for package in ("softcat_sym", "casadi", "sympy")})
