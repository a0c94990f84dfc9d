"""What is done with the members of a sweep: validated, run, judged; whatever becomes of one, it is a row."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass

from softcat_sym.ensemble.members import Choosing, Member, members_of, pattern_of
from softcat_sym.ensemble.running import Stop, side_by_side
from softcat_sym.ensemble.shared import Workshop
from softcat_sym.ensemble.table import Row
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.scene import Scene
from softcat_sym.simulate import simulated, without_estimate
from softcat_sym.single_run import OF_A_STEP_TOO_LONG
from softcat_sym.study.blocks.work import Told
from softcat_sym.study.judged_member import judged, shared_workshop
from softcat_sym.study.sweep.member_result import FAILED, LOST, REFUSED, MemberResult, answer, no_answer


@dataclass(frozen=True)
class SweepWork:
    """Runs members; it can be sent to another process.

    Attributes
    ----------
    scene : Scene
        What they have in common.
    digest : str
        Of the plan: blocks of one plan share equations, graphs and C code.
    shapes, estimate : bool
        As in the plan.
    """

    scene: Scene
    digest: str
    shapes: bool
    estimate: bool

    def run(self, items: Sequence[Row], threads: int, told: Told) -> list[MemberResult]:
        """Run rows, `threads` at a time; where Python's lock is held while they integrate, one by one."""
        if self.estimate:
            return [self._estimated(row, told) for row in items]
        admitted = admit(self.scene, items)
        found = {k: one for k, one in enumerate(admitted) if isinstance(one, Member)}
        if not all(member.parallel for member in found.values()):
            threads = 1
        stop, workshop = Stop(), shared_workshop(self.digest)
        if len(found) < len(items):
            told(len(items) - len(found))
        ran = side_by_side(
            lambda member: self._ran(member, workshop, stop), [*found.values()], threads, stop, lambda _: told(1)
        )
        results = dict(zip(found, ran, strict=True))
        frames = self.scene.run.frames
        return [results[k] if k in results else no_answer(REFUSED, str(why), frames) for k, why in enumerate(admitted)]

    def lost(self, item: Row, why: str) -> MemberResult:
        """The row of a member that has killed whoever ran it."""
        del item
        return no_answer(LOST, why, self.scene.run.frames)

    def _ran(self, member: Member, workshop: Workshop, stop: Stop) -> MemberResult:
        begun, scene = time.perf_counter(), member.scene
        try:
            run = judged(member, workshop, stop)
        except (SoftcatError, RuntimeError, ArithmeticError, ValueError) as error:
            # What a sweep is worth does not hang on one member.
            return no_answer(FAILED, _text(error), scene.run.frames, scene, wall=time.perf_counter() - begun)
        if run.overlooked or (run.outcome in OF_A_STEP_TOO_LONG and scene.numerics.rtol is None):
            # Rare: what a single run would be repeated for is repeated as a single run, one at a time.
            with workshop.alone():
                return self._simulated(without_estimate(scene), begun)
        wall = time.perf_counter() - begun
        if not run.outcome.is_success:
            return no_answer(run.outcome.name, run.complaint, scene.run.frames, scene, wall=wall)
        times, numbers = run.solution.time * run.prepared.scale, (run.energy_residual, wall)
        places = (run.nodes, run.cells)
        return answer(scene, run.regime or "", times, run.fields, places, numbers, shapes=self.shapes)

    def _estimated(self, row: Row, told: Told) -> MemberResult:
        """A member with its error estimated, refined if it must be."""
        begun = time.perf_counter()
        try:
            (member,) = members_of(self.scene, [row], "each")
            return self._simulated(member.scene, begun)
        except SceneError as error:
            return no_answer(REFUSED, faults_text(error), self.scene.run.frames)
        finally:
            told(1)

    def _simulated(self, scene: Scene, begun: float) -> MemberResult:
        """A member by :func:`softcat_sym.simulate`: every check, and repeated where the finished run calls for it."""
        frames = scene.run.frames
        try:
            run = simulated(scene)
        except (SoftcatError, RuntimeError, ArithmeticError, ValueError) as error:
            outcome = REFUSED if isinstance(error, SceneError) else FAILED
            return no_answer(outcome, _text(error), frames, scene, wall=time.perf_counter() - begun)
        wall = time.perf_counter() - begun
        if not run.outcome.is_success:
            return no_answer(run.outcome.name, run.summary["complaint"], frames, scene, wall=wall)
        fields = {name: run.data[name].values for name in ("x", "y", "stretch")}
        places = (run.data.X_node.values, run.data.X_cell.values)
        numbers = (float(run.summary["energy_residual"]), wall)
        regime = str(run.summary["regime"] or "")
        return answer(scene, regime, run.data.time.values, fields, places, numbers, shapes=self.shapes)


def admit(scene: Scene, rows: Sequence[Row]) -> list[Member | str]:
    """The members that rows make, each whatever the others are; or why one makes none.

    Where the program chooses the effects, it does so for each member by itself. Where the scene names them, the choice
    is made once, and again for a row that changes a choice.
    """
    how: Choosing = "each" if scene.run.effects == "auto" else "once"
    try:
        members = members_of(scene, rows, how)
    except SceneError as error:
        if len(rows) == 1:
            return [faults_text(error)]
        half = len(rows) // 2
        return admit(scene, rows[:half]) + admit(scene, rows[half:])
    # What the first row of its sort was given in a table, each is given here: no member depends on its neighbours.
    base = [pattern_of(scene, row) for row in rows]
    return [
        member if member.pattern == own or how == "each" else members_of(scene, [row], "each")[0]
        for member, row, own in zip(members, rows, base, strict=True)
    ]


def faults_text(error: SceneError) -> str:
    """What is wrong with the scene of a single row."""
    faults = [str(fault).removeprefix("row 0").removeprefix(": ") for fault in error.faults]
    return "; ".join(faults)


def _text(error: Exception) -> str:
    return " ".join(str(error).split()) or type(error).__name__
