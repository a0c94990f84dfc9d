"""The scenes of the paper's figures 3(b) and 4, as elements and as filaments by the paper's physics and by ours."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from softcat_sym.graph.grid import Floats
from softcat_sym.reference import Mesh
from softcat_sym.scene import load_scene
from softcat_sym.scene.scales import elastic_time
from softcat_sym.simulate import simulated
from softcat_sym.solve import Progress
from softcat_sym.study.figure_elements import ElementFilm, film_elements

if TYPE_CHECKING:
    from softcat_sym.scene import Scene
    from softcat_sym.trajectory import Trajectory

ALPHA = 46.0
"""The paper's unit of the snapshots' times, in L sqrt(rho/E)."""

INSTANTS = tuple(share * ALPHA for share in (0.25, 0.5, 1.0, 2.0, 10.0))
"""Times t~ at which the elements are kept whole."""

MESH = Mesh(64, 4)

PAPER, PRINTED, OWN = "paper's physics, material closure", "paper's physics, printed closure", "chosen by the program"
THEORIES: dict[str, dict[str, object]] = {
    PAPER: {"run.effects": "paper", "run.closure": "material"},
    PRINTED: {"run.effects": "paper", "run.closure": "printed"},
    OWN: {},
}

# What the elements assume of the width, and enough frames for what rings.
_CHANGES: dict[str, object] = {"filament.width": "0.06 mm", "run.frames": 801}

Listening = Callable[[str, float], AbstractContextManager[Progress]]
"""Given what is about to run and how long [s] it is, a context whose value is told how far it is."""


@dataclass(frozen=True)
class FigureScene:
    """One set of the paper's parameters.

    Attributes
    ----------
    name : str
        Of the bundled scene.
    title : str
        In pictures.
    parameters : str
        delta, G, eps_Y, V as the scene has them.
    """

    name: str
    title: str
    parameters: str


SCENES = (
    FigureScene("no-yield", "no yielding", "G = 0.01"),
    FigureScene("arrested-overdamped", "arrested, overdamped", "G = 0.4, V = 26"),
    FigureScene("arrested-underdamped", "arrested, underdamped", "G = 0.25, V = 0.4"),
    FigureScene("edge-of-rupture", "edge of rupture (paper)", "G = 0.4, V = 0.4"),
    FigureScene("continual-descent", "continual descent", "G = 1.9, V = 26"),
)
SNAPSHOTS = ("no-yield", "arrested-overdamped", "continual-descent")
"""Scenes of figure 4(a), (b) and (c); the last one is also that of (d)."""


@dataclass(frozen=True)
class FilmedScene:
    """A scene, run in every way.

    Attributes
    ----------
    of : FigureScene
        Its name and titles.
    scene : Scene
        What was run, with the effects that the program chooses.
    film : ElementFilm
        The elements.
    filaments : dict of str to Trajectory
        By the names of `THEORIES`; those that localised included.
    """

    of: FigureScene
    scene: Scene
    film: ElementFilm
    filaments: dict[str, Trajectory]

    @property
    def elements(self) -> tuple[Floats, Floats]:
        """t~ and y/L of the elements' midpoint."""
        run = self.film.run
        return run.time / run.elastic_time, run.midpoint / self.scene.filament.span

    def filament(self, theory: str) -> tuple[Floats, Floats]:
        """t~ and y/L of a filament's midpoint."""
        data = self.filaments[theory].data
        return data["time"].values / elastic_time(self.scene), data["midpoint"].values / self.scene.filament.span


def film_scene(of: FigureScene, folder: Path, listening: Listening, mesh: Mesh = MESH) -> FilmedScene:
    """Run a scene as elements and as filaments.

    Parameters
    ----------
    of : FigureScene
        Which.
    folder : pathlib.Path
        Exists. Where the elements keep their state; a finished run is taken from there.
    listening : callable
        See `Listening`.
    mesh : Mesh
        Elements.

    Raises
    ------
    SoftcatError
        If the elements fail.
    KeyboardInterrupt
        On Ctrl-C; the elements' state is in the folder.
    """
    scene = load_scene(of.name, _CHANGES)
    with listening(f"{of.name}: elements", scene.run.duration) as listener:
        film = film_elements(scene, mesh, INSTANTS, folder, of.name, listener)
    filaments = {}
    for theory, changes in THEORIES.items():
        with listening(f"{of.name}: {theory}", scene.run.duration) as listener:
            filaments[theory] = simulated(load_scene(of.name, {**_CHANGES, **changes}), listener)
    return FilmedScene(of, scene, film, filaments)
