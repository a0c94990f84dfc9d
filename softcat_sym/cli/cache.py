"""``softcat cache``: libraries and results that are stored between runs, and their deletion."""

from __future__ import annotations

from typing import Annotated

import typer

from softcat_sym import cache as kept
from softcat_sym.cli.application import switch
from softcat_sym.lazy import lazy_imports

with lazy_imports():
    from softcat_sym import store
    from softcat_sym.codegen import compiler, library

_HEADINGS = {"native": "libraries", "texts": "texts", "results": "results"}
_NAMES = {
    "native": ("compiled library", "compiled libraries"),
    "texts": ("text", "texts"),
    "results": ("result of studies", "results of studies"),
    "zig": ("folder of zig", "folders of zig"),
}
_BESIDE = {"elements": "states of finite elements", "answers": "answers of acceptance checks"}


def cache(
    clear: Annotated[
        bool, switch("Delete libraries, texts and results; nothing else in the folder.", "--clear")
    ] = False,
) -> None:
    """Show the libraries and results that are kept, or clear them.

    The folder is SOFTCAT_CACHE, by default softcat_sym in the user's folder of caches. Libraries take at most
    SOFTCAT_CACHE_LIMIT (512 MB); beyond that, the least recently used ones are deleted. Results of studies take at most
    1 GB in addition.
    """
    folder = kept.cache_folder()
    if clear:
        for kind, entries in kept.clear(*kept.KINDS).items():
            freed = sum(entry.size for entry in entries)
            if freed or kind in _HEADINGS:
                found = f"{len(entries)} {_NAMES[kind][len(entries) != 1]}"
                typer.echo(f"deleted {found} from {folder / kind}: {library.size_text(freed)} freed")
    else:
        limits = {kept.LIBRARIES: library.cache_limit(), kept.RESULTS: store.LIMIT}
        typer.echo(f"folder     {folder}")
        typer.echo(f"compiler   {compiler.compiler_name() or 'none'}")
        for kind, heading in _HEADINGS.items():
            entries = kept.entries(kind)
            most = f" of at most {library.size_text(limits[kind])}" if kind in limits else ""
            typer.echo(f"{heading:9}  {len(entries)}, {library.size_text(sum(entry.size for entry in entries))}{most}")
    for name, what in _BESIDE.items():
        files = [path for path in (folder / name).rglob("*") if path.is_file()]
        if files:
            size = library.size_text(sum(path.stat().st_size for path in files))
            typer.echo(f"{name}: {what}, {len(files)} files, {size}; not cleared: to remove them, delete the folder")
