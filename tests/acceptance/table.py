"""Moved to ``tests.common.table``."""

from tests.common.table import show as show
