"""The collapse test: from the contour of a strand that has come to rest on pillars to its yield stress and modulus.

Ribeiro et al., "Assessing bioink shape fidelity to aid material development in 3D bioprinting", Biofabrication 10,
014102 (2018), print a strand over pillars with gaps of 1 to 16 mm and photograph it. Here every gap is a filament of
its own; all share the material, and one fit has its constants.
"""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from softcat_sym.errors import Fault, SceneError
from softcat_sym.fitting.fit import FitOptions, fit
from softcat_sym.fitting.free_parameters import candidates
from softcat_sym.fitting.measurements import (
    FEWEST,
    Measurements,
    PlainNumber,
    Series,
    Shapes,
    comments_in,
    film_scale,
)
from softcat_sym.fitting.result import Fit
from softcat_sym.scene.laws import laws_with
from softcat_sym.scene.reading import SceneLike, as_scene
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.table_reader import (
    counted,
    known,
    read_table,
    refusal,
)

Floats = NDArray[np.float64]

_KIND = "contour"
_SIGNIFICANT, _LEAST_DROP = 3.0, 0.01
"""Standard errors, and share of the span, from which on a difference of the supports' heights is a drop."""
_WINDOW = 8
"""A strand's slope is that of a line through an eighth of the gap."""
_NEAR, _FEWEST_NEAR = 12, 6
"""The height of an edge is read from points within a twelfth of the gap, six at least."""
_ONE_WAY = 0.75
"""Share of the points of a centre line that go one way at least; of an outline half of them do."""
_RESTING = 0.95
"""Share of the pillars' height at which a strand has come to lie on the bed."""


@dataclass(frozen=True, eq=False)
class Contour:
    """A strand on its pillars, in the frame of the photograph."""

    x: Floats  # shape (points,); [m], to the right; in the order of the file
    y: Floats  # shape (points,); [m], upwards
    gaps: tuple[tuple[float, float], ...]  # x of the left and right edge of each gap [m], from left to right
    pillar_height: float | None = None  # Of the pillars above the bed [m]
    time: float | None = None  # Since the strand was laid [s]; None for the scene's duration
    overrides: tuple[tuple[str, str], ...] = ()  # Values of the scene that stand in the file
    path: Path | None = None
    notes: tuple[str, ...] = ()  # What was left out, a sentence each

    @property
    def forth(self) -> NDArray[np.bool_]:
        """Points from one end to the other, shape (points,): all of a centre line, one of both edges of an outline."""
        ends = sorted((int(np.argmin(self.x)), int(np.argmax(self.x))))
        number = np.arange(self.x.size)
        return np.asarray((number >= ends[0]) & (number <= ends[1]))

    @property
    def is_outline(self) -> bool:
        """Whether the points go forth on one edge and back on the other."""
        return bool(np.mean(self.forth) < _ONE_WAY)


@dataclass(frozen=True, eq=False)
class Gap:
    """The centre line over one gap, level."""

    number: int  # Counted from the left, from 1
    span: float  # Distance of the pillars' edges [m]
    drop: float  # By which the right edge is below the left one [m]; 0 if that is not significant
    level_std: float  # Standard error of the supports' level [m]
    x: Floats  # shape (points,); [m] from halfway between the edges
    y: Floats  # shape (points,); [m] above the left edge
    left_x: float  # Of the left edge and its height in the levelled photograph [m]
    left_y: float

    @property
    def below_chord(self) -> Floats:
        """Depth below the straight line from edge to edge [m], shape (points,)."""
        return np.asarray(-self.drop * (self.x / self.span + 0.5) - self.y)

    @property
    def sag(self) -> float:
        """Largest depth below the chord, of a running mean [m]."""
        return float(_running_lines(self.x, self.below_chord)[0].max())

    @property
    def area(self) -> float:
        """Area between the chord and the strand [m^2]."""
        x = np.concatenate([[-self.span / 2], self.x, [self.span / 2]])
        return float(np.trapezoid(np.concatenate([[0.0], self.below_chord, [0.0]]), x))

    @property
    def angle(self) -> float:
        """Steepest inclination to the chord, mean of both sides [rad]."""
        slope = np.abs(_running_lines(self.x, self.below_chord)[1])
        middle = slope.size // 2
        return float(np.arctan([slope[:middle].max(), slope[middle:].max()]).mean())


@dataclass(frozen=True)
class GapResult:
    """What one gap shows beside the fit."""

    number: int  # Of the gap, from the left
    span: float  # Distance of the edges [m]
    drop: float  # Height of the left above the right one [m]
    sag: float  # Largest depth below their chord [m]
    # Share of the open area below a straight strand that the sagging one takes: 0 for a straight strand; None without
    # ``pillars.height``
    collapsed: float | None
    remaining: float | None  # The share that it leaves, the other published collapse factor: 1 for a straight strand
    angle: float  # Steepest inclination of the strand [rad]
    # Tensile yield stress rho g span/(2 sin(angle)) [Pa], as :func:`closed_form` has it; None where the sag is not
    # significant
    closed_form: float | None
    ratio: float | None  # That over the fitted yield stress


@dataclass(frozen=True, eq=False)
class CollapseTest:
    """A strand's constants, by all gaps together, and what each gap shows."""

    fit: Fit  # Of all gaps
    contour: Contour  # As read
    gaps: tuple[Gap, ...]  # Levelled
    tilt: float  # Of the photograph, by which it was turned back [rad]
    results: tuple[GapResult, ...]  # One for each gap

    def to_dict(self) -> dict[str, Any]:
        """Entry ``collapse_test`` of ``fit.json``, in SI."""
        names = {"span": "span_m", "drop": "drop_m", "sag": "sag_m", "angle": "angle_rad"}
        names |= {"closed_form": "closed_form_yield_stress_Pa", "ratio": "closed_form_over_fit"}
        rows = [{names.get(key, key): value for key, value in vars(one).items()} for one in self.results]
        return {"tilt_rad": self.tilt, "pillar_height_m": self.contour.pillar_height, "gaps": rows}


def read_contour(path: str | os.PathLike[str]) -> Contour:
    """Read the contour of a strand on pillars from a CSV file, in SI and in the frame of the photograph.

    Columns ``x`` and ``y`` in any unit (``x_mm``, ``y [um]``, or ``x_px`` with a line ``# camera.pixel = 0.05 mm``;
    pixels count downwards) hold the strand's centre line from left to right, or its outline, both edges in one go
    around. Lines ``# pillars.gap = 2.0, 6.0`` have the x of both edges of each gap, ``# pillars.height = 6 mm`` is
    optional, and ``# pillars.time = 30 s`` is the age of the photograph, the scene's duration by default. ``#
    filament.thickness = 0.41 mm`` and other values of the scene may stand there too.
    """
    file, accepted = Path(path), "a CSV file with the columns x_mm and y_mm"
    table = read_table(file, _KIND, accepted, ("x", "y"))
    overrides, comments, faults = comments_in(table.text)
    table.refuse(faults)
    columns = table.columns(("x", "y"), film_scale(comments))
    numbers = table.numbers(columns, ("x", "y"))
    numbers = table.without(numbers, numbers.isna().any(axis=1), "number")
    x, y = numbers["x"].to_numpy(), numbers["y"].to_numpy()
    across = next(one for one in columns if one.quantity == "x" and one.fault is None)
    edges = [
        [across.to_si(x) if isinstance(x, PlainNumber) else x for x in pair] for pair in comments.get("pillars.gap", [])
    ]
    gaps = sorted((left, right) for left, right in edges)
    form = f"# {known('comments')['pillars.gap']['form']}; a line for each gap, from left to right"
    faults = [] if gaps else [Fault("pillars.gap", "no gap is named", form)]
    for left, right in gaps:
        inside = int(np.sum((x > left) & (x < right)))
        if inside < FEWEST:
            found = f"{left:g} m to {right:g} m has {counted(inside, 'point')}"
            faults.append(Fault("pillars.gap", found, f"at least {FEWEST} between; {form}"))
    overlaps = [one[1] for one, other in pairwise(gaps) if other[0] < one[1]]
    table.refuse(faults + [Fault("pillars.gap", f"gaps overlap at {place:g} m", form) for place in overlaps])
    height, time = (comments.get(f"pillars.{key}", [(None,)])[0][0] for key in ("height", "time"))
    return Contour(x, y, tuple(gaps), height, time, tuple(overrides.items()), file, table.notes)


def level(contour: Contour) -> tuple[tuple[Gap, ...], float]:
    """Turn the photograph level by the line through all edges, and cut the centre line into its gaps.

    Returned are the gaps from left to right, and the angle by which the photograph is turned back [rad]. Of what the
    edges are then off by, only what is significant is a drop of a support.
    """
    lines = [_centre_line(contour, *edges) for edges in contour.gaps]
    accepted = f"a strand from edge to edge, of points at {FEWEST} distinct x at least"
    faults = [
        Fault(f"gap {number}", f"its points lie at {x.size} distinct x", accepted)
        for number, (x, _) in enumerate(lines, start=1)
        if x.size < FEWEST
    ]
    if faults:
        raise refusal(_KIND, contour.path, faults)
    noise = float(np.median([_noise(*line) for line in lines]))
    edges = np.array(contour.gaps)
    ends = np.array([_edge_heights(contour, line, pair, noise) for line, pair in zip(lines, edges, strict=True)])
    heights, errors = ends[:, :2], np.maximum(ends[:, 2:], 1e-12)
    slope = np.polyfit(edges.ravel(), heights.ravel(), 1, w=1 / errors.ravel())[0]
    tilt = float(np.arctan(slope))
    cos, sin = math.cos(tilt), math.sin(tilt)

    def turned(x: Floats, y: Floats) -> tuple[Floats, Floats]:
        return cos * x + sin * y, cos * y - sin * x

    gaps = []
    for number, (x, y) in enumerate(lines, start=1):
        x_edges, y_edges, error = edges[number - 1], heights[number - 1], errors[number - 1]
        (left, right), (y_left, y_right) = turned(x_edges, y_edges)
        x, y = turned(x, y)
        drop, level_std = float(y_left - y_right), float(np.sqrt(np.sum(error**2)) / 2)
        place = x - (left + right) / 2
        if abs(drop) < max(_SIGNIFICANT * 2 * level_std, _LEAST_DROP * (right - left)):
            y, drop = y + drop * (place / (right - left) + 0.5), 0.0
        gap = Gap(number, float(right - left), drop, level_std, place, y - y_left, float(left), float(y_left))
        gaps.append(gap)
    return tuple(gaps), tilt


def _centre_line(contour: Contour, left: float, right: float) -> tuple[Floats, Floats]:
    """Points over one gap, x increasing, those of one x as their mean; of an outline the middle between its edges."""
    inside = (contour.x > left) & (contour.x < right)

    def line(one: NDArray[np.bool_]) -> tuple[Floats, Floats]:
        x, place, count = np.unique(contour.x[one], return_inverse=True, return_counts=True)
        return x, np.bincount(place, contour.y[one]) / count

    edges = [inside & contour.forth, inside & ~contour.forth]
    if not contour.is_outline or min(int(one.sum()) for one in edges) < FEWEST:
        return line(inside)
    sorted_edges = [line(one) for one in edges]
    places = sorted_edges[0][0]
    both = (places >= sorted_edges[1][0][0]) & (places <= sorted_edges[1][0][-1])
    places = places[both]
    return places, np.asarray(sum(np.interp(places, *one) for one in sorted_edges) / 2)


def _noise(x: Floats, y: Floats) -> float:
    """Standard deviation of a height, by second differences of a centre line."""
    ahead = (x[1:-1] - x[:-2]) / (x[2:] - x[:-2])
    off = y[1:-1] - (1 - ahead) * y[:-2] - ahead * y[2:]
    return float(np.sqrt(np.mean(off**2 / (1 + ahead**2 + (1 - ahead) ** 2))))


def _edge_heights(
    contour: Contour, line: tuple[Floats, Floats], edges: tuple[float, float], noise: float
) -> tuple[float, float, float, float]:
    """Heights of both edges and their standard errors.

    By a straight line through the points on the pillar, where a centre line shows it. Otherwise by a parabola through
    the nearest points of the gap, which a hinge may bend: its error is at least by how much it differs from a line.
    """
    reach = (edges[1] - edges[0]) / _NEAR
    heights, errors = list[float](), list[float]()
    for edge, outwards, others in (
        (edges[0], -1.0, [right for _, right in contour.gaps if right < edges[1]]),
        (edges[1], 1.0, [left for left, _ in contour.gaps if left > edges[0]]),
    ):
        # Half of a pillar is this gap's, the other half that of the next.
        half = min((abs(edge - other) / 2 for other in others), default=reach)
        beyond = outwards * (contour.x - edge)
        on_pillar = (beyond >= 0) & (beyond <= half)
        if not contour.is_outline and on_pillar.sum() >= _FEWEST_NEAR:
            height, error = _intercept(contour.x[on_pillar] - edge, contour.y[on_pillar], 1)
            errors.append(noise * error)
        else:
            near = np.argsort(np.abs(line[0] - edge))[: max(_FEWEST_NEAR, int(np.sum(np.abs(line[0] - edge) < reach)))]
            x, y = line[0][near] - edge, line[1][near]
            height, error = _intercept(x, y, 2)
            errors.append(math.hypot(noise * error, height - _intercept(x, y, 1)[0]))
        heights.append(height)
    return heights[0], heights[1], errors[0], errors[1]


def _intercept(x: Floats, y: Floats, degree: int) -> tuple[float, float]:
    """Value at 0 of the polynomial through some points, and its standard error for points of standard error one."""
    # All points may be at 0.
    row = np.linalg.pinv(np.vander(x / (np.abs(x).max() or 1.0), degree + 1, increasing=True))[0]
    return float(row @ y), float(np.linalg.norm(row))


def _running_lines(x: Floats, y: Floats) -> tuple[Floats, Floats]:
    """Height and slope at every point of the line through its neighbours within a sixteenth of the gap."""
    reach = (x[-1] - x[0]) / (2 * _WINDOW)
    lines = []
    for place in x:
        near = np.argsort(np.abs(x - place))[: max(3, int(np.sum(np.abs(x - place) <= reach)))]
        lines.append(np.polyfit(x[near] - place, y[near], 1))
    slope, height = np.array(lines).T
    return height, slope


def yield_stress_name(scene: Scene) -> str:
    """Name of the yield stress by which the scene states it; a law without one is refused."""
    names = {one.path.rpartition(".")[2] for one in candidates(scene)}
    found = next((name for name in ("yield_stress", "shear_yield_stress") if name in names), None)
    if found is None:
        accepted = f"a law with a yield stress: {', '.join(laws_with('yield_stress'))}"
        raise SceneError([Fault("material.law", f"'{scene.material.law}' has no yield stress to measure", accepted)])
    return found


def measurements_of(contour: Contour, gaps: Sequence[Gap], scene: Scene) -> Measurements:
    """Whole shapes, one film for each gap, of which the only frame is the photograph.

    A strand of a scene with pillars lies on those of each gap, as much longer than it as the scene's is; otherwise the
    ends of the scene hold it at their edges.
    """
    over = scene.filament.span / scene.pillars.gap if scene.pillars.gap else None

    def placed(gap: Gap) -> dict[str, str]:
        drop = {"ends.drop": f"{gap.drop!r} m"}
        if over is None:
            return {"filament.span": f"{gap.span!r} m", **drop}
        return {"filament.span": f"{over * gap.span!r} m", "pillars.gap": f"{gap.span!r} m", **drop}

    when = scene.run.duration if contour.time is None else contour.time
    return Measurements(
        tuple(
            Series(
                np.empty(0),
                np.empty(0),
                shapes=Shapes(np.full(one.x.size, when), one.x, one.y, level_std=one.level_std),
                overrides=placed(one),
                path=contour.path,
                label=f"gap {one.number}, {1e3 * one.span:.3g} mm",
            )
            for one in gaps
        )
    )


def collapse_test(
    contour: Contour | str | os.PathLike[str],
    scene: SceneLike,
    also_free: Sequence[str] = (),
    **how: Unpack[FitOptions],
) -> CollapseTest:
    """Find the yield stress and the modulus of a strand from its contour over gaps between pillars.

    The scene is the strand on one gap: thickness, section, density, surface tension, how it is held, and rough values
    of its constants; its span, or the gap of its ``[pillars]``, is replaced by that of each gap. `also_free` names what
    is fitted besides, such as ``["viscosity"]``; the options are those of :func:`softcat_sym.fit`. A strand on the bed,
    and a law without a yield stress, are refused.
    """
    seen = contour if isinstance(contour, Contour) else read_contour(contour)
    scene = as_scene(scene)
    scene = scene.replace(dict(seen.overrides)) if seen.overrides else scene
    names = [yield_stress_name(scene), "youngs_modulus"]
    gaps, tilt = level(seen)
    if seen.pillar_height is not None:
        resting = [one for one in gaps if one.sag > _RESTING * seen.pillar_height]
        if resting:
            faults = [
                Fault(f"gap {one.number}", f"a sag of {one.sag:.3g} m reaches the bed", "no such gap among pillars.gap")
                for one in resting
            ]
            raise refusal(_KIND, seen.path, faults)
    free = [*names, *(one for one in also_free if one not in names)]
    # The closed formula lies above the yield stress, where a strand stops; below it long ones may fall without end.
    deepest = max(gaps, key=lambda one: one.sag)
    closed = closed_form(deepest, scene)
    if closed is not None:
        closed /= math.sqrt(3) if names[0].startswith("shear") else 1.0
        scene = scene.replace({f"material.{names[0]}": f"{closed!r} Pa"})
    found = fit(measurements_of(seen, gaps, scene), scene, free, **how)
    stress = found.fitted_scene.material.yield_stress or math.nan
    results = tuple(_result(one, seen, found.fitted_scene, stress) for one in gaps)
    return CollapseTest(found, seen, gaps, tilt, results)


def closed_form(gap: Gap, scene: Scene) -> float | None:
    """Tensile yield stress [Pa] that alone carries half of the strand where it is steepest: rho g L/(2 sin(angle)).

    None where the sag is not significant: on average, as the deepest of many points is below any level by its noise.
    """
    if not gap.area > _SIGNIFICANT * gap.level_std * gap.span or not gap.angle > 0:
        return None
    return scene.filament.density * scene.load.gravity * gap.span / (2 * math.sin(gap.angle))


def _result(gap: Gap, contour: Contour, scene: Scene, stress: float) -> GapResult:
    closed, share = closed_form(gap, scene), gap.area / (gap.span * (contour.pillar_height or math.nan))
    known = math.isfinite(share)
    return GapResult(
        number=gap.number,
        span=gap.span,
        drop=gap.drop,
        sag=gap.sag,
        collapsed=share if known else None,
        remaining=1 - share if known else None,
        angle=gap.angle,
        closed_form=closed,
        ratio=None if closed is None else closed / stress,
    )
