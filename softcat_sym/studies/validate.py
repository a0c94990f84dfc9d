"""Validation: published measurements and computations, compared with results of this package."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from importlib.resources import files
from importlib.util import find_spec
from typing import Any, Protocol

import pandas as pd

from softcat_sym import store
from softcat_sym.codegen.compiler import build_identity
from softcat_sym.drawing import Drawable
from softcat_sym.errors import SoftcatError
from softcat_sym.scene.units import did_you_mean
from softcat_sym.studies.published import elastic, glass, viscous, yield_stress
from softcat_sym.studies.published.case import (
    Case,
    CaseCurve,
    CasePicture,
    DataKind,
    Finding,
    PublishedValue,
    published_scene,
)

_RUNS = elastic.RUNS | viscous.RUNS | glass.RUNS | yield_stress.RUNS


def _published_cases() -> tuple[Case, ...]:
    text = (files("softcat_sym.studies.published") / "cases.toml").read_text(encoding="utf-8")
    return tuple(
        Case(**entry | {"kind": DataKind(entry["kind"]), "run": _RUNS.get(entry["name"])})
        for entry in tomllib.loads(text)["case"]
    )


CASES = _published_cases()
"""All cases, in the order of the table."""


class StudyProgress(Protocol):
    """Receiver of the progress of a study with several tasks."""

    def step(self, what: str) -> None:
        """Receive the name of the task that begins."""
        ...


@dataclass(frozen=True)
class Result:
    """Result of a case."""

    case: Case
    finding: Finding | None = None  # Results of the runs; None if there were no runs, or one of them is no answer
    not_run: str = ""  # Why there were no runs
    failure: str = ""  # Why a run is no answer

    def to_dict(self) -> dict[str, Any]:
        """Entry of the case in ``validation.json``."""
        case, found = self.case, self.finding
        texts = ("name", "title", "source", "kind", "stated", "independent", "explains")
        rows = [] if found is None else found.rows
        return {
            **{name: str(getattr(case, name)) for name in texts},
            "not_run": self.not_run,
            "failure": self.failure,
            "scenes": list(case.scenes),
            "rows": [{**asdict(row), "difference": row.difference, "agrees": row.agrees} for row in rows],
            "picture": None if found is None or found.picture is None else asdict(found.picture),
        }


@dataclass(frozen=True)
class Validation(Drawable):
    """Published cases and the results of this package, in the order of the table."""

    results: tuple[Result, ...]

    @property
    def failures(self) -> tuple[Result, ...]:
        """Cases with a run that is no answer."""
        return tuple(result for result in self.results if result.failure)

    def to_dict(self) -> dict[str, Any]:
        """Content of ``validation.json``; absolute differences are in the unit of the quantity, others relative."""
        return {"cases": [result.to_dict() for result in self.results]}

    def to_frame(self) -> pd.DataFrame:
        """One row for each number; a case that was not run is a row without numbers."""
        names = ("quantity", "unit", "published", "ours", "difference", "is_absolute", "band", "agrees")
        rows = []
        for result in self.results:
            each = result.to_dict()
            about = {name: each[name] for name in ("name", "kind", "source")}
            why = {"explains": each["explains"], "not_run": each["not_run"] or each["failure"]}
            for row in each["rows"] or [dict.fromkeys(names)]:
                rows.append({**about, **{name: row[name] for name in names}, **why})
        return pd.DataFrame(rows)

    def __repr__(self) -> str:
        text: str = self.to_frame().to_string()
        return text


def chosen_cases(names: Sequence[str]) -> tuple[Case, ...]:
    """The cases of these names, in the order of the table; all cases if no name is given."""
    known = [case.name for case in CASES]
    for name in names:
        if name not in known:
            raise SoftcatError(f"no case {name!r}{did_you_mean(name, known)}; accepted: {', '.join(known)}")
    return tuple(case for case in CASES if not names or case.name in names)


def validate(names: Sequence[str] = (), progress: StudyProgress | None = None) -> Validation:
    """Compare the package with published measurements and computations; all cases if none is named.

    Nothing is fitted: the constants of every case come from its source. Finished cases come from the store; one that
    cannot be run has a reason, and one whose run is no answer a failure. `progress` receives each name as it begins.
    """
    results = []
    for case in chosen_cases(names):
        if progress is not None:
            progress.step(case.name)
        results.append(_result(case))
    return Validation(tuple(results))


def _result(case: Case) -> Result:
    if case.run is None:
        return Result(case, not_run=case.reason)
    if case.needs and find_spec(case.needs) is None:
        return Result(case, not_run=f"it needs {case.needs}: pip install softcat_sym[peers]")
    scenes = [published_scene(name).to_toml() for name in case.scenes]
    parts = [case.name, scenes, build_identity(), *([store.version(_PACKAGES[case.needs])] if case.needs else [])]
    try:
        return Result(case, store.stored(store.key_of("validation", *parts), case.run, _FORM))
    except SoftcatError as error:
        return Result(case, failure=" ".join(str(error).split()))


_PACKAGES = {"rheodata": "rheopy-rheodata"}
"""Distribution names of needed packages."""


def _read(written: Mapping[str, Any]) -> Finding:
    rows = tuple(PublishedValue(**{**row, "band": row["band"] and tuple(row["band"])}) for row in written["rows"])
    picture = written["picture"]
    if picture is not None:
        picture = CasePicture(**{**picture, "curves": tuple(CaseCurve(**curve) for curve in picture["curves"])})
    return Finding(rows, picture)


_FORM = store.json_form(asdict, _read)
