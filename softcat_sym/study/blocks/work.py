"""What is worked off, and where: a block of items, the work on each, the place where it is done."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

Item = TypeVar("Item")
Done = TypeVar("Done")
ItemIn = TypeVar("ItemIn", contravariant=True)
DoneOut = TypeVar("DoneOut", covariant=True)

Told = Callable[[int], None]
"""Told of that many items that are done."""


@dataclass(frozen=True)
class Block(Generic[Item]):
    """Items that are run, kept and lost together.

    Attributes
    ----------
    number : int
        Its place among the blocks, from 0.
    items : tuple
        What is run.
    """

    number: int
    items: tuple[Item, ...]


class Work(Protocol[ItemIn, DoneOut]):
    """What is done with items; it can be sent to another process."""

    def run(self, items: Sequence[ItemIn], threads: int, told: Told) -> Sequence[DoneOut]:
        """Run items, `threads` at a time; a result for each, in their order."""
        ...

    def lost(self, item: ItemIn, why: str) -> DoneOut:
        """The result of an item that has killed whoever ran it."""
        ...


class Workplace(Protocol):
    """Where blocks are run."""

    def run(
        self, work: Work[Item, Done], blocks: Iterable[Block[Item]], told: Told
    ) -> Iterator[tuple[int, Sequence[Done]]]:
        """The number and the results of each block, as they are finished."""
        ...

    def named(self) -> str:
        """What it is, for the record."""
        ...

    def size(self) -> int:
        """How many members it runs at a time."""
        ...


def blocks_of(items: Sequence[Item], size: int) -> list[Block[Item]]:
    """Cut items into blocks of a size; the last may be smaller."""
    starts = range(0, len(items), size)
    return [Block(number, tuple(items[start : start + size])) for number, start in enumerate(starts)]
