"""Blocks worked off one after the other, with an estimate of the time left."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Sequence

from softcat_sym.ensemble.progress import MembersProgress
from softcat_sym.study.blocks.work import Block, Done, Item, Work, Workplace

Keep = Callable[[int, Sequence[Done]], object]


class Count:
    """Items done, told on with the time that the others will take.

    Parameters
    ----------
    members : int
        How many there are.
    done : int
        How many were done before.
    listener : MembersProgress
        Whom to tell.
    """

    def __init__(self, members: int, done: int, listener: MembersProgress) -> None:
        self._members, self._before, self._done, self._listener = members, done, done, listener
        self._begun = time.monotonic()

    def __call__(self, more: int) -> None:
        """Note that so many more are done."""
        self._done += more
        now = self._done - self._before
        left = (time.monotonic() - self._begun) / now * (self._members - self._done) if now else 0.0
        self._listener.update(self._done, self._members, max(left, 0.0))


def run_blocks(
    work: Work[Item, Done], blocks: Iterable[Block[Item]], place: Workplace, told: Count, keep: Keep[Done]
) -> None:
    """Run blocks, and hand each to `keep` as soon as it is finished.

    Parameters
    ----------
    work : Work
        What is done with each item.
    blocks : iterable of Block
        Taken one by one, as there is room for them.
    place : Workplace
        Where.
    told : Count
        Told of items done.
    keep : callable
        Given the number of a block and its results.

    Raises
    ------
    KeyboardInterrupt
        If the user stops it: what was handed to `keep` stays.
    """
    for number, results in place.run(work, blocks, told):
        keep(number, results)
