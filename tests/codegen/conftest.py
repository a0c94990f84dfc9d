"""``pytest tests/codegen/test_generated_folder.py --update`` writes the checked-in products anew."""

from __future__ import annotations

import pytest


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--update", action="store_true", help="write generated/ anew in place of comparing it")
