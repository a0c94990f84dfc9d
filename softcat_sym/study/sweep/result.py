"""What a sweep returns."""

from __future__ import annotations

import contextlib
import importlib.metadata
import sys
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from softcat_sym.study.sweep.plan import SweepPlan
from softcat_sym.study.sweep.store import Counts

if TYPE_CHECKING:
    import xarray as xr

_VERSIONS = ("softcat_sym", "casadi", "sympy", "numpy")


@dataclass(frozen=True)
class Sweep:
    """A finished sweep.

    Attributes
    ----------
    plan : SweepPlan
        What was run.
    path : pathlib.Path
        The store, ``sweep.nc``.
    counts : Counts
        Members by outcome and by regime.
    resumed : int
        Members that were there from before.
    place : str
        Where it ran.
    wall_s : float
        How long [s].
    peak_memory : float
        Largest memory of this process so far [MB].
    loaded : xarray.Dataset or None
        The store in memory, where it is no longer on disk.
    """

    plan: SweepPlan
    path: Path
    counts: Counts
    resumed: int
    place: str
    wall_s: float
    peak_memory: float
    loaded: xr.Dataset | None = None

    def __len__(self) -> int:
        return self.plan.members

    @cached_property
    def data(self) -> xr.Dataset:
        """The store, dims ``member`` and ``frame``; read from disk as it is used.

        A variable for each varied key, ``outcome``, ``regime``, ``message``, ``midpoint`` [m] and numbers of each
        member; with shapes ``x``, ``y`` [m] and ``stretch``.
        """
        import xarray as xr

        return self.loaded if self.loaded is not None else xr.open_dataset(self.path, engine="h5netcdf")

    def in_memory(self) -> Sweep:
        """The same with its data loaded, independent of the file."""
        import xarray as xr

        return replace(self, loaded=xr.load_dataset(self.path, engine="h5netcdf"))

    def summary(self) -> dict[str, Any]:
        """What ``sweep.json`` holds."""
        ran = len(self) - self.resumed
        return {
            "title": self.plan.scene.title,
            "plan": self.plan.described(),
            "digest": self.plan.digest,
            "outcomes": dict(sorted(self.counts.outcomes.items())),
            "regimes": dict(sorted(self.counts.regimes.items())),
            "place": self.place,
            "wall_s": self.wall_s,
            "resumed_members": self.resumed,
            "members_per_second": ran / self.wall_s if self.wall_s > 0 else None,
            "peak_memory_MB": self.peak_memory,
            "versions": {name: importlib.metadata.version(name) for name in _VERSIONS},
        }


def peak_memory() -> float:
    """Largest resident memory of this process so far [MB]; zero where the system does not tell."""
    # What getrusage says of a Linux process begins at the peak of the one that started it.
    with contextlib.suppress(OSError):
        lines = Path("/proc/self/status").read_text(encoding="utf-8").splitlines()
        for line in lines:
            if line.startswith("VmHWM:"):
                return float(line.split()[1]) * 1.024e-3  # kB of 1024 bytes
    try:
        import resource
    except ImportError:
        return 0.0
    largest = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return largest / (1e6 if sys.platform == "darwin" else 1e3)
