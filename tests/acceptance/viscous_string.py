"""Moved to ``tests.common.viscous_string``."""

from tests.common.viscous_string import *  # noqa: F403
