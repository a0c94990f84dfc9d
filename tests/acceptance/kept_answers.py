"""Moved to ``tests.common.kept_answers``."""

from tests.common.kept_answers import fingerprint as fingerprint
from tests.common.kept_answers import kept as kept
