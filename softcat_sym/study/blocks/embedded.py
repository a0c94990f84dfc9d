"""Blocks run in this process: members side by side in threads, one block after the other."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from softcat_sym.study.blocks.work import Block, Done, Item, Told, Work


@dataclass(frozen=True)
class Embedded:
    """Threads of this process.

    Attributes
    ----------
    threads : int
        Members at a time.
    """

    threads: int

    def run(
        self, work: Work[Item, Done], blocks: Iterable[Block[Item]], told: Told
    ) -> Iterator[tuple[int, Sequence[Done]]]:
        """The number and the results of each block, in order.

        Raises
        ------
        KeyboardInterrupt
            If the user stops it: no thread goes on.
        """
        for block in blocks:
            yield block.number, work.run(block.items, self.threads, told)

    def named(self) -> str:
        """How many threads there are."""
        return f"embedded, {self.threads} thread{'s' if self.threads > 1 else ''}"

    def size(self) -> int:
        """The threads."""
        return self.threads
