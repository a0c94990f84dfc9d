"""``softcat cache``: libraries and results that are stored between runs, and their deletion."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated

import typer

from softcat_sym.cli.application import commands

_SHOWN = 20
_BESIDE = {"elements": "states of finite elements", "answers": "answers of acceptance checks"}


@commands.command()
def cache(
    clear: Annotated[
        bool,
        typer.Option("--clear", help="Delete libraries, C texts and results; nothing else in the folder."),
    ] = False,
) -> None:
    """Show the libraries and results that are kept, or clear them.

    The folder is SOFTCAT_CACHE, by default softcat_sym in the user's folder of caches. Libraries take at most
    SOFTCAT_CACHE_LIMIT (512 MB); beyond that, the least recently used ones are deleted. Results of studies take at most
    1 GB in addition.
    """
    from softcat_sym import store
    from softcat_sym.codegen.compiler import cache_folder, compiler_name
    from softcat_sym.codegen.library import cache_entries, cache_limit, clear_cache, kept_texts, size_text

    folder, entries, results = cache_folder(), cache_entries(), store.entries()
    if clear:
        freed = size_text(clear_cache()), size_text(store.clear())
        libraries = f"{len(entries)} compiled {'library' if len(entries) == 1 else 'libraries'}"
        typer.echo(f"deleted {libraries} from {folder / 'native'}: {freed[0]} freed")
        studies = f"{len(results)} {'result' if len(results) == 1 else 'results'} of studies"
        typer.echo(f"deleted {studies} from {store.folder()}: {freed[1]} freed")
    else:
        texts = kept_texts()
        total, limit = size_text(sum(entry.size for entry in entries)), size_text(cache_limit())
        stored = size_text(sum(size for _, size in results))
        typer.echo(f"folder     {folder}")
        typer.echo(f"compiler   {compiler_name() or 'none'}")
        typer.echo(f"libraries  {len(entries)}, {total} of at most {limit}")
        typer.echo(f"C texts    {len(texts)}, {size_text(sum(path.stat().st_size for path in texts))}")
        typer.echo(f"results    {len(results)}, {stored} of at most {size_text(store.LIMIT)}")
        if entries:
            typer.echo(f"\n{'key':12}  {'size':>9}  {'last used':16}  made from")
        for entry in entries[:_SHOWN]:
            used = f"{datetime.fromtimestamp(entry.used).astimezone():%Y-%m-%d %H:%M}"
            typer.echo(f"{entry.key[:12]}  {size_text(entry.size):>9}  {used:16}  {entry.about}")
        if len(entries) > _SHOWN:
            typer.echo(f"... and {len(entries) - _SHOWN} with an earlier use")
    for name, what in _BESIDE.items():
        files = [path for path in (folder / name).rglob("*") if path.is_file()]
        if files:
            size = size_text(sum(path.stat().st_size for path in files))
            typer.echo(f"{name}: {what}, {len(files)} files, {size}; not cleared: to remove them, delete the folder")
