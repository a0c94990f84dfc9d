"""An experiment in plain sentences."""

from __future__ import annotations

import math
from collections.abc import Mapping

from softcat_sym.inverse.design.noise import Noise
from softcat_sym.inverse.design.polishing import Limit
from softcat_sym.inverse.design.trial import Trial
from softcat_sym.inverse.design.variables import DURATION, FRAME_RATE, SPAN, THICKNESS

_CALLED = {SPAN: "span", THICKNESS: "thickness", FRAME_RATE: "frame rate", DURATION: "duration"}
_LENGTHS = ((1.0, "m"), (1e-3, "mm"), (1e-6, "um"))
_WORTH = 1.05


def length_text(value: float) -> str:
    """A length with three digits and the unit that suits it."""
    factor, unit = next((pair for pair in _LENGTHS if abs(value) >= pair[0]), _LENGTHS[-1])
    return f"{value / factor:.3g} {unit}"


def percent(error: float) -> str:
    """A relative error for reading."""
    return f"{100 * error:.2g} %" if math.isfinite(error) else "not determined"


def sentences(
    best: Trial,
    given: Trial,
    at_bounds: Mapping[str, str],
    noise: Noise,
    counted: tuple[str, ...],
    rough: float,
    sag_at_most: Limit | None,
) -> tuple[str, ...]:
    """Say what to film, what it will tell, what the scene as given would, and which bounds bind."""
    film = (
        f"Film a span of {length_text(best.span)}, {length_text(best.thickness)} thick, for {best.duration:.3g} s at "
        f"{best.frame_rate:.4g} frames a second: {best.frames} frames."
    )
    listed = ", ".join(f"{name.rpartition('.')[2]} {percent(best.errors[name])}" for name in counted)
    found = [film, f"Relative standard errors to expect with {_noise_text(noise, best)} of noise a reading: {listed}."]
    if rough > 1:
        found.append(f"Each is the largest for rough values that are wrong by a factor of {rough:g} either way.")
    allowed = math.inf if sag_at_most is None else sag_at_most.at(best.span)
    limited = "" if math.isinf(allowed) else f", of {length_text(allowed)} that are allowed"
    found.append(f"It sags {length_text(best.sag)} while it is filmed{limited}.")
    found.append(_compared(best, given))
    if given.sag > allowed:
        found.append(f"The scene as given sags {length_text(given.sag)}, which is more than allowed.")
    bound = [f"{_CALLED[path]} at its {edge} bound" for path, edge in at_bounds.items() if path in _CALLED]
    if "frames_at_most" in at_bounds:
        bound.append("as many frames as the camera keeps")
    if bound:
        found.append(f"What limits it: {', '.join(bound)}.")
    found.append("These are the least errors that any fit can have, if the law is right and the noise is white.")
    return tuple(found)


def _noise_text(noise: Noise, best: Trial) -> str:
    amount = length_text(noise.of(best.sag))
    return f"{amount} ({100 * noise.value:.3g} % of the sag)" if noise.of_sag else amount


def _compared(best: Trial, given: Trial) -> str:
    if not math.isfinite(given.worst):
        why = f" ({given.note})" if given.note else ""
        return f"The scene as given would not determine them all{why}."
    gain = given.worst / best.worst
    same = f"{percent(given.worst)} at worst, with {given.frames} frames"
    if gain < _WORTH:
        return f"The scene as given is as good: {same}."
    return f"The scene as given would leave {same}: {gain:.3g} times more."
