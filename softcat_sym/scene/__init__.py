"""What is asked: frozen models, units at this boundary only, TOML; and the bundled scenes."""

from __future__ import annotations

from softcat_sym.scene.bundled import bundled_lesson, bundled_names, bundled_text, bundled_title
from softcat_sym.scene.constituents import Mode, Parameter
from softcat_sym.scene.ends import Ends
from softcat_sym.scene.filament import Filament
from softcat_sym.scene.formula import Formula, parse_formula
from softcat_sym.scene.geometry import (
    chord_angle,
    distance,
    is_held,
    is_slack,
    is_symmetric,
    rest_length,
    stress_free_length,
    undeformed_area,
)
from softcat_sym.scene.initial import Initial
from softcat_sym.scene.load import Load
from softcat_sym.scene.material import Material
from softcat_sym.scene.model import Scene
from softcat_sym.scene.numerics import Numerics
from softcat_sym.scene.reading import SceneLike, as_scene, load_scene
from softcat_sym.scene.run import Run
from softcat_sym.scene.scales import Groups, elastic_time, gravity_time, groups_of
from softcat_sym.scene.surroundings import Surroundings

__all__ = [
    "Ends",
    "Filament",
    "Formula",
    "Groups",
    "Initial",
    "Load",
    "Material",
    "Mode",
    "Numerics",
    "Parameter",
    "Run",
    "Scene",
    "SceneLike",
    "Surroundings",
    "as_scene",
    "bundled_lesson",
    "bundled_names",
    "bundled_text",
    "bundled_title",
    "chord_angle",
    "distance",
    "elastic_time",
    "gravity_time",
    "groups_of",
    "is_held",
    "is_slack",
    "is_symmetric",
    "load_scene",
    "parse_formula",
    "rest_length",
    "stress_free_length",
    "undeformed_area",
]
