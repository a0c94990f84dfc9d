"""What the paper says of its figures 3 and 4, sentence by sentence, against the runs behind our drawings of them.

The elements are kept in the user's cache; those of the published figures are finer (64 x 4).
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.plotting.paper_figures import (
    BLACK_RATE,
    strip_at,
)
from softcat_sym.reference.element_loop import Mesh
from softcat_sym.results.motion import rebound_of
from softcat_sym.solvers.solution import Silence
from softcat_sym.studies.compare import filament_clamp_strain
from softcat_sym.studies.paper_figures import (
    ALPHA,
    INSTANTS,
    MOMENTS,
    OWN,
    PAPER,
    PRINTED,
    SCENES,
    FilmedScene,
    film_scene,
    stopping_depth,
)
from softcat_sym.studies.phase import SETTINGS, PhaseDiagram, phase_diagram
from tests.common.elements import PUBLISHED
from tests.common.table import show

pytestmark = pytest.mark.slow

# What can be told apart in the paper's figure 3(b), whose axis spans a quarter of the length.
READABLE = 0.02


@cache
def filmed(name: str) -> FilmedScene:
    of = next(each for each in SCENES if each.name == name)
    return film_scene(of, Silence(), mesh=Mesh(32, 2))


def final(name: str, curve: str = "elements") -> float:
    """Sag/L at t~ = 460."""
    time, height = filmed(name).elements if curve == "elements" else filmed(name).filament(curve)
    return -float(height[np.argmin(np.abs(time - MOMENTS[-1]))])


def test_without_yield_nothing_flows_and_both_ring_on() -> None:
    """'long-term oscillations'; 'neither simulation indicates that any plastic deformation occurs'."""
    known = filmed("no-yield")
    rows = []
    for name, (time, height) in {"elements": known.elements, **{t: known.filament(t) for t in (PAPER, OWN)}}.items():
        early, late = (np.ptp(height[(time > since) & (time < since + 150)]) for since in (10, 310))
        rows.append([name, f"{early:.5f}", f"{late:.5f}"])
        assert late > 0.97 * early
    show("no-yield: swing of the midpoint/L", ["", "t~ = 10 to 160", "t~ = 310 to 460"], rows)
    assert not any(shot.rate.any() for shot in known.film.snapshots)
    assert not known.film.run.energy_dissipated.any()
    assert all(strip_at(known, instant).yielded_share == 0 for instant in INSTANTS)
    assert all(trajectory.summary["regime"] == "no-yield" for trajectory in known.filaments.values())


def test_stopping_depth_and_the_two_arrests() -> None:
    """'Equation (3.13) predicts H_stop/L = 0.05 ... very close to the overdamped value and slightly above the
    underdamped value': heights are negative, so the underdamped filament hangs deeper."""
    depth = stopping_depth(0.4)
    assert depth["paper"] is not None
    assert depth["exact"] is not None
    over, under = final("arrested-overdamped"), final("edge-of-rupture")
    rows = [["H_stop (3.13)", f"{depth['paper']:.4f}"], ["H_stop, exact catenary", f"{depth['exact']:.4f}"]]
    rows += [["overdamped, elements", f"{over:.4f}"]]
    rows += [[f"overdamped, {name}", f"{final('arrested-overdamped', name):.4f}"] for name in (PAPER, PRINTED, OWN)]
    rows += [["underdamped (G = 0.4), elements", f"{under:.4f}"]]
    back = {name: rebound_of(filmed(name).elements[1]) for name in ("arrested-overdamped", "arrested-underdamped")}
    rows += [[f"{name}: turned back", f"{share:.1%}"] for name, share in back.items()]
    show("arrest at G = 0.4: sag/L at t~ = 460", ["", "sag/L"], rows)
    assert depth["paper"] == pytest.approx(0.05, abs=0.002)
    assert depth["paper"] < over < under
    # Close on the paper's axis, not to a per cent: the sudden load and creep carry the filament a quarter further.
    assert over - depth["paper"] < READABLE
    assert 1.2 < over / depth["paper"] < 1.35
    assert back["arrested-overdamped"] < 0.05 < back["arrested-underdamped"]


def test_papers_underdamped_numbers_are_on_the_edge_of_rupture() -> None:
    """Elements stop; no filament has a limit there, and none is passed off as an answer."""
    known = filmed("edge-of-rupture")
    rows = [[name, known.filaments[name].outcome.name] for name in (PAPER, PRINTED, OWN)]
    show(f"G = 0.4, V = 0.4; elements: {final('edge-of-rupture'):.4f} L", ["filament", "outcome"], rows)
    assert not any(trajectory.outcome.is_success for trajectory in known.filaments.values())
    assert 0.10 < final("edge-of-rupture") < 0.115


def test_descent_ends_a_quarter_deep_with_over_23_per_cent_of_strain() -> None:
    """'the filament deflects about a quarter of its original length by the end of the run, and we find local strains
    over 23% near the clamp'."""
    known = filmed("continual-descent")
    run, thickness = known.film.run, known.scene.filament.thickness
    strains = {"elements": run.clamp_strain_largest[-1]}
    for name in (PAPER, PRINTED, OWN):
        strains[name] = filament_clamp_strain(known.filaments[name].data, run, thickness).largest[-1]
    rows = [
        [name, f"{final('continual-descent', name):.4f}", f"{np.expm1(strain):.1%}", f"{strain:.3f}"]
        for name, strain in strains.items()
    ]
    show("continual-descent at t~ = 460", ["", "sag/L", "largest strain at the clamp", "logarithmic"], rows)
    for name in strains:
        assert final("continual-descent", name) == pytest.approx(0.25, abs=0.02)
        assert strains[name] > 0.23


def test_thinning_and_finite_stretch_are_both_needed() -> None:
    """'otherwise the prediction diverges early on from the FEM solutions, as we have verified'."""
    known = filmed("continual-descent")
    time, truth = known.elements
    shared = {"filament.width": "0.06 mm", "run.frames": 801}
    curves = {"paper's physics": known.filament(PAPER)[1]}
    for left_out in ("thinning", "finite-stretch"):
        effects = tuple(name for name in PUBLISHED if name != left_out)
        run = sc.simulate(sc.load_scene("continual-descent", {**shared, "run.effects": effects}))
        curves[f"without {left_out}"] = run.data.midpoint.values / run.scene.filament.span
    at = [int(np.argmin(np.abs(time - moment))) for moment in MOMENTS]
    errors = {name: height[at] / truth[at] - 1 for name, height in curves.items()}
    rows = [[name, *(f"{100 * value:+.1f} %" for value in error)] for name, error in errors.items()]
    show("continual-descent: sag against the elements", ["", *(f"t~ = {t:g}" for t in MOMENTS)], rows)
    whole = np.abs(errors.pop("paper's physics"))
    for error in map(np.abs, errors.values()):
        assert np.all(error > 1.5 * whole)
        assert error[-1] > 2 * error[0]


def test_snapshots_flow_where_and_as_fast_as_the_caption_says() -> None:
    """Figure 4, grey from 0 to 4.4e-4: the flow of (b) dies out, that of (c) stays beyond the scale's end."""
    rows, largest = [], {}
    for name in ("arrested-overdamped", "continual-descent"):
        known = filmed(name)
        for instant in INSTANTS:
            shot, strip = known.film.at(instant), strip_at(known, instant)
            assert shot.time == pytest.approx(instant, abs=0.3)
            largest[name, instant] = float(shot.rate.max())
            flowing, apart = float(np.mean(shot.rate > 0)), float(np.mean(shot.rate > BLACK_RATE))
            rows.append([name, f"{instant / ALPHA:g}", f"{shot.rate.max():.2e}", f"{apart:.1%}", f"{flowing:.1%}"])
            rows[-1] += [f"{strip.yielded_share:.1%}"]
    header = ["scene", "t~/46", "largest rate", "of the points beyond black", "points that flow", "filament yielded"]
    show("figure 4", header, rows)
    assert largest["arrested-overdamped", INSTANTS[-1]] < 0.05 * largest["arrested-overdamped", INSTANTS[0]]
    shot = filmed("continual-descent").film.at(ALPHA)
    assert np.mean(shot.rate > 0) > 0.9
    assert BLACK_RATE < np.median(shot.rate) < 5 * BLACK_RATE


@pytest.fixture(scope="module")
def diagram() -> PhaseDiagram:
    return phase_diagram(sc.load_scene("arrested-overdamped", list(SETTINGS)), resolution=8)


def test_papers_parameter_sets_lie_where_the_paper_puts_them(diagram: PhaseDiagram) -> None:
    """Its underdamped set excepted: there the published physics has no answer."""
    sheet = next(sheet for sheet in diagram.sheets if sheet.plane.name == "G-V")

    def mark(G: float, V: float) -> str:
        i, j = (int(np.argmin(np.abs(np.log(axis / value)))) for axis, value in ((sheet.x, G), (sheet.y, V)))
        return str(sheet.lattice.labels[i, j])

    assert mark(0.01, 26.0) == "no-yield"
    assert mark(0.4, 26.0) in ("arrested-overdamped", "arrested-underdamped")
    assert mark(1.9, 26.0).startswith("descending")
    assert mark(0.4, 0.4) == "localised"
