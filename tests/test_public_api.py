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
from softcat_sym.scene.reading import as_scene

TINY = ["numerics.cells=4", "run.frames=2", "run.duration=1 ms", "numerics.estimate=false"]


def test_every_name_resolves_once_and_says_what_it_is_and_takes() -> None:
    assert list(sc.__all__) == sorted(set(sc.__all__)) == dir(sc)
    for name in sc.__all__:
        thing = getattr(sc, name)
        text = inspect.getdoc(thing) or ""
        assert callable(thing) and thing.__name__ == name and thing.__module__.startswith("softcat_sym.")
        # The docstring that a dataclass makes by itself is its signature.
        assert len(text.split()) >= 4 and not text.startswith(f"{name}("), name
        if inspect.isfunction(thing):
            signature = inspect.signature(thing)
            assert signature.return_annotation is not inspect.Signature.empty, name
            for parameter in signature.parameters.values():
                assert parameter.annotation is not inspect.Parameter.empty, (name, parameter.name)
                assert parameter.name in text, (name, parameter.name)
    with pytest.raises(AttributeError, match=r"no attribute 'simulat'; it has BridgeTable, Card, Effect, .*simulate"):
        _ = sc.simulat
    assert issubclass(SceneError, SoftcatError)
    assert (sc.SceneError, sc.SoftcatError, sc.__version__) == (SceneError, SoftcatError, version("softcat_sym"))


@pytest.mark.parametrize(
    ("code", "heavy"),
    [
        # Loading a module of the same name would put the module where the function was.
        ("import softcat_sym.simulate, softcat_sym.studies.explanation, softcat_sym.cli; "
         "assert all(callable(getattr(sc, name)) for name in sc.__all__)", ()),
        ("dir(sc), sc.__all__, sc.__doc__",
         ("sympy", "matplotlib", "casadi", "xarray", "pint", "pydantic", "rich", "scipy", "pandas", "numpy")),
        ("sc.load_scene('no-yield'), sc.bundled_names()", ("sympy", "matplotlib", "casadi", "xarray")),
        (f"scene = sc.load_scene('cold-honey', {TINY}); "
         "assert sc.explain(scene).regime and sc.simulate(scene).outcome.is_success", ("matplotlib", "xarray")),
    ],
)  # fmt: skip
def test_each_use_loads_no_more_than_it_needs(code: str, heavy: tuple[str, ...]) -> None:
    check = (
        f"import sys, softcat_sym as sc\n{code}\nloaded = {set(heavy)} & set(sys.modules)\nassert not loaded, loaded"
    )
    done = subprocess.run([sys.executable, "-c", check], capture_output=True, text=True, check=False)
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


WIDE = {"filament.span": "6 mm"}


def test_whatever_takes_a_scene_takes_changes(tmp_path: Path) -> None:
    """By name, as a table or as a scene; as a mapping or as texts."""
    ink = sc.load_scene("ink-bridge")
    for given in ("ink-bridge", ink, tomllib.loads(ink.to_toml())):
        for changes in (WIDE, ["filament.span=6 mm"]):
            assert as_scene(given, changes) == sc.load_scene("ink-bridge", WIDE)
    with pytest.raises(SceneError, match=r"filament\.spam"):
        sc.explain("ink-bridge", {"filament.spam": "6 mm"})
    assert sc.simulate("ink-bridge", [*TINY, "filament.span=6 mm"]).scene.filament.span == 0.006
    takers = [getattr(sc, name) for name in sc.__all__ if inspect.isfunction(getattr(sc, name))]
    takers = [one for one in takers if "scene" in inspect.signature(one).parameters]
    assert len(takers) >= 12
    assert all("changes" in inspect.signature(one).parameters for one in takers)


def test_warnings_of_a_run_are_pythons_too_once_each(monkeypatch: pytest.MonkeyPatch) -> None:
    run = sc.simulate(sc.load_scene("cold-honey", TINY))
    run.summary["warnings"] = ["one thing", "another"]
    monkeypatch.setattr(sys.modules["softcat_sym.simulate"], "simulated", lambda *_: run)
    with pytest.warns(sc.SoftcatWarning) as caught:
        sc.simulate("cold-honey")
    assert [str(warning.message) for warning in caught] == ["one thing", "another"]
    assert {warning.filename for warning in caught} == {__file__}
