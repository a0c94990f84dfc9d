"""Moved to ``tests.common.limited_process``."""

from tests.common.limited_process import *  # noqa: F403
