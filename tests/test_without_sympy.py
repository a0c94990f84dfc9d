"""What a run asks is known without SymPy, and the same as the equations say; nor does it load CasADi."""

from __future__ import annotations

import subprocess
import sys

import sympy as sp

from softcat_sym.physics.densities import Densities
from softcat_sym.physics.section_equations import clocks_of, law_named
from softcat_sym.physics.surroundings import densities_of
from softcat_sym.physics.symbols import g, h0
from softcat_sym.physics.terms import Course, Rheology, Terms
from softcat_sym.scene.laws import LAWS
from softcat_sym.scene.reading import load_scene
from softcat_sym.simulate import simulated

SCENES = ("ink-bridge", "arrested-overdamped", "maxwell-slow", "glass-fibre", "polymer-thread", "coil-spring")
OWN_LAW = """
[filament]
span = "0.2 m"
thickness = "6 mm"
density = "1900 kg/m^3"
[material]
law = "custom"
youngs_modulus = "1 MPa"
flow = "sinh(sigma/s0)/t0"
parameters = {s0 = "9 kPa", t0 = "1 s"}
[run]
duration = "1 s"
"""
CHOOSE = f"""
import sys, tomllib
import softcat_sym as sc
from softcat_sym.discretization.assembly import choose_body, choose_grid, choose_theory
from softcat_sym.discretization.parameters import parameter_values
from softcat_sym.effects.selection import choose_effects
from softcat_sym.effects.theory_limits import theory_limits
from softcat_sym.solvers.settings import choose_backend, settings_for
scenes = [sc.load_scene(name) for name in {SCENES}]
for scene in [*scenes, sc.Scene.from_dict(tomllib.loads({OWN_LAW!r}))]:
    effects = choose_effects(scene)
    hash((effects.terms(), effects.at_rest()))
    settings_for(scene, effects, compiled=choose_backend(scene, effects).compiled)
    theory_limits(scene, effects.names, effects.terms())
    choose_body(scene, choose_grid(scene, effects)), choose_theory(scene, effects.terms()), parameter_values(scene)
assert "sympy" not in sys.modules
"""


def test_a_run_is_prepared_without_sympy() -> None:
    """Effects, tolerances, grid, theory, numbers; with heat, with chains, in space and with a law of its own."""
    subprocess.run([sys.executable, "-c", CHOOSE], check=True)


SHORT = ("numerics.cells=10", "run.duration=0.05 s", "run.frames=11")
RUN = f"""
import sys
import softcat_sym as sc
from softcat_sym.simulate import simulated
assert simulated(sc.load_scene("no-yield", {SHORT})).outcome.is_success
assert not {{"sympy", "casadi"}} & set(sys.modules)
"""


def test_a_run_whose_library_is_cached_loads_neither_sympy_nor_casadi() -> None:
    """With its companions that estimate the error, and all that is judged of it."""
    assert simulated(load_scene("no-yield", SHORT)).outcome.is_success
    subprocess.run([sys.executable, "-c", RUN], check=True)


def test_a_law_is_what_its_equations_are() -> None:
    own = {"custom": {"flow": "sigma/t0", "threshold": True}, "multimode-maxwell": {"modes": 2}}
    for name in LAWS:
        for solvent in (True, False):
            rheology = Rheology(name, solvent=solvent, **own.get(name, {}))
            law, spec = law_named(rheology), rheology.spec
            flows = [branch.flow for branch in law.branches if branch.flow is not None]
            said = (spec.flows, rheology.yields, rheology.is_viscous, spec.has_chains, spec.has_springs)
            found = (law.flows, law.yields, law.viscosity is not None, law.chains is not None, bool(law.branches))
            assert said == found, name
            assert spec.has_closed_means is all(flow.closed_means for flow in flows), name
        for constant in (
            ("mode_1_youngs_modulus", "mode_2_viscosity") if name == "multimode-maxwell" else LAWS[name].constants
        ):
            if constant in ("youngs_modulus", "second_modulus", "viscosity", "yield_stress"):
                terms = Terms(law=rheology, curing=(Course(constant, rows=2),))
                (clock,) = clocks_of(terms)
                assert terms.grows is bool(clock.grows), (name, constant)


def test_what_surrounds_a_filament_leaves_it_symmetric() -> None:
    """And belongs to a cell if it depends on the tangent."""
    for terms in (Terms(buoyant=True), Terms(drag="slender"), Terms(drag="cross-flow"), Terms(added_mass=True)):
        (found,) = densities_of(terms, "rectangle")
        assert found.symmetric
        assert terms.drags is (found.dissipation != 0)
        assert terms.adds_mass is (found.kinetic != 0)
    keys = {Densities("one", stored=one).signature for one in (g, g * h0, g * sp.Float(2), g * 2)}
    assert len(keys) == 4
