"""Adapter to the public benchmark `cosseratbench` (https://github.com/jakeryderv/cosseratbench): `softcat_sym` there.

Its scenarios become scenes, its rods runs of :func:`softcat_sym.simulate`, their nodes and sections its trajectories.
The benchmark finds :class:`CosseratBenchmarkSolver` by the entry point of this package; it need not be installed.
"""

from __future__ import annotations

import math
from importlib.metadata import version
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from softcat_sym.effects.effect_sets import of_a_rod
from softcat_sym.errors import SceneError
from softcat_sym.scene.scene import Scene
from softcat_sym.simulate import simulate

if TYPE_CHECKING:
    from cosseratbench.scenario import Motion, Rod, Scenario
    from cosseratbench.solver import Capability
    from cosseratbench.trajectory import Trajectory

    from softcat_sym.results.run import Run

Floats = npt.NDArray[np.float64]

_ACCURACY, _LOOSEST, _ORDER = 1e-3, 0.5, 5
"""Accuracy that sets the tolerances, the loosest of them, and the order of the integrator, by which steps follow it."""

_ALONG = 1e-3
"""Angle [rad] below which a clamp points along the line between the ends; a seed of buckling may bend it so far."""

_SAME = 1e-9
"""Part of a length or a force that is rounding."""


class CosseratBenchmarkSolver:
    """Run scenarios of cosseratbench with this package.

    Parameters
    ----------
    time_step_scale : float
        By how much steps are longer than they would be: the tolerance goes with its fifth power.

    Notes
    -----
    Every rod is a scene of its own: nothing touches. What moves slowly (``quasi_static``) is a row of equilibria where
    nothing drives it, whose first frame is the shape that the scenario states; otherwise it is followed with the
    scenario's inertia and a viscous stress in its sections, whose relaxation time is that in which sound runs along it.
    """

    name = "softcat_sym"
    backend_version = version("softcat_sym")

    def __init__(self, time_step_scale: float = 1.0) -> None:
        self.accuracy = min(_ACCURACY * time_step_scale**_ORDER, _LOOSEST)

    @property
    def capabilities(self) -> frozenset[Capability]:
        """Physics that it models, in the benchmark's words."""
        from cosseratbench.solver import Capability

        return frozenset({Capability.STRETCH, Capability.SHEAR})

    def settings(self, scenario: Scenario, *, n_elements: int, n_frames: int) -> dict[str, Any]:
        """Return its numerical choices for a scenario; none for one that it refuses."""
        try:
            scenes = self.scenes(scenario, n_elements=n_elements, n_frames=n_frames)
        except NotImplementedError:
            return {}
        viscosity, rests = scenes[0].material.viscosity, all(is_static(scenario, rod) for rod in scenario.rods)
        return {
            "integrator": "none: Newton's method" if rests else "Rosenbrock, fifth order, adaptive",
            "accuracy": self.accuracy,
            "relaxation_time": 0.0 if viscosity is None else viscosity / scenario.rods[0].material.youngs_modulus,
            "contact": "none: rods pass through each other and themselves",
        }

    def scenes(self, scenario: Scenario, *, n_elements: int, n_frames: int) -> list[Scene]:
        """Return the scene of each rod.

        Parameters
        ----------
        scenario : cosseratbench.Scenario
            What is asked.
        n_elements, n_frames : int
            Cells of a rod, and frames.

        Raises
        ------
        NotImplementedError
            For what is outside the theory or the scenes of this package, by name.
        """
        if scenario.obstacles:
            raise NotImplementedError("contact: nothing can be touched")
        if n_elements % 2 or n_elements < 8:
            raise NotImplementedError(f"{n_elements} elements: an even number of at least 8")
        tables = [self._table(scenario, rod, n_elements, n_frames) for rod in scenario.rods]
        try:
            return [Scene.from_dict(table) for table in tables]
        except SceneError as error:
            raise NotImplementedError(str(error)) from error

    def run(self, scenario: Scenario, *, n_elements: int, n_frames: int) -> Trajectory:
        """Simulate a scenario.

        Parameters
        ----------
        scenario : cosseratbench.Scenario
            What is asked.
        n_elements, n_frames : int
            Cells of a rod, and frames.

        Returns
        -------
        cosseratbench.Trajectory
            Nodes, and a material direction of each element.

        Raises
        ------
        NotImplementedError
            For what is outside the theory or the scenes of this package, by name.
        cosseratbench.solver.Diverged
            If a run ends without success.
        """
        from cosseratbench.solver import Diverged
        from cosseratbench.trajectory import Trajectory

        positions, directors = [], []
        scenes = self.scenes(scenario, n_elements=n_elements, n_frames=n_frames)
        for rod, scene in zip(scenario.rods, scenes, strict=True):
            try:
                run = simulate(scene)
            except SceneError as error:
                raise NotImplementedError(str(error)) from error
            if not run.outcome.is_success:
                raise Diverged(f"{run.outcome.name}: {run.summary['message']}", float(run.data.time.values[-1]))
            places, lines = in_its_words(rod, axes_of(rod, scenario.gravity), run, static=is_static(scenario, rod))
            positions.append(places if len(places) == n_frames else places[[0] + [1] * (n_frames - 1)])
            directors.append(lines if len(lines) == n_frames else lines[[0] + [1] * (n_frames - 1)])
        times = np.linspace(0.0, scenario.duration, n_frames)
        return Trajectory(times, tuple(positions), tuple(directors))

    def _table(self, scenario: Scenario, rod: Rod, n_elements: int, n_frames: int) -> dict[str, Any]:
        """The scene file of a rod, in SI."""
        axes, law = axes_of(rod, scenario.gravity), rod.material
        poisson = law.youngs_modulus / (2 * law.shear_modulus) - 1
        if poisson > 0.5 + _SAME:
            raise NotImplementedError(f"a Poisson ratio of {poisson:.3g}: at most 0.5")
        # A volume that is kept, to the last bit: scenes state less than 0.5.
        poisson = min(poisson, math.nextafter(0.5, 0))
        nodes = (rod.nodes(n_elements) - rod.centerline[0]) @ axes.T
        material = {"law": "elastic", "youngs_modulus": law.youngs_modulus, "poisson": poisson}
        static = is_static(scenario, rod)
        damped = scenario.quasi_static and not static
        initial: dict[str, Any] = {}
        if not static:
            straight = np.outer(np.linspace(0, rod.length, n_elements + 1), [1.0, 0.0, 0.0])
            if np.max(np.abs(nodes - straight)) > _SAME * rod.length:
                initial = {"centreline": nodes.tolist()}
        if damped:
            viscosity = rod.length * math.sqrt(law.density * law.youngs_modulus)
            material |= {"law": "kelvin-voigt", "viscosity": viscosity}
        return {
            "filament": {
                "span": float(np.linalg.norm(nodes[-1])),
                "rest_length": rod.length,
                "diameter": 2 * rod.radius,
                "density": law.density,
            },
            "material": material,
            "ends": _ends(rod, axes),
            "load": _load(scenario, rod, axes),
            "initial": initial,
            "run": {
                "duration": scenario.duration,
                "frames": 2 if static else n_frames,
                "accuracy": self.accuracy,
                "effects": list(of_a_rod(moves=not static, damped=damped)),
            },
            "numerics": {"cells": n_elements // 2, "grading": 1.0, "estimate": False},
        }


def is_static(scenario: Scenario, rod: Rod) -> bool:
    """Tell whether a rod is asked for its equilibrium, and nothing drives it."""
    return bool(scenario.quasi_static) and rod.start_motion is None and rod.end_motion is None


def axes_of(rod: Rod, gravity: tuple[float, float, float]) -> Floats:
    """Axes of a rod's scene in the world, as rows: along its ends, up as far as gravity says it, and across."""
    points = np.asarray(rod.centerline, dtype=float)
    x = _unit(points[-1] - points[0])
    up = -np.asarray(gravity, dtype=float)
    across = up - (up @ x) * x
    if np.linalg.norm(across) <= _SAME * np.linalg.norm(up):
        # No weight, or one along the rod: what then is up is the benchmark's reference.
        across = np.cross(x, np.cross(rod.normal, x))
    y = _unit(across)
    return np.array([x, y, np.cross(x, y)])


def _unit(vectors: Floats) -> Floats:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


def _load(scenario: Scenario, rod: Rod, axes: Floats) -> dict[str, Any]:
    """Gravity, and the force on an end that gives way to it."""
    weight = axes @ np.asarray(scenario.gravity, dtype=float)
    size = float(np.linalg.norm(weight))
    load: dict[str, Any] = {"gravity": size}
    if size:
        direction = np.where(np.abs(weight) < _SAME * size, 0.0, weight / size)
        load["direction"] = direction.tolist()
    force = axes @ sum((np.asarray(one.force, dtype=float) for one in rod.loads if one.at.value == "end"), np.zeros(3))
    force[np.abs(force) < _SAME * np.linalg.norm(force)] = 0.0
    slides = rod.end_motion is not None and rod.end_motion.slides_along is not None
    # What is held carries the rest.
    force *= [1, 0, 0] if slides else rod.end.value == "free"
    return load | {"tip_force": force.tolist()}


def _ends(rod: Rod, axes: Floats) -> dict[str, Any]:
    """Supports; the start of the rod is the left one."""
    if rod.start.value == "free":
        raise NotImplementedError("a rod whose start is free")
    if rod.start_motion is not None:
        raise NotImplementedError("a start that moves: only the end of a rod does")
    segments = _unit(np.diff(np.asarray(rod.centerline, dtype=float), axis=0)) @ axes.T
    for held, tangent in ((rod.start, segments[0]), (rod.end, segments[-1])):
        if held.value == "clamped" and np.linalg.norm(tangent[1:]) > _ALONG:
            raise NotImplementedError("a clamp that does not point along the line between the ends")
    ends = {"left": rod.start.value, "right": rod.end.value}
    return ends if rod.end_motion is None else ends | _driven(rod, rod.end_motion, axes)


def _driven(rod: Rod, motion: Motion, axes: Floats) -> dict[str, Any]:
    """How a clamp at the end moves, turns and slides."""
    moved, turned = (np.asarray(one, dtype=float) @ axes.T for one in (motion.displacement, motion.rotation))
    if np.max(np.abs(turned[:, 1:])) > _SAME * np.max(np.abs(turned)):
        raise NotImplementedError("a clamp that turns about any but its own axis")
    if rod.start.value == "pinned" and np.any(turned):
        raise NotImplementedError("a turning clamp opposite a pin, which holds the spin here")
    if motion.slides_along is not None and np.linalg.norm(np.cross(axes @ motion.axis, [1, 0, 0])) > _SAME:
        raise NotImplementedError("a clamp that slides any way but along the line between the ends")
    ends: dict[str, Any] = {"right_slides": motion.slides_along is not None}
    if np.any(moved):
        ends["motion"] = np.column_stack([motion.times, moved]).tolist()
    if np.any(turned):
        ends["right_twist"] = np.column_stack([motion.times, turned[:, 0]]).tolist()
    return ends


def in_its_words(rod: Rod, axes: Floats, run: Run, *, static: bool) -> tuple[Floats, Floats]:
    """Nodes and directors of a run in the world; of one frame of equilibrium, behind the shape that the rod states."""
    data, cells = run.data, len(run.data.X_cell)
    flat = "z" not in data
    places = np.stack([data.x, data.y, 0 * data.y if flat else data.z], axis=-1)
    places -= places[:, :1]
    if static:
        places[0] = (rod.nodes(cells) - rod.centerline[0]) @ axes.T
    tangents = _unit(np.diff(places, axis=1))
    second = np.cross([0.0, 0.0, 1.0], tangents)
    if not flat:
        # d2 of the turns between two nodes, of any length.
        w, x, y, z = np.moveaxis(data.quaternion.values[:, 1:] + data.quaternion.values[:, :-1], -1, 0)
        second = np.stack([2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)], axis=-1)
        if static:
            second[0] = np.cross([0.0, 0.0, 1.0], tangents[0])
    second = _unit(second - np.sum(second * tangents, axis=-1, keepdims=True) * tangents)
    third = np.cross(tangents, second)
    # Where the material line is in the section it stays.
    lines = rod.directors(cells) @ axes.T
    along, across = (np.sum(lines * one[0], axis=-1)[:, None] for one in (second, third))
    return places @ axes + rod.centerline[0], (along * second + across * third) @ axes
