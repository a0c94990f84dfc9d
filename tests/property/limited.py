"""Runs in processes of their own that are ended when they take too long: a run that hangs is found, not waited for."""

from __future__ import annotations

import json
import tempfile
from multiprocessing.connection import Connection
from typing import Any

from tests.limited_process import Ask, limit_this_process

from .scene_runs import Answer, answer

_LATE = "no answer within"


def is_late(answer: Answer) -> bool:
    """Whether a scene was ended for the time it took: no exception, no process that died of its own."""
    return not answer.outcome and answer.broken[0].startswith(_LATE)


def answer_within(ask: Ask, table: dict[str, Any], limit: float) -> Answer:
    """Answer one scene within so many seconds of the processor; else its answer says that there was none."""
    answers, died = ask((table, limit), (limit,))
    if answers:
        found: Answer = answers[0]
        return found
    why = died or f"{_LATE} {limit:g} s"
    return Answer(json.dumps(table), table["material"]["law"], "", broken=(why,), seconds=limit)


def serve(there: Connection) -> None:
    """Answer scenes one after another."""
    import softcat_sym.simulate  # noqa: F401  imported before the clock runs

    there.send("ready")
    with tempfile.TemporaryDirectory() as folder:
        while True:
            try:
                table, limit = there.recv()
            except EOFError:
                return
            limit_this_process(limit)
            found = answer(table, folder)
            limit_this_process(0)
            there.send(found)
