"""Scenes from names, paths and dicts."""

from __future__ import annotations

import os
import re
import tomllib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from softcat_sym.errors import Fault, SceneError
from softcat_sym.files import read_limited
from softcat_sym.scene.bundled import bundled_names, bundled_text
from softcat_sym.scene.groups import determined_by_groups
from softcat_sym.scene.material import physical_path, twins
from softcat_sym.scene.scene import LATE, Scene
from softcat_sym.scene.shapes import CSV
from softcat_sym.scene.toml import Override, apply, read_overrides
from softcat_sym.scene.units import did_you_mean, shown

# A scene has some kilobytes; whatever is a thousand times longer was given by mistake (a device, a result).
_LONGEST = 1 << 20
# Keys have three parts at the most; the time that tomllib takes for a key grows as the square of their number.
_DEEPEST = 16
_STRING_OR_COMMENT = re.compile(
    r"""\"{3}(?:[^\\]|\\.)*?\"{3}|'{3}.*?'{3}|"(?:[^"\\\n]|\\.)*"|'[^'\n]*'|\#[^\n]*""", re.DOTALL
)


SceneLike = Scene | str | os.PathLike[str] | Mapping[str, Any]
"""What stands for a scene: itself, the name of a bundled one, the path of a TOML file, or a table as it would hold."""

Changes = Mapping[str, object] | Sequence[str]
"""Values by dotted key, or texts ``KEY=VALUE`` as on the command line."""


def as_scene(given: SceneLike, changes: Changes = ()) -> Scene:
    """Take whatever stands for a scene, with some of its values changed.

    Parameters
    ----------
    given : Scene, str, path or mapping
        A scene; the name of a bundled one or a path, as :func:`load_scene` takes them; or nested tables, whose
        quantities are numbers in SI, text with a unit or pint quantities.
    changes : mapping or sequence of str, optional
        As for :func:`load_scene`; groups are changed by name or path only.

    Raises
    ------
    SceneError
        With every fault at once.
    """
    if isinstance(given, (str, os.PathLike)):
        return load_scene(given, changes)
    scene = given if isinstance(given, Scene) else Scene.from_dict(given)
    read, faults = read_overrides(changes)
    if faults:
        raise SceneError(faults)
    return scene.replace({one.path: one.value for one in read}) if read else scene


def load_scene(name_or_path: str | os.PathLike[str], overrides: Changes = ()) -> Scene:
    """Read a scene and validate it.

    Parameters
    ----------
    name_or_path : str or path
        Name of a bundled scene, or a path of a TOML file. ``./no-yield`` is a file even where a scene has that name.
    overrides : mapping or sequence of str, optional
        ``{"material.yield_stress": "5 kPa"}`` or ``["run.effects=paper", "numerics.cells=40"]``. An override wins over
        whatever the file or its ``[groups]`` say: span, density, gravity and groups are set before the groups are
        resolved, values that the groups determine are set afterwards.

    Returns
    -------
    Scene
        Frozen, plain SI.

    Raises
    ------
    SceneError
        With every fault at once.
    """
    source = str(name_or_path)
    table = _table_of(_text_of(name_or_path, source), source)
    # A file that a scene names lies beside it
    filament = table.get("filament")
    shape = filament.get("shape") if isinstance(filament, dict) else None
    if isinstance(shape, str) and shape.lower().endswith(CSV):
        table["filament"]["shape"] = str(Path(source).parent / shape)
    changes, faults = read_overrides(overrides)
    faults += apply([change for change in changes if _is_group(change)], table)
    determined = determined_by_groups(table)
    late = tuple(one for one in changes if determined & {physical_path(one.path), *twins(one.path)})
    faults += apply([change for change in changes if change not in late and not _is_group(change)], table)
    try:
        scene = Scene.model_validate(table, context={LATE: late})
    except SceneError as error:
        raise SceneError([*faults, *error.faults], source) from None
    if faults:
        raise SceneError(faults, source)
    return scene


def _is_group(change: Override) -> bool:
    return change.path.split(".")[0] == "groups"


def _text_of(name_or_path: str | os.PathLike[str], source: str) -> str:
    if isinstance(name_or_path, str) and name_or_path in bundled_names():
        return bundled_text(name_or_path)
    known = f"a path of a TOML file, or a bundled scene: {', '.join(bundled_names())}"
    try:
        content = read_limited(name_or_path, _LONGEST + 1)
    except FileNotFoundError:
        hint = did_you_mean(Path(source).stem, bundled_names())
        raise _refuse(source, f"no such file and no bundled scene of this name{hint}", known) from None
    except IsADirectoryError:
        raise _refuse(source, "a directory, not a file", known) from None
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise _refuse(source, f"cannot be read: {reason}", known) from None
    if len(content) > _LONGEST:
        raise _refuse(source, "longer than 1 MiB, so not a scene", known)
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        raise _refuse(source, f"not UTF-8 text (line {line})", "TOML in UTF-8") from None


def _table_of(text: str, source: str) -> dict[str, Any]:
    keys = re.split(r"[=,{}\[\]\n]", _STRING_OR_COMMENT.sub("_", text))
    if any(key.count(".") > _DEEPEST for key in keys):
        raise _refuse(source, f"a key of more than {_DEEPEST} parts", "keys such as material.yield_stress")
    try:
        table = tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        raise _refuse(
            source, f"not TOML: {shown(str(error), 200)[1:-1]}", "TOML; `softcat new my-ink.toml` writes a scene"
        ) from None
    if not table:
        raise _refuse(source, "the file is empty", "at least the tables [filament], [material], [run], or [groups]")
    return table


def _refuse(source: str, found: str, accepted: str) -> SceneError:
    return SceneError([Fault("", found, accepted)], source)
