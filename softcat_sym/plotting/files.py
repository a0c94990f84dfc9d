"""Pages of results."""

from __future__ import annotations

from typing import Any


def page(template: str, **values: Any) -> bytes:
    """A page of the package's templates, in which no text is read as HTML unless it is marked as such."""
    import jinja2  # not needed by a run

    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("softcat_sym.plotting"), autoescape=True, trim_blocks=True, lstrip_blocks=True,
        undefined=jinja2.StrictUndefined,
    )  # fmt: skip
    return environment.get_template(template).render(**values).encode()
