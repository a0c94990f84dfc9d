"""What the paper's figure 4 draws: half a strip of elements by its flow, half a filament by its yielded zones."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize

from softcat_sym.plotting import style
from softcat_sym.plotting.section import Section, elastic_core, quads_outside, section_at
from softcat_sym.scene.scene import elastic_time
from softcat_sym.studies.paper_figures import PAPER

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes

    from softcat_sym.discretization.grid import Floats
    from softcat_sym.studies.paper_figures import FilmedScene, Snapshot

BLACK_RATE = 4.4e-4
"""Plastic shear rate times L sqrt(rho/E) that the paper's scale shows as black; white is 0."""

YIELDED = style.VERMILLION
_EDGE = 0.5


@dataclass(frozen=True)
class Strip:
    """A filament at one instant, whole span; lengths over the span."""

    section: Section  # Centreline, normals, thickness on the nodes
    # shape (cells,); Limits in zeta of the part that does not yield, by the stress sigma_0 + sigma_1 zeta of (2.24).
    low: Floats
    high: Floats
    X: Floats  # shape (cells,); Material coordinate and place of the middle of each cell
    place: Floats

    @property
    def yielded_share(self) -> float:
        """Part of the side view that yields, cells weighted by their length."""
        length = np.hypot(np.diff(self.section.x), np.diff(self.section.y))
        return float(np.average(1 - (self.high - self.low) / 2, weights=length))

    def side(self, zeta: float) -> Floats:
        """Right half of a face, or of the centreline; shape (points, 2)."""
        return np.asarray(self.section.at(zeta)[self.section.x >= -1e-12])

    @property
    def yielded(self) -> Floats:
        """Quads of the yielded zones of the right half; shape (quads, 4, 2)."""
        quads = quads_outside(self.section, self.low, self.high)
        return np.asarray(quads[quads[:, :, 0].mean(axis=1) > 0])


def strip_at(filmed: FilmedScene, instant: float, theory: str = PAPER) -> Strip:
    """The filament of one theory at the frame nearest to t~."""
    data, span = filmed.filaments[theory].data, filmed.scene.filament.span
    frame = int(np.abs(data["time"].values / elastic_time(filmed.scene) - instant).argmin())
    section = _section_of(data, frame)
    scaled = Section(section.x / span, section.y / span, section.normal, section.thickness / span)
    mean, bending = data["stress_mean"].values[frame], data["stress_bending"].values[frame]
    low, high = elastic_core(mean, bending, filmed.scene.material.yield_stress or np.inf)
    middle = np.column_stack([(c[1:] + c[:-1]) / 2 for c in (scaled.x, scaled.y)])
    return Strip(scaled, low, high, data["X_cell"].values / span, middle)


def _section_of(data: xr.Dataset, frame: int) -> Section:
    """Sections turn by psi = theta - atan(Gam/Lam): normal to the centreline only where nothing shears."""
    section = section_at(data, frame, (True, True))
    shear = data["shear"].values[frame] if "shear" in data else np.zeros(data.sizes["cell"])
    if not shear.any():
        return section
    turned = np.arctan2(np.diff(section.y), np.diff(section.x)) - np.arctan(shear)
    nodes, cells = data["X_node"].values, data["X_cell"].values
    angle = np.interp(nodes, [nodes[0], *cells, nodes[-1]], [0.0, *turned, 0.0])
    return replace(section, normal=np.column_stack([-np.sin(angle), np.cos(angle)]))


def boundary(shot: Snapshot, through: int) -> Floats:
    """Outline of the half strip of elements, along the bottom and back along the top; shape (points, 2)."""
    columns = shot.outline.reshape(-1, through, 8, 2)
    bottom, top = columns[:, 0, :3].reshape(-1, 2), columns[:, -1, 4:7][:, ::-1].reshape(-1, 2)
    return np.concatenate([bottom, top[::-1], bottom[:1]])


def draw_elements(axes: Axes, shot: Snapshot, through: int) -> PolyCollection:
    """Draw the strip as the left half, in the grey of its plastic shear rate."""
    mirror = np.array([-1.0, 1.0])
    # Anti-aliasing would leave hairlines between neighbouring quarters.
    field = PolyCollection(
        list(mirror * shot.quarter),
        array=shot.rate,
        cmap="gray_r",
        norm=Normalize(0.0, BLACK_RATE),
        edgecolors="none",
        antialiaseds=False,
        rasterized=True,
    )
    axes.add_collection(field, autolim=False)
    axes.plot(*(mirror * boundary(shot, through)).T, color=style.BLACK, linewidth=_EDGE)
    return field


def draw_filament(axes: Axes, strip: Strip) -> None:
    """Draw the filament as the right half: centreline, faces, and its yielded zones."""
    zones = PolyCollection(
        list(strip.yielded), facecolors=YIELDED, edgecolors="none", antialiaseds=False, rasterized=True
    )
    axes.add_collection(zones, autolim=False)
    for zeta, line in ((-1.0, "-"), (0.0, (0, (6, 2))), (1.0, "-")):
        axes.plot(*strip.side(zeta).T, color=style.BLACK, linewidth=_EDGE, linestyle=line)
    bottom, top = strip.side(-1.0)[-1], strip.side(1.0)[-1]
    axes.plot([bottom[0], top[0]], [bottom[1], top[1]], color=style.BLACK, linewidth=_EDGE)


def draw_mesh(axes: Axes, shot: Snapshot) -> None:
    """Draw both halves of the deformed mesh."""
    for side in (-1.0, 1.0):
        mesh = PolyCollection(
            list(np.array([side, 1.0]) * shot.outline), facecolors="#f2f2f2", edgecolors="#5a5a5a", linewidths=0.3
        )
        axes.add_collection(mesh, autolim=False)
