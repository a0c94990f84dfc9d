"""Yield stresses: conversion from shear to tension, and published flow curves."""

from __future__ import annotations

import importlib
import math

from softcat_sym.fitting.flow_curve import FlowCurve, fit_flow_curve
from softcat_sym.studies.published.case import CaseCurve, CasePicture, Finding, PublishedValue, published_scene

_YIELDS, _FLOWS = 100.0, 10.0
"""Shear yield stress [Pa] and shear viscosity [Pa s] of the scene."""


def _elongational() -> Finding:
    material = published_scene("shear-data").material
    ratio = (material.yield_stress or 0.0) / _YIELDS
    return Finding((PublishedValue("elongational over shear yield stress", "", math.sqrt(3), ratio),))


def _trouton() -> Finding:
    material = published_scene("shear-data").material
    ratio = (material.viscosity or 0.0) / _FLOWS
    return Finding((PublishedValue("viscous traction over viscosity", "", 3.0, ratio),))


_GLASSES = {"mason1996_fig5": 0.58}
"""Volume fraction below which these emulsions flow as liquids (Mason, Bibette & Weitz 1996)."""


def _flow_curves() -> Finding:
    rheodata = importlib.import_module("rheodata")
    solids = set(rheodata.search(experiment="flow_curve", tag="yield-stress")["id"])
    as_said, curves = [], []
    for name in rheodata.search(experiment="flow_curve")["id"]:
        for sample, rows in rheodata.load(name).df.groupby("sample_id", sort=False):
            rate, stress = (rows[column].to_numpy(float) for column in ("shear_rate_1/s", "stress_Pa"))
            yields = fit_flow_curve(FlowCurve(rate, stress)).best.tau_Y is not None
            flows = name not in solids
            if name in _GLASSES:
                flows = float(str(sample).removeprefix("phi_")) < _GLASSES[name]
            as_said.append(yields is not flows)
            curves.append(CaseCurve(f"{name} {sample}", rate.tolist(), stress.tolist(), is_published=True))
    number = float(len(as_said))
    row = PublishedValue(
        "curves with a yield stress or without, as their authors say", "", number, float(sum(as_said)),
        band=(number, number), is_absolute=True,
    )  # fmt: skip
    picture = CasePicture("shear rate [s⁻¹]", "shear stress [Pa]", tuple(curves), is_log_x=True, is_log_y=True)
    return Finding((row,), picture)


RUNS = {"martinie": _elongational, "trouton": _trouton, "rheodata": _flow_curves}
