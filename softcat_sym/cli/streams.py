"""What a terminal that is not UTF-8 is sent instead of the letters it does not have."""

from __future__ import annotations

import codecs
import io
import sys
import unicodedata

# What has no plain letter for its base, or another one than its look suggests.
_PLAIN = str.maketrans(
    {
        **{"−": "-", "–": "-", "—": "-", "×": "x", "·": "*", "±": "+-", "÷": "/", "≈": "~", "≤": "<=", "≥": ">="},
        **{
            "≠": "!=",
            "→": "->",
            "←": "<-",
            "…": "...",
            "‘": "'",
            "’": "'",
            "“": '"',
            "”": '"',
            "°": " deg",
            "√": "sqrt",
        },
        **{"µ": "u", "μ": "u", "α": "alpha", "β": "beta", "γ": "gamma", "δ": "delta", "Δ": "Delta", "ε": "eps"},
        **{"ζ": "zeta", "η": "eta", "θ": "theta", "κ": "kappa", "λ": "lambda", "ν": "nu", "π": "pi", "ρ": "rho"},
        **{
            "σ": "sigma",
            "τ": "tau",
            "φ": "phi",
            "ω": "omega",
            "Ω": "Ohm",
            "∞": "inf",
            "█": "#",
            "━": "-",
            "ß": "ss",
            "│": "|",
            "⁄": "/",
        },
    }
)
_HANDLER = "softcat-plain"


def plain(text: str) -> str:
    """Write a text in ASCII: signs by what they mean, letters without their accents, and ``?`` for what is left."""
    parts = unicodedata.normalize("NFKD", text.translate(_PLAIN))
    bare = "".join(letter for letter in parts if not unicodedata.combining(letter))
    return bare.translate(_PLAIN).encode("ascii", "replace").decode()


def print_whatever_the_terminal_takes() -> None:
    """Let standard output and error write :func:`plain` text where their encoding lacks a letter, and never fail."""
    codecs.register_error(_HANDLER, _replaced)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors=_HANDLER)


def _replaced(error: UnicodeError) -> tuple[str | bytes, int]:
    """Replace what cannot be encoded; the bytes of a file's name that is no text are written as they are."""
    if not isinstance(error, UnicodeEncodeError):
        raise error
    letter = error.object[error.start]
    if "\udc80" <= letter <= "\udcff":
        return bytes([ord(letter) - 0xDC00]), error.start + 1
    return plain(letter), error.start + 1
