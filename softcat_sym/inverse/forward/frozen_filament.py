"""One filament for all values of what is free: effects, grid, body, unit of time and tolerances are chosen once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from softcat_sym.effects import Effects, choose_effects
from softcat_sym.errors import Fault, SceneError
from softcat_sym.graph.choosing import choose_body, choose_grid
from softcat_sym.graph.grid import Floats
from softcat_sym.graph.parameters import TIME_SCALE, parameter_values, time_scale
from softcat_sym.inverse.forward.compiled import CompiledForward
from softcat_sym.inverse.forward.free import FreeParameter
from softcat_sym.inverse.forward.interpreted import InterpretedForward
from softcat_sym.inverse.forward.path import Begin, Integrator
from softcat_sym.inverse.forward.starts import Starts
from softcat_sym.inverse.forward.substituting import with_values
from softcat_sym.scene import Scene, rest_length
from softcat_sym.solve import Backend, Settings, choose_backend, compiled_settings
from softcat_sym.solve.assembled import Assembled, assembled
from softcat_sym.solve.backend import integrates
from softcat_sym.solve.compiling import compile_filament
from softcat_sym.solve.starting import Start

_ACCURACY = 1e-3
_TIGHT_ENOUGH = 5e-5  # of filaments that ring: measured, 1e-5 of the largest sag
_STEP = 1e-5  # in unknowns of order one; differences of smooth formulas err by 1e-10
_FURTHER = 1e-3  # in unknowns, for what of the supports is free to move


@dataclass(frozen=True)
class Point:
    """The filament with given values.

    Attributes
    ----------
    start : Start
        Where it begins.
    parameters : ndarray, shape (p,)
        Of the graph.
    length : float
        Rest length [m].
    d_parameters, d_x, d_z, d_length : ndarray, shapes (k, p), (k, nx), (k, nz), (k,)
        By each unknown of the scene; k = 0 if they were not asked for.
    """

    start: Start
    parameters: Floats
    length: float
    d_parameters: Floats
    d_x: Floats
    d_z: Floats
    d_length: Floats

    def begin(self, times: Floats) -> Begin:
        """A run from here through these times, in units of the time scale."""
        return Begin(self.start, self.parameters, times, self.d_parameters, self.d_x, self.d_z)


class FrozenFilament:
    """A filament ready to be integrated with any values of its free parameters.

    Parameters
    ----------
    scene : Scene
        With typical values.
    free : sequence of FreeParameter
        What may change, of the scene and of the measurement.
    effects : Effects
        For all values.
    backend : Backend
        What integrates.

    Raises
    ------
    SceneError
        If something free makes no difference.
    """

    def __init__(self, scene: Scene, free: Sequence[FreeParameter], effects: Effects, backend: Backend) -> None:
        self._scene, self.backend = scene, backend
        self._all = tuple(free)
        self.scale = time_scale(scene)
        parts = _assembled(scene, effects, self._all)
        self.graph = parts.graph
        self._starts = Starts(parts, follow=all(one.path != "initial.stretch" for one in self._all))
        self._integrator = self._made(parts, effects)
        self._refuse_what_does_nothing()

    @property
    def integrator(self) -> Integrator:
        """What integrates it."""
        return self._integrator

    @property
    def near(self) -> Start | None:
        """Where the last evaluation began; the next start is followed from there."""
        return self._starts.last

    @near.setter
    def near(self, start: Start | None) -> None:
        self._starts.last = start

    @cached_property
    def free(self) -> tuple[FreeParameter, ...]:
        """Those of the scene."""
        return tuple(one for one in self._all if not one.of_measurement)

    def scene_of(self, q: Floats) -> Scene:
        """The scene with these unknowns, those of the measurement left out."""
        return with_values(self._scene, self.free, [one.value(float(x)) for one, x in zip(self.free, q, strict=True)])

    def point(self, q: Floats, *, slopes: bool) -> Point | None:
        """The filament with these unknowns of the scene, and how it moves with them; None if it cannot begin so.

        Parameters
        ----------
        q : ndarray, shape (k,)
            Of :attr:`free`.
        slopes : bool
            Whether derivatives are wanted: two-sided differences.
        """
        base = self._at(q, None, settle=True)
        if base is None:
            return None
        if not slopes:
            return base
        count = len(self.free)
        p, x, z = (np.zeros((count, part.size)) for part in (base.parameters, base.start.x, base.start.z))
        length = np.zeros(count)
        # In lock-step the compiled solver makes algebraic unknowns consistent by itself.
        settle = not self.backend.compiled or self.graph.positions_are_algebraic or "fibres" in self.graph.effects
        for row, direction in enumerate(np.eye(count)):
            low, high = (self._at(q + step * direction, base.start, settle=settle) for step in (-_STEP, _STEP))
            if low is None or high is None:
                return None
            p[row] = (high.parameters - low.parameters) / (2 * _STEP)
            x[row] = (high.start.x - low.start.x) / (2 * _STEP)
            z[row] = (high.start.z - low.start.z) / (2 * _STEP)
            length[row] = (high.length - low.length) / (2 * _STEP)
        return replace(base, d_parameters=p, d_x=x, d_z=z, d_length=length)

    def _at(self, q: Floats, near: Start | None, *, settle: bool) -> Point | None:
        scene = self.scene_of(q)
        if not scene.filament.thickness < scene.filament.span:
            return None
        values = self.graph.vector(parameter_values(scene) | {TIME_SCALE: self.scale})
        if not np.all(np.isfinite(values)):
            return None
        start = self._starts.at(scene, values, near, settle=settle)
        if start is None:
            return None
        p, x, z = (np.zeros((0, part.size)) for part in (values, start.x, start.z))
        return Point(start, values, rest_length(scene), p, x, z, np.zeros(0))

    def _made(self, parts: Assembled, effects: Effects) -> Integrator:
        scene = self._scene
        settings = _tolerances(scene, effects)
        kinks = np.array(sorted({row[0] / self.scale for row in scene.ends.motion if row[0] > 0}))
        if not self.backend.compiled:
            if kinks.size:
                found = "a support that moves is followed by the compiled solver only, when derivatives are wanted"
                raise SceneError([Fault("ends.motion", found, f"a C compiler; {self.backend.reason}")])
            return InterpretedForward(parts.graph, settings)
        filament = compile_filament(parts.graph, parts.structure())
        works = "v" not in parts.graph.x_kinds
        return CompiledForward(filament, settings, kinks, controls_work=works, jumps="fibres" in effects.names)

    def _refuse_what_does_nothing(self) -> None:
        typical = np.array([one.scaled(one.typical) for one in self.free])
        point = self.point(typical, slopes=True)
        if point is None:
            found = "no shape in balance was found to start from"
            raise SceneError([Fault("ends", found, "supports between which a filament can rest")])
        moves = [np.any(part != 0, axis=1) for part in (point.d_parameters, point.d_x, point.d_z)]
        idle = ~(moves[0] | moves[1] | moves[2] | (point.d_length != 0))
        named = ", ".join(self.graph.effects)
        faults = [
            Fault(
                f"free {one.name}", f"makes no difference with the effects in force: {named}", "run.effects with more"
            )
            for one, does_nothing in zip(self.free, idle, strict=True)
            if does_nothing
        ]
        if faults:
            raise SceneError(faults)


def frozen_filament(scene: Scene, free: Sequence[FreeParameter], backend: str, rtol: float | None) -> FrozenFilament:
    """Choose once what holds for all values.

    Parameters
    ----------
    scene : Scene
        With typical values.
    free : sequence of FreeParameter
        Of it.
    backend : str
        ``"auto"``, ``"compiled"`` or ``"interpreted"``.
    rtol : float or None
        Relative tolerance of the integrator.

    Raises
    ------
    SceneError
        If the filament has nothing to integrate, or no such backend, or something free makes no difference.
    """
    # Whichever backend: a linearly implicit method, whose discrete solution can be differentiated.
    update: dict[str, object] = {"solver": None}
    if backend != "auto":
        update["backend"] = backend
    if rtol is not None:
        update["rtol"] = rtol
    scene = scene.model_copy(update={"numerics": scene.numerics.model_copy(update=update)})
    effects = choose_effects(scene)
    if not integrates(effects.names):
        found = "without inertia or flow nothing of the motion depends on time"
        raise SceneError([Fault("run.effects", found, "inertia, or a law that flows")])
    return FrozenFilament(scene, free, effects, choose_backend(scene, effects))


def _tolerances(scene: Scene, effects: Effects) -> Settings:
    """Those with which the time error is 1e-4 of the largest sag at most; those of a run conserve energy too."""
    accuracy = min(_ACCURACY, scene.run.accuracy)
    accurate = scene.model_copy(update={"run": scene.run.model_copy(update={"accuracy": accuracy})})
    settings = compiled_settings(accurate, effects)
    if scene.numerics.rtol is not None or settings.rtol >= _TIGHT_ENOUGH:
        return settings
    return replace(settings, rtol=_TIGHT_ENOUGH, atol=settings.atol * _TIGHT_ENOUGH / settings.rtol)


def _assembled(scene: Scene, effects: Effects, free: Sequence[FreeParameter]) -> Assembled:
    """The filament, with every support that may move an input of its graph."""
    typical = assembled(scene, effects)
    moved = with_values(scene, free, [one.value(one.scaled(one.typical) - _FURTHER) for one in free])
    if choose_body(moved, choose_grid(scene, effects)).supports == typical.body.supports:
        return typical
    return assembled(moved, effects)
