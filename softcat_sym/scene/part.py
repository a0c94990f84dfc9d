"""What the parts of a scene share: frozen, no unknown keys, equality by physics."""

from __future__ import annotations

from typing import Any, ClassVar

from pydantic import BaseModel, ConfigDict

from softcat_sym.scene.kinds import Kind


class Part(BaseModel):
    """One table of the scene file, every value plain SI.

    Two parts are equal when their physics is: how a value was given (in shear or in tension) does not count.
    """

    model_config = ConfigDict(frozen=True, extra="forbid", use_attribute_docstrings=True)
    table_name: ClassVar[str] = ""

    def kinds(self) -> dict[str, Kind]:
        """Return how each value is written, by field name."""
        return kinds_of(type(self))

    def physics(self) -> dict[str, Any]:
        """Values that make a difference to the answer, by field name; SI."""
        return {name: getattr(self, name) for name, info in type(self).model_fields.items() if not info.exclude}

    @property
    def notes(self) -> tuple[str, ...]:
        """What was converted from other names or data, in words and numbers."""
        return ()

    def given(self) -> dict[str, object]:
        """Return the raw table as it was asked for: only what was set, so that what follows from it still follows."""
        return {
            name: kind.write(getattr(self, name))
            for name, kind in self.kinds().items()
            if name in self.model_fields_set and getattr(self, name) is not None
        }

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and isinstance(other, Part) and self.physics() == other.physics()

    def __hash__(self) -> int:
        return hash((type(self), tuple(self.physics().values())))


def dotted(*names: str) -> str:
    """Join the names that are not empty by dots."""
    return ".".join(name for name in names if name)


def kinds_of(part: type[BaseModel]) -> dict[str, Kind]:
    """Return the kind of each field that holds a value (not a part)."""
    return {name: kind for name, info in part.model_fields.items() for kind in info.metadata if isinstance(kind, Kind)}
