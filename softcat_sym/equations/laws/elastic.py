"""Elastic: a spring, which never flows (2.8)."""

from __future__ import annotations

from softcat_sym.equations.law import ELASTIC

LAW = ELASTIC
