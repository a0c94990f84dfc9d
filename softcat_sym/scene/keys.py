"""Every key of the scene file, as the models have it."""

from __future__ import annotations

from dataclasses import dataclass

from pydantic.fields import FieldInfo

from softcat_sym.scene.groups import GroupBlock
from softcat_sym.scene.kinds import Kind, Quantity
from softcat_sym.scene.model import Scene, parts_of_scene
from softcat_sym.scene.part import Part, dotted, kinds_of
from softcat_sym.scene.units import SI_UNITS
from softcat_sym.scene.writing import toml_value


@dataclass(frozen=True, slots=True)
class SceneKey:
    """One key of the scene file.

    Attributes
    ----------
    path : str
        Dotted, such as ``"material.yield_stress"``.
    unit : str
        Its SI unit; empty for what has none.
    default : str
        As TOML; ``"required"``, or empty where nothing stands for it unless given.
    meaning : str
        A sentence.
    accepted : str
        What a value looks like.
    """

    path: str
    unit: str
    default: str
    meaning: str
    accepted: str


def scene_keys(part: str = "") -> tuple[SceneKey, ...]:
    """List the keys of the scene file in its order.

    Parameters
    ----------
    part : str
        Only those that have this in their names: ``"material"``, ``"stress"``.

    Returns
    -------
    tuple of SceneKey
        Empty if there is none.
    """
    parts: dict[str, type[Part]] = {"": Scene, **parts_of_scene(), "groups": GroupBlock}
    keys = (
        _key(dotted(table, name), part.model_fields[name], kind)
        for table, part in parts.items()
        for name, kind in kinds_of(part).items()
    )
    return tuple(key for key in keys if part in key.path)


def _key(path: str, field: FieldInfo, kind: Kind) -> SceneKey:
    unit = (kind.unit or SI_UNITS[kind.dimension]) if isinstance(kind, Quantity) else ""
    default = "required" if field.is_required() else ""
    if not field.is_required() and field.default is not None:
        default = toml_value(kind.write(field.default))
    return SceneKey(path, unit, default, field.description or "", kind.accepted)


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
