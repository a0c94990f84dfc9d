"""Commands of one answer: what is finished is kept, and ``--resume`` goes on from there to the same numbers."""

from __future__ import annotations

import json
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from softcat_sym import single_run
from softcat_sym.fitting.forward_model import ForwardModel
from tests.cli.in_process import Softcat, sets
from tests.inverse.filmed import CHEAP, write_film


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    monkeypatch.setenv("COLUMNS", "160")
    return Softcat(monkeypatch, capsys)


class Counted:
    """Stands in for a method or function, counts its calls, and presses Ctrl-C before one of them."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, where: Any, name: str) -> None:
        own: Callable[..., Any] = getattr(where, name)
        self.calls, self.at = 0, 0

        def counted(*given: Any, **named: Any) -> Any:
            self.calls += 1
            if self.calls == self.at:
                signal.raise_signal(signal.SIGINT)
            return own(*given, **named)

        monkeypatch.setattr(where, name, counted)

    def fresh(self, at: int = 0) -> None:
        """Count anew, and press Ctrl-C in the call of that number."""
        self.calls, self.at = 0, at


def numbers(folder: Path, name: str, timed: tuple[str, ...] = ("wall_s", "seconds")) -> Any:
    """A JSON file without what no two runs share: wall times."""

    def without(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: without(one) for key, one in value.items() if key not in timed}
        return [without(one) for one in value] if isinstance(value, list) else value

    return without(json.loads((folder / name).read_text()))


def interrupted(softcat: Softcat, command: list[str], output: Path, counted: Counted, at: int) -> None:
    """Interrupt a command, see it told, refused without --resume and with another wish, and let it go on."""
    counted.fresh(at)
    done = softcat(*command, "-q", "-o", str(output))
    assert (done.status, done.out) == (130, "")
    assert f"in {output / 'parts'}: the same command with --resume goes on from there" in done.err
    assert [path.name for path in output.iterdir()] == ["parts"]
    counted.fresh()
    assert softcat(*command, "-q", "-o", str(output)).status == 2
    other = softcat(*command, "-q", "-o", str(output), "--resume", *sets("filament.density=1234 kg/m^3"))
    assert other.status == 2 and "another plan" in other.err
    assert counted.calls == 0
    done = softcat(*command, "-q", "-o", str(output), "--resume")
    assert done.status == 0, done.err
    assert not (output / "parts").exists()


def test_a_fit_goes_on(softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    film, whole, broken = write_film(tmp_path / "film.csv"), tmp_path / "whole", tmp_path / "broken"
    free = ("--free", "yield_stress", "--free", "viscosity")
    command = ["fit", str(film), "--scene", "continual-descent", *sets(*CHEAP), *free, "--starts", "0"]
    counted = Counted(monkeypatch, ForwardModel, "_integrated")
    assert softcat(*command, "-q", "-o", str(whole)).status == 0
    count = counted.calls
    interrupted(softcat, command, broken, counted, at=count - 3)
    # That of the interruption, and those after it.
    assert counted.calls == 4
    assert numbers(broken, "fit.json") == numbers(whole, "fit.json")
    for name in ("fit.csv", "scene.toml", "fit.png", "profiles.png"):
        assert (broken / name).read_bytes() == (whole / name).read_bytes()


def test_prices_go_on(softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    whole, broken = tmp_path / "whole", tmp_path / "broken"
    effects = 'run.effects=["inertia", "bending", "viscous-stress"]'
    command = ["effects", "cold-honey", *sets("numerics.cells=4", "run.frames=4", "run.duration=0.02 s", effects)]
    counted = Counted(monkeypatch, single_run, "_run_once")
    assert softcat(*command, "-q", "-o", str(whole)).status == 0
    count = counted.calls
    interrupted(softcat, command, broken, counted, at=count - 1)
    assert counted.calls == 2 < count
    timed = ("solve_s", "time_ratio", "reading")
    assert numbers(broken, "effects.json", timed) == numbers(whole, "effects.json", timed)
    assert (broken / "scene.toml").read_bytes() == (whole / "scene.toml").read_bytes()


def test_a_design_goes_on(softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    whole, broken = tmp_path / "whole", tmp_path / "broken"
    scene = ("maxwell-fast", *sets("run.effects=paper", "groups.duration=6", "numerics.cells=10"))
    film = ("--duration", "0.2:0.8 s", "--frame-rate", "10:200 Hz", "--span", "0.1:0.2 m")
    command = ["experiment", *scene, "--free", "viscosity", "--noise", "10 um", *film]
    counted = Counted(monkeypatch, ForwardModel, "_integrated")
    assert softcat(*command, "-q", "-o", str(whole)).status == 0
    count = counted.calls
    interrupted(softcat, command, broken, counted, at=count - 3)
    assert counted.calls == 4 < count
    assert numbers(broken, "experiment.json") == numbers(whole, "experiment.json")
    for name in ("experiment.csv", "experiment.png", "scene.toml"):
        assert (broken / name).read_bytes() == (whole / name).read_bytes()


def test_a_card_goes_on(softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    whole, broken = tmp_path / "whole", tmp_path / "broken"
    body = ("--density", "1000 kg/m^3", "--span", "10 cm", "--diameter", "1 mm", "--duration", "1 s")
    oil = ("--law", "newtonian", "--viscosity", "1 MPa*s", "--sag", "0.1 mm")
    command = ["card", *body, *oil, *sets("numerics.cells=6", "run.frames=21")]
    counted = Counted(monkeypatch, single_run, "_run_once")
    assert softcat(*command, "-q", "-o", str(whole)).status == 0
    count = counted.calls
    interrupted(softcat, command, broken, counted, at=count - 1)
    assert counted.calls == 2 < count
    assert numbers(broken, "card.json") == numbers(whole, "card.json")
    for name in ("card.csv", "card.png", "scene.toml"):
        assert (broken / name).read_bytes() == (whole / name).read_bytes()
