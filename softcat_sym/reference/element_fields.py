"""Fields of a finished run of the elements, at the instants that were kept: displacements, flow and stress."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from softcat_sym.reference.element import POINTS, Floats, shape_gradients
from softcat_sym.reference.element_run import ElementRun
from softcat_sym.reference.mesh import Strip
from softcat_sym.reference.point import MaterialPoint
from softcat_sym.reference.problem import problem_of
from softcat_sym.scene import Scene


@dataclass(frozen=True)
class ElementField:
    """The half filament X >= 0 at one instant.

    Attributes
    ----------
    time : float
        [s].
    displacement : ndarray, shape (nodes, 2)
        [m].
    shear_rate : ndarray, shape (elements, 4)
        Plastic shear rate |Lp| at the Gauss points [1/s].
    stress : ndarray, shape (elements, 4, 2, 2)
        Cauchy stress in the plane [Pa]; the other components are zero.
    """

    time: float
    displacement: Floats
    shear_rate: Floats
    stress: Floats


def strip_of(scene: Scene, run: ElementRun) -> Strip:
    """The mesh of a run, with its nodes; lengths over the span."""
    return Strip(run.mesh, problem_of(scene).thickness)


def element_fields(scene: Scene, run: ElementRun) -> Iterator[ElementField]:
    """The fields that were kept, in the order of time.

    Parameters
    ----------
    scene : Scene
        What was run.
    run : ElementRun
        What came of it. Instants whose displacements were not kept are left out.

    Yields
    ------
    ElementField
    """
    strip, problem = strip_of(scene, run), problem_of(scene)
    modulus = scene.material.youngs_modulus or 0.0
    law = MaterialPoint(problem.law, dict(problem.material))
    gradient = shape_gradients(POINTS)
    for time, rate, displacement, flow in zip(run.rate_time, run.rate, run.displacement, run.flow, strict=True):
        if not np.isfinite(displacement).all():
            continue
        slopes = np.einsum("eai,Jap->epiJ", displacement[strip.corner] / scene.filament.span, gradient)
        deformation = np.eye(2) + slopes * (2 / strip.size)[:, None, None, :]
        stress = modulus * _cauchy(law, deformation, flow)
        yield ElementField(float(time), displacement, math.sqrt(3) * rate, stress)


def _cauchy(law: MaterialPoint, deformation: Floats, flow: Floats) -> Floats:
    """Cauchy stresses over E of points whose plastic state is known; shape (elements, 4, 2, 2)."""
    found = np.empty_like(deformation)
    for place in np.ndindex(found.shape[:2]):
        law.state = flow[place]
        # No time passes: the elastic response from the plastic state.
        law.step(deformation[place], 0.0)
        found[place] = law.cauchy
    return found
