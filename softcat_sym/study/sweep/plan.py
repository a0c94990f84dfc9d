"""The plan of a sweep: which members there are, in which order, known by a hash."""

from __future__ import annotations

import hashlib
import importlib.metadata
import json
import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, Final, Literal

import numpy as np

from softcat_sym.ensemble.table import Row
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene
from softcat_sym.study.blocks import Block
from softcat_sym.study.sweep.axes import SweepAxis, read_axes, refuse_units
from softcat_sym.study.sweep.csv_table import columns_of, read_table

Mode = Literal["grid", "zip", "lhs", "table"]
MODES: Final = ("grid", "zip", "lhs")

MOST: Final = 10_000_000
"""Members of a sweep."""

SHAPE_FRAMES, SHAPE_NODES = 21, 41

_FEW, _MANY, _BLOCKS, _SLOW = 10, 500, 200, 4
"""Least and most members of a block, how many blocks a sweep should have, and members of a block where each takes
seconds: what an interruption can cost, against a file for each."""

_LISTED = 200
"""Values of an axis that the record lists; of longer ones it gives the number."""

_SHARED = frozenset({"run.frames"})


@dataclass(frozen=True)
class SweepPlan:
    """What is to be run.

    Attributes
    ----------
    scene : Scene
        What the members have in common.
    axes : tuple of SweepAxis
        What varies.
    mode : str
        ``"grid"``: every combination, the last axis fastest; ``"zip"`` and ``"table"``: values side by side; ``"lhs"``:
        a Latin hypercube (McKay, Beckman and Conover 1979).
    samples, seed : int
        Of the hypercube.
    shapes : bool
        Whether shapes are kept.
    estimate : bool
        Whether each member is run as :func:`softcat_sym.simulate` runs it, with its error estimated.
    """

    scene: Scene
    axes: tuple[SweepAxis, ...]
    mode: Mode = "grid"
    samples: int = 0
    seed: int = 0
    shapes: bool = False
    estimate: bool = False

    @property
    def keys(self) -> tuple[str, ...]:
        """What varies."""
        return tuple(axis.key for axis in self.axes)

    @cached_property
    def members(self) -> int:
        """How many there are."""
        if self.mode == "grid":
            return math.prod(len(axis.values) for axis in self.axes)
        return self.samples if self.mode == "lhs" else len(self.axes[0].values)

    @property
    def block_size(self) -> int:
        """Members of a block."""
        if self.estimate:
            return _SLOW
        return min(_MANY, max(_FEW, math.ceil(self.members / _BLOCKS)))

    @property
    def blocks(self) -> int:
        """How many there are."""
        return math.ceil(self.members / self.block_size)

    def block(self, number: int) -> Block[Row]:
        """The members of a block: rows of raw values by key."""
        start = number * self.block_size
        stop = min(start + self.block_size, self.members)
        return Block(number, tuple(self.row(member) for member in range(start, stop)))

    def row(self, member: int) -> Row:
        """What a member changes in the scene."""
        if self.mode == "grid":
            places = np.unravel_index(member, [len(axis.values) for axis in self.axes])
            return {axis.key: axis.values[int(place)] for axis, place in zip(self.axes, places, strict=True)}
        if self.mode == "lhs":
            shares = zip(self.axes, self._shares[member], strict=True)
            return {axis.key: axis.at(float(share)) for axis, share in shares}
        return {axis.key: axis.values[member] for axis in self.axes}

    @cached_property
    def _shares(self) -> Floats:
        """Places of the samples, shape (samples, axes), each axis cut into as many equal parts, one in each."""
        random = np.random.default_rng(self.seed)
        parts = np.stack([random.permutation(self.samples) for _ in self.axes], axis=1)
        return np.asarray((parts + random.random(parts.shape)) / self.samples)

    def described(self) -> dict[str, Any]:
        """For the record; long lists of values are left to the table of results."""
        axes = [axis.described() for axis in self.axes]
        for axis in axes:
            if len(axis["values"]) > _LISTED:
                axis["values"] = len(axis["values"])
        told: dict[str, Any] = {"mode": self.mode, "members": self.members, "axes": axes}
        if self.mode == "lhs":
            told |= {"samples": self.samples, "seed": self.seed}
        return told | {"block": self.block_size, "shapes": self.shapes, "estimate": self.estimate}

    @cached_property
    def digest(self) -> str:
        """Hash of all that decides the results, this package's version included."""
        versions = {name: importlib.metadata.version(name) for name in ("softcat_sym", "casadi", "numpy")}
        axes = [axis.described() for axis in self.axes]
        told = [versions, self.scene.to_toml(), axes, self.mode, self.samples, self.seed, self.shapes, self.estimate]
        return hashlib.sha256(json.dumps([*told, self.block_size], default=repr).encode()).hexdigest()


def plan_sweep(
    scene: Scene,
    vary: Mapping[str, Sequence[object] | str] | Sequence[str] | Path,
    mode: str = "grid",
    *,
    samples: int | None = None,
    seed: int = 0,
    shapes: bool = False,
    estimate: bool = False,
) -> SweepPlan:
    """Read what is asked for.

    Parameters
    ----------
    scene : Scene
        What the members have in common.
    vary : mapping, sequence of str, or pathlib.Path
        As :func:`softcat_sym.study.sweep.axes.read_axes` takes it, or a CSV file.
    mode, samples, seed, shapes, estimate
        As in :class:`SweepPlan`.

    Raises
    ------
    SoftcatError
        If it makes no sense; no member is looked at yet.
    """
    if mode not in MODES:
        raise SoftcatError(f"no mode {mode!r} of a sweep; accepted: {', '.join(MODES)}")
    _check_samples(mode, samples, seed)
    if isinstance(vary, Path):
        if mode != "grid":
            raise SoftcatError(f"a table has its members in rows: no mode {mode!r}")
        axes, kind = read_table(scene, vary), "table"
    else:
        axes, kind = read_axes(scene, vary, drawn=mode == "lhs"), mode
        if kind == "grid":
            _check_distinct(axes)
        elif kind == "zip":
            columns_of(axes)
    refuse_units(scene, axes)
    shared = [axis.key for axis in axes if axis.key in _SHARED]
    if shared:
        raise SceneError([Fault(shared[0], "varied, but members share their frames", "--set run.frames=...")], "")
    plan = SweepPlan(scene, axes, _mode(kind), samples or 0, seed, shapes, estimate)
    if plan.members > MOST:
        raise SoftcatError(f"a sweep of {plan.members} members; accepted: up to {MOST}")
    return plan


def _mode(kind: str) -> Mode:
    modes: dict[str, Mode] = {"grid": "grid", "zip": "zip", "lhs": "lhs", "table": "table"}
    return modes[kind]


def _check_samples(mode: str, samples: int | None, seed: int) -> None:
    if mode == "lhs":
        if isinstance(samples, bool) or not isinstance(samples, int) or not 2 <= samples <= MOST:
            raise SoftcatError(f"samples = {samples!r}: a Latin hypercube needs a number of samples, 2 to {MOST}")
        if isinstance(seed, bool) or not isinstance(seed, int) or seed < 0:
            raise SoftcatError(f"seed = {seed!r}: accepted: a whole number, 0 or more")
    elif samples is not None:
        raise SoftcatError(f"samples are for a Latin hypercube (mode lhs), not for mode {mode}")


def _check_distinct(axes: Sequence[SweepAxis]) -> None:
    """Refuse an axis that names a value twice: its members would be run twice."""
    for axis in axes:
        value, times = Counter(map(repr, axis.values)).most_common(1)[0]
        if times > 1:
            raise SceneError([Fault(axis.key, f"{value} is named twice", "different values")], "of a sweep")
