"""The live page of a scene as one file: it needs no server, no network and no other file."""

from __future__ import annotations

import base64
import gzip
import hashlib
import json
import re
from collections.abc import Callable, Mapping, Sequence
from html import escape
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from softcat_sym.errors import SoftcatError
from softcat_sym.files import write_results
from softcat_sym.scene.reading import as_scene
from softcat_sym.web.description import describe_page
from softcat_sym.web.module import wasm_compiler, wasm_module

if TYPE_CHECKING:
    from softcat_sym.scene.reading import Changes, SceneLike

LARGEST: Final = 400_000
"""Bytes of a page."""

_ROOMS: Final = {"MODULE": "the compiled solver", "DATA": "what is known of the scenes"}
"""Parts that a scene makes large."""


STEPS: Final = 3
"""Of :func:`live_page`."""


def live_page(
    scene: SceneLike,
    directory: str | Path,
    sliders: Sequence[str] = (),
    name: str = "filament",
    on_progress: Callable[[str], None] = lambda _: None,
    *,
    changes: Changes = (),
) -> Path:
    """Write a scene as a page with sliders, which solves it in any browser: no server, no network, no other file.

    Parameters
    ----------
    scene : Scene, str, path or dict
        The scene. It is run once, for its effects and its resolution, which the page keeps.
    directory : str or pathlib.Path
        Folder for the page, made if missing.
    sliders : sequence of str
        Further keys to move, or other ranges, as ``KEY=low:high[:log]``; span, diameter, density, duration, and what
        the law and the surface have, are there already.
    name : str
        Name of the file, without ``.html``, and of the scene in the page's links.
    on_progress : callable
        Told which of the `STEPS` begins.
    changes : mapping or sequence of str, optional
        Values that replace the scene's, as :func:`load_scene` takes them: ``{"filament.span": "6 mm"}``.

    Returns
    -------
    pathlib.Path
        The page.

    Raises
    ------
    SceneError
        If the scene has no compiled form, or a key cannot be a slider.
    SoftcatError
        If there is no compiler for WebAssembly (``pip install "softcat_sym[web]"``), the page would be too large, or
        the name is none of a file.
    OSError
        If the directory cannot be written. Nothing is written of a scene that is refused.
    """
    if not name or name.startswith((".", "-")) or Path(name).name != name:
        accepted = "take that of a file, without folders and without .html, that begins with neither a dot nor a dash"
        raise SoftcatError(f"name {name!r}: {accepted}")
    text = page_text(as_scene(scene, changes), sliders, name, on_progress)
    on_progress("writing")
    return write_results(directory, {f"{name}.html": text})[0]


def page_text(
    scene: SceneLike, sliders: Sequence[str] = (), name: str = "", on_progress: Callable[[str], None] = lambda _: None
) -> str:
    """The page itself, with errors as :func:`live_page`."""
    # Before the scene is run: without a compiler it need not be.
    wasm_compiler()
    on_progress("running the scene")
    page = describe_page(scene, sliders, name)
    on_progress("compiling its solver for browsers")
    return page_of(page.data, wasm_module(page.described))


def page_of(data: Mapping[str, Any], module: bytes, model: str | None = None) -> str:
    """Write the page of a scene, which solves it in the browser.

    Parameters
    ----------
    data : mapping
        What `softcat_sym.web.description` says of the scene.
    module : bytes
        Its solver, compiled to WebAssembly.
    model : str, optional
        Instead of the package's model.js.

    Raises
    ------
    SoftcatError
        If the page would be larger than `LARGEST`.
    """
    # In a function of its own, the page's names do not meet the model's.
    script = f"\n(() => {{\n{template('drawing.js', 'page.js')}}})();\n"
    parts = {
        "TITLE": escape(" ".join(str(data["title"] or "").split()) or str(data["name"])),
        "STYLE": template("page.css"),
        "DATA": inlined(data),
        # Without a time in it, the same page at every writing.
        "MODULE": base64.b64encode(gzip.compress(module, 9, mtime=0)).decode("ascii"),
        "WORKER": template("worker.js"),
        "MODEL": template("model.js") if model is None else model,
        "SCRIPT": script,
    }
    policy = {
        "default-src": "'none'",
        "script-src": f"{_hash(parts['MODEL'])} {_hash(script)} 'wasm-unsafe-eval'",
        "worker-src": "blob:",
        "style-src": _hash(parts["STYLE"]),
        "img-src": "data: blob:",
        "base-uri": "'none'",
        "form-action": "'none'",
    }
    parts["POLICY"] = "; ".join(f"{name} {given}" for name, given in policy.items())
    page = filled(template("page.html"), parts)
    if (size := len(page.encode())) > LARGEST:
        rooms = ", ".join(f"{words} {len(parts[name].encode()) // 1000} kB" for name, words in _ROOMS.items())
        raise SoftcatError(
            f"the page would take {size // 1000} kB, more than the {LARGEST // 1000} kB of a page ({rooms}): give it "
            "fewer scenes, or leave effects out by run.effects"
        )
    return page


def inlined(data: Mapping[str, Any]) -> str:
    """JSON for a script element: only "<" can end one, and JSON may write it otherwise."""
    return json.dumps(data, allow_nan=False, ensure_ascii=False, separators=(",", ":")).replace("<", "\\u003c")


def filled(text: str, parts: Mapping[str, str]) -> str:
    """Put the parts at their marks, such as @TITLE@, in one pass: a title that looks like a mark stays a title."""
    return re.sub(f"@({'|'.join(parts)})@", lambda mark: parts[mark[1]], text)


def template(*names: str) -> str:
    """Templates of pages, one after another."""
    folder = resources.files("softcat_sym.web") / "templates"
    return "".join((folder / name).read_text(encoding="utf-8") for name in names)


def _hash(text: str) -> str:
    """By which a policy knows an inlined script or style."""
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode('ascii')}'"
