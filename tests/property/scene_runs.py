"""One drawn scene: read, written, run, and looked at; what was found is plain text and numbers."""

from __future__ import annotations

import json
import time
import warnings
from dataclasses import dataclass
from typing import Any

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from softcat_sym.scene.scene import Scene

from .invariants import is_balanced, messages

REFUSED = "refused"


@dataclass(frozen=True)
class Answer:
    """One scene."""

    scene: str
    law: str
    outcome: str
    reason: str = ""
    broken: tuple[str, ...] = ()
    residual: float | None = None
    seconds: float = 0.0


def answer(table: dict[str, Any], folder: str) -> Answer:
    """Run one scene, and look for what is broken; any exception but the package's own is."""
    started = time.process_time()
    known: dict[str, Any] = {"scene": json.dumps(table), "law": table["material"]["law"]}
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            warnings.simplefilter("ignore", sc.SoftcatWarning)  # what the package tells of a good answer
            known |= _run(table, folder)
    except SoftcatError as error:
        known |= {"outcome": REFUSED, "reason": str(error)}
    except Exception as error:  # noqa: BLE001  whatever comes out is what is looked for
        known |= {"outcome": "", "broken": (f"{type(error).__name__}: {error}",)}
    return Answer(**known, seconds=time.process_time() - started)


def _run(table: dict[str, Any], folder: str) -> dict[str, Any]:
    scene = Scene.model_validate(table)
    broken = _there_and_back(scene, folder)
    run = sc.simulate(scene)
    balanced = is_balanced(scene, run)
    found: dict[str, Any] = {"outcome": run.outcome.name, "reason": run.summary["message"]}
    if run.outcome.is_success:
        broken += messages(run)
        found["residual"] = run.summary["energy_residual"] if balanced else None
    return found | {"broken": tuple(broken)}


def _there_and_back(scene: Scene, folder: str) -> list[str]:
    """Scene to TOML to scene is the identity, and so is the text."""
    from pathlib import Path

    text = scene.to_toml()
    file = Path(folder) / "scene.toml"
    file.write_text(text, encoding="utf-8")
    again = sc.load_scene(file)
    broken = [] if again == scene else ["scene to TOML to scene is not the identity"]
    return broken + ([] if again.to_toml() == text else ["the scene is written differently the second time"])
