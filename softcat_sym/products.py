"""The checked-in products: C for the bundled scenes' structures, as few as show everything."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING

from softcat_sym.generating import export

if TYPE_CHECKING:
    from softcat_sym.codegen.description import Description

COMMAND = "softcat generate --bundled -o generated"
NAME = "filament"
ALWAYS = "arrested-overdamped"
"""The examples call it."""


@dataclass(frozen=True)
class Product:
    """A structure, under the name of the first scene that has it.

    Attributes
    ----------
    scene : str
        That scene.
    description : Description
        What C is told of it.
    """

    scene: str
    description: Description

    @property
    def features(self) -> frozenset[str]:
        """What it shows: law, section, ends, effects, what its supports and its body have."""
        described = self.description
        scene, structure = described.scene, described.structure
        supports, body = structure.body.supports, structure.body
        flags = {
            "profile": body.profile.nodes is not None,
            "point mass": body.weighted,
            "path": supports.rows > 0,
            "lowered": supports.lowered,
            "turned": supports.right_turned,
            "apart": supports.apart,
            "curved": "curvature" in described.model.parameters,
        }
        return frozenset(
            {
                f"law {scene.material.law}",
                f"section {scene.filament.section}",
                f"ends {structure.ends[0].name} {structure.ends[1].name}",
                *(f"effect {effect}" for effect in described.effects.names),
                *(flag for flag, there in flags.items() if there),
            }
        )


def bundled(told: Callable[[str], None] = lambda _: None) -> dict[str, Description]:
    """Each bundled scene, described for C.

    Parameters
    ----------
    told : callable, optional
        Given the name of each scene before its turn.

    Raises
    ------
    SceneError
        If one has no compiled form.
    """
    from softcat_sym.scene import bundled_names, load_scene

    described = {}
    for name in bundled_names():
        told(name)
        described[name] = export(load_scene(name)).description
    return described


def chosen(described: dict[str, Description]) -> list[Product]:
    """Structures that show every feature at least once: those first that show most for their size."""
    products: dict[str, Product] = {}
    for scene, description in described.items():
        products.setdefault(description.digest, Product(scene, description))
    waiting = {product.scene: product for product in products.values()}
    taken = [waiting.pop(ALWAYS)]
    missing = frozenset().union(*(product.features for product in waiting.values())) - taken[0].features
    while missing:
        best = max(waiting.values(), key=lambda one: len(one.features & missing) / len(one.description.model.text))
        taken.append(waiting.pop(best.scene))
        missing -= best.features
    return sorted(taken, key=lambda product: product.scene)


def product_files(product: Product) -> dict[str, str]:
    """The files of one structure by their paths."""
    from softcat_sym.codegen.export import model_files

    files = model_files(product.description, NAME, COMMAND)
    return {f"{product.scene}/{file}": text for file, text in files.items()}


def contents(described: dict[str, Description]) -> dict[str, str]:
    """Everything but the examples, which are written by hand, by path."""
    from softcat_sym.codegen.export import runtime_files

    folder = resources.files("softcat_sym.codegen") / "templates"
    products = chosen(described)
    files = {f"runtime/{file}": text for file, text in runtime_files().items()}
    files["runtime/main.c"] = (folder / "main.c").read_text(encoding="utf-8")
    for product in products:
        files |= product_files(product)
    files["README.md"] = _readme((folder / "products.md").read_text(encoding="utf-8"), described, products)
    return files


def write(directory: str | Path, told: Callable[[str], None] = lambda _: None) -> list[Path]:
    """Write the products, all or none; folders of structures that are no longer among them are left alone.

    Parameters
    ----------
    directory : str or pathlib.Path
        Made if missing.
    told : callable, optional
        Given the name of each scene before its turn.

    Raises
    ------
    OSError
        If the directory cannot be written.
    """
    from softcat_sym.files import write_all, written_together

    root, files = Path(directory), contents(bundled(told))
    written: list[Path] = []
    with written_together():
        for folder in sorted({Path(path).parent for path in files}):
            inside = {Path(path).name: text.encode() for path, text in files.items() if Path(path).parent == folder}
            written += write_all(root / folder, inside)
    return written


def _readme(text: str, described: dict[str, Description], products: list[Product]) -> str:
    folders = {product.description.digest: product.scene for product in products}
    rows = [
        f"| {name} | {one.scene.material.law} | {one.scene.filament.section} | {one.digest[:8]} "
        f"| {folders.get(one.digest, '')} |"
        for name, one in described.items()
    ]
    count = len({one.digest for one in described.values()})
    filled = {"@COMMAND@": COMMAND, "@COUNT@": str(count), "@SCENES@": str(len(described)), "@TABLE@": "\n".join(rows)}
    for mark, value in filled.items():
        text = text.replace(mark, value)
    return text
