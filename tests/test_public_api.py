"""What ``import softcat_sym as sc`` offers: every name is there, says what it is, and is loaded when it is used."""

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


def in_a_new_python(code: str) -> None:
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_the_names_are_sorted_once_each_and_listed() -> None:
    assert list(sc.__all__) == sorted(set(sc.__all__))
    assert dir(sc) == sorted(sc.__all__)


def test_every_name_resolves_and_says_what_it_is() -> None:
    for name in sc.__all__:
        thing = getattr(sc, name)
        assert callable(thing)
        assert thing.__name__ == name and thing.__module__.startswith("softcat_sym.")
        assert len((inspect.getdoc(thing) or "").split()) >= 4
        # The docstring that a dataclass makes by itself is its signature.
        assert not (thing.__doc__ or "").startswith(f"{name}(")


FUNCTIONS = [
    "card",
    "explain",
    "fit_flow_curve",
    "generate",
    "load_scene",
    "price_effects",
    "simulate",
    "simulate_many",
]


def test_every_function_tells_its_parameters_and_annotates_them() -> None:
    for name in FUNCTIONS:
        function = getattr(sc, name)
        signature = inspect.signature(function)
        for parameter in signature.parameters.values():
            assert parameter.annotation is not inspect.Parameter.empty
            assert parameter.name in (function.__doc__ or ""), (name, parameter.name)
        assert signature.return_annotation is not inspect.Signature.empty


def test_a_name_that_is_not_there_is_told_with_those_that_are() -> None:
    with pytest.raises(AttributeError, match=r"no attribute 'simulat'; it has Card, Ensemble, .*simulate"):
        _ = sc.simulat


def test_one_exception_catches_all() -> None:
    assert issubclass(SceneError, SoftcatError)
    assert (sc.SceneError, sc.SoftcatError) == (SceneError, SoftcatError)


def test_a_name_takes_the_place_of_no_module() -> None:
    """Loading a module of the same name would put the module where the function was."""
    code = (
        "import softcat_sym as sc, softcat_sym.simulate, softcat_sym.studies.explanation, softcat_sym.cli\n"
        "assert all(callable(getattr(sc, name)) for name in sc.__all__)\n"
    )
    in_a_new_python(code)


def test_neither_the_import_nor_a_list_of_its_names_loads_anything_heavy() -> None:
    code = (
        "import sys, softcat_sym as sc\n"
        "dir(sc), sc.__all__, sc.__doc__\n"
        "heavy = {'sympy', 'matplotlib', 'casadi', 'xarray', 'pint', 'pydantic', 'rich'} & set(sys.modules)\n"
        "assert not heavy, heavy\n"
    )
    in_a_new_python(code)


def test_a_scene_is_read_without_sympy_casadi_or_matplotlib() -> None:
    code = (
        "import sys, softcat_sym as sc\n"
        "sc.load_scene('no-yield'), sc.bundled_names()\n"
        "heavy = {'sympy', 'matplotlib', 'casadi'} & set(sys.modules)\n"
        "assert not heavy, heavy\n"
    )
    in_a_new_python(code)


def test_a_scene_is_explained_and_run_without_matplotlib() -> None:
    code = (
        "import sys, softcat_sym as sc\n"
        "scene = sc.load_scene('cold-honey', ['numerics.cells=4', 'run.frames=2', 'run.duration=1 ms'])\n"
        "assert sc.explain(scene).regime and sc.simulate(scene).outcome.is_success\n"
        "assert 'matplotlib' not in sys.modules\n"
    )
    in_a_new_python(code)


TINY = ["numerics.cells=4", "run.frames=2", "run.duration=1 ms", "numerics.estimate=false"]


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


def test_the_version_is_told() -> None:
    assert sc.__version__ == version("softcat_sym")


def test_warnings_of_a_run_are_pythons_too_once_each(monkeypatch: pytest.MonkeyPatch) -> None:
    run = sc.simulate(sc.load_scene("cold-honey", TINY))
    run.summary["warnings"] = ["one thing", "another"]
    monkeypatch.setattr(sys.modules["softcat_sym.simulate"], "simulated", lambda *_: run)
    with pytest.warns(sc.SoftcatWarning) as caught:
        sc.simulate("cold-honey")
    assert [str(one.message) for one in caught] == ["one thing", "another"]
    assert {one.filename for one in caught} == {__file__}
