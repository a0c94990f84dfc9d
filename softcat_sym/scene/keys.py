"""Every key of the scene file, and the first scene of one's own that ``softcat new`` writes."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass

from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene.groups import GroupBlock
from softcat_sym.scene.laws import LAWS, spec_of
from softcat_sym.scene.material import tensile_name, twins
from softcat_sym.scene.parts import Part, dotted, kinds_of, meanings_of
from softcat_sym.scene.scene import Scene, parts_of_scene
from softcat_sym.scene.toml import toml_value
from softcat_sym.scene.units import consistency_unit


@dataclass(frozen=True, slots=True)
class SceneKey:
    """One key of the scene file."""

    path: str  # Dotted, such as ``"material.yield_stress"``
    unit: str  # Its SI unit; empty for what has none
    default: str  # As TOML; ``"required"``, or empty where nothing stands for it unless given
    meaning: str  # A sentence
    accepted: str  # What a value looks like


def scene_keys(part: str = "") -> tuple[SceneKey, ...]:
    """List the keys of the scene file in its order."""
    parts: dict[str, type[Part]] = {"": Scene, **parts_of_scene(), "groups": GroupBlock}
    keys = []
    for table, one in parts.items():
        for name, kind in kinds_of(one).items():
            field, meaning = one.model_fields[name], meanings_of(one).get(name, "")
            default = "required" if field.is_required() else ""
            if not field.is_required() and field.default is not None:
                default = toml_value(kind.write(field.default))
            keys.append(SceneKey(dotted(table, name), kind.unit, default, meaning, kind.accepted))
    return tuple(key for key in keys if part in key.path)


PAGE = """# Keys of a scene

Every key of a scene file, as `softcat keys` lists them; quantities are text with a unit, any of that dimension.
This page is made by `softcat keys --markdown > .docs/manual/keys.md`.
"""


def keys_in_markdown() -> str:
    """Write the page of the manual: a table of keys for each table of the file."""
    lines = [PAGE.rstrip("\n")]
    table = None
    for key in scene_keys():
        here, _, name = key.path.rpartition(".")
        if here != table:
            table = here
            head = f"`[{table}]`" if table else "Outside every table"
            lines += ["", f"## {head}", "", "| key | unit | default | meaning | accepted |", "|---|---|---|---|---|"]
        default = key.default if key.default in ("", "required") else f"`{key.default}`"
        cells = (f"`{name}`", key.unit, default, key.meaning, key.accepted)
        lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return "\n".join([*lines, ""])


_GEOMETRY = {"filament.span": "5 mm", "filament.thickness": "0.4 mm", "filament.density": "2200 kg/m^3"}
_CHOICES = ("filament.section", "material.law", "ends.left", "ends.right")
_INK = {
    "storage_modulus": "103 kPa",
    "shear_yield_stress": "200 Pa",
    "shear_viscosity": "10 Pa*s",
    "relaxation_time": "0.1 s",
    "shear_solvent_viscosity": "10 Pa*s",
    "finite_extensibility": "1000",
    "mobility": "0.2",
    "ptt_epsilon": "0.1",
    "loss_tangent": "0.1",
}
"""Constants of an ink, and of polymer chains in a solvent, in the order of the file."""
TEMPLATES = tuple(
    one.name
    for one in LAWS.values()
    if one.constants and not one.lists and set(one.constants) <= {tensile_name(name) or name for name in _INK}
)
"""Laws whose constants a template asks for: each has some, with values here, and nothing besides."""
LOSS, LOSS_MODULUS = "material.loss_tangent", "material.loss_modulus"
REASONS = {
    LOSS: "Without it a strand that is let go rings for long.",
    "surroundings.surface_tension": "Without it a thin strand of ink sags several times as far; water has 72 mN/m.",
}
"""Why a first scene states what it could leave out."""
_NUMBERS = (LOSS, "material.index", "material.finite_extensibility", "material.mobility", "material.ptt_epsilon")
_LATER = ("ends.left", "ends.right", "load.ramp", "run.frames", "run.accuracy", "run.effects")
"""Keys whose defaults are written as comments, for who wants to change them next."""


def example_values(given: Mapping[str, str]) -> dict[str, str]:
    """Return values of an ink for all that a scene of a law needs, but for what is given by another key."""
    law = given.get("material.law", "bingham")
    constants = (*spec_of(law).constants, *(() if law not in LAWS or LAWS[law].loss_refused else ("loss_tangent",)))
    own = {name: text for name, text in _INK.items() if (tensile_name(name) or name) in constants}
    if spec_of(law).has_index:
        index = given.get("material.index", "0.5")
        number = _value("material.index", index)
        del own["shear_viscosity"]
        own["index"] = index
        own["shear_consistency"] = f"10 {consistency_unit(number if isinstance(number, float) else 1.0)}"
    if spec_of(law).has_chains:
        own["storage_modulus"] = "100 Pa"
    values = {**_GEOMETRY, "material.law": law, **{f"material.{name}": text for name, text in own.items()}}
    values |= {"surroundings.surface_tension": "72 mN/m", "run.duration": "0.5 s"}
    return {path: text for path, text in values.items() if not {*twins(path)} & given.keys()}


def scene_template(title: str, given: Mapping[str, str]) -> tuple[str, Scene]:
    """Write a scene of a round strand, with a comment on every value, and validate it."""
    law = given.get("material.law", TEMPLATES[0])
    if law in LAWS and law not in TEMPLATES:
        found = f"'{law}', whose constants are more than are asked for here"
        raise SceneError([Fault("material.law", found, f"{', '.join(TEMPLATES)}; softcat show NAME writes others")])
    values = {**example_values(given), **given}
    lines = [
        "# Every value has its unit. What else may stand here, and what it means: softcat keys",
        f"title = {toml_value(title)}",
    ]
    table = ""
    for key in scene_keys():
        if key.path not in values and key.path not in _LATER and key.path != "filament.section":
            continue
        here, _, name = key.path.partition(".")
        if here != table:
            lines += ["", f"[{here}]"]
            table = here
        choice = f" ({key.accepted})" if key.path in _CHOICES else ""
        lines.append(f"# {key.meaning}{choice}")
        lines += [f"# {REASONS[key.path]}"] if key.path in REASONS else []
        if key.path == "filament.section":
            lines.append(f'{name} = "circle"')
        elif key.path in values:
            lines.append(f"{name} = {toml_value(_value(key.path, values[key.path]))}")
        else:
            lines.append(f"# {name} = {key.default}")
    text = "\n".join([*lines, ""])
    return text, Scene.model_validate(tomllib.loads(text))


def _value(path: str, text: str) -> object:
    """A number where the key takes one; what is none is refused with the scene."""
    if path not in _NUMBERS:
        return text
    try:
        return float(text)
    except ValueError:
        return text
