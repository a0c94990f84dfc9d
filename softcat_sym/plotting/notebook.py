"""How results show themselves in a notebook: one of their pictures, and lines of text above it."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Callable, Mapping
from html import escape

from matplotlib.figure import Figure

from softcat_sym.errors import SoftcatError
from softcat_sym.plotting.style import png


def drawn(figures: Mapping[str, Callable[..., Figure | None]], what: str, *of: object) -> Figure:
    """One of the pictures that there are of a result."""
    if what not in figures:
        raise SoftcatError(f"no picture {what!r}: there are {', '.join(figures)}")
    figure = figures[what](*of)
    if figure is None:
        raise SoftcatError(f"no picture {what!r} of this result: nothing in it varies, or nothing has an answer")
    return figure


def html(text: str, figure: Figure) -> str:
    """Lines of text and a picture as HTML that needs no other file."""
    picture = b64encode(png(figure)).decode()
    return f'<pre>{escape(text)}</pre><img style="max-width:100%" alt="" src="data:image/png;base64,{picture}">'
