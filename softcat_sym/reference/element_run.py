"""What a run of the elements gives: SI values of the whole filament."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from softcat_sym.reference.element import Floats
from softcat_sym.reference.mesh import Mesh, Strip
from softcat_sym.reference.records import Records
from softcat_sym.reference.supports import Clamp
from softcat_sym.scene import Scene
from softcat_sym.scene.scales import elastic_time


@dataclass(frozen=True)
class ElementRun:
    """A finished run. Lengths in m, times in s, energies in J of the whole filament; shapes are of the half X >= 0.

    Attributes
    ----------
    time : ndarray, shape (frames,)
        Output times.
    elastic_time : float
        L sqrt(rho/E) [s]; ``time / elastic_time`` is the time of the paper's section 3.
    midpoint : ndarray, shape (frames,)
        Height of the node X = 0, Y = 0, negative downwards.
    X : ndarray, shape (columns,)
        Reference positions of the nodes of the centreline.
    x, y : ndarray, shape (frames, columns)
        Where they are.
    thinning : ndarray, shape (frames,)
        Height of the clamped face over its height at the beginning, lambda.
    clamp_strain : ndarray, shape (frames,)
        Logarithm of the axial stretch |F e_X|, mean over the points of the elements at the clamp.
    clamp_strain_largest : ndarray, shape (frames,)
        The largest over these points.
    energy_kinetic, energy_elastic, energy_potential, energy_dissipated, work_external : ndarray, shape (frames,)
        The potential is that of gravity as it is at the time; external work is what the growth of gravity does.
    energy_residual : ndarray, shape (frames,)
        Kinetic + elastic + potential + dissipated - external work.
    work : float
        Largest magnitude of the work of gravity: what the residual is to be compared with.
    rate_time : ndarray, shape (fields,)
        Output times at which a rate field is kept, the last one included.
    rate : ndarray, shape (fields, elements, 4)
        Equivalent tensile plastic rate [1/s] at the Gauss points; the plastic shear rate is sqrt(3) times it.
    displacement : ndarray, shape (fields, nodes, 2)
        Displacement of every node at the same instants [m].
    flow : ndarray, shape (fields, elements, 4, 3)
        Cp^-1 in the plane, 11, 12, 22, at the Gauss points at the same instants.
    point : ndarray, shape (elements, 4, 2)
        Reference positions X, Y of the Gauss points.
    dofs : int
        Displacements that are free.
    steps : int
        Steps taken.
    wall : float
        Seconds spent, those before a resumption included.
    mesh : Mesh
        The elements.
    clamp : Clamp
        What the clamped face may do.
    """

    time: Floats
    elastic_time: float
    midpoint: Floats
    X: Floats
    x: Floats
    y: Floats
    thinning: Floats
    clamp_strain: Floats
    clamp_strain_largest: Floats
    energy_kinetic: Floats
    energy_elastic: Floats
    energy_potential: Floats
    energy_dissipated: Floats
    work_external: Floats
    energy_residual: Floats
    work: float
    rate_time: Floats
    rate: Floats
    displacement: Floats
    flow: Floats
    point: Floats
    dofs: int
    steps: int
    wall: float
    mesh: Mesh
    clamp: Clamp

    @property
    def energy_error(self) -> float:
        """Largest residual over the work of gravity; 0 where nothing moved."""
        return float(np.abs(self.energy_residual).max() / self.work) if self.work > 0 else 0.0


def run_of(scene: Scene, strip: Strip, clamp: Clamp, records: Records, *, dofs: int, wall: float) -> ElementRun:
    """Put units to what was recorded.

    Parameters
    ----------
    scene : Scene
        Gives span, width, density and modulus.
    strip : Strip
        The mesh.
    clamp : Clamp
        What the clamped face may do.
    records : Records
        Complete.
    dofs : int
        Displacements that are free.
    wall : float
        Seconds spent.
    """
    span, kept, scale = scene.filament.span, records.arrays, elastic_time(scene)
    time = np.linspace(0.0, scene.run.duration, scene.run.frames)
    # Two halves, as wide as the filament.
    joule, stored = 2 * (scene.material.youngs_modulus or 0.0) * span**2 * scene.filament.width, _stored(kept)
    return ElementRun(
        time=time,
        elastic_time=scale,
        midpoint=span * kept["centreline"][:, 0, 1],
        X=span * strip.position[strip.centreline, 0],
        x=span * kept["centreline"][..., 0],
        y=span * kept["centreline"][..., 1],
        thinning=kept["thinning"],
        clamp_strain=kept["clamp_strain_mean"],
        clamp_strain_largest=kept["clamp_strain_largest"],
        energy_kinetic=joule * kept["kinetic"],
        energy_elastic=joule * kept["elastic"],
        energy_potential=joule * kept["potential"],
        energy_dissipated=joule * kept["dissipated"],
        work_external=joule * (kept["gravity_work"] + kept["potential"]),
        energy_residual=joule * (stored - kept["gravity_work"]),
        work=float(joule * np.abs(kept["gravity_work"]).max()),
        rate_time=time[records.frame_of_field],
        rate=kept["rate"] / scale,
        displacement=span * kept["displacement"],
        flow=kept["flow"],
        point=span * strip.points,
        dofs=dofs,
        steps=int(kept["steps"][-1]),
        wall=wall,
        mesh=strip.mesh,
        clamp=clamp,
    )


def _stored(kept: Mapping[str, Floats]) -> Floats:
    """Kinetic, elastic and dissipated energy."""
    return kept["kinetic"] + kept["elastic"] + kept["dissipated"]
