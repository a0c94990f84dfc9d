"""Explicit finite elements of a filament in plane stress, from a scene to a finished run."""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.reference.element_loop import (
    POINT_STATE,
    POINTS,
    Clamp,
    ElementLoop,
    Floats,
    HalfFilament,
    Mesh,
    Problem,
    half_span_supports,
    largest_frequency,
    problem_of,
    shape_values,
)
from softcat_sym.reference.material_point import point_code
from softcat_sym.scene.scene import Scene, elastic_time
from softcat_sym.store import Form, key_of, packed, stored, unpacked

# Fields kept unless their times are named, evenly spaced; the last output time is always among them.
_FIELDS = 21
ENERGIES = ("kinetic", "elastic", "surface", "contact", "dissipated", "gravity_work", "potential")


class Records:
    """Arrays that fill up as a run goes on."""

    def __init__(self, problem: Problem, strip: HalfFilament, shares: Sequence[float] = ()) -> None:
        frames, elements = problem.frames, len(strip.corner)
        fields = np.array(shares) if len(shares) else np.linspace(0, 1, min(_FIELDS, frames))
        self.frame_of_field = np.unique((fields * (frames - 1)).round().astype(int))
        count = len(self.frame_of_field)
        shapes: dict[str, tuple[int, ...]] = {
            "centreline": (frames, len(strip.centreline), 2),
            **dict.fromkeys(("thinning", "clamp_strain", "clamp_strain_largest", "steps", *ENERGIES), (frames,)),
            "rate": (count, elements, len(POINTS)),
            "displacement": (count, *strip.position.shape),
            "flow": (count, elements, len(POINTS), POINT_STATE),
        }
        self.arrays: dict[str, Floats] = {name: np.full(shape, np.nan) for name, shape in shapes.items()}

    def take(self, frame: int, loop: ElementLoop, steps: int) -> None:
        """Record what the loop holds now."""
        strip = loop.strip
        place = strip.position + loop.displacement
        fibre = np.linalg.norm(loop.deformation()[-strip.mesh.through :, :, :, 0], axis=-1)
        now = {
            "centreline": place[strip.centreline],
            "thinning": np.ptp(place[strip.face, 1]) / np.ptp(strip.position[strip.face, 1]),
            "clamp_strain": np.log(fibre).mean(),
            "clamp_strain_largest": np.log(fibre.max()),
            "steps": steps,
            "kinetic": loop.kinetic_energy,
            "elastic": loop.elastic_energy,
            "surface": loop.surface_energy,
            "contact": loop.contact_energy,
            "dissipated": loop.plastic_work,
            "gravity_work": loop.gravity_work,
            "potential": loop.gravity(loop.time) * (strip.mass @ loop.displacement[:, 1]),
        }
        for name, value in now.items():
            self.arrays[name][frame] = value
        field = np.flatnonzero(self.frame_of_field == frame)
        for name, value in (("rate", loop.rate), ("displacement", loop.displacement), ("flow", loop.point)):
            self.arrays[name][field] = value


@dataclass(frozen=True)
class ElementRun:
    """A finished run. Lengths in m, times in s, energies in J of the whole filament; shapes are of the half X >= 0."""

    time: Floats  # shape (frames,); Output times
    elastic_time: float  # L sqrt(rho/E) [s]; ``time / elastic_time`` is the time of the paper's section 3
    midpoint: Floats  # shape (frames,); Height of the node X = 0, Y = 0, negative downwards
    X: Floats  # shape (columns,); Reference positions of the nodes of the centreline
    x: Floats  # shape (frames, columns); Where they are
    y: Floats
    thinning: Floats  # shape (frames,); Height of the clamped face over its height at the beginning, lambda
    # shape (frames,); Logarithm of the axial stretch |F e_X|, mean over the points of the elements at the clamp.
    clamp_strain: Floats
    clamp_strain_largest: Floats  # shape (frames,); The largest over these points
    # shape (frames,); The potential is that of gravity as it is at the time; external work is what the growth of
    # gravity does.
    energy_kinetic: Floats
    energy_elastic: Floats
    energy_surface: Floats  # Surface tension times what the lateral surface has grown by
    energy_potential: Floats
    energy_dissipated: Floats
    work_external: Floats
    energy_residual: Floats  # shape (frames,); Kinetic + elastic + surface + potential + dissipated - external work
    work: float  # Largest magnitude of the work of gravity: what the residual is to be compared with
    rate_time: Floats  # shape (fields,); Output times at which a rate field is kept, the last one included
    # shape (fields, elements, 4); Equivalent tensile plastic rate [1/s] at the Gauss points; the plastic shear rate
    # is sqrt(3) times it.
    rate: Floats
    displacement: Floats  # shape (fields, nodes, 2); Displacement of every node at the same instants [m]
    # shape (fields, elements, 4, 3); Cp^-1 in the plane, 11, 12, 22, at the Gauss points at the same instants.
    flow: Floats
    point: Floats  # shape (elements, 4, 2); Reference positions X, Y of the Gauss points
    dofs: int  # Displacements that are free
    steps: int  # Steps taken
    wall: float  # Seconds spent, those before a resumption included
    mesh: Mesh  # The elements
    clamp: Clamp  # What the clamped face may do

    @property
    def energy_error(self) -> float:
        """Largest residual over the work of gravity; 0 where nothing moved."""
        return float(np.abs(self.energy_residual).max() / self.work) if self.work > 0 else 0.0


def run_of(scene: Scene, strip: HalfFilament, clamp: Clamp, records: Records, *, dofs: int, wall: float) -> ElementRun:
    """Put units to what was recorded."""
    span, kept, scale = scene.filament.span, records.arrays, elastic_time(scene)
    time = np.linspace(0.0, scene.run.duration, scene.run.frames)
    # Two halves, as wide as the filament.
    held = sum(kept[name] for name in ("kinetic", "elastic", "surface", "contact", "dissipated"))
    joule = 2 * (scene.material.youngs_modulus or 0.0) * span**2 * scene.filament.width
    energy = {name: joule * kept[name] for name in ENERGIES}
    return ElementRun(
        time=time,
        elastic_time=scale,
        midpoint=span * kept["centreline"][:, 0, 1],
        X=span * strip.position[strip.centreline, 0],
        x=span * kept["centreline"][..., 0],
        y=span * kept["centreline"][..., 1],
        **{name: kept[name] for name in ("thinning", "clamp_strain", "clamp_strain_largest", "flow")},
        **{f"energy_{name}": energy[name] for name in ("kinetic", "elastic", "surface", "potential", "dissipated")},
        work_external=joule * (kept["gravity_work"] + kept["potential"]),
        energy_residual=joule * (held - kept["gravity_work"]),
        work=float(np.abs(energy["gravity_work"]).max()),
        rate_time=time[records.frame_of_field],
        rate=kept["rate"] / scale,
        displacement=span * kept["displacement"],
        point=span * strip.points,
        dofs=dofs,
        steps=int(kept["steps"][-1]),
        wall=wall,
        mesh=strip.mesh,
        clamp=clamp,
    )


def strip_of(scene: Scene, run: ElementRun) -> HalfFilament:
    """The mesh of a run, with its nodes; lengths over the span."""
    return HalfFilament(run.mesh, problem_of(scene).thickness)


# Corners and middles of an element's sides in the order of its outline, in lattice coordinates of element.NODES.
_OUTLINE = ((-1, -1), (0, -1), (1, -1), (1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0))


@dataclass(frozen=True)
class Snapshot:
    """The half strip X >= 0 at one instant; lengths over the span, times in units of the caller."""

    time: float
    outline: Floats  # shape (elements, 8, 2); Corners and middles of the sides of each element, in order around it
    quarter: Floats  # shape (4 elements, 4, 2); Corners of the quarter of an element around each Gauss point
    place: Floats  # shape (4 elements, 2); Positions of the Gauss points
    rate: (
        Floats  # shape (4 elements,); Plastic shear rate at the Gauss points, sqrt(3) times the equivalent tensile one
    )


def snapshot(strip: HalfFilament, instant: float, displacement: Floats, rate: Floats) -> Snapshot:
    """The strip with these displacements of its nodes and rates at its Gauss points."""
    corners = (strip.position + displacement)[strip.corner]

    def placed(local: Floats) -> Floats:
        """Positions of points of the parent square, shape (elements, points, 2)."""
        return np.asarray(np.einsum("pa,eai->epi", shape_values(local), corners))

    # The quarter of the parent square in the direction of each point, around it.
    quarters = np.array([[[0.0, 0.0], [x, 0.0], [x, y], [0.0, y]] for x, y in np.sign(POINTS)])
    return Snapshot(
        time=instant,
        outline=placed(np.array(_OUTLINE, dtype=np.float64)),
        quarter=placed(quarters.reshape(-1, 2)).reshape(-1, 4, 2),
        place=placed(POINTS).reshape(-1, 2),
        rate=np.sqrt(3) * rate.ravel(),
    )


# Step over the largest stable one, 2/omega: the rest is for stiffening until the step is chosen anew.
SAFETY = 0.9

# The step is chosen anew at least this often, in L sqrt(rho/E): an elastic wave has crossed the span once.
_STRETCH = 1.0

# Element steps between two looks at the clock and the keyboard: about a tenth of a second.
_CHUNK = 200_000

# A run whose energies do not add up to this, relative to the work of gravity, is not an answer. A sound one is at 1e-5.
_UNBALANCED = 1e-3

# Most of (surface pull over E) times (thickness over the shortest element). The pull falls as an edge stretches, which
# waves along it shorter than about that pull times the thickness do not bear: runs failed from 0.75 on.
_FOLDS = 0.5


def _audited(loop: ElementLoop, work: float) -> float:
    """Largest work of gravity so far; refuses energies that do not add up: steps too long for what the strip became."""
    held = loop.kinetic_energy + loop.elastic_energy + loop.surface_energy + loop.contact_energy + loop.plastic_work
    residual, work = held - loop.gravity_work, max(work, abs(loop.gravity_work))
    # Written so that NaN is refused too.
    if not abs(residual) <= _UNBALANCED * work:
        raise SoftcatError(
            f"finite elements: at t = {loop.time:.6g} L sqrt(rho/E) the energies miss the work of gravity by "
            f"{abs(residual) / work if work else math.inf:.2g} of it; shorten the steps (step_factor below 1) or "
            "refine the mesh where it is stretched most"
        )
    return work


class ElementProgress(Protocol):
    """Listens to a run."""

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Take note of the time reached [s] and of the step [s]."""
        ...


def run_elements(
    scene: Scene,
    mesh: Mesh | None = None,
    *,
    clamp: Clamp = Clamp.THINNING,
    step_factor: float = 1.0,
    fields: Sequence[float] = (),
    progress: ElementProgress | None = None,
) -> ElementRun:
    """Run the elements over a scene: a rectangular filament between two clamps; elastic, Maxwell or Bingham.

    The law is (3.1)-(3.8), corrected, in plane stress; the leap-frog integrates the motion, undamped, in `step_factor`
    of the stable step. The width scales energies, and decides with the thickness how much surface tension pulls: the
    section is taken to shrink alike in both, as the filament's is. `fields` are shares of the duration at which whole
    fields are kept, by default 21 evenly spaced ones.

    SceneError names every key that the elements do not know; SoftcatError if an element is turned inside out, or
    energies do not add up.
    """
    if not 0 < step_factor <= 1:
        raise SoftcatError(f"step_factor of {step_factor}: take a value above 0, and at most 1, the stable step")
    problem, began = problem_of(scene), time.perf_counter()
    strip, code = HalfFilament(mesh if mesh is not None else Mesh(), problem.thickness), point_code(problem.law)
    if problem.pull * problem.thickness > _FOLDS * strip.size[:, 0].min():
        found = f"pulls with {problem.pull:.2g} of Young's modulus, which folds the edges of elements this short"
        raise SceneError(
            [Fault("surroundings.surface_tension", found, "a smaller one, or fewer elements along the span")]
        )
    supports = half_span_supports(strip, clamp)
    loop = ElementLoop(
        strip,
        supports,
        code,
        dict(problem.material),
        gravity=problem.gravity,
        pull=problem.pull,
        ramp=problem.ramp,
        bodies=dict(problem.bodies),
    )
    records, second = Records(problem, strip, fields), elastic_time(scene)
    interval = problem.duration / (problem.frames - 1)
    stretches = math.ceil(interval / _STRETCH)  # Of a frame
    length, taken, work = interval / stretches, 0, 0.0
    for stretch in range(stretches * (problem.frames - 1)):
        frequency = largest_frequency(strip.size, problem.poisson, loop.deformation())
        steps = math.ceil(length * frequency / (2 * SAFETY * step_factor))
        loop.begin(stretch * length, length / steps, steps)
        if stretch == 0:
            loop.evaluate(loop.step, 0.0)
            records.take(0, loop, 0)
        while loop.taken < loop.steps:
            loop.march(loop.taken + max(1, _CHUNK // len(strip.corner)))
            if progress is not None:
                progress.update(second * loop.time, second * loop.step)
        taken, work = taken + steps, _audited(loop, work)
        if (stretch + 1) % stretches == 0:
            records.take((stretch + 1) // stretches, loop, taken)
    # The nodes of a face that thins share one displacement.
    dofs = int(np.sum(~supports.held)) + (1 if len(supports.face) else 0)
    return run_of(scene, strip, clamp, records, dofs=dofs, wall=time.perf_counter() - began)


def element_form(mesh: Mesh, clamp: Clamp) -> Form[ElementRun]:
    """How a finished run is kept."""

    def write(run: ElementRun) -> bytes:
        return packed({name: np.asarray(value) for name, value in vars(run).items() if name not in ("mesh", "clamp")})

    def read(content: bytes) -> ElementRun:
        found: dict[str, Any] = {
            name: array if array.ndim else array.item() for name, array in unpacked(content).items()
        }
        return ElementRun(**found, mesh=mesh, clamp=clamp)

    return Form(write, read)


def recalled_elements(
    scene: Scene,
    mesh: Mesh | None = None,
    *,
    clamp: Clamp = Clamp.THINNING,
    fields: Sequence[float] = (),
    progress: ElementProgress | None = None,
) -> ElementRun:
    """The finished run of :func:`run_elements` from the store; without one it is run, and kept."""
    mesh = mesh if mesh is not None else Mesh()
    sizes = [scene.filament.span, scene.filament.width, scene.material.youngs_modulus, elastic_time(scene)]
    key = key_of("elements", problem_of(scene), sizes, mesh, clamp, list(fields))

    def compute() -> ElementRun:
        return run_elements(scene, mesh, clamp=clamp, fields=fields, progress=progress)

    return stored(key, compute, element_form(mesh, clamp))
