"""Pictures of results: a result asks for its own here, and knows nothing of plotting, which says how each is drawn."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Callable, Mapping
from functools import singledispatch
from html import escape
from importlib import import_module
from typing import TYPE_CHECKING, Any, cast

from softcat_sym.errors import SoftcatError

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@singledispatch
def plot(result: object, *what: Any, **how: Any) -> Figure:
    """Draw one picture of a result."""
    return cast("Figure", _loaded(plot, result)(result, *what, **how))


@singledispatch
def figures(result: object) -> dict[str, Figure]:
    """Draw all pictures of a result, by name."""
    return cast("dict[str, Figure]", _loaded(figures, result)(result))


def drawn(figures: Mapping[str, Callable[..., Figure | None]], what: str, *of: object) -> Figure:
    """One of the pictures that there are of a result."""
    if what not in figures:
        raise SoftcatError(f"no picture {what!r}: there are {', '.join(figures)}")
    figure = figures[what](*of)
    if figure is None:
        raise SoftcatError(f"no picture {what!r} of this result: nothing in it varies, or nothing has an answer")
    return figure


def png(figure: Figure) -> bytes:
    """Draw a figure as PNG."""
    return cast("bytes", import_module("softcat_sym.plotting.style").png(figure))


def html(text: str, figure: Figure) -> str:
    """Lines of text and a picture as HTML that needs no other file."""
    picture = b64encode(png(figure)).decode()
    return f'<pre>{escape(text)}</pre><img style="max-width:100%" alt="" src="data:image/png;base64,{picture}">'


def _loaded(drawers: Any, result: object) -> Any:
    """What draws a result, once the module that registers it has been loaded, and Matplotlib with it."""
    kind, drawn_in = type(result), import_module("softcat_sym.plotting").DRAWN_IN
    for name in {one.__name__ for one in kind.__mro__} & drawn_in.keys():
        import_module(f"softcat_sym.plotting.{drawn_in[name]}")
    if drawers.dispatch(kind) is drawers.dispatch(object):
        raise SoftcatError(f"no picture of a {kind.__name__}: there are some of {', '.join(drawn_in)}")
    return drawers.dispatch(kind)
