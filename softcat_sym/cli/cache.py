"""``softcat cache``: libraries and results that are stored between runs, and their deletion."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated

import typer

from softcat_sym.cli.application import commands, switch

_SHOWN = 20
_HEADINGS = {"native": "libraries", "texts": "texts", "results": "results"}
_NAMES = {
    "native": ("compiled library", "compiled libraries"),
    "texts": ("text", "texts"),
    "results": ("result of studies", "results of studies"),
    "zig": ("folder of zig", "folders of zig"),
}
_BESIDE = {"elements": "states of finite elements", "answers": "answers of acceptance checks"}


@commands.command()
def cache(
    clear: Annotated[
        bool,
        switch("Delete libraries, texts and results; nothing else in the folder.", "--clear"),
    ] = False,
) -> None:
    """Show the libraries and results that are kept, or clear them.

    The folder is SOFTCAT_CACHE, by default softcat_sym in the user's folder of caches. Libraries take at most
    SOFTCAT_CACHE_LIMIT (512 MB); beyond that, the least recently used ones are deleted. Results of studies take at most
    1 GB in addition.
    """
    from softcat_sym import cache, store
    from softcat_sym.codegen.compiler import compiler_name
    from softcat_sym.codegen.library import about, cache_limit, size_text

    folder = cache.cache_folder()
    if clear:
        for kind, entries in cache.clear(*cache.KINDS).items():
            freed = sum(entry.size for entry in entries)
            if freed or kind in _HEADINGS:
                found = f"{len(entries)} {_NAMES[kind][len(entries) != 1]}"
                typer.echo(f"deleted {found} from {folder / kind}: {size_text(freed)} freed")
    else:
        limits = {cache.LIBRARIES: cache_limit(), cache.RESULTS: store.LIMIT}
        typer.echo(f"folder     {folder}")
        typer.echo(f"compiler   {compiler_name() or 'none'}")
        for kind, heading in _HEADINGS.items():
            entries = cache.entries(kind)
            most = f" of at most {size_text(limits[kind])}" if kind in limits else ""
            typer.echo(f"{heading:9}  {len(entries)}, {size_text(sum(entry.size for entry in entries))}{most}")
        libraries = cache.entries(cache.LIBRARIES)
        if libraries:
            typer.echo(f"\n{'key':12}  {'size':>9}  {'last used':16}  made from")
        for entry in libraries[:_SHOWN]:
            used = f"{datetime.fromtimestamp(entry.used).astimezone():%Y-%m-%d %H:%M}"
            typer.echo(f"{entry.path.name[:12]}  {size_text(entry.size):>9}  {used:16}  {about(entry.path)[1]}")
        if len(libraries) > _SHOWN:
            typer.echo(f"... and {len(libraries) - _SHOWN} with an earlier use")
    for name, what in _BESIDE.items():
        files = [path for path in (folder / name).rglob("*") if path.is_file()]
        if files:
            size = size_text(sum(path.stat().st_size for path in files))
            typer.echo(f"{name}: {what}, {len(files)} files, {size}; not cleared: to remove them, delete the folder")
