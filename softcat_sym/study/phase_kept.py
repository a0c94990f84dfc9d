"""Finished runs of a phase diagram on disk, from which an interrupted one goes on."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from softcat_sym.study.blocks import KeptBlocks
from softcat_sym.study.phase_plane import Place
from softcat_sym.study.phase_runs import LocalStrains, PhaseRun, Watched


class KeptRuns:
    """Finished runs in a folder, that an interrupted diagram goes on from; whatever its planes and resolution.

    Parameters
    ----------
    blocks : KeptBlocks
        The folder.

    Attributes
    ----------
    runs : dict
        By place and duration.
    """

    def __init__(self, blocks: KeptBlocks) -> None:
        self._blocks = blocks
        numbers = blocks.numbers()
        self._next = max(numbers, default=-1) + 1
        self.runs: dict[Watched, PhaseRun] = {}
        for number in sorted(numbers):
            content = blocks.read(number)
            if content is not None:
                self.runs |= {(run.place, asked): run for asked, run in map(_read_run, json.loads(content))}

    def keep(self, runs: Mapping[Watched, PhaseRun]) -> None:
        """Write finished runs whole or not at all.

        Raises
        ------
        OSError
            If they cannot be written.
        """
        listed = [{**asdict(run), "asked": asked} for (_, asked), run in runs.items()]
        self._blocks.keep(self._next, json.dumps(listed).encode())
        self._next += 1
        self.runs |= runs


def _read_run(told: dict[str, Any]) -> tuple[float, PhaseRun]:
    """The duration that was asked, and the run."""
    asked = float(told.pop("asked"))
    parts = {"place": Place(**told["place"])} | {name: LocalStrains(**told[name]) for name in ("clamp", "midspan")}
    return asked, PhaseRun(**{**told, **parts})
