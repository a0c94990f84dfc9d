"""Whether an answer may be trusted: what was left out, strain that localises, rupture, and where the theory ends."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from softcat_sym.discretization.grid import choose_grading
from softcat_sym.discretization.parameters import time_scale
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.effect import Estimate
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.effects.selection import Effects
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.estimates.scaling import neck_length
from softcat_sym.results.breaking import breakable, first_break
from softcat_sym.results.fields import audit_of, energies_of, is_loss, min_energy
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.outcome import POLYMER_THREAD, THREAD, Outcome
from softcat_sym.solvers.solution import Solution


def measures(scene: Scene, effects: Effects, motion: Motion) -> dict[str, Estimate]:
    """The size of every effect that the scene has and the run left out, from how the filament has moved."""
    sag = motion.sag * scene.filament.span
    return {
        decision.effect.name: decision.effect.estimate(scene, motion).seen(sag, lacking=True)
        for decision in effects.decisions
        if not decision.in_force and decision.estimate is not None
    }


def missing_effect(scene: Scene, effects: Effects, measured: dict[str, Estimate], outcome: Outcome) -> dict[str, str]:
    """Effects that ``auto`` has left out and the run shows to matter more than the accuracy asked, and how.

    A run that fails shows nothing: then it is everything in the published theory that was left out, and of one that
    localises the gradient that limits a neck. Nothing where the scene names its effects: what the user has left out is
    reported, not repaired.
    """
    if scene.run.effects != "auto" or scene.run.closure == "printed" or scene.model == "small-deflection":
        return {}
    omitted = [decision.effect for decision in effects.decisions if decision.effect.name in measured]
    if outcome in (Outcome.broken, Outcome.descends, Outcome.interrupted):
        return {}  # It is run again up to there, which shows more, or not at all.
    if outcome is Outcome.localised:
        return {e.name: "without it a neck has no width" for e in omitted if e.cures == outcome.name}
    if not outcome.is_success and outcome is not Outcome.energy_drift:
        # Without rotary inertia the angles of sheared sections are algebraic: a stiff pull may leave them no solution.
        able = [e for e in omitted if e.cures == "failure" and set(e.needs) <= set(effects.names)]
        called_for = [e for e in omitted if e.in_paper or e in able]
        return {e.name: "the run without it failed" for e in called_for}
    return {
        effect.name: f"shown by the run without it: {measured[effect.name]}"
        for effect in omitted
        if measured[effect.name].value > scene.run.accuracy and not effect.saved(scene)
    }


def saved(scene: Scene, effects: Effects, measured: dict[str, Estimate]) -> list[str]:
    """Warn of effects that ``auto`` leaves out for what they cost, and that the run shows to matter."""
    if scene.run.effects != "auto":
        return []
    return [
        f"{decision.effect.name} is left out ({why}), but may matter: {measured[decision.effect.name]}; "
        "name it in run.effects to have it"
        for decision in effects.decisions
        if decision.effect.name in measured
        and measured[decision.effect.name].value > scene.run.accuracy
        and (why := decision.effect.saved(scene))
    ]


SHARE_OF_ONE_CELL = 0.3
"""A cell that by itself, beyond its neighbours, carries this share of its half's elongation is a localised neck.

Converged runs stay below 0.2 (a thick ink strand at N = 20) and fall with 1/N; a neck that the theory cannot resolve
carries 0.4 or more on every grid from N = 10 up. A thick strand on very few cells (N = 8) comes close to the limit.
"""

BEYOND_A_LIQUID = 14.0
"""Times the stretch of its neighbours to which a cell of a liquid must be drawn to be a localised neck.

Without a yield stress a neck grows as fast as the strain itself, and the stretch of a thread rises towards its support
as x^(q - 1). That is no localisation: the share of the last cell falls as N^-q, and its neighbour is drawn 2^q - 1
times as far. Beyond this limit, q = 0.1, cells a thousand times shorter would not halve the share: the thread is cut.
"""

DRAWN_OUT = 0.4
"""Strain of a neck, spread over its length, beyond which it is drawn out even where the necking gradient is in force.

Elongation beyond the neighbourhood does not depend on the grid, unlike the stretch of the cell that shows it. In plane
stress the paper's ringing filament stops at 0.18 for G = 0.25 and at 0.33 for G = 0.3, on 40 cells as on 160, where
elements stop too; for G = 0.4 it ruptures on every grid (tests/slow/test_necking.py).
"""

SMOOTH = 0.3
"""Of the neighbours' strain: what a cell much longer than a neck may exceed them by without one."""

RUPTURED = 10.0
"""Strain beyond which only a thread is left: its number means nothing."""

STRONGEST = math.e
"""Stretch at which a bar of true strain is strongest, A0 E log(s)/s: an elastic solid drawn further runs away."""

GAIN = 0.2
"""Share by which the energy of a filament may exceed what weight and supports gave it, where the closure is the paper's
printed one and its balance is no more than approximate; a filament that has run away exceeds it a millionfold."""

NOISE = 0.01
"""Of the largest energy: the first frames hold next to nothing, to no accuracy."""

SHORTEST_CELL = 1 / 18
"""Of the thickness. A ringing filament whose hinge has cells of h0/17 stops where elements do, on 40, 80 and 160 cells;
with cells of h0/19 to h0/35 it sags a tenth to four times further, differently on every grid."""

COMPRESSION = 0.02
"""Of the largest tension: what a string that does not bend may be compressed by."""


def largest_share_of_one_cell(stretch: Floats, length: Floats, beyond: float = 1.0) -> float:
    """Share of a half's elongation that one cell carries in excess of its more stretched neighbour.

    A cell counts that is drawn to more than `beyond` times the stretch of that neighbour.
    """
    # A support has no cell behind it: its cell is compared with the one neighbour it has.
    left = np.concatenate([[-np.inf], stretch[:-1]])
    right = np.concatenate([stretch[1:], [-np.inf]])
    beside = np.maximum(left, right)
    excess = np.where(stretch > beyond * beside, np.maximum(stretch - np.maximum(beside, 1.0), 0.0), 0.0) * length
    # Where parts are compressed and parts drawn, their sum may vanish: it is no scale.
    elongation = np.abs(stretch - 1.0) * length
    middle = len(stretch) // 2
    shares = [
        float(np.max(excess[half])) / float(np.sum(elongation[half]))
        for half in (slice(None, middle), slice(middle, None))
        if float(np.sum(elongation[half])) > 1e-9 * float(np.sum(length))
    ]
    return max(shares, default=0.0)


def neck_strain(stretch: Floats, length: Floats, neck: float) -> float:
    """Largest strain of any neck beyond its neighbourhood, spread over the length of a neck."""
    edges = np.concatenate([[0.0], np.cumsum(length)])
    elongation = np.concatenate([[0.0], np.cumsum((stretch - 1) * length)])
    # A cell longer than a neck shows the same elongation over its own length.
    window = np.maximum(length, neck)
    left = np.clip((edges[1:] + edges[:-1] - window) / 2, 0.0, edges[-1] - window)

    def mean(start: Floats) -> Floats:
        inside = (start > -1e-9 * edges[-1]) & (start + window < (1 + 1e-9) * edges[-1])
        gain = np.interp(start + window, edges, elongation) - np.interp(start, edges, elongation)
        return np.where(inside, gain / window, -np.inf)

    beside = np.maximum(mean(left - window), mean(left + window))
    # Over a cell longer than a neck strain also varies smoothly, and by more than a short neck holds.
    smooth = SMOOTH * (1 - neck / window) * np.maximum(np.where(np.isfinite(beside), beside, 0.0), 0.0)
    excess = mean(left) - beside - smooth
    return float(np.max(np.where(np.isfinite(excess), excess, 0.0) * window / neck))


def neck_that_the_grid_decides(stretch: Floats, nodes: Floats, neck: float | None, *, yields: bool = True) -> str:
    """What is wrong with a neck, or an empty text."""
    length, where = np.diff(nodes), f"X/L = {_place(nodes, int(np.argmax(stretch))):.4g}"
    if neck is None:
        share = largest_share_of_one_cell(stretch, length, 1.0 if yields else BEYOND_A_LIQUID)
        text = f"the cell at {where} carries {share:.0%} of the elongation of its half beyond its neighbour"
        return text if share > SHARE_OF_ONE_CELL else ""
    strain = neck_strain(stretch, length, neck)
    far = f"by {strain:.0%} of its length" if strain < RUPTURED else f"to more than {RUPTURED:g} times its length"
    text = f"the neck at {where} is drawn out {far} beyond its neighbourhood: near rupture"
    return text if strain > DRAWN_OUT else ""


def _place(nodes: Floats, cell: int) -> float:
    """X/L amid a cell, 0 at midspan."""
    return round(float((nodes[cell] + nodes[cell + 1] - nodes[0] - nodes[-1]) / 2 / (nodes[-1] - nodes[0])), 6) + 0.0


def largest_stretch(scene: Scene) -> float:
    """The stretch at which a filament counts as ruptured."""
    if scene.material.spec.has_chains:
        return POLYMER_THREAD
    return STRONGEST if scene.material.spec.is_solid else THREAD


def rupture_frame(scene: Scene, stretch: Floats) -> int | None:
    """The first frame in which a cell is drawn beyond what its material can bear; None without."""
    torn = np.flatnonzero(~(np.max(stretch, axis=1) <= largest_stretch(scene)))
    return int(torn[0]) if len(torn) else None


def rupture(scene: Scene, time: Floats, stretch: Floats, nodes: Floats) -> str:
    """When and where the filament ruptures, or an empty text."""
    frame = rupture_frame(scene, stretch)
    if frame is None:
        return ""
    where = _place(nodes, int(np.argmax(np.nan_to_num(stretch[frame], nan=np.inf))))
    return (
        f"by t = {time[frame]:.6g} s the cell at X/L = {where:.4g} is drawn to more than {largest_stretch(scene):.4g} "
        "times its length"
    )


def gained_energy(fields: Mapping[str, Floats], least: float) -> str:
    """That motion and stress hold more energy than weight and supports gave the filament, or an empty text.

    Dissipation only takes energy away, whatever the closure: this holds also where the balance itself is not audited.
    """
    held = fields["energy_kinetic"] + fields["energy_elastic"]
    inner = ("energy_kinetic", "energy_elastic", "energy_gradient")
    stored = np.sum([fields[name] for name in energies_of(fields) if name not in inner and not is_loss(name)], axis=0)
    works = np.sum([fields[name] for name, sign in audit_of(fields).items() if sign < 0], axis=0)
    given = held[0] + stored[0] - stored + works
    noise = NOISE * np.max(held) + least
    excess = held - (1 + GAIN) * np.maximum(np.maximum.accumulate(given), 0.0) - noise
    frame = int(np.argmax(excess))
    if not excess[frame] > 0:
        return ""
    return (
        f"in frame {frame} motion and stress hold {held[frame]:.3g} J, but weight and supports gave "
        f"{given[frame]:.3g} J: no filament can be in that state"
    )


def pushed_string(time: Floats, tension: Floats) -> str:
    """When a string without bending is pushed together, or an empty text: it has no stiffness against folds."""
    # Waves along a string leave traces of compression in the first order of the grid.
    pushed = np.flatnonzero(np.min(tension, axis=1) < -COMPRESSION * np.max(tension))
    if not len(pushed):
        return ""
    share = -float(np.min(tension[pushed[0]])) / float(np.max(tension))
    return (
        f"by t = {time[pushed[0]]:.6g} s the string is pushed together with {share:.0%} of its largest tension: "
        "without bending that is ill-posed"
    )


def shortest_hinge_cell(scene: Scene, effects: Effects, nodes: Floats, yielded: Floats) -> float | None:
    """Length over thickness of the shortest cell at a clamp whose section has yielded and shears, if it is too short.

    A sheared section that has yielded resists a neck only over lengths comparable with the thickness: below
    `SHORTEST_CELL` the answer may change with the grid. Only a grading set by hand makes such cells where they need
    not be: the program's own are that short in a filament too thick to neck.
    """
    terms = effects.terms()
    if not (terms.yields and terms.bending and terms.turns):
        return None
    requested = scene.numerics.grading
    if requested is None or requested <= choose_grading(scene, (len(nodes) - 1) // 2, effects):
        return None
    ends = [place for place, one in zip((0, -1), scene.ends.supports, strict=True) if one.carries_moment]
    lengths = np.diff(nodes) / scene.filament.thickness
    short = [float(lengths[end]) for end in ends if np.max(yielded[:, end]) > 0.5 and lengths[end] < SHORTEST_CELL]
    return min(short, default=None)


BEADED = 0.4
"""Change of the logarithm of the stretch from cell to cell, a fifth of the radius, that shows a bead where it is."""


def beads_over_single_cells(nodes: Floats, fields: Mapping[str, Floats]) -> str:
    """What is wrong with beads, or an empty text: their fastest waves need cells shorter than the radius.

    A wave that the cells cannot show grows slower than it should, so that a thread which stays smooth says nothing.
    """
    stretch = fields["stretch"]
    long = np.diff(nodes) * stretch / (fields["thickness"] / 2)
    uneven = np.abs(np.diff(np.log(np.maximum(stretch, 1e-300)), axis=1))
    longer = np.where(uneven > BEADED, np.minimum(long[:, 1:], long[:, :-1]), 0.0)
    frame, at = np.unravel_index(int(np.argmax(longer)), longer.shape)
    if not longer[frame, at] > 1:
        return ""
    found, cells = float(longer[frame, at]), (len(nodes) - 1) // 2
    return (
        f"the surface gathers the filament into beads over single cells: at X/L = {_place(nodes, int(at)):g} they are "
        f"{found:.2g} radii long, and waves of the surface need less than one; take numerics.cells = "
        f"{math.ceil(cells * found)} or more"
    )


def warnings_of(
    scene: Scene, effects: Effects, motion: Motion, nodes: Floats, fields: Mapping[str, Floats], residual: float
) -> list[str]:
    """Warnings in words, none if the theory holds."""
    warnings = [words for effect in REGISTRY for words in effect.warnings(scene, motion)]
    shortest = shortest_hinge_cell(scene, effects, nodes, fields["yielded_fraction"])
    if shortest is not None:
        warnings.append(
            f"cells of the hinge at a clamp are 1/{1 / shortest:.0f} of the thickness long: below "
            f"1/{1 / SHORTEST_CELL:.0f} a hinge may neck as the grid lets it; leave out numerics.grading or take fewer "
            "numerics.cells"
        )
    if effects.terms().surface_tension and (beads := beads_over_single_cells(nodes, fields)):
        warnings.append(beads)
    # Without thinning a section swells as it is drawn: the energy that this stores, no force gives back.
    swells = effects.terms().finite and not effects.terms().thins
    if swells and scene.run.closure == "material" and residual > scene.run.accuracy:
        warnings.append(
            f"the energy residual, {residual:.2g}, exceeds the accuracy of {scene.run.accuracy:g}: with finite-stretch "
            "and without thinning the section swells as it is drawn, and energy is not conserved; add thinning to "
            "run.effects"
        )
    return warnings


def verdict(
    scene: Scene, effects: Effects, solution: Solution, fields: Mapping[str, Floats], nodes: Floats, residual: float
) -> tuple[Outcome, str]:
    """Decide: a break, a neck that the grid decides, a rupture, a failed integration, an open energy balance."""
    if solution.outcome is Outcome.no_equilibrium and not solution.steps:
        # Nothing was found to begin from: what the frame holds is no state of the filament.
        return solution.outcome, solution.message
    terms, time, stretch = effects.terms(), solution.time * time_scale(scene), fields["stretch"]
    places = {"time": time, "X_node": nodes, "X_cell": (nodes[1:] + nodes[:-1]) / 2}
    if breakable(scene) and (end := first_break(scene, {**fields, **places})) is not None:
        return Outcome.broken, end.text
    if solution.outcome in (Outcome.descends, Outcome.interrupted):
        return solution.outcome, solution.message
    # The gradient bounds necks of what yields: a liquid is drawn out where the filament is.
    # A strand that is laid is drawn here and thickened there: a share of its elongation says nothing.
    neck = neck_length(scene) if (terms.necking_gradient or terms.laid) and terms.yields else None
    # An elastic filament is as uneven as its load: only flow gathers strain.
    necked = neck_that_the_grid_decides(stretch[-1], nodes, neck, yields=terms.yields) if terms.flows else ""
    if necked:
        return Outcome.localised, "; ".join(filter(None, [necked, solution.message]))
    torn = rupture(scene, time, stretch, nodes)
    if torn:
        return Outcome.ruptured, "; ".join(filter(None, [torn, solution.message]))
    if not solution.outcome.is_success:
        return solution.outcome, solution.message
    # At rest, in the first frame, the viscous stress is not there yet that balances the surface.
    felt = slice(1 if terms.viscous and terms.surface_tension else 0, None)
    along = fields.get("axial_force", fields["tension"])
    pushed = pushed_string(time[felt], along[felt]) if not terms.bending and len(time[felt]) else ""
    if pushed:
        return Outcome.compressed, pushed
    gained = gained_energy(fields, min_energy(scene)) if solution.steps else ""
    if not gained and residual > scene.run.accuracy:
        gained = f"energy residual {residual:.2g} against an accuracy of {scene.run.accuracy:g}"
    return (Outcome.energy_drift, gained) if gained else (Outcome.solved, "")
