"""Which numbers of a scene and of its measurement are free: names, units, bounds and how they are scaled.

An unknown q is log(value/typical) of a number that is positive by nature, and value/scale of one of any sign, so that
every q is of order one.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from pydantic_core import PydanticCustomError

from softcat_sym.errors import Fault, SceneError
from softcat_sym.inverse.forward.free_candidates import INITIAL_SAG, TIME_OFFSET, Candidate, candidates, why_not_free
from softcat_sym.scene import Scene
from softcat_sym.scene.consistency import refuse_settled

__all__ = ["INITIAL_SAG", "TIME_OFFSET", "FreeParameter", "free_parameters"]

_ROUNDING = 1e-12

Bounds = Mapping[str, tuple[object, object]]


@dataclass(frozen=True, slots=True)
class FreeParameter:
    """One unknown of a fit.

    Attributes
    ----------
    name : str
        Leaf name, as in tables and reports.
    path : str
        Dotted path in the scene; of the measurement the name itself.
    unit : str
        SI; ``"1"`` of a pure number.
    typical : float
        What the scene says; zero of the measurement.
    logarithmic : bool
        Whether q = log(value/typical); otherwise q = value/scale.
    scale : float
        Positive, SI.
    bounds : (float, float)
        Of the value, SI.
    """

    name: str
    path: str
    unit: str
    typical: float
    logarithmic: bool
    scale: float
    bounds: tuple[float, float]

    @property
    def of_measurement(self) -> bool:
        """Whether the camera has it, and not the filament."""
        return self.path in (TIME_OFFSET, INITIAL_SAG)

    @property
    def lower(self) -> float:
        """Lower bound of q."""
        return self.scaled(self.bounds[0])

    @property
    def upper(self) -> float:
        """Upper bound of q."""
        return self.scaled(self.bounds[1])

    def scaled(self, value: float) -> float:
        """Turn a value [SI] into q."""
        return math.log(value / self.typical) if self.logarithmic else value / self.scale

    def value(self, q: float) -> float:
        """Turn q into a value [SI]; infinite where it overflows."""
        if not self.logarithmic:
            return q * self.scale
        try:
            return self.typical * math.exp(q)
        except OverflowError:
            return math.inf

    def slope(self, q: float) -> float:
        """Return d value/dq [SI]."""
        return self.value(q) if self.logarithmic else self.scale


def free_parameters(scene: Scene, names: Sequence[str], bounds: Bounds | None = None) -> tuple[FreeParameter, ...]:
    """Find what is free in a scene.

    Parameters
    ----------
    scene : Scene
        Its values are the typical ones.
    names : sequence of str
        Leaf names (``youngs_modulus``, ``viscosity``, ``yield_stress``, ``index``, ``second_modulus``,
        ``mode_1_viscosity``, ``density``, ``thickness``, ``width``, ``span``, ``rest_length``, ``gravity``, ``ramp``,
        ``shake``, ``shake_frequency``, ``surface_tension``, a constant of the user's own law, ...) or dotted paths;
        shear data by their names (``shear_viscosity``, ``shear_consistency``, ``shear_yield_stress``), whose value is
        then the one in shear. And two that are the camera's:

        ``time_offset`` [s]
            The camera's clock minus the filament's: time in the data = time since the load came on + offset.
        ``initial_sag`` [m]
            How far below the level of the supports the camera has its zero: height in the data = height of the
            midpoint above the supports' level + initial_sag. It shifts every height alike and is no property of the
            filament. That a *filament* hangs slack from the start is its length: free ``rest_length`` instead, which
            also changes how it moves.
    bounds : mapping of str to (low, high)
        Overrule the default bounds: numbers in SI, or text with units.

    Returns
    -------
    tuple of FreeParameter
        In the order of the names. By default positive numbers may be a thousand times smaller or larger, as far as
        they then still make sense.

    Raises
    ------
    SceneError
        With every name that is unknown, given twice, or no number of this scene, and every bound that makes no sense.
    """
    refuse_settled(scene, "the filament is compared at the times of its measurements")
    found, faults = _found(scene, names)
    chosen, wrong = _with_bounds([_free(candidate) for candidate in found], found, bounds or {})
    if faults or wrong:
        raise SceneError([*faults, *wrong])
    return tuple(chosen)


def _found(scene: Scene, names: Sequence[str]) -> tuple[list[Candidate], list[Fault]]:
    """What the names mean, and which mean nothing."""
    known = candidates(scene)
    by_name = {one.name: one for one in known} | {one.path: one for one in known}
    found: list[Candidate] = []
    faults: list[Fault] = []
    if not names:
        faults.append(Fault("free", "nothing is free", "one name or more, such as youngs_modulus"))
    for name in names:
        candidate = by_name.get(name)
        if candidate is None:
            faults.append(why_not_free(scene, name, by_name))
        elif candidate.trouble:
            faults.append(Fault(f"free {name}", candidate.trouble, candidate.remedy))
        elif clash := _clash(candidate, found):
            faults.append(Fault(f"free {name}", clash, "each constant once"))
        else:
            found.append(candidate)
    return found, faults


def _clash(candidate: Candidate, found: Sequence[Candidate]) -> str:
    for other in found:
        if other.path == candidate.path:
            return "named twice"
        if other.constant == candidate.constant:
            return f"the same constant as {other.name}"
    return ""


def _free(candidate: Candidate) -> FreeParameter:
    return FreeParameter(
        name=candidate.name,
        path=candidate.path,
        unit=candidate.unit or "1",
        typical=candidate.typical,
        logarithmic=candidate.logarithmic,
        scale=candidate.scale,
        bounds=candidate.bounds,
    )


def _with_bounds(
    free: list[FreeParameter], found: Sequence[Candidate], bounds: Bounds
) -> tuple[list[FreeParameter], list[Fault]]:
    faults = [
        Fault(f"bounds of {name}", "not free", ", ".join(one.name for one in free) or "names that are free")
        for name in bounds
        if name not in {key for one in found for key in (one.name, one.path)}
    ]
    result = []
    for one, candidate in zip(free, found, strict=True):
        pair = bounds.get(one.name, bounds.get(one.path))
        if pair is None:
            result.append(one)
            continue
        try:
            low, high = (candidate.read(bound) for bound in pair)
        except PydanticCustomError as error:
            faults.append(Fault(f"bounds of {one.name}", *_words(error)))
            continue
        fault = _of_bounds(one, low, high, candidate.limits)
        faults += [fault] if fault else []
        result.append(replace(one, bounds=(low, high)))
    return result, faults


def _words(error: PydanticCustomError) -> tuple[str, str]:
    context = error.context or {}
    return str(context["found"]), str(context["accepted"])


def _of_bounds(one: FreeParameter, low: float, high: float, limits: tuple[float, float]) -> Fault | None:
    where, unit = f"bounds of {one.name}", one.unit
    if not low < high:
        return Fault(where, f"{low:g} is not below {high:g} {unit}", "the lower one first")
    if one.logarithmic and low <= 0:
        return Fault(where, f"{low:g} {unit}, but {one.name} is positive", "a lower bound above zero")
    if low < limits[0] * (1 - math.copysign(_ROUNDING, limits[0])) or high > limits[1] * (1 + _ROUNDING):
        return Fault(where, f"{low:g} to {high:g} {unit}", f"within {limits[0]:.6g} to {limits[1]:.6g} {unit}")
    if not low <= one.typical <= high and not one.of_measurement:
        found = f"{low:g} to {high:g} {unit} does not hold the scene's own {one.typical:g}"
        return Fault(where, found, f"bounds around it, or another {one.path} in the scene")
    return None
