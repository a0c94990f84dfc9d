"""Which place a study runs at: this process, a Dask cluster that is there, or one that is started for it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from softcat_sym.ensemble.running import workers_of
from softcat_sym.errors import SoftcatError
from softcat_sym.study.blocks.embedded import Embedded
from softcat_sym.study.blocks.work import Workplace


def check_workplace(workers: int | None, scheduler: str | None, local_cluster: int | None) -> None:
    """Refuse what cannot be had, before anything is computed.

    Raises
    ------
    SoftcatError
        If two places are named, or a number of workers is none.
    """
    if scheduler is not None and local_cluster is not None:
        raise SoftcatError("name a scheduler or a local cluster, not both")
    if workers is not None and (scheduler is not None or local_cluster is not None):
        raise SoftcatError("a number of threads is for runs in this process; workers of a cluster have their own")
    workers_of(workers)
    if local_cluster is not None and (
        isinstance(local_cluster, bool) or not isinstance(local_cluster, int) or local_cluster < 1
    ):
        raise SoftcatError(f"a local cluster of {local_cluster!r}: give a whole number of worker processes, 1 or more")


@contextmanager
def workplace(
    workers: int | None = None, scheduler: str | None = None, local_cluster: int | None = None
) -> Iterator[Workplace]:
    """The place that is asked for, ready to work; a cluster that was started for it ends with it.

    Parameters
    ----------
    workers : int, optional
        Threads of this process; as many as there are cores by default.
    scheduler : str, optional
        Address of a Dask scheduler, ``tcp://host:port``.
    local_cluster : int, optional
        Worker processes of a Dask cluster on this machine.

    Raises
    ------
    SoftcatError
        As :func:`check_workplace`; if there is no Dask; if the scheduler does not answer or has no workers.
    """
    check_workplace(workers, scheduler, local_cluster)
    if scheduler is None and local_cluster is None:
        yield Embedded(workers_of(workers))
        return
    from softcat_sym.study.blocks.dask_cluster import cluster_at, own_cluster

    with cluster_at(scheduler) if scheduler is not None else own_cluster(local_cluster or 1) as cluster:
        yield cluster
