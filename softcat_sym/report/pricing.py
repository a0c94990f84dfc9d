"""Terminal output and files of a pricing, of one scene or of many."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from softcat_sym.files import write_all
from softcat_sym.report.canvas import png
from softcat_sym.report.pricing_chart import pricing_figure
from softcat_sym.report.pricing_tables import document, pricing_table, rows_csv, table_line
from softcat_sym.report.units import significant
from softcat_sym.study.bundled_pricing import KeptPricing, Unpriced, pricing_identity
from softcat_sym.study.reading import percent, reading

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from softcat_sym.study.pricing import Pricing, PricingRow

_NOTE = (
    "change of the midpoint, of its largest; own: without what goes along; expected: the estimate before the run;\n"
    "unknowns, instructions, time: with the effect over without it"
)

_LEAST = 1e-6


def row_texts(row: PricingRow) -> tuple[str, ...]:
    """Effect, in or out, change, own share, expected, and the ratios of unknowns, instructions and solve time."""
    amounts = (_share(value) for value in (row.change, row.share, row.estimate))
    ratios = (_ratio(value) for value in (row.states_ratio, row.instructions_ratio, row.time_ratio))
    return (row.effect, "" if row.variant is None else "out" if row.in_force else "in", *amounts, *ratios)


def pricing_columns(pricing: Pricing) -> Table:
    """Lay the rows out as a table for the terminal."""
    from rich import box
    from rich.table import Table
    from rich.text import Text

    table = Table(
        title=Text(pricing.scene.title or "Filament", style="bold"),
        title_justify="left",
        caption=Text(_NOTE, style="dim"),
        caption_justify="left",
        box=box.SIMPLE_HEAD,
        padding=(0, 1, 0, 0),
    )
    names = ("effect", "", "change", "own", "expected", "un-\nknowns", "instruc-\ntions", "time")
    for k, name in enumerate(names):
        table.add_column(Text(name), justify="left" if k < 2 else "right", no_wrap=True)
    for row in (*pricing.rows, pricing.everything):
        table.add_row(*(Text(text) for text in row_texts(row)))
    return table


def remarks(pricing: Pricing) -> list[str]:
    """What went along, what failed, and why some were not run."""
    found = []
    for row in (*pricing.rows, pricing.everything):
        word = "without" if row.in_force else "with"
        if row.fails and row.variant is not None:
            found.append(f"{word} {row.effect}: {row.variant.outcome.name}; {row.variant.complaint}".rstrip("; "))
        if row.also:
            found.append(f"{word} {row.effect}: {'also' if row.in_force else 'and'} {word} {', '.join(row.also)}")
        if row.reason:
            found.append(f"{row.effect}: {row.reason}")
    return found


def print_pricing(pricing: Pricing, console: Console | None = None) -> None:
    """Print the table, the remarks and the sentence.

    Parameters
    ----------
    pricing : Pricing
        As from :func:`softcat_sym.study.pricing.price`.
    console : rich.console.Console or None
        Where to; standard output by default.
    """
    from rich.console import Console
    from rich.text import Text

    screen = console or Console()
    screen.print(pricing_columns(pricing))
    for text in remarks(pricing):
        screen.print(Text(text, style="dim"))
    screen.print(Text(f"{reading(pricing)}."))


def write_pricing(pricing: Pricing, directory: str | Path) -> list[Path]:
    """Write ``effects.json``, ``effects.csv``, ``effects.png`` and ``scene.toml``; all is drawn before any is written.

    Parameters
    ----------
    pricing : Pricing
        As from :func:`softcat_sym.study.pricing.price`.
    directory : str or pathlib.Path
        Where the files go; made if missing.

    Returns
    -------
    list of pathlib.Path
        The files written.

    Raises
    ------
    OSError
        If the directory cannot be made or written.
    """
    contents = {
        "effects.json": _json(pricing),
        "effects.csv": rows_csv(pricing),
        "effects.png": png(pricing_figure(pricing)),
        "scene.toml": pricing.scene.to_toml().encode(),
    }
    return write_all(directory, contents)


def write_pricings(pricings: Iterable[Pricing | KeptPricing | Unpriced], directory: str | Path) -> list[Path]:
    """Write ``effects_<scene>.json`` and ``.png`` of each scene as it comes, and ``pricing.md`` over all so far.

    Parameters
    ----------
    pricings : iterable of Pricing, KeptPricing or Unpriced
        As from :func:`softcat_sym.study.bundled_pricing.price_bundled`.
    directory : str or pathlib.Path
        Where the files go; made if missing.

    Returns
    -------
    list of pathlib.Path
        The files written, each once.

    Raises
    ------
    OSError
        If the directory cannot be made or written.
    """
    done: list[Pricing | KeptPricing | Unpriced] = []
    written: dict[Path, None] = {}
    for one in pricings:
        done.append(one)
        contents = {"pricing.md": pricing_table(done).encode()}
        if not isinstance(one, KeptPricing | Unpriced):
            more = {"identity": pricing_identity(one.scene), "line": list(table_line(one))}
            contents[f"effects_{one.name}.json"] = _json(one, more)
            contents[f"effects_{one.name}.png"] = png(pricing_figure(one))
        written |= dict.fromkeys(write_all(directory, contents))
    return list(written)


def kept_pricings(directory: str | Path) -> dict[str, KeptPricing]:
    """Find the scenes that an earlier command has priced into this folder, by name.

    Parameters
    ----------
    directory : str or pathlib.Path
        Need not exist.

    Returns
    -------
    dict of str to KeptPricing
        What cannot be read is not among them, and is priced again.
    """
    kept = {}
    for path in sorted(Path(directory).glob("effects_*.json")):
        try:
            found = json.loads(path.read_text(encoding="utf-8"))
            one = KeptPricing(str(found["scene"]), str(found["identity"]), tuple(map(str, found["line"])))
        except (OSError, ValueError, KeyError, TypeError):
            continue
        if path.with_suffix(".png").is_file():
            kept[one.name] = one
    return kept


def _json(pricing: Pricing, more: Mapping[str, Any] | None = None) -> bytes:
    return (json.dumps({**document(pricing), **(more or {})}, indent=2, allow_nan=False) + "\n").encode()


def _share(value: float | None) -> str:
    if value is None:
        return "–"
    if 0 < value < _LEAST:
        return f"< {percent(_LEAST)}"
    return percent(value) if value < 10 else f"× {significant(value)}"


def _ratio(value: float | None) -> str:
    return "–" if value is None else f"{value:.2g}" if value < 100 else f"{value:.0f}"
