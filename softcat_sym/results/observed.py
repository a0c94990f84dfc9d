"""What of a run is compared with runs beside it: displacement, and in space all that has an error of its own."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np

from softcat_sym.discretization.unknowns import PLACES, TURN, Floats
from softcat_sym.results.fields import cubic_weights, least_displacement, turn_of, unknown_at
from softcat_sym.scene.scene import Scene, rest_length, undeformed_area
from softcat_sym.solvers.solution import Solution
from softcat_sym.solvers.solve import Prepared

DISPLACEMENT: Final = "displacement"
OWN: Final = ("sideways", "turn", "torque")
"""What has an error of its own in three dimensions, relative to its own largest value."""

NOTHING = 1e-6
"""Share of the largest displacement, and of what it goes with in turns and moments, below which a quantity is none."""

_AS_FAR = 0.999
"""Of the largest displacement: so far a node moves as far."""

_AT_ONCE = 500
"""Frames of which the fields are computed together: a long ringing has thousands."""

Series = Mapping[str, Floats]
"""Quantities over time by name, shape (frames, values)."""


@dataclass(frozen=True)
class Watched:
    """Where each quantity of an answer is largest, and how large; what is nothing is not there."""

    at: Mapping[str, float]  # X/L_0; the displacement is compared at midspan, too
    scale: Mapping[str, float]  # m, rad, N m over the undeformed area

    @classmethod
    def of(cls, scene: Scene, fields: Mapping[str, Floats], moved: Floats, places: tuple[Floats, Floats]) -> Watched:
        """What to watch of a run; displacements are (frames, nodes, axes), places are those of nodes and cells."""
        distance, length = np.sqrt(np.einsum("fna,fna->fn", moved, moved)), rest_length(scene)
        sizes = {DISPLACEMENT: distance}
        least = {DISPLACEMENT: least_displacement(scene, fields)}
        largest = max(float(np.max(distance)), least[DISPLACEMENT])
        if "quaternion" in fields:
            moments = (np.max(np.abs(fields[name])) for name in ("torque", "moment", "moment_2"))
            pull = scene.filament.thickness * float(np.max(np.abs(fields["tension"])))
            sizes["torque"] = np.abs(fields["torque"])
            if largest > least[DISPLACEMENT]:
                sizes["sideways"] = np.abs(moved[..., 2])
            # A clamp holds its section, and is no unknown.
            free = np.ones(len(places[0]), dtype=bool)
            free[[0, -1]] = [not support.holds_angle for support in scene.ends.supports]
            sizes["turn"] = turn_of(fields) * free
            bounds = {"sideways": largest, "turn": largest / length, "torque": max(pull, *map(float, moments))}
            least |= {name: NOTHING * bound for name, bound in bounds.items()}
        at, scale = dict[str, float](), dict[str, float]()
        for name, size in sizes.items():
            most = np.max(size, axis=0)
            # Where several move as far, the midpoint or an end is named.
            named = (len(most) // 2, -1, 0) if name == DISPLACEMENT else ()
            as_far = (node for node in named if most[node] > _AS_FAR * largest)
            where = int(next(as_far, np.argmax(most)))
            if most[where] > least[name] or name == DISPLACEMENT:
                at[name] = float(places[int(name == "torque")][where]) / length
                scale[name] = max(float(most[where]), least[name])
        return cls(at, scale)

    def where(self, other: Watched | None) -> Watched:
        """The sizes of this run where another one is watched."""
        return self if other is None else Watched(other.at, {**other.scale, **self.scale})

    def between_frames(self, series: Series, stride: int) -> Watched:
        """The sizes with what every `stride`-th time, a frame, does not show of the series."""

        def reach(values: Floats) -> float:
            return float(np.max(np.linalg.norm(values - values[0], axis=-1)))

        more = {name: reach(values) - reach(values[::stride]) for name, values in series.items()}
        return Watched(self.at, {name: size + more.get(name, 0.0) for name, size in self.scale.items()})

    def told(self, time: Floats, moved: Floats, nodes: Floats) -> dict[str, object]:
        """What a summary says of the largest displacement [m], where it is (X/L_0), and of the midpoint's height."""
        where = self.at[DISPLACEMENT]
        there = moved[:, int(np.argmin(np.abs(nodes / (nodes[-1] - nodes[0]) - where)))]
        before = [np.interp(0.8 * time[-1], time, each) for each in there.T]
        return {
            "scale_m": self.scale[DISPLACEMENT],
            "largest_m": float(np.max(np.linalg.norm(there, axis=-1))),
            "where": where,
            "final_m": [float(each) + 0.0 for each in there[-1]],
            "last_fifth_m": float(np.linalg.norm(there[-1] - before)),
            "midpoint_m": float(np.max(np.abs(moved[:, moved.shape[1] // 2, 1]))),
        }

    def series(self, scene: Scene, prepared: Prepared, solution: Solution) -> Series:
        """Quantities of a run at the watched places, of whatever grid."""
        graph, unit = prepared.graph, rest_length(scene)
        kinds = {*graph.differential.kinds, *graph.algebraic.kinds}

        def along(names: tuple[str, ...], *places: float) -> Floats:
            rows = [
                unknown_at(graph, solution, name, where)
                for where in places
                for name in names
                # By symmetry the middle of a half moves only up and down.
                if name in kinds and not (name == "x" and where == 0 and graph.grid.is_half)
            ]
            return np.stack(rows, axis=-1)

        found, here = dict[str, Floats](), self.at
        mirrored = abs(here[DISPLACEMENT]) if graph.grid.is_half else here[DISPLACEMENT]
        found[DISPLACEMENT] = unit * along(PLACES, *dict.fromkeys((0.0, mirrored)))
        if "sideways" in here:
            found["sideways"] = unit * along(("z",), here["sideways"])
        if "turn" in here:
            found["turn"] = 2 * along(TURN, here["turn"])
        if "torque" in here:
            near, weights = cubic_weights(graph.grid.centres, here["torque"])
            pieces = (solution.only(slice(k, k + _AT_ONCE)) for k in range(0, len(solution.time), _AT_ONCE))
            torque = [prepared.observe(piece)["torque"][:, near] @ weights for piece in pieces]
            found["torque"] = undeformed_area(scene) * np.concatenate(torque)[:, None]
        return found
