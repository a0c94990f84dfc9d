"""Results as people see them: a result asks here for its pictures and its report, which plotting registers."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import singledispatch
from html import escape
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from softcat_sym.errors import SoftcatError
from softcat_sym.files import figure_bytes, write_results

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from rich.console import Console, RenderableType


@dataclass(frozen=True)
class Report:
    """A result as people read it: on a terminal, and as files.

    Attributes
    ----------
    files : mapping of str to object
        Contents by file name: figures, tables, documents, texts or bytes, or functions that make them when the report
        is written. None stands for a file that this result does not have.
    texts : sequence of renderables
        Texts and tables for a terminal, in their order; a plain string is printed as it is, without line breaks.
    title : str
        Heading above them.
    stale : sequence of str
        Patterns of files that an earlier result may have left, to be removed where this one does not replace them.
    pictures : mapping of str to Figure
        Figures, by name, of those pictures that are among the files as bytes, since a page holds them too.
    """

    files: Mapping[str, object]
    texts: Sequence[RenderableType] = ()
    title: str = ""
    stale: Sequence[str] = ()
    pictures: Mapping[str, Figure] = field(default_factory=dict)

    def write(self, directory: str | Path) -> list[Path]:
        """Write all files into a folder, which is made if missing; each file is replaced whole."""
        written = write_results(directory, self.files)
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
            screen.print(text, markup=False, highlight=False, soft_wrap=isinstance(text, str))

    def figures(self) -> dict[str, Figure]:
        """Draw the pictures among the files, by name without ending."""
        made = {
            name.removesuffix(".png"): content() if callable(content) else content
            for name, content in self.files.items()
            if name.endswith(".png")
        }
        found = {name: cast("Figure", figure) for name, figure in made.items() if hasattr(figure, "savefig")}
        return {**found, **self.pictures}


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
    picture = b64encode(figure_bytes(figure)).decode()
    return f'{html(text)}<img style="max-width:100%" alt="" src="data:image/png;base64,{picture}">'


def _loaded(drawers: Any, result: object) -> Any:
    """What draws or reports a result, once the module that registers it has been loaded, and Matplotlib with it."""
    kind, drawn_in = type(result), import_module("softcat_sym.plotting").DRAWN_IN
    for name in {one.__name__ for one in kind.__mro__} & drawn_in.keys():
        import_module(f"softcat_sym.plotting.{drawn_in[name]}")
    if drawers.dispatch(kind) is drawers.dispatch(object):
        raise SoftcatError(f"no {drawers.__name__} of a {kind.__name__}: there are some of {', '.join(drawn_in)}")
    return drawers.dispatch(kind)
