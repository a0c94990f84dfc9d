"""Moved to ``tests.common.fading_filaments``."""

from tests.common.fading_filaments import *  # noqa: F403
