"""What the program beside the generated C reads: a list of parameters, and a starting shape."""

from __future__ import annotations

from softcat_sym.codegen.description import Description
from softcat_sym.graph.grid import Floats

START = "start.csv"


def parameter_text(described: Description, command: str, *, has_start: bool) -> str:
    """Lines ``name = number unit  # comment``, in SI units, of all that a run is asked.

    Parameters
    ----------
    described : Description
        With the values of its scene.
    command : str
        That writes the file again.
    has_start : bool
        Whether a starting shape lies beside it.
    """
    run, free = described.scene.run, ("curvature", "drop", "_angle", "_dx", "_dy")
    lines = [f"# {' '.join(described.title.split())}", f"# Written by: {command}. Edit freely: name = number unit.", ""]
    for one in described.parameters:
        bound = {"positive": "> 0", "not-negative": ">= 0", "poisson": "-1 < nu < 1/2"}.get(one.bound, "")
        said = "; ".join(part for part in (one.meaning, bound) if part and not one.name.endswith(free))
        lines.append(
            _line(f"{one.name} = {one.value!r}{'' if one.unit == '1' else f' {one.unit}'}", said or one.meaning)
        )
    lines += ["", _line(f"cells = {described.cells}", f"per half span, {described.least_cells} or more")]
    lines.append(_line(f"grading = {described.grading!r}", "longest cell over the shortest"))
    lines.append(_line(f"duration = {run.duration!r} s", ""))
    lines.append(_line(f"frames = {run.frames}", "times, evenly spaced from 0"))
    lines.append(_line(f"relative = {described.relative!r}", "tolerance of a step"))
    lines.append(_line(f"absolute = {described.absolute!r}", "tolerance of a step, in rest lengths"))
    if has_start:
        lines.append(_line(f"start = {START}", "shape to begin from, at rest with the parameters above only"))
    return "\n".join(lines) + "\n"


def _line(text: str, said: str) -> str:
    return f"{text:40}  # {said}" if said else text


def start_text(described: Description, nodes: Floats, state: Floats) -> str:
    """A starting shape as CSV: X of the nodes [rest lengths] and all unknowns, dimensionless.

    Parameters
    ----------
    described : Description
        For the names of the unknowns.
    nodes : ndarray, shape (sites,)
        X.
    state : ndarray, shape (sites, slots)
        Unknowns; what the ends hold has its value there, too.
    """
    names = [slot.name for slot in described.model.slots]
    rows = [",".join(repr(float(value)) for value in (x, *row)) for x, row in zip(nodes, state, strict=True)]
    return "\n".join([",".join(["X", *names]), *rows]) + "\n"
