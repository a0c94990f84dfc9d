"""``softcat cache``: what is kept between runs, and its deletion."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from softcat_sym.cli.application import DEVELOPER, app

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from softcat_sym.codegen.library import CacheEntry

_SHOWN = 20
_BESIDE = {"elements": "states of finite elements", "answers": "answers of acceptance checks"}


@app.command(rich_help_panel=DEVELOPER)
def cache(
    clear: Annotated[
        bool,
        typer.Option("--clear", help="Delete libraries, C texts and results; nothing else in the folder."),
    ] = False,
) -> None:
    """Show the libraries and results that are kept, or clear them.

    Folder: SOFTCAT_CACHE, else softcat_sym in XDG_CACHE_HOME or ~/.cache. Limit: SOFTCAT_CACHE_LIMIT (512 MB); beyond
    it the libraries go that were not used for longest. Results of studies take at most 1 GB beside them.
    """
    from softcat_sym import store
    from softcat_sym.codegen.compiler import cache_folder
    from softcat_sym.codegen.library import cache_entries, clear_cache, size_text

    folder = cache_folder()
    if clear:
        entries = cache_entries()
        freed = clear_cache()
        typer.echo(f"deleted {_count(len(entries))} from {folder / 'native'}: {size_text(freed)} freed")
        count = len(store.entries())
        typer.echo(f"deleted {_results(count)} from {store.folder()}: {size_text(store.clear())} freed")
    else:
        _show(cache_entries())
    for line in _beside(folder):
        typer.echo(f"{line}; not cleared: delete the folder to be rid of it")


def _show(entries: Sequence[CacheEntry]) -> None:
    from datetime import datetime

    from softcat_sym import store
    from softcat_sym.codegen.compiler import cache_folder, compiler_name
    from softcat_sym.codegen.library import cache_limit, kept_texts, size_text

    total, limit, texts = sum(entry.size for entry in entries), cache_limit(), kept_texts()
    typer.echo(f"folder     {cache_folder()}")
    typer.echo(f"compiler   {compiler_name() or 'none'}")
    typer.echo(f"libraries  {len(entries)}, {size_text(total)} of at most {size_text(limit)}")
    typer.echo(f"C texts    {len(texts)}, {size_text(sum(path.stat().st_size for path in texts))}")
    results = store.entries()
    typer.echo(
        f"results    {len(results)}, {size_text(sum(size for _, size in results))} of at most {size_text(store.LIMIT)}"
    )
    if entries:
        typer.echo(f"\n{'key':12}  {'size':>9}  {'last used':16}  made from")
    for entry in entries[:_SHOWN]:
        used = f"{datetime.fromtimestamp(entry.used).astimezone():%Y-%m-%d %H:%M}"
        typer.echo(f"{entry.key[:12]}  {size_text(entry.size):>9}  {used:16}  {entry.about}")
    if len(entries) > _SHOWN:
        typer.echo(f"... and {len(entries) - _SHOWN} that were used before")


def _count(entries: int) -> str:
    return f"{entries} compiled {'library' if entries == 1 else 'libraries'}"


def _results(count: int) -> str:
    return f"{count} {'result' if count == 1 else 'results'} of studies"


def _beside(folder: Path) -> list[str]:
    """What the acceptance checks keep in the same folder."""
    from softcat_sym.codegen.library import size_text

    lines = []
    for name, what in _BESIDE.items():
        files = [path for path in (folder / name).rglob("*") if path.is_file()]
        if files:
            lines.append(f"{name}: {what}, {len(files)} files, {size_text(sum(f.stat().st_size for f in files))}")
    return lines
