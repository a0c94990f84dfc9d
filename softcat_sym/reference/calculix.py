"""A scene as an input deck of CalculiX, a finite element program that is not ours."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.reference.element_loop import Clamp, Floats, HalfFilament, Indices, Mesh, problem_of
from softcat_sym.scene.scene import Scene, elastic_time
from softcat_sym.scene.tables import bodies_of

# Points of the table that stands for the quintic ramp; straight lines between them miss it by 2e-5 of gravity.
_RAMP_POINTS = 201

# Keyword lines of CalculiX hold at most 16 entries, and at most 132 characters.
_IN_A_ROW = 8

# CalculiX judges forces by absolute numbers too: with millimetres and grams, which leave stresses in Pa, those of a
# filament lie far above them.
_MM, _GRAM_PER_MM3 = 1e3, 1e-6

# Hilber, Hughes & Taylor's alpha, as CalculiX has it where nothing is said.
_ALPHA = -0.05

STEP = 0.5
"""Longest increment unless another is asked for, in L sqrt(rho/E): a 64th of the first period at h0/L = 0.03.

The flow is of first order in it: the midpoint of the bundled scenes moves by 0.02 to 0.25 % when it is halved.
"""

FIRST_STEP = 0.01
"""First increment over the longest."""


@dataclass(frozen=True)
class Deck:
    """An input deck, and how to read what CalculiX prints."""

    text: str  # The deck; lengths in mm, masses in g, times in s, stresses in Pa
    # shape (columns,); Numbers of the printed nodes: those of the centreline in the plane of symmetry, from midspan
    # to the clamp.
    centreline: Indices
    X: Floats  # shape (columns,); Their reference positions [m]
    time: Floats  # shape (frames,); Output times [s]; CalculiX prints all but the first, which is at rest
    dofs: int  # Displacements that are free


def calculix_deck(scene: Scene, mesh: Mesh | None = None, *, clamp: Clamp = Clamp.THINNING, step: float = STEP) -> Deck:
    """Write a scene as a deck of CalculiX.

    Half the span, from the plane of symmetry at midspan to the clamp, and half the width, from the plane of symmetry
    z = 0 to a free face: plane stress where the width is small against the thickness. The clamped face may do what
    that of our elements may; across the width it is free, as plane stress is. The motion is integrated by the method
    of Hilber, Hughes & Taylor (1977) with the little numerical damping that is CalculiX's own choice.
    """
    if not 0 < step < np.inf:
        raise SoftcatError(f"CalculiX increments of {step} L sqrt(rho/E): take a positive number, such as {STEP}")
    problem = problem_of(scene)
    if problem.pull:
        found = f"{scene.surroundings.surface_tension:g} N/m, which the deck of CalculiX does not know"
        raise SceneError([Fault("surroundings.surface_tension", found, "0 N/m, or our own elements")])
    for body in bodies_of(scene):
        found = "given, but the deck of CalculiX knows neither floor nor pillars"
        raise SceneError([Fault(body.table_name, found, "leaving it out, or our own elements")])
    strip = HalfFilament(mesh if mesh is not None else Mesh(), problem.thickness)
    layers = _Layers(strip, _MM * scene.filament.span, _MM * scene.filament.width / 2)
    time = np.linspace(0.0, scene.run.duration, scene.run.frames)
    held = _held(strip, layers, clamp)
    # On one line that CalculiX reads whole and takes for no keyword.
    title = "".join(letter if letter.isascii() and letter.isprintable() else "?" for letter in scene.title)
    lines = [
        "*HEADING",
        f"softcat_sym: {title}"[:80],
        *layers.lines(),
        *material_lines(scene),
        *held,
        *_ramp(scene),
        "*TIME POINTS, NAME=FRAMES",
        *_rows(map(_real, time[1:])),
        *_motion(scene, step * elastic_time(scene)),
    ]
    return Deck(
        text="\n".join([*lines, ""]),
        centreline=layers.bottom[strip.centreline],
        X=scene.filament.span * strip.position[strip.centreline, 0],
        time=time,
        dofs=3 * layers.count - sum("," in line for line in held),
    )


class _Layers:
    """The strip, drawn out across the width into bricks: z = 0, the middle, the free face."""

    def __init__(self, strip: HalfFilament, span: float, depth: float) -> None:
        self._strip, self._span, self._depth = strip, span, depth
        nodes = len(strip.position)
        self.bottom: Indices = np.arange(1, nodes + 1, dtype=np.int32)
        self.middle: Indices = self.bottom + nodes
        self.top: Indices = self.bottom + 2 * nodes
        # The middle layer has the corners of the elements only.
        self._corners: Indices = np.unique(strip.corner[:, :4])
        self.count = 2 * nodes + len(self._corners)

    def all_at(self, nodes: Indices) -> Indices:
        """Numbers of all nodes of the bricks at some nodes of the strip."""
        corners = nodes[np.isin(nodes, self._corners)]
        return np.concatenate([self.bottom[nodes], self.middle[corners], self.top[nodes]])

    def lines(self) -> Iterator[str]:
        """Nodes, elements and sets."""
        place = self._span * self._strip.position
        every = np.arange(len(place))
        yield "*NODE, NSET=NALL"
        for number, nodes, z in ((self.bottom, every, 0.0), (self.middle, self._corners, 0.5), (self.top, every, 1.0)):
            for node in nodes:
                yield f"{number[node]}, {_real(place[node, 0])}, {_real(place[node, 1])}, {_real(z * self._depth)}"
        yield "*ELEMENT, TYPE=C3D20R, ELSET=EALL"
        for element, nodes in enumerate(self._strip.corner, start=1):
            corners, edges = nodes[:4], nodes[4:]
            parts = (self.bottom[corners], self.top[corners], self.bottom[edges], self.top[edges], self.middle[corners])
            yield ",\n".join(_rows([element, *np.concatenate(parts)]))
        yield "*NSET, NSET=CENTRE"
        yield from _rows(self.bottom[self._strip.centreline])


def _real(value: float) -> str:
    """A number as CalculiX takes it: of more than 20 characters it reads the first 20, and so drops the exponent."""
    return f"{value:.12e}"


def _rows(numbers: Iterable[object]) -> Iterator[str]:
    every = list(numbers)
    for start in range(0, len(every), _IN_A_ROW):
        yield ", ".join(str(number) for number in every[start : start + _IN_A_ROW])


def material_lines(scene: Scene) -> Iterator[str]:
    """The material, and its section: Hooke's law at small strain, density, and flow above the yield stress."""
    material = scene.material
    if material.youngs_modulus is None:
        raise SoftcatError("a deck of CalculiX needs material.youngs_modulus")
    yield "*MATERIAL, NAME=FILAMENT"
    yield "*ELASTIC"
    yield f"{_real(material.youngs_modulus)}, {_real(material.poisson)}"
    yield "*DENSITY"
    yield f"{_real(_GRAM_PER_MM3 * scene.filament.density)}"
    if material.yield_stress is not None:
        yield "*PLASTIC"
        yield f"{_real(material.yield_stress)}, 0."
    if material.viscosity is not None:
        yield "*CREEP, LAW=NORTON"
        yield f"{_real(1 / material.viscosity)}, 1., 0."
    yield "*SOLID SECTION, ELSET=EALL, MATERIAL=FILAMENT"


def _held(strip: HalfFilament, layers: _Layers, clamp: Clamp) -> list[str]:
    """Symmetry in x and z, and the clamp: each line with a comma takes one displacement away."""
    lines = ["*BOUNDARY"]
    lines += [f"{number}, 1" for number in layers.all_at(strip.midspan)]
    lines += [f"{number}, 3" for number in layers.bottom]
    lines += [f"{number}, 1" for number in layers.all_at(strip.face)]
    if clamp is Clamp.FIXED:
        return lines + [f"{number}, 2" for number in layers.all_at(strip.face)]
    height = strip.position[strip.face, 1]
    middle = height == 0
    lines += [f"{number}, 2" for number in layers.all_at(strip.face[middle])]
    # Every other height follows the upper edge in proportion.
    upper = int(strip.face[-1])
    free = int(layers.bottom[upper])
    for node, share in zip(strip.face[~middle], height[~middle] / height[-1], strict=True):
        for number in layers.all_at(np.array([node])):
            if number != free:
                lines += ["*EQUATION", "2", f"{number}, 2, 1., {free}, 2, {_real(-share)}"]
    return lines


def _ramp(scene: Scene) -> Iterator[str]:
    """The quintic step 10 u^3 - 15 u^4 + 6 u^5; without a ramp nothing."""
    if scene.load.ramp == 0:
        return
    yield "*AMPLITUDE, NAME=RAMP, TIME=TOTAL TIME"
    for u in np.linspace(0.0, 1.0, _RAMP_POINTS):
        yield f"{_real(u * scene.load.ramp)}, {_real(u**3 * (10 - 15 * u + 6 * u**2))}"


def _motion(scene: Scene, longest: float) -> Iterator[str]:
    first, ramp = FIRST_STEP * longest, ", AMPLITUDE=RAMP" if scene.load.ramp > 0 else ""
    yield "*STEP, NLGEOM, INC=10000000, AMPLITUDE=STEP"
    yield f"*DYNAMIC, ALPHA={_ALPHA}"
    yield f"{_real(first)}, {_real(scene.run.duration)}, {_real(first * 1e-4)}, {_real(longest)}"
    yield f"*DLOAD{ramp}"
    yield f"EALL, GRAV, {_real(_MM * scene.load.gravity)}, 0., -1., 0."
    yield "*NODE PRINT, NSET=CENTRE, TIME POINTS=FRAMES"
    yield "U"
    yield "*END STEP"
