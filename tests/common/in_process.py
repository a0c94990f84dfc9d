"""The ``softcat`` command in this process: as quick as a function, with the exit status of the command."""

from __future__ import annotations

import sys
from dataclasses import dataclass

import pytest

from softcat_sym.cli import main


@dataclass(frozen=True)
class Done:
    """Exit status and what was printed."""

    status: int | str | None
    out: str
    err: str


@dataclass(frozen=True)
class Softcat:
    """Calls the command with arguments."""

    monkeypatch: pytest.MonkeyPatch
    capsys: pytest.CaptureFixture[str]

    def __call__(self, *arguments: str) -> Done:
        self.monkeypatch.setattr(sys, "argv", ["softcat", *arguments])
        self.capsys.readouterr()
        with pytest.raises(SystemExit) as left:
            main()
        said = self.capsys.readouterr()
        assert "Traceback" not in said.err
        return Done(left.value.code, said.out, said.err)


def sets(*changes: str) -> list[str]:
    """The options that make these changes."""
    return [word for change in changes for word in ("--set", change)]
