"""Phase diagrams: regimes of runs over planes of dimensionless groups, with the paper's lines."""

from __future__ import annotations

import math
import time
from collections import Counter
from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import cache
from typing import Any, Final, Literal, NamedTuple

import numpy as np
import numpy.typing as npt
import pandas as pd

from softcat_sym.batch.executor import MembersProgress, RunPool, run_pool
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.drawing import Drawable
from softcat_sym.errors import SoftcatError
from softcat_sym.estimates.expected_regime import TURNS_BACK
from softcat_sym.estimates.scaling import beam_of, instant_modulus, section_of, weight_stress
from softcat_sym.physics import beams
from softcat_sym.physics.cross_sections import CrossSection
from softcat_sym.results.motion import ARREST_RATE, ARREST_TIME
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.solution import watched
from softcat_sym.studies.phase_runs import (
    ARREST_FLOW_TIME,
    CLAMP_REGION,
    CLAMPS_ONLY,
    DESCENDING,
    ELASTIC_TIME,
    PASSED,
    PLANES,
    WEIGHT_TIME,
    Node,
    PhasePlane,
    PhaseRun,
    Place,
    RefinedLattice,
    place_at,
    refined,
    refuse_scene,
    run_places,
)

Kind = Literal["first yield", "arrest", "overdamping", "arrest of the span"]
Source = Literal["paper", "exact"]

MIN_RESOLUTION, MAX_RESOLUTION = 4, 640

_PSI, _PSI_POINTS = (0.1, 300.0), 160  # psi of first yield: linear beam to taut string


@dataclass(frozen=True)
class PhaseLine:
    """A line of a formula in a phase diagram."""

    name: str  # Description
    kind: Kind  # The boundary that the formula predicts
    source: Source  # ``"paper"``, or ``"exact"`` for its own idealisation
    equation: str  # Source of the formula
    other: Floats  # delta or V, shape (points,)
    G: Floats  # Gravity number there; NaN where there is none

    def at(self, other: float) -> float:
        """G at a value of the other group, with logarithmic interpolation."""
        return float(np.exp(np.interp(math.log(other), np.log(self.other), np.log(self.G))))


def phase_lines(scene: Scene, plane: PhasePlane, points: int = 81) -> tuple[PhaseLine, ...]:
    """The lines of a plane."""
    other = np.geomspace(plane.y.low, plane.y.high, points)
    places = [place_at(scene, plane, 1.0, float(value)) for value in other]
    section, beam = section_of(scene), beam_of(scene)

    def line(name: str, kind: Kind, source: Source, equation: str, G: Callable[[Place], float]) -> PhaseLine:
        return PhaseLine(name, kind, source, equation, other, np.array([G(place) for place in places]))

    static, exact = beams.first_yield(section, beam, 1.0), beams.ARREST_THRESHOLD_EXACT
    sudden = static / beam.overshoot_bound
    # An arrested filament may still flow at this rate: its stress exceeds the yield stress by the same share.
    at_rate = 1 + ARREST_RATE
    found = [
        line("first yield of a beam", "first yield", "paper", "(3.11)", lambda place: static * place.delta),
        line("arrest of a shallow catenary", "arrest", "paper", "(3.12)", lambda _: math.sqrt(2)),
        line(
            "sudden load, undamped beam",
            "first yield",
            "exact",
            "(3.11) over the bound",
            lambda place: sudden * place.delta,
        ),
        line("arrest of the exact catenary", "arrest", "exact", "(3.12), exact", lambda _: exact),
        line("the same, of rate 0.5", "arrest of the span", "exact", "(3.12) at 1.5 σʏ", lambda _: exact * at_rate),
    ]
    if beam is beams.CLAMPED:
        slow = _slow_yield(scene, section)
        found.append(line("slow load, bending and tension", "first yield", "exact", "(3.11) with tension", slow))
    return tuple(found)


def modulus_number(scene: Scene) -> float:
    """E* = E/(rho g L), the same for all filaments of a diagram."""
    return (instant_modulus(scene) or math.inf) / weight_stress(scene)


def _slow_yield(scene: Scene, section: CrossSection) -> Callable[[Place], float]:
    """G of first yield under a slow load, from eps_Y G E* = 1 along the curve of psi; NaN beyond its end.

    At a given psi, eps_Y is proportional to delta^2 and G to delta: one table of their product serves every filament.
    """
    product, gravity = _yield_curve(section)
    modulus = modulus_number(scene)

    def found(place: Place) -> float:
        wanted = -math.log(modulus * place.delta**3)
        return place.delta * math.exp(float(np.interp(wanted, product, gravity, right=math.nan)))

    return found


@cache
def _yield_curve(section: CrossSection) -> tuple[Floats, Floats]:
    """Logarithms of eps_Y G and of G along the curve of first yield, for a filament with delta = 1."""
    points = np.geomspace(*_PSI, _PSI_POINTS)
    strain, gravity = np.log(beams.stretched_first_yield(points, section.gyration, 1.0, np))
    return strain + gravity, gravity


NO_YIELD, UNDERDAMPED, OVERDAMPED = "no-yield", "arrested-underdamped", "arrested-overdamped"

_RESTS = frozenset({NO_YIELD, UNDERDAMPED, OVERDAMPED})
_SIDES: dict[str, tuple[frozenset[str], frozenset[str]]] = {
    "first yield": (frozenset({NO_YIELD}), frozenset({UNDERDAMPED, OVERDAMPED, DESCENDING, CLAMPS_ONLY})),
    "overdamping": (frozenset({UNDERDAMPED}), frozenset({OVERDAMPED})),
    "arrest": (_RESTS, frozenset({DESCENDING, CLAMPS_ONLY})),
    "arrest of the span": (_RESTS | {CLAMPS_ONLY}, frozenset({DESCENDING})),
}
_FORMULAS_OF: dict[str, tuple[Kind, ...]] = {
    "first yield": ("first yield",),
    "overdamping": ("overdamping",),
    "arrest": ("arrest",),
    "arrest of the span": ("arrest", "arrest of the span"),
}


class Crossing(NamedTuple):
    """A change of regime between two neighbouring runs in a row of the lattice."""

    # The boundary: of first yield, of underdamped arrest, of arrest in every fibre, or of arrest except at the clamps.
    kind: str
    other: float  # delta or V of the row
    G_low: float  # G of the two neighbours
    G_high: float

    @property
    def G(self) -> float:
        """Geometric mean of the two neighbours."""
        return math.sqrt(self.G_low * self.G_high)


class Distance(NamedTuple):
    """Deviation of the runs from one formula."""

    kind: str  # The boundary of the runs
    line: PhaseLine  # The formula
    rows: int  # Rows with a crossing and a value of the formula
    median: float  # G of the runs over that of the formula, minus one
    least: float
    most: float

    def to_dict(self) -> dict[str, Any]:
        """Entry in ``phase.json``."""
        line = {"boundary": self.kind, "line": self.line.name, "source": self.line.source}
        line |= {"equation": self.line.equation}
        return line | {"rows": self.rows, "median": self.median, "least": self.least, "most": self.most}


def crossings(G: Floats, other: Floats, marks: npt.NDArray[np.str_]) -> tuple[Crossing, ...]:
    """Every crossing of a lattice."""
    found = []
    for kind, (below, above) in _SIDES.items():
        for j, value in enumerate(other):
            steps = [i for i in range(len(G) - 1) if marks[i, j] in below and marks[i + 1, j] in above]
            found += [Crossing(kind, float(value), float(G[i]), float(G[i + 1])) for i in steps]
    return tuple(found)


def distances(lines: Sequence[PhaseLine], seen: Sequence[Crossing]) -> tuple[Distance, ...]:
    """Each formula against the crossings of its kind; a row with several crossings counts with its first."""
    found = []
    for kind, line in [(kind, line) for kind in _SIDES for line in lines if line.kind in _FORMULAS_OF[kind]]:
        first: dict[float, Crossing] = {}
        for crossing in seen:
            if crossing.kind == kind:
                first.setdefault(crossing.other, crossing)
        off = np.array([one.G / line.at(one.other) - 1 for one in first.values()])
        off = off[np.isfinite(off)]
        if len(off):
            found.append(Distance(kind, line, len(off), *map(float, (np.median(off), np.min(off), np.max(off)))))
    return tuple(found)


SETTINGS: Final = ("run.effects=paper", "run.accuracy=0.01", "numerics.cells=40", "numerics.grading=30")
"""Settings of a diagram: the published physics, an accuracy that suffices for a regime, one grid for all runs."""


class PhasePoint(NamedTuple):
    """A run and its lattice node."""

    i: int  # Number of the node along G, and along the other group
    j: int
    run: PhaseRun


@dataclass(frozen=True)
class PhaseSheet:
    """One plane."""

    plane: PhasePlane  # Its axes
    x: Floats  # shape (cells + 1,); Lattice values: G, and delta or V
    y: Floats
    points: tuple[PhasePoint, ...]  # The runs
    lattice: RefinedLattice  # Marks of the nodes
    lines: tuple[PhaseLine, ...]  # Formulas
    crossings: tuple[Crossing, ...]  # Boundaries between regimes of runs
    distances: tuple[Distance, ...]  # Deviations of the boundaries from the formulas
    wall: float  # Wall time, and processor time of all threads of this process [s]
    processor: float

    @property
    def nodes(self) -> int:
        """Number of lattice nodes, all of which a diagram without refinement would run."""
        return self.lattice.labels.size

    @property
    def runs(self) -> int:
        """Number of runs, including repetitions."""
        return sum(point.run.runs for point in self.points)

    @property
    def counts(self) -> dict[str, int]:
        """Number of runs with each mark."""
        return dict(sorted(Counter(point.run.mark for point in self.points).items()))

    def held(self, scene: Scene) -> str:
        """Text with the group that does not vary and the modulus."""
        place = place_at(scene, self.plane, float(self.x[0]), float(self.y[0]))
        fixed = (
            f"V = {place.V:.4g}" if self.plane.y.key == "delta" else f"\N{GREEK SMALL LETTER DELTA} = {place.delta:.4g}"
        )
        return f"{fixed}, E = {modulus_number(scene):.4g} \N{GREEK SMALL LETTER RHO} g L"

    def to_dict(self, scene: Scene) -> dict[str, Any]:
        """Entry of the plane in ``phase.json``."""
        return {
            "resolution": self.lattice.cells,
            "held": self.held(scene),
            "nodes": self.nodes,
            "nodes_run": len(self.points),
            "nodes_saved": self.lattice.saved,
            "runs": self.runs,
            "wall_s": self.wall,
            "processor_s": self.processor,
            "marks": self.counts,
            "boundaries": [one.to_dict() for one in self.distances],
        }


@dataclass(frozen=True)
class PhaseDiagram(Drawable):
    """Phase diagrams over one or more planes."""

    scene: Scene  # The common part of all filaments
    sheets: tuple[PhaseSheet, ...]  # One for each plane
    workers: int  # Threads, or workers of a cluster

    def caption(self, sheet: PhaseSheet) -> str:
        """Caption of a plane: its content, the criteria of the regimes, and the runs that refinement saved."""
        effects = self.scene.run.effects
        physics = effects if isinstance(effects, str) else ", ".join(effects)
        return (
            f"Each mark is a run ({physics} physics, {sheet.held(self.scene)}), each tint the regime between runs. "
            f"{len(sheet.points)} of the {sheet.nodes} nodes of a {sheet.lattice.cells} x {sheet.lattice.cells} "
            f"lattice were run, refined where neighbours differ: {sheet.lattice.saved} were saved "
            f"({sheet.lattice.saved / sheet.nodes:.0%}). Arrested: the plastic rate is below {ARREST_RATE:g} σʏ/η in "
            "every fibre over the last tenth of the run; hollow: except within "
            f"{CLAMP_REGION:g} L of the ends, where the clamps still "
            "flow. A run that is no answer has no regime, unless its sag first passes "
            f"{PASSED:g} L: "
            "then the regime is that of the run up to this sag."
        )

    def to_frame(self) -> pd.DataFrame:
        """One row for each filament of each plane, including runs that are no answer.

        Rates are the largest of the last tenth of the run over sigma_Y/eta.
        """
        rows = [
            {"plane": sheet.plane.name, **point.run.to_dict()}
            for sheet in self.sheets
            for point in sorted(sheet.points, key=lambda point: (point.j, point.i))
        ]
        return pd.DataFrame(rows)

    def boundaries(self) -> pd.DataFrame:
        """Boundaries between regimes of runs, a row for each crossing of a lattice row."""
        columns = ("plane", "boundary", "other", "other_value", "G_low", "G_high")
        rows = [
            (sheet.plane.name, found.kind, sheet.plane.y.key, found.other, found.G_low, found.G_high)
            for sheet in self.sheets
            for found in sheet.crossings
        ]
        return pd.DataFrame(rows, columns=columns)

    def lines(self) -> pd.DataFrame:
        """The lines of the formulas, a row for each of their points."""
        tables = []
        for sheet in self.sheets:
            for line in sheet.lines:
                about = {"plane": sheet.plane.name, "line": line.name, "boundary": line.kind, "source": line.source}
                about |= {"equation": line.equation, "other": sheet.plane.y.key}
                tables.append(pd.DataFrame({**about, "other_value": line.other, "G": line.G}))
        return pd.concat(tables)

    def to_dict(self) -> dict[str, Any]:
        """Content of ``phase.json``."""
        return {
            "title": self.scene.title,
            "definitions": {
                "arrested": f"plastic rate below {ARREST_RATE:g} sigma_Y/eta in every fibre over the last "
                f"{ARREST_TIME:.0%} of the run",
                "underdamped": f"the midpoint turned back by more than {TURNS_BACK:.0%} of its largest sag",
                "descending-at-clamps": f"descending, but arrested further than {CLAMP_REGION:g} L from the ends",
                "no answer": f"localised or failed; repeated until the sag passes {PASSED:g} L if it does so",
                "duration": f"ramp + ({ELASTIC_TIME:g} + V min({WEIGHT_TIME:g}, {ARREST_FLOW_TIME:g} G)) sqrt(L/g)",
            },
            "planes": {
                sheet.plane.name: sheet.to_dict(self.scene) | {"caption": self.caption(sheet)} for sheet in self.sheets
            },
            "workers": self.workers,
        }


def phase_diagram(
    scene: Scene,
    planes: Sequence[str] = tuple(PLANES),
    resolution: int = 40,
    *,
    workers: int | None = None,
    executor: Executor | None = None,
    progress: MembersProgress | None = None,
) -> PhaseDiagram:
    """Run filaments over one or more planes and find their regimes."""
    if not planes or not set(planes) <= set(PLANES):
        named = ", ".join(name for name in planes if name not in PLANES)
        raise SoftcatError(f"no phase plane {named or 'named'}; accepted: {', '.join(PLANES)}")
    if type(resolution) is not int or not MIN_RESOLUTION <= resolution <= MAX_RESOLUTION:
        accepted = f"a whole number of cells along each axis, {MIN_RESOLUTION} to {MAX_RESOLUTION}"
        raise SoftcatError(f"resolution = {resolution!r}; accepted: {accepted}")
    refuse_scene(scene)
    # Estimate: refinement along the boundaries runs some nodes in every column.
    chosen = [PLANES[name] for name in dict.fromkeys(planes)]
    with watched(), run_pool(workers, executor, 4 * resolution * len(chosen)) as pool:
        sheets = tuple(_sheet(scene, plane, resolution, pool, progress) for plane in chosen)
        return PhaseDiagram(scene, sheets, pool.size)


def _sheet(scene: Scene, plane: PhasePlane, cells: int, pool: RunPool, progress: MembersProgress | None) -> PhaseSheet:
    begun, spent = time.perf_counter(), time.process_time()
    x, y = (np.geomspace(axis.low, axis.high, cells + 1) for axis in (plane.x, plane.y))
    points: list[PhasePoint] = []

    def marks(nodes: Sequence[Node]) -> list[str]:
        runs = run_places(scene, [place_at(scene, plane, float(x[i]), float(y[j])) for i, j in nodes], pool, progress)
        points.extend(PhasePoint(i, j, run) for (i, j), run in zip(nodes, runs, strict=True))
        return [run.mark for run in runs]

    lattice = refined(cells, marks)
    lines = phase_lines(scene, plane)
    seen = crossings(x, y, lattice.labels)
    return PhaseSheet(
        plane,
        x,
        y,
        tuple(points),
        lattice,
        lines,
        seen,
        distances(lines, seen),
        time.perf_counter() - begun,
        time.process_time() - spent,
    )
