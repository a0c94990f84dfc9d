"""Held against the world: what others have measured or computed, beside what comes out here."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, Protocol

import pandas as pd

from softcat_sym import store
from softcat_sym.codegen.compiler import build_identity
from softcat_sym.errors import SoftcatError
from softcat_sym.scene.units import did_you_mean
from softcat_sym.studies.published import elastic, glass, viscous, yielding
from softcat_sym.studies.published.case import Case, Curve, Finding, Picture, Row, published_scene

if TYPE_CHECKING:
    from matplotlib.figure import Figure

CASES = (*elastic.CASES, *viscous.CASES, *glass.CASES, *yielding.CASES)
"""All cases, in the order of the table."""


class Steps(Protocol):
    """Listens to a study of several tasks."""

    def step(self, what: str) -> None:
        """Take note of which task begins."""
        ...


@dataclass(frozen=True)
class Result:
    """A case, and what came out.

    Attributes
    ----------
    case : Case
        What others have published.
    finding : Finding or None
        What the runs have come to; None where there were none, or one of them is no answer.
    not_run : str
        Why there were none; empty otherwise.
    failure : str
        What is wrong with a run that is no answer; empty otherwise.
    """

    case: Case
    finding: Finding | None = None
    not_run: str = ""
    failure: str = ""

    def to_dict(self) -> dict[str, Any]:
        """What ``validation.json`` holds of it."""
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
class Validation:
    """Published cases beside what comes out here.

    Attributes
    ----------
    results : tuple of Result
        One a case, in the order of the table.
    """

    results: tuple[Result, ...]

    @property
    def failures(self) -> tuple[Result, ...]:
        """Cases with a run that is no answer."""
        return tuple(result for result in self.results if result.failure)

    def to_dict(self) -> dict[str, Any]:
        """What ``validation.json`` holds; differences are in the unit of an absolute one, else relative."""
        return {"cases": [result.to_dict() for result in self.results]}

    def to_frame(self) -> pd.DataFrame:
        """One row a number; a case that was not run is one without any."""
        names = ("quantity", "unit", "published", "ours", "difference", "is_absolute", "band", "agrees")
        rows = []
        for result in self.results:
            each = result.to_dict()
            about = {name: each[name] for name in ("name", "kind", "source")}
            why = {"explains": each["explains"], "not_run": each["not_run"] or each["failure"]}
            for row in each["rows"] or [dict.fromkeys(names)]:
                rows.append({**about, **{name: row[name] for name in names}, **why})
        return pd.DataFrame(rows)

    def figures(self) -> dict[str, Figure]:
        """A picture of each case that has one, by its name."""
        from softcat_sym.plotting.validate import case_figure

        return {
            result.case.name: case_figure(result)
            for result in self.results
            if result.finding is not None and result.finding.picture is not None
        }

    def plot(self) -> Figure:
        """Draw all differences in one picture."""
        from softcat_sym.plotting.validate import validation_figure

        return validation_figure(self)

    def _repr_html_(self) -> str:
        from softcat_sym.plotting.notebook import html

        return html(self.to_frame().to_string(), self.plot())


def chosen_cases(names: Sequence[str]) -> tuple[Case, ...]:
    """The cases of these names, in the order of the table; all of them without any.

    Raises
    ------
    SoftcatError
        If there is no such case.
    """
    known = [case.name for case in CASES]
    for name in names:
        if name not in known:
            raise SoftcatError(f"no case {name!r}{did_you_mean(name, known)}; accepted: {', '.join(known)}")
    return tuple(case for case in CASES if not names or case.name in names)


def validate(names: Sequence[str] = (), progress: Steps | None = None) -> Validation:
    """Hold the package against what others have measured or computed.

    Nothing is fitted: every case has its constants from its source. Finished cases come from the store.

    Parameters
    ----------
    names : sequence of str
        Of the cases; all of them if empty.
    progress : Steps, optional
        Told which case begins.

    Returns
    -------
    Validation
        A case that cannot be run stands in it with the reason; one with a run that is no answer with its failure.

    Raises
    ------
    SoftcatError
        If there is no case of a name.
    KeyboardInterrupt
        On Ctrl-C.
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
"""Names under which what is needed is installed."""


def _read(written: Mapping[str, Any]) -> Finding:
    rows = tuple(Row(**{**row, "band": row["band"] and tuple(row["band"])}) for row in written["rows"])
    picture = written["picture"]
    if picture is not None:
        picture = Picture(**{**picture, "curves": tuple(Curve(**curve) for curve in picture["curves"])})
    return Finding(rows, picture)


_FORM = store.json_form(asdict, _read)
