"""A scene from a handful of flags: density, span, diameter, a law with its constants or a flow curve."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from softcat_sym.effects.prediction import effective_viscosity_at, weight_stress, yield_stress_of
from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene import Scene, gravity_time
from softcat_sym.scene.laws import CONSTANTS

if TYPE_CHECKING:
    from softcat_sym.inverse import FlowCurveFit

TITLE = "Filament"
GEOMETRY = {"density": "filament.density", "span": "filament.span", "diameter": "filament.thickness"}
"""Flags that every filament needs, and where they go."""

MATERIAL = {
    "law": "material.law",
    "youngs-modulus": "material.youngs_modulus",
    "viscosity": "material.viscosity",
    "yield-stress": "material.yield_stress",
    "index": "material.index",
    "shear-viscosity": "material.shear_viscosity",
    "shear-consistency": "material.shear_consistency",
    "shear-yield-stress": "material.shear_yield_stress",
}
"""Flags of the material, and where they go."""

OTHERS = {"ends": "", "duration": "run.duration", "flow-curve": ""}
"""What may be said beside."""

_EXAMPLES = {
    "density": '"1900 kg/m^3"',
    "span": '"2 mm"',
    "diameter": '"250 um"',
    "law": '"bingham"',
    "youngs-modulus": '"300 kPa", some three times the storage modulus G\' of an ink',
}
_SWINGS, _FLOWS = 20.0, 5.0
_ACCURACY = 0.02
_RAMP = 1.0


def scene_from_flags(flags: Mapping[str, str | None], changes: Sequence[str] = ()) -> tuple[Scene, tuple[str, ...]]:
    """Make a scene of a round filament that is let go within sqrt(L/g).

    Parameters
    ----------
    flags : mapping of str to str or None
        Texts with units by the names of :data:`GEOMETRY`, :data:`MATERIAL` and :data:`OTHERS`; None: not given.
    changes : sequence of str
        ``"load.ramp=10 ms"``, as of every command.

    Returns
    -------
    Scene, tuple of str
        And what was assumed.

    Raises
    ------
    SceneError
        With every fault; a flag that is missing is named.
    SoftcatError
        If the flow curve is none, or its fit is one that no scene can take.
    """
    given = {name: text for name, text in flags.items() if text is not None}
    curve = given.get("flow-curve")
    _refuse(given, curve)
    notes: list[str] = []
    table: dict[str, dict[str, object]] = {"filament": {"section": "circle"}, "material": {}, "run": {}}
    for name, path in {**GEOMETRY, **MATERIAL}.items():
        if name in given and not (curve and name == "law"):
            part, key = path.split(".")
            table[part][key] = _number(given[name]) if name == "index" else given[name]
    if curve is not None:
        fitted, told = _from_curve(curve, given.get("law"))
        table["material"] |= fitted
        notes.append(told)
    kind = given.get("ends", "clamped")
    table["ends"] = {"left": kind, "right": kind}
    table["run"] = {"duration": given.get("duration", "1 s"), "accuracy": _ACCURACY}
    scene = Scene.model_validate({"title": _title(given), **table})
    if changes:
        scene = _changed(scene, changes)
    return _timed(scene, given, changes, notes)


def _refuse(given: Mapping[str, str], curve: str | None) -> None:
    needed = [*GEOMETRY, *(["youngs-modulus"] if curve else ["law"])]
    faults = []
    for name in needed:
        if name not in given:
            why = "missing" if name != "youngs-modulus" else "missing: a flow curve says nothing about the modulus"
            faults.append(Fault(f"--{name}", why, _EXAMPLES[name]))
    if curve:
        own = [name for name in MATERIAL if name in given and name not in ("law", "youngs-modulus")]
        faults += [Fault(f"--{name}", "given twice, here and by --flow-curve", "one of the two") for name in own]
    elif "law" in given and given["law"] in CONSTANTS:
        has = {name.removeprefix("shear-").replace("consistency", "viscosity").replace("-", "_") for name in given}
        lacking = [name for name in CONSTANTS[given["law"]] if name not in has]
        flagged = {name: name.replace("_", "-") for name in lacking}
        faults += [
            Fault(f"--{flag}", f"missing: the law '{given['law']}' needs it", "a value with its unit")
            for name, flag in flagged.items()
            if flag in MATERIAL
        ]
    if faults:
        raise SceneError(faults)


def _from_curve(curve: str, law: str | None) -> tuple[dict[str, object], str]:
    from softcat_sym.inverse import fit_flow_curve

    fit: FlowCurveFit = fit_flow_curve(curve)
    fitted: dict[str, object] = {path.removeprefix("material."): value for path, value in fit.overrides(law).items()}
    best = fit.candidate(law)
    told = f"{best.law} fitted to {curve}, {100 * best.relative_rms:.2g} % rms; shear data are converted to tension"
    return fitted, told


def _changed(scene: Scene, changes: Sequence[str]) -> Scene:
    from softcat_sym.scene.overriding import read_overrides

    read, faults = read_overrides(changes)
    if faults:
        raise SceneError(faults)
    return scene.replace({change.path: change.value for change in read})


def _timed(
    scene: Scene, given: Mapping[str, str], changes: Sequence[str], notes: list[str]
) -> tuple[Scene, tuple[str, ...]]:
    """Duration and ramp, where neither is given."""
    own = {change.split("=")[0].strip() for change in changes}
    swing, late = gravity_time(scene), {}
    if not swing > 0:
        return scene, tuple(notes)
    if "load.ramp" not in own:
        late["load.ramp"] = f"{_RAMP * swing!r} s"
    if "duration" not in given and "run.duration" not in own:
        weight = weight_stress(scene)
        stress = yield_stress_of(scene) or weight
        viscosity = effective_viscosity_at(scene, stress) or 0.0
        slow = (_FLOWS if yield_stress_of(scene) else 1.0) * viscosity / stress
        duration = float(f"{_SWINGS * swing + slow:.3g}")
        late["run.duration"] = f"{duration!r} s"
        notes.append(f"duration {duration:g} s: 20 sqrt(L/g) and the time of flow; --duration gives another")
    return scene.replace(late), tuple(notes)


def _number(text: str) -> object:
    try:
        return float(text)
    except ValueError:
        return text


def _title(given: Mapping[str, str]) -> str:
    what = given.get("law") or "ink"
    return f"{what}, {given['diameter']} across {given['span']}"
