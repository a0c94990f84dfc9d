"""``manifest.json``: what a folder of generated C is, for programs that look before they build."""

from __future__ import annotations

import json
from typing import Any

from softcat_sym.codegen.c_source import CSource
from softcat_sym.codegen.description import Description
from softcat_sym.codegen.interface import prefix_of
from softcat_sym.codegen.versions import VERSIONS


def manifest_text(described: Description, name: str, command: str, source: CSource) -> str:
    """The manifest.

    Parameters
    ----------
    described, name, command
        As :func:`softcat_sym.codegen.interface.source_text` takes them.
    source : CSource
        The generated C, whose digest it states.
    """
    return json.dumps(manifest(described, name, command, source), indent=1, ensure_ascii=False) + "\n"


def manifest(described: Description, name: str, command: str, source: CSource) -> dict[str, Any]:
    """What the manifest says, before it is text."""
    scene, model = described.scene, described.model
    return {
        "generated": f"do not edit; written by: {command}",
        "title": described.title,
        "structure": _structure(described),
        "parameters": [
            {"name": one.name, "unit": one.unit, "bound": one.bound, "value": one.value, "meaning": one.meaning}
            for one in described.parameters
        ],
        "unknowns": [
            {
                "name": slot.name,
                "on": "cells" if on_cells else "nodes",
                "kind": "differential" if slot.differential else "algebraic",
                "rate": slot.rate,
                "section": slot.section,
            }
            for slot, on_cells in zip(model.slots, described.on_cells, strict=True)
        ],
        "work": list(model.powers),
        "sizes": {
            "unknowns_per_site": len(model.slots),
            "jacobian_entries_per_site": len(model.entries),
            "numbers_per_site": list(model.places),
            "bytes_of_text": source.size,
        },
        "defaults": {
            "cells": described.cells,
            "grading": described.grading,
            "relative": described.relative,
            "absolute": described.absolute,
            "duration_s": scene.run.duration,
            "frames": scene.run.frames,
        },
        "prefix": prefix_of(name),
        "versions": dict(VERSIONS),
        "sha256": source.digest,
    }


def _structure(described: Description) -> dict[str, Any]:
    """What one build cannot change."""
    scene, structure = described.scene, described.structure
    supports = structure.body.supports
    return {
        "digest": described.digest,
        "effects": list(described.effects.names),
        "law": scene.material.law,
        "section": scene.filament.section,
        "closure": scene.run.closure,
        "theory": structure.theory.label.split(" ")[0],
        "ends": [end.name.lower().replace("symmetry", "plane of symmetry") for end in structure.ends],
        "supports": {"points_of_path": supports.rows, "parameters": list(supports.parameters)},
        "profile": structure.body.profile.nodes is not None,
        "point_mass": structure.body.weighted,
    }
