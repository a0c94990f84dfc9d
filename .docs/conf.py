"""Sphinx reads the documentation from where it is already: README, docstrings, help of the commands, notebooks.

Build with ``python -m sphinx -W -b html .docs out/docs``. The pages here hold little more than titles; what they show
is put in while they are read, so that nothing stands written twice. MyST-NB runs the notebooks of tutorials and how-to
guides for what they print and draw, which takes a minute; ``-t without_outputs`` leaves that out. ``-t pages`` adds the
live pages of the bundled scenes, for which a compiler for WebAssembly is needed and some minutes.
"""

from __future__ import annotations

import inspect
import os
import re
from html import escape
from importlib.metadata import version as version_of
from pathlib import Path
from typing import TYPE_CHECKING, Any

import jupytext
import typer.main
from nbformat.v4 import new_markdown_cell

import softcat_sym
from softcat_sym.scene.bundled import bundled_names, bundled_title

if TYPE_CHECKING:
    from sphinx.application import Sphinx

ROOT = Path(__file__).resolve().parents[1]

project = "softcat_sym"
author = "The softcat_sym authors"
release = version = version_of("softcat_sym")
extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx.ext.mathjax"]
html_theme = "furo"
html_title = f"softcat_sym {release}"
html_show_copyright = False
html_copy_source = False
templates_path: list[str] = []
exclude_patterns = ["_build"]

myst_enable_extensions = ["dollarmath", "amsmath"]
myst_heading_anchors = 3

# Pictures are shown beneath their cell whatever the backend of who builds.
os.environ["MPLBACKEND"] = "module://matplotlib_inline.backend_inline"
nb_execution_mode = "off" if tags.has("without_outputs") else "force"  # noqa: F821 - Sphinx defines tags
nb_execution_in_temp = True
nb_execution_timeout = 600
nb_execution_raise_on_error = True

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
maximum_signature_line_length = 88
napoleon_google_docstring = False
napoleon_use_ivar = False
napoleon_use_param = True
# Every reference must lead somewhere, except to names of other packages, whose pages are not at hand here, and to
# modules of this package that are not public: their docstrings are for who reads the source.
nitpicky = True
nitpick_ignore_regex = [("py:.*", r"(?!softcat_sym\.[a-z_]+$).*")]

GROUPS = {
    "Scenes": ("load_scene", "bundled_names", "Scene"),
    "Runs": ("simulate", "Run", "Outcome", "explain", "Explanation", "card", "Card", "longest_span"),
    "Many runs": ("simulate_many", "Ensemble", "sweep", "Sweep", "bridges", "BridgeTable"),
    "What effects are worth": ("price_effects", "Pricing"),
    "From measurements": ("track", "Track", "fit", "Fit", "Measurements", "fit_flow_curve"),
    "C to take away": ("generate", "live_page"),
    "Refusals": ("SoftcatError", "SceneError"),
}

PAGES = {
    "generated/README.md": "generated.md",
    "derivations/ERRATA.md": "errata.md",
    "CHANGELOG.md": "changelog.md",
    "CONTRIBUTING.md": "contributing.md",
    **{
        f"derivations/{page.stem}.py": f"{folder}/{page.name}"
        for folder in ("tutorials", "howto")
        for page in (ROOT / ".docs" / folder).glob("*.md")
    },
}
"""Files of the repository that are pages here."""


def setup(app: Sphinx) -> None:
    """Put in what pages hold but for their titles."""
    app.connect("builder-inited", live_pages)
    app.connect("source-read", fill)
    app.connect("autodoc-process-signature", of_functions_only)


def live_pages(app: Sphinx) -> None:
    """Write the live pages of the bundled scenes beside the others."""
    if "pages" in app.tags:
        from softcat_sym.web.page import bundled_pages

        bundled_pages(Path(app.outdir) / "pages")


def list_of_pages(app: Sphinx) -> str:
    """The live pages that were written, by title."""
    folder = Path(app.outdir) / "pages"
    names = [name for name in bundled_names() if (folder / f"{name}.html").is_file()]
    if not names:
        return "`python -m sphinx -t pages -b html .docs out/docs` lists here the pages of all bundled scenes.\n"
    rows = [f'<li><a href="../pages/{name}.html">{escape(bundled_title(name))}</a></li>' for name in names]
    return "\n".join(["## Bundled scenes", "", "<ul>", *rows, "</ul>", ""])


def fill(app: Sphinx, name: str, source: list[str]) -> None:
    """Fill a page as it is read; it is read again when the file changes that it is filled from."""
    if name == "index":
        app.env.note_dependency(str(ROOT / "README.md"))
        source[0] = front_page() + source[0]
    elif name.startswith("manual/"):
        source[0] = manual_page(source[0]) + (list_of_pages(app) if name.endswith("/live-page") else "")
    elif name == "api":
        source[0] += api()
    elif name == "commands":
        for path in (ROOT / "softcat_sym" / "cli").glob("*.py"):
            app.env.note_dependency(str(path))
        source[0] += commands()
    elif name.startswith(("tutorials/", "howto/")):
        notebook = ROOT / "derivations" / f"{name.partition('/')[2]}.py"
        app.env.note_dependency(str(notebook))
        source[0] = notebook_page(notebook)


def of_functions_only(app: Sphinx, what: str, *_: object) -> tuple[str, None] | None:
    """Leave out the signatures of classes: their attributes say the same, with words."""
    del app
    return ("", None) if what == "class" else None


def front_page() -> str:
    """The README without its badges; its links lead to files of the repository."""
    text = re.sub(r"(?m)^\[!\[tests\].*\n", "", (ROOT / "README.md").read_text(encoding="utf-8"))
    text = text.replace("](.docs/", "](")
    for path, page in PAGES.items():
        text = text.replace(f"]({path})", f"]({page})")
    return re.sub(r"\]\((\.readme/[^)]+)\)", r"](../\1)", text) + "\n"


def manual_page(text: str) -> str:
    """A page of the manual, whose links lead to files of the repository."""
    for path, page in PAGES.items():
        text = text.replace(f"](../../{path})", f"](../{page})")
    return text


def api() -> str:
    """A section for each group of public names; names that no group has come last."""
    named = {name for names in GROUPS.values() for name in names}
    rest = tuple(name for name in softcat_sym.__all__ if name not in named)
    parts = []
    for title, names in {**GROUPS, **({"More": rest} if rest else {})}.items():
        parts.append(f"{title}\n{'-' * len(title)}\n")
        parts += [entry(name) for name in names if name in softcat_sym.__all__]
    return "\n" + "\n".join(parts)


def entry(name: str) -> str:
    """The directive for a public name."""
    thing = getattr(softcat_sym, name)
    if not inspect.isclass(thing):
        return f".. autofunction:: softcat_sym.{name}\n"
    if issubclass(thing, Exception):
        return f".. autoexception:: softcat_sym.{name}\n"
    members = [key for key, value in vars(thing).items() if is_told(key, value)]
    told = f"   :members: {', '.join(members)}\n" if members else ""
    return f".. autoclass:: softcat_sym.{name}\n{told}"


def is_told(key: str, value: object) -> bool:
    """Whether a member is a public method or property with a docstring, or a member of an enumeration."""
    method = inspect.isfunction(value) or isinstance(value, property | classmethod | staticmethod)
    return not key.startswith("_") and method and bool(inspect.getdoc(value))


def commands() -> str:
    """What ``softcat --help`` says, of every command."""
    from softcat_sym.cli.application import app

    group: Any = typer.main.get_command(app)
    parts = []
    with group.make_context("softcat", [], resilient_parsing=True) as above:
        for name in group.list_commands(above):
            command = group.get_command(above, name)
            # A width of its own: the terminal of who builds must not show.
            context = command.context_class(command, info_name=name, parent=above, max_content_width=88)
            context.terminal_width = 88
            parts.append(f"## softcat {name}\n\n```text\n{command.get_help(context).rstrip()}\n```\n")
    return "\n" + "\n".join(parts)


def notebook_page(path: Path) -> str:
    """A notebook as a page, which MyST-NB runs: in MyST's own format, without its number."""
    notebook = jupytext.read(path)
    notebook.cells[0].source = re.sub(r"^# \d+\. ", "# ", notebook.cells[0].source)
    told = f"The notebook is `derivations/{path.name}`: `jupytext --to ipynb` makes it one."
    notebook.cells.append(new_markdown_cell(told))
    return str(jupytext.writes(notebook, "md:myst"))
