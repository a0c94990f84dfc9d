"""A viscous thread with a wave on it, drained by its surface: axisymmetric flow with a free surface, by pyoomph.

Called with half the length of the wave, its height over the mean radius, the time to stop, the step of time, elements
across and along, and a folder for what pyoomph writes. Units: mean radius, viscosity and surface tension are one.
Prints a line of time and smallest radius for each step, behind the word "neck".
"""

from __future__ import annotations

import sys

HALF, HEIGHT, END, STEP = map(float, sys.argv[1:5])
ACROSS, ALONG = map(int, sys.argv[5:7])
FOLDER = sys.argv[7]
# pyoomph reads the command line, too.
sys.argv = sys.argv[:1]

from pyoomph import DirichletBC, InitialCondition, Problem, RectangularQuadMesh  # noqa: E402
from pyoomph.equations.ALE import LaplaceSmoothedMesh  # noqa: E402
from pyoomph.equations.navier_stokes import NavierStokesEquations, NavierStokesFreeSurface  # noqa: E402
from pyoomph.expressions import cos, pi, var  # noqa: E402


class Thread(Problem):
    """Half a wave between two planes of symmetry; its neck is at the bottom."""

    def define_problem(self) -> None:
        self.set_coordinate_system("axisymmetric")
        self.add_mesh(RectangularQuadMesh(size=[1.0, HALF], N=[ACROSS, ALONG], name="liquid"))
        # Next to no inertia; none at all would leave the velocities without a rate.
        flow = NavierStokesEquations(dynamic_viscosity=1.0, mass_density=1e-4) + LaplaceSmoothedMesh()
        x, z = var(["lagrangian_x", "lagrangian_y"])
        flow += InitialCondition(mesh_x=x * (1 - HEIGHT * cos(pi * z / HALF)))
        flow += DirichletBC(mesh_x=0, velocity_x=0) @ "left"
        flow += DirichletBC(mesh_y=True, velocity_y=0) @ ["top", "bottom"]
        flow += NavierStokesFreeSurface(surface_tension=1.0) @ "right"
        self.add_equations(flow @ "liquid")

    def neck(self) -> float:
        """Radius where the surface meets the lower plane."""
        return min(node.x(0) for node in self.get_mesh("liquid/right").nodes())


with Thread() as problem:
    problem.set_output_directory(FOLDER)
    problem.initialise()
    print("neck", 0.0, problem.neck())
    time = 0.0
    while time < END:
        problem.run(time + STEP, startstep=STEP, outstep=False, temporal_error=None)
        time += STEP
        print("neck", time, problem.neck(), flush=True)
        if problem.neck() < 0.1:
            break
