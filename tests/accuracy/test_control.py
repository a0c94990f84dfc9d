"""The loop ends with an answer that is as accurate as was asked, and refines nothing that need not be."""

from __future__ import annotations

from softcat_sym.error_control.control import ROUNDS, controlled

from .known import FIRST, Known, graded, scene_of


def test_an_answer_that_will_do_is_left_alone() -> None:
    known = Known(space=0.8)
    found = controlled(scene_of(), FIRST, known, known, graded)
    assert found.resolution == FIRST
    assert found.refinements == ()


CASES = {
    "space": (Known(space=5.0), {"cells"}),
    "time": (Known(time=200.0), {"rtol"}),
    "section": (Known(section=0.09), {"fibres"}),
    "all": (Known(space=5.0, time=200.0, section=0.09), {"cells", "rtol", "fibres"}),
}


def test_what_falls_short_is_refined_and_nothing_else() -> None:
    for accuracy, case in [
        (1e-3, "all"),
        (1e-4, "all"),
        (1e-4, "section"),
        *((1e-5, name) for name in ("space", "time")),
    ]:
        known, touched = CASES[case]
        found = controlled(scene_of(accuracy), FIRST, known, known, graded)
        assert sum(known.parts(found.resolution)) <= accuracy
        changed = {
            name for name in ("cells", "rtol", "fibres") if getattr(found.resolution, name) != getattr(FIRST, name)
        }
        assert changed == touched
        assert found.refinements


def test_what_the_user_fixed_stays() -> None:
    known = Known(space=20.0, time=200.0, section=0.3)
    found = controlled(scene_of(1e-5, cells=40, rtol=1e-4, fibres=8), FIRST, known, known, graded)
    assert found.resolution == FIRST
    assert found.refinements == ()


def test_hopeless_cases_end() -> None:
    """An error that does not fall with the grid."""
    known = Known(space=1.0, order=0.3)
    found = controlled(scene_of(1e-5), FIRST, known, known, graded)
    assert found.found is not None
    assert found.found.space is not None
    assert found.found.space > 1e-5
    assert len(found.refinements) < ROUNDS


def test_a_run_that_is_not_to_be_trusted_is_not_refined() -> None:
    known = Known(space=1.0)
    found = controlled(scene_of(), FIRST, lambda at: None, known, graded)
    assert found.found is None
    assert known.asked == []


def test_finer_grids_are_graded_anew() -> None:
    """At a hinge no cell may become much shorter than the thickness."""
    known = Known(space=5.0)
    found = controlled(scene_of(1e-4), FIRST, known, known, lambda cells: 400 / cells)
    assert found.resolution.cells > FIRST.cells
    assert found.resolution.grading == 400 / found.resolution.cells
