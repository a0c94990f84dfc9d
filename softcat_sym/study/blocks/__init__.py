"""Many runs worked off in blocks: here in threads or on a Dask cluster, each finished block kept in a file."""

from softcat_sym.study.blocks.kept import KeptBlocks, kept_text
from softcat_sym.study.blocks.results import KeptResults
from softcat_sym.study.blocks.running import run_blocks
from softcat_sym.study.blocks.work import Block, Work, Workplace, blocks_of
from softcat_sym.study.blocks.workplaces import workplace

__all__ = [
    "Block",
    "KeptBlocks",
    "KeptResults",
    "Work",
    "Workplace",
    "blocks_of",
    "kept_text",
    "run_blocks",
    "workplace",
]
