"""Results as people see them: a result asks here for its pictures and its report, which plotting registers."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Callable, Container, Mapping, Sequence
from dataclasses import dataclass, field
from functools import singledispatch
from html import escape
from importlib import import_module
from itertools import zip_longest
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, TypeAlias, cast

from softcat_sym.errors import SoftcatError
from softcat_sym.files import figure_bytes, write_results

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text


@dataclass(frozen=True)
class TextTable:
    """A table of texts for a terminal and a page; none of them is read as markup.

    Attributes
    ----------
    headings : sequence of str
        Of the columns; where all are empty there is no such line.
    rows : sequence of sequences of str
        The cells.
    right : container of int
        Columns whose texts stand at the right, such as numbers.
    kinds : sequence of str
        Style of each row, as `rich` names it: ``dim``, ``bold``, ``yellow``.
    title, caption : str
        Above and below the table.
    whole : container of int
        Columns that a narrow terminal does not break.
    """

    headings: Sequence[str]
    rows: Sequence[Sequence[str]]
    right: Container[int] = ()
    kinds: Sequence[str] = ()
    title: str = ""
    caption: str = ""
    whole: Container[int] = ()

    def for_terminal(self) -> Table:
        """The table as rich prints it."""
        from rich import box
        from rich.table import Table
        from rich.text import Text

        has_head = any(self.headings)
        looks: dict[str, Any] = {"title_justify": "left", "title_style": "bold", "caption_justify": "left"}
        looks |= {"box": box.SIMPLE_HEAD if has_head else None, "show_header": has_head, "padding": (0, 1, 0, 0)}
        table = Table(title=Text(self.title) if self.title else None, **looks)
        table.caption = Text(self.caption, style="dim") if self.caption else None
        for k, name in enumerate(self.headings):
            justify: Any = "right" if k in self.right else "left"
            table.add_column(Text(name), justify=justify, no_wrap=k in self.whole, overflow="fold")
        for row, kind in zip_longest(self.rows, self.kinds, fillvalue=""):
            table.add_row(*(Text(cell, style=kind) for cell in row))
        return table

    def for_page(self) -> str:
        """The table as HTML."""

        def line(tag: str, texts: Sequence[str], kind: str = "") -> str:
            cells = (
                f"<{tag}{' class=number' if k in self.right else ''}>{escape(text)}</{tag}>"
                for k, text in enumerate(texts)
            )
            return f'<tr class="{kind}">{"".join(cells)}</tr>\n'

        head = line("th", self.headings) if any(self.headings) else ""
        body = "".join(line("td", *pair) for pair in zip_longest(self.rows, self.kinds, fillvalue=""))
        title = f"<h2>{escape(self.title)}</h2>\n" if self.title else ""
        caption = f'<p class="dim">{escape(self.caption)}</p>\n' if self.caption else ""
        return f"{title}<table>\n{head}{body}</table>\n{caption}"


Shown: TypeAlias = "str | Text | TextTable"
"""What a report says: a plain string is printed as it is, without line breaks."""

_STYLE = """\
@page { size: A4; margin: 12mm; }
body { font: 14px/1.4 "DejaVu Sans", Verdana, sans-serif; color: #222222; max-width: 1080px; margin: 2em auto; }
h1 { font-size: 1.4em; border-bottom: 2px solid #0072B2; }
h2 { font-size: 1.05em; margin: 1.4em 0 0.3em; }
h2, p, th, td { white-space: pre-line; }
table { border-collapse: collapse; }
th, td { text-align: left; vertical-align: top; padding: 0.2em 1.2em 0.2em 0; border-bottom: 1px solid #e8e8e8; }
th { color: #6a6a6a; font-weight: normal; }
.number { text-align: right; white-space: nowrap; }
.dim, .dim td, figcaption { color: #6a6a6a; }
.bold, .bold td { font-weight: 600; }
.red, .red td { color: #b03a00; }
.yellow, .yellow td { color: #8a6100; }
.green, .green td { color: #00724f; }
p { margin: 0.4em 0; }
figure { display: inline-table; margin: 1em 1em 0 0; break-inside: avoid; }
figcaption { display: table-caption; caption-side: bottom; }
img { max-width: 100%; height: auto; }
pre { background: #f6f8fa; padding: 0.6em 0.8em; white-space: pre-wrap; }
@media print { body { font-size: 9px; margin: 0; } }
"""


@dataclass(frozen=True)
class Report:
    """A result as people read it: on a terminal, as files, and as a page.

    Attributes
    ----------
    files : mapping of str to object
        Contents by file name: figures, tables, documents, texts or bytes, or functions that make them when the report
        is written. None stands for a file that this result does not have.
    texts : sequence of str, Text or TextTable
        What it says, in the order of reading.
    title : str
        Heading above them.
    page : str
        Name of the file for the page that holds texts and pictures; none if empty.
    captions : mapping of str to str
        Pictures of the page, by their names without ending, and the words below each.
    command : str
        By which the same is had again, at the end of the page.
    stale : sequence of str
        Patterns of files that an earlier result may have left, to be removed where this one does not replace them.
    """

    files: Mapping[str, object]
    texts: Sequence[Shown] = ()
    title: str = ""
    page: str = ""
    captions: Mapping[str, str] = field(default_factory=dict)
    command: str = ""
    stale: Sequence[str] = ()

    def write(self, directory: str | Path) -> list[Path]:
        """Write all files into a folder, which is made if missing; each file is replaced whole."""
        contents = {name: content() if callable(content) else content for name, content in self.files.items()}
        if self.page:
            drawn = {name: contents.get(f"{name}.png") for name in self.captions}
            pictures = {name: _png(content) for name, content in drawn.items() if content is not None}
            contents |= {f"{name}.png": content for name, content in pictures.items()}
            contents[self.page] = self.html(pictures)
        written = write_results(directory, contents)
        for path in (path for pattern in self.stale for path in Path(directory).glob(pattern)):
            if path not in written:
                path.unlink()
        return written

    def print(self, console: Console | None = None) -> None:
        """Print title, tables and texts; none of them is read as markup."""
        from rich.console import Console
        from rich.text import Text

        screen = console or Console()
        for text in ([Text(self.title, style="bold")] if self.title else []) + [*self.texts]:
            shown = text.for_terminal() if isinstance(text, TextTable) else text
            screen.print(shown, markup=False, highlight=False, soft_wrap=isinstance(text, str))

    def figures(self) -> dict[str, Figure]:
        """Draw the pictures among the files, by name without ending."""
        made = {
            name.removesuffix(".png"): content() if callable(content) else content
            for name, content in self.files.items()
            if name.endswith(".png")
        }
        return {name: cast("Figure", figure) for name, figure in made.items() if hasattr(figure, "savefig")}

    def html(self, pictures: Mapping[str, bytes] = MappingProxyType({})) -> str:
        """A page that needs no other file: title, texts, and pictures by their names."""
        title, parts = escape(self.title or "softcat"), list[str]()
        for text in self.texts:
            if isinstance(text, TextTable):
                parts.append(text.for_page())
            else:
                kind = "" if isinstance(text, str) else str(text.style)
                parts.append(f'<p class="{kind}">{escape(str(text))}</p>\n')
        for name, picture in pictures.items():
            words = escape(self.captions.get(name, ""))
            parts.append(f'<figure id="{name}">{_img(picture, words)}<figcaption>{words}</figcaption></figure>\n')
        if self.command:
            parts.append(f"<pre>{escape(self.command)}</pre>\n")
        head = f'<meta charset="utf-8">\n<title>{title}</title>\n<style>\n{_STYLE}</style>'
        body = f"<h1>{title}</h1>\n{''.join(parts)}"
        return f'<!DOCTYPE html>\n<html lang="en">\n<head>\n{head}\n</head>\n<body>\n{body}</body>\n</html>\n'


def _png(content: Any) -> bytes:
    return content if isinstance(content, bytes) else figure_bytes(content)


def _img(picture: bytes, words: str = "") -> str:
    return f'<img alt="{words}" style="max-width:100%" src="data:image/png;base64,{b64encode(picture).decode()}">'


@singledispatch
def plot(result: object, *what: Any, **how: Any) -> Figure:
    """Draw one picture of a result."""
    return cast("Figure", _loaded(plot, result)(result, *what, **how))


@singledispatch
def report(result: object, **beside: Any) -> Report:
    """Report a result, with what belongs `beside` it."""
    return cast("Report", _loaded(report, result)(result, **beside))


class Drawable:
    """A result with pictures, files and a printed form, which plotting registers for its type."""

    def plot(self, *what: Any, **how: Any) -> Figure:
        """Draw one picture of the result."""
        return plot(self, *what, **how)

    def figures(self) -> dict[str, Figure]:
        """Draw all pictures of the result, by the names of their files."""
        return report(self).figures()

    def write(self, directory: str | Path, **beside: Any) -> list[Path]:
        """Write the files of the result into a folder."""
        return report(self, **beside).write(directory)

    def _repr_html_(self) -> str:
        return html(repr(self), self.plot())


def figure_by_name(figures: Mapping[str, Callable[..., Figure | None]], what: str, *of: object) -> Figure:
    """One of the pictures that there are of a result."""
    if what not in figures:
        raise SoftcatError(f"no picture {what!r}: there are {', '.join(figures)}")
    figure = figures[what](*of)
    if figure is None:
        raise SoftcatError(f"no picture {what!r} of this result: nothing in it varies, or nothing has an answer")
    return figure


def html(text: str, figure: Figure | None = None) -> str:
    """Lines of text, and a picture if there is one, as HTML that needs no other file."""
    if figure is None:
        return f"<pre>{escape(text)}</pre>"
    return html(text) + _img(figure_bytes(figure))


def _loaded(drawers: Any, result: object) -> Any:
    """What draws or reports a result, once the module that registers it has been loaded, and Matplotlib with it."""
    kind, drawn_in = type(result), import_module("softcat_sym.plotting").DRAWN_IN
    for name in {one.__name__ for one in kind.__mro__} & drawn_in.keys():
        import_module(f"softcat_sym.plotting.{drawn_in[name]}")
    if drawers.dispatch(kind) is drawers.dispatch(object):
        raise SoftcatError(f"no {drawers.__name__} of a {kind.__name__}: there are some of {', '.join(drawn_in)}")
    return drawers.dispatch(kind)
