"""What ``import softcat_sym as sc`` offers: every name is there, documented, and loaded when it is used."""

from __future__ import annotations

import inspect
import subprocess
import sys
import tomllib
from importlib.metadata import version
from pathlib import Path

import pytest

import softcat_sym as sc
from softcat_sym.errors import SceneError, SoftcatError

FUNCTIONS = (
    *("card", "explain", "fit_flow_curve", "generate", "load_scene", "price_effects", "simulate", "simulate_many"),
)
TINY = ["numerics.cells=4", "run.frames=2", "run.duration=1 ms", "numerics.estimate=false"]
# What each step of a program loads, in a new Python.
LIGHT = """
import sys

def none_of(*names):
    loaded = set(names) & set(sys.modules)
    assert not loaded, loaded

import softcat_sym as sc
dir(sc), sc.__all__, sc.__doc__
none_of("sympy", "casadi", "matplotlib", "xarray", "pint", "pydantic", "scipy", "pandas", "rich")

sc.load_scene("no-yield"), sc.bundled_names()
none_of("sympy", "casadi", "matplotlib", "scipy")

scene = sc.load_scene("cold-honey", ["numerics.cells=4", "run.frames=2", "run.duration=1 ms"])
assert sc.explain(scene).regime and sc.simulate(scene).outcome.is_success
# Simplifying loads the units of SymPy, in a seventh of a second.
none_of("matplotlib", "sympy.physics.units")

# Loading a module of the same name would put the module where the function was.
import softcat_sym.simulate, softcat_sym.studies.explanation, softcat_sym.cli
assert all(callable(getattr(sc, name)) for name in sc.__all__)
"""


def test_every_name_is_sorted_documented_and_resolves() -> None:
    assert list(sc.__all__) == sorted(set(sc.__all__)) == dir(sc)
    for name in sc.__all__:
        thing = getattr(sc, name)
        assert callable(thing)
        assert thing.__name__ == name and thing.__module__.startswith("softcat_sym.")
        assert len((inspect.getdoc(thing) or "").split()) >= 4
        # The docstring that a dataclass makes by itself is its signature.
        assert not (thing.__doc__ or "").startswith(f"{name}(")
    with pytest.raises(AttributeError, match=r"no attribute 'simulat'; it has Card, Ensemble, .*simulate"):
        _ = sc.simulat
    assert sc.__version__ == version("softcat_sym")


def test_every_function_documents_and_annotates_its_parameters() -> None:
    for name in FUNCTIONS:
        function = getattr(sc, name)
        signature = inspect.signature(function)
        for parameter in signature.parameters.values():
            assert parameter.annotation is not inspect.Parameter.empty
            assert parameter.name in (function.__doc__ or ""), (name, parameter.name)
        assert signature.return_annotation is not inspect.Signature.empty


def test_one_exception_catches_all() -> None:
    assert issubclass(SceneError, SoftcatError)
    assert (sc.SceneError, sc.SoftcatError) == (SceneError, SoftcatError)


def test_each_step_loads_only_what_it_needs() -> None:
    done = subprocess.run([sys.executable, "-c", LIGHT], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_a_scene_is_given_by_path_table_or_itself_and_a_run_read_again(tmp_path: Path) -> None:
    scene = sc.load_scene("cold-honey", TINY)
    path = tmp_path / "mine.toml"
    path.write_text(scene.to_toml())
    runs = [sc.simulate(given) for given in (scene, path, str(path), tomllib.loads(path.read_text()))]
    assert all(run.data.identical(runs[0].data.assign_attrs(run.data.attrs)) for run in runs)
    assert sc.explain("cold-honey").title == sc.explain(sc.load_scene("cold-honey")).title
    with pytest.raises(SceneError, match="is not a table"):
        sc.simulate(3)  # type: ignore[arg-type]
    assert len(repr(runs[0]).splitlines()) == 5 and len(repr(runs[0])) < 500
    runs[0].save(tmp_path / "out")
    again = sc.open_run(tmp_path / "out")
    assert (again.summary, again.scene, again.outcome) == (runs[0].summary, scene, runs[0].outcome)
    with pytest.raises(SoftcatError, match="no such file; accepted: a trajectory"):
        sc.open_run(tmp_path)


def test_warnings_of_a_run_are_pythons_too_once_each(monkeypatch: pytest.MonkeyPatch) -> None:
    run = sc.simulate(sc.load_scene("cold-honey", TINY))
    run.summary["warnings"] = ["one thing", "another"]
    monkeypatch.setattr(sys.modules["softcat_sym.simulate"], "simulated", lambda *_: run)
    with pytest.warns(sc.SoftcatWarning) as caught:
        sc.simulate("cold-honey")
    assert [str(one.message) for one in caught] == ["one thing", "another"]
    assert {one.filename for one in caught} == {__file__}
