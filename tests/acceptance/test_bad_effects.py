"""Lists of effects that contradict themselves or the scene: one clear fault each, and nothing is written.

Tried through the command line as a user would: ``softcat explain``, and a few by ``run`` and ``effects`` too.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

import pytest

from softcat_sym.effects.registry import REGISTRY
from tests.cli.in_process import Softcat, sets

from .table import show

NAMES = ", ".join(effect.name for effect in REGISTRY)
STRING = ("inertia", "finite-stretch", "thinning", "large-rotation")
PUBLISHED = (*STRING, "bending", "viscous-flow", "yielding", "gravity-ramp")
INK, HONEY, STRAND, MAXWELL, FOUR = "ink-bridge", "cold-honey", "gelatin-strand", "maxwell-slow", "arrested-overdamped"
SMALL, PRINTED = "model=small-deflection", "run.closure=printed"


def of(*names: object) -> str:
    return f"run.effects={json.dumps(names)}"


@dataclass(frozen=True)
class Mistake:
    """A scene, what is changed in it, the key at fault, and what must be said: what was found, what is accepted."""

    scene: str
    changes: tuple[str, ...]
    found: str
    accepted: str
    path: str = "run.effects"


MISTAKES: dict[str, Mistake] = {
    # Names.
    "misspelt": Mistake(INK, (of("inertia", "bendign"),), "'bendign' (did you mean 'bending'?)", "one of"),
    "underscore": Mistake(INK, (of("viscous_flow"),), "(did you mean 'viscous-flow'?)", "one of"),
    "capital": Mistake(INK, (of("Inertia"),), "(did you mean 'inertia'?)", "one of"),
    "unknown": Mistake(INK, (of("inertia", "magic"),), "unknown effect 'magic'", f"one of {NAMES}"),
    "empty name": Mistake(INK, (of(""),), "unknown effect ''", f"one of {NAMES}"),
    "named twice": Mistake(INK, (of("bending", "inertia", "bending"),), "'bending' named twice", "each name once"),
    "auto in a list": Mistake(INK, (of("auto"),), "'auto'", NAMES),
    "misspelt auto": Mistake(INK, ("run.effects=atuo",), "did you mean 'auto'?", "auto, paper, or a list"),
    "a name, not a list": Mistake(INK, ("run.effects=inertia",), "'inertia'", '["inertia"]'),
    "a number": Mistake(INK, ("run.effects=3",), "3 is not a list of names", "auto, paper, or a list of names"),
    "numbers": Mistake(INK, (of(1, 2),), "[1, 2] is not a list of names", "auto, paper, or a list of names"),
    "an empty list": Mistake(INK, ("run.effects=[]",), "[] names nothing", "auto, paper, or a list of names"),
    # Effects that miss another.
    "yields without flow": Mistake(INK, (of("yielding"),), "'yielding' without 'viscous-flow'", "add 'viscous-flow'"),
    "shear, no bending": Mistake(INK, (of(*STRING, "shear"),), "'shear' without 'bending'", "leave 'shear' out"),
    "rotary inertia, no shear": Mistake(
        INK, (of(*STRING, "bending", "rotary-inertia"),), "'rotary-inertia' without 'shear'", "add 'shear'"
    ),
    "rotary inertia, no inertia": Mistake(
        INK, (of(*STRING[1:], "bending", "shear", "rotary-inertia"),), "without 'inertia'", "add 'inertia'"
    ),
    "fibres, no flow": Mistake(INK, (of(*STRING, "bending", "fibres"),), "'fibres' without 'viscous-flow'", "add"),
    "neck, no thinning": Mistake(
        INK, (of("finite-stretch", "viscous-flow", "necking-gradient"),), "without 'thinning'", "add 'thinning'"
    ),
    # Effects that the law cannot have.
    "a gel flows": Mistake(STRAND, (of("viscous-flow"),), "no plastic strain", "leave 'viscous-flow' out"),
    "a fluid flows plastically": Mistake(
        HONEY, (of("viscous-stress", "viscous-flow"),), "no plastic strain", "leave 'viscous-flow' out"
    ),
    "Maxwell yields": Mistake(MAXWELL, (of("viscous-flow", "yielding"),), "no yield stress", "leave 'yielding' out"),
    "Bingham, a viscous stress": Mistake(
        INK, (of("bending", "viscous-stress"),), "'viscous-stress' cannot be had", "leave 'viscous-stress' out"
    ),
    "rubber, a viscous stress": Mistake(
        "stretched-rubber-band", (of("viscous-stress"),), "'viscous-stress' cannot be had", "leave"
    ),
    "fluid without its stress": Mistake(HONEY, (of("inertia", "bending"),), "no other stress", "add 'viscous-stress'"),
    # Effects that the scene, the model or the closure cannot have, or cannot do without.
    "ramp without a ramp": Mistake(
        INK, ("load.ramp=0 s", of("gravity-ramp")), "load.ramp is zero", "leave 'gravity-ramp' out"
    ),
    "plastic start, no flow": Mistake(
        "drying-ink", (of("inertia", "bending"),), "initial state is a plastic strain", "add 'viscous-flow'"
    ),
    "curled, no bending": Mistake(
        "curled-rod", (of("extensibility", "viscous-stress"),), "curved by nature", "add 'bending'"
    ),
    "small deflections stretch": Mistake(
        MAXWELL, (SMALL, of("bending", "extensibility")), "small-deflection", "leave 'extensibility' out"
    ),
    "small deflections of Bingham": Mistake(INK, (SMALL,), "'bingham'", "elastic or maxwell", "material.law"),
    "printed closure, shear": Mistake(
        FOUR, (PRINTED, of(*PUBLISHED, "shear")), "'printed' with shear", "'material'", "run.closure"
    ),
    "printed closure, necks": Mistake(
        FOUR, (PRINTED, of(*PUBLISHED, "necking-gradient")), "with necking-gradient", "'material'", "run.closure"
    ),
    "printed closure, order 3": Mistake(FOUR, (PRINTED, "numerics.order=3"), "'printed'", "order = 1", "run.closure"),
    "printed closure, 8 fibres": Mistake(FOUR, (PRINTED, "numerics.fibres=8"), "'printed'", "fibres", "run.closure"),
    "fibres of a gel": Mistake(STRAND, ("numerics.fibres=8",), "does not flow", "leaving it out", "numerics.fibres"),
    "order of a gel": Mistake(STRAND, ("numerics.order=3",), "does not flow", "leaving it out", "numerics.order"),
    "cvodes, no inertia": Mistake(
        INK, (of("bending"), "numerics.solver=cvodes"), "without inertia", "idas", "numerics.solver"
    ),
}

# One mistake that could be told in many ways.
ONCE: dict[str, Mistake] = {
    "auto and more": Mistake(INK, (of("auto", "shear"),), "'auto'", NAMES),
    "shear alone": Mistake(INK, (of("inertia", "shear"),), "'shear' without", "leave 'shear' out"),
    "neck alone": Mistake(INK, (of("bending", "necking-gradient"),), "'necking-gradient' without", "leave"),
    "fibres alone": Mistake(INK, (of("bending", "viscous-flow", "fibres"),), "'fibres' without", "leave 'fibres' out"),
    "8 fibres and a list": Mistake(
        INK,
        (of("bending", "viscous-flow"), "numerics.fibres=8"),
        "without 'finite-stretch'",
        "run.effects",
        "numerics.fibres",
    ),
    "rotary inertia alone": Mistake(
        INK, (of("inertia", "bending", "rotary-inertia"),), "'rotary-inertia' without", "'finite-stretch'"
    ),
    "a gel yields": Mistake(STRAND, (of("bending", "yielding"),), "no yield stress", "leave 'yielding' out"),
    "honey yields": Mistake(HONEY, (of("viscous-stress", "yielding"),), "no yield stress", "leave 'yielding' out"),
    "a gel has fibres": Mistake(
        STRAND, (of(*STRING, "bending", "fibres"),), "'fibres' cannot be had", "leave 'fibres' out"
    ),
    "small deflections shear": Mistake(
        MAXWELL, (SMALL, of("bending", "shear")), "small-deflection", "leave 'shear' out"
    ),
    "small deflections neck": Mistake(
        MAXWELL, (SMALL, of("viscous-flow", "necking-gradient")), "small-deflection", "leave 'necking-gradient' out"
    ),
}


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    return Softcat(monkeypatch, capsys)


def refused(softcat: Softcat, command: str, mistake: Mistake, output: Path) -> str:
    """The only fault that the command tells; it must leave nothing behind."""
    changes = sets(*mistake.changes, "numerics.cells=4")
    done = softcat(command, mistake.scene, "-o", str(output), *changes)
    assert (done.status, done.out) == (2, ""), done
    assert not output.exists()
    head, *faults = done.err.splitlines()
    assert head.startswith("softcat: scene") and head.endswith("1 fault"), done.err
    assert len(faults) == 1
    return faults[0].strip()


def check(softcat: Softcat, command: str, mistake: Mistake, output: Path) -> str:
    fault = refused(softcat, command, mistake, output)
    assert fault.startswith(f"{mistake.path}: "), fault
    found, accepted = fault.split("; accepted: ")
    assert mistake.found in found, fault
    assert mistake.accepted in accepted, fault
    return fault


def test_each_mistake_is_one_clear_fault(softcat: Softcat, tmp_path: Path) -> None:
    rows = []
    for name, mistake in MISTAKES.items():
        fault = check(softcat, "explain", mistake, tmp_path / "out")
        rows.append([name, mistake.scene, fault.replace(NAMES, "...")])
    show("bad lists of effects", ["mistake", "scene", "what is said"], rows)
    assert len(rows) >= 15


@pytest.mark.parametrize("command", ["run", "effects"])
@pytest.mark.parametrize("name", ["misspelt", "auto in a list", "curled, no bending", "printed closure, order 3"])
def test_every_command_refuses_before_it_runs(name: str, command: str, softcat: Softcat, tmp_path: Path) -> None:
    check(softcat, command, MISTAKES[name], tmp_path / "out")


@pytest.mark.parametrize("name", ONCE)
def test_a_mistake_is_told_once(name: str, softcat: Softcat, tmp_path: Path) -> None:
    check(softcat, "explain", ONCE[name], tmp_path / "out")


def test_two_mistakes_are_two_faults(softcat: Softcat, tmp_path: Path) -> None:
    done = softcat("explain", INK, "-o", str(tmp_path / "out"), *sets(of("magic", "viscous-stress")))
    assert done.status == 2
    assert "2 faults" in done.err and "'magic'" in done.err and "'viscous-stress' cannot be had" in done.err
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("scene", "names", "implied"),
    [
        ("slack-taffy", ("inertia", "bending", "viscous-flow"), True),
        ("slime-slope", ("inertia", "bending", "viscous-flow"), True),
        ("drying-ink", ("inertia", "bending", "viscous-flow"), True),
        (INK, ("inertia",), True),
        (INK, ("inertia", "bending"), False),
        (INK, ("bending", "finite-stretch"), True),
    ],
)
def test_what_is_no_mistake_stretching_is_implied_where_nothing_else_would_do(
    scene: str, names: tuple[str, ...], implied: bool, softcat: Softcat, tmp_path: Path
) -> None:
    done = softcat("explain", scene, "-q", "-o", str(tmp_path), *sets(of(*names), "numerics.cells=4"))
    assert (done.status, done.err) == (0, "")
    told = {one["effect"]: one for one in json.loads((tmp_path / "explain.json").read_text())["effects"]}
    in_force = {name for name, one in told.items() if one["in_force"]}
    assert in_force == {*names, *(["extensibility"] if implied else [])}
    assert told["extensibility"]["reason"] != "named in run.effects"
