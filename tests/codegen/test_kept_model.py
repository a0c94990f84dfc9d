"""A model that an earlier process wrote is the one that this process would write."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from types import FunctionType
from typing import Any

import pytest

import softcat_sym as sc
from softcat_sym.codegen import model as kept_model
from softcat_sym.codegen import model as structure
from softcat_sym.codegen.library import kept_texts
from softcat_sym.codegen.model import Structure, _template, model_for, template_kept, template_of
from softcat_sym.codegen.recording import record
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.physics.laws import Branch, Flow
from softcat_sym.physics.symbols import sigma
from softcat_sym.solvers.run import assembled

NAMES = "arrested-overdamped", "bread-dough"
KEYS = f"""
import softcat_sym as sc
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.solvers.run import assembled
for name in {NAMES}:
    scene = sc.load_scene(name)
    print(assembled(scene, choose_effects(scene)).structure().key)
"""


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))


def structure_in(name: str, **changes: Any) -> Structure:
    scene = sc.load_scene(name, {key.replace("__", "."): value for key, value in changes.items()})
    return assembled(scene, choose_effects(scene)).structure()


def forget() -> None:
    model_for.cache_clear()
    _template.cache_clear()


def never() -> Any:
    raise AssertionError("it was there already")


@pytest.mark.parametrize("name", ["maxwell-fast", "cold-honey"])
def test_what_is_read_is_what_was_written(name: str) -> None:
    of = structure_in(name)
    written = template_of(record(of.equations, of.theory, of.ends, of.body))
    assert template_kept(of.key, lambda: written) is written
    assert template_kept(of.key, never) == written


def test_surface_tension_is_another_structure_and_its_size_is_not() -> None:
    """A library without it must never be taken for one that has it: the answer would be six times off, silently."""
    bare = structure_in("ink-bridge", surroundings__surface_tension="0 N/m")
    pulled = structure_in("ink-bridge")
    assert set(pulled.effects) - set(bare.effects) == {"surface-tension"}
    assert pulled.key != bare.key
    assert model_for(pulled).text != model_for(bare).text
    assert "surface_tension" in model_for(pulled).parameters
    assert structure_in("ink-bridge", surroundings__surface_tension="50 mN/m").key == pulled.key


def test_a_further_process_writes_none() -> None:
    forget()
    of = structure_in("maxwell-fast", run__effects="paper")
    first = model_for(of)
    assert len(kept_texts()) == 1
    forget()
    assert model_for(of) == first
    assert len(kept_texts()) == 1


def test_another_program_writes_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    of = structure_in("maxwell-fast", run__effects="paper")
    forget()
    first = _template(of)
    monkeypatch.setattr(kept_model, "_program", lambda: "changed")
    again: list[bool] = []
    template_kept(of.key, lambda: again.append(True) or first)
    assert again


def test_another_number_of_fibres_is_another_library_of_the_same_template() -> None:
    forget()
    first, second = (structure_in("ink-bridge", numerics__fibres=fibres) for fibres in (8, 12))
    assert first.key == second.key
    assert first != second
    assert [len(model_for(of).slots) for of in (first, second)] == [5 + 2 * 8, 5 + 2 * 12]
    assert len(kept_texts()) == 1


def test_the_program_is_known_by_its_whole_code() -> None:
    names = {path.name for path in kept_model._files(kept_model.resources.files("softcat_sym"))}
    assert {"simulate.py", "filament.py", "registry.py"} <= names, "folders within folders, too"


def test_structures_have_the_same_names_in_every_process() -> None:
    environment = {**os.environ, "PYTHONHASHSEED": "1"}
    done = subprocess.run([sys.executable, "-c", KEYS], env=environment, check=True, capture_output=True, text=True)
    assert done.stdout.split() == [structure_in(name).key for name in NAMES]


def test_what_only_an_address_tells_apart_is_not_taken_for_the_same_elsewhere(monkeypatch: pytest.MonkeyPatch) -> None:
    closure = (lambda: None,)
    here = structure._digest(closure)
    assert structure._digest(closure) == here
    monkeypatch.setattr(structure, "_PROCESS", "another")
    assert structure._digest(closure) != here
    assert structure._digest((never,)) == structure._digest((never,))


def test_functions_of_one_name_in_two_modules_are_two() -> None:
    namesake = FunctionType(never.__code__, {}, never.__name__)
    namesake.__module__ = "elsewhere"
    branches = [Branch(flow=Flow(sigma, closed_means=means)) for means in (never, namesake)]
    assert structure._digest((branches[0],)) != structure._digest((branches[1],))


@pytest.mark.parametrize("name", sc.bundled_names())
def test_no_bundled_scene_is_named_by_an_address(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    scene = sc.load_scene(name)
    filament = assembled(scene, choose_effects(scene))
    here = filament.structure().key
    monkeypatch.setattr(structure, "_PROCESS", "another")
    assert filament.structure().key == here
