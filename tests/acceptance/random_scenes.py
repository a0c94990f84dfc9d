"""Moved to ``tests.common.random_scenes``."""

from tests.common.random_scenes import *  # noqa: F403
