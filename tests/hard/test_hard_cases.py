"""Hard cases: a right answer or an honest refusal, never a wrong answer returned as success."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from ..acceptance.table import show
from .case import Case
from .cases import CASES
from .in_a_process import CaseWorker, Seen


def _row(case: Case, seen: Seen, fault: str) -> tuple[str, ...]:
    def short(number: float | None) -> str:
        return "" if number is None else f"{number:.1e}"

    seconds = f"{seen.seconds:.1f}"
    verdict = "known gap" if case.gap and fault else ("RED" if fault else "")
    return case.family, case.name, seen.outcome, short(seen.error), short(seen.estimate), seconds, verdict


@pytest.fixture(scope="module")
def rows() -> Iterator[list[tuple[str, ...]]]:
    """Gathers the table and prints it at the end, whatever failed."""
    found: list[tuple[str, ...]] = []
    yield found
    show("hard cases", ("family", "scene", "outcome", "error", "estimate", "seconds", ""), found)


@pytest.fixture(scope="module")
def worker() -> Iterator[CaseWorker]:
    """The process in which the cases run."""
    made = CaseWorker()
    yield made
    made.close()


def _fault(case: Case, seen: Seen) -> str:
    """What is wrong with an answer or a refusal; empty for a sound one."""
    if not seen.is_success:
        if seen.outcome not in case.refusals:
            return f"must be answered: {seen.outcome}: {seen.message}"
        return "" if case.says in seen.message else f"does not say {case.says!r}: {seen.message}"
    if seen.broken:
        return "broken: " + ", ".join(seen.broken)
    if case.judge is None:
        return f"must be refused, but {seen.outcome}"
    if seen.error is None or not seen.error < case.allowed:
        return f"a wrong answer returned as success: {seen.error} against {case.allowed:g}"
    return ""


def _check(case: Case, rows: list[tuple[str, ...]], worker: CaseWorker) -> None:
    seen = worker.see(case)
    fault = _fault(case, seen)
    rows.append(_row(case, seen, fault))
    print(" | ".join((*rows[-1], fault[:300])), flush=True)
    if case.gap and fault:
        pytest.xfail(f"{case.gap} ({fault})")
    assert not fault, fault
    assert not case.gap, "a known gap is closed: strike it from the table"


@pytest.mark.parametrize("case", [case for case in CASES if case.fast], ids=lambda case: case.title)
def test_fast_hard_case(case: Case, rows: list[tuple[str, ...]], worker: CaseWorker) -> None:
    _check(case, rows, worker)


@pytest.mark.slow
@pytest.mark.parametrize("case", [case for case in CASES if not case.fast], ids=lambda case: case.title)
def test_hard_case(case: Case, rows: list[tuple[str, ...]], worker: CaseWorker) -> None:
    _check(case, rows, worker)
