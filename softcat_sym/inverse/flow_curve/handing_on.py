"""A fitted material handed on to a scene."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from softcat_sym.errors import SceneError

if TYPE_CHECKING:
    from softcat_sym.inverse.flow_curve.curve_fit import FlowCurveFit
    from softcat_sym.scene import Scene

REPLACED = (
    "viscosity",
    "yield_stress",
    "index",
    "second_modulus",
    "modes",
    "flow",
    "parameters",
    "shear_viscosity",
    "shear_yield_stress",
    "shear_consistency",
)
"""Constants of a scene's own law that go with it; the elastic ones stay, a flow curve says nothing about them."""


def fitted_scene(fit: FlowCurveFit, scene: str | Scene, law: str | None = None, overrides: Sequence[str] = ()) -> Scene:
    """Give a scene the material of a fit.

    Parameters
    ----------
    fit : FlowCurveFit
        As from :func:`softcat_sym.inverse.fit_flow_curve`.
    scene : str or Scene
        Name of a bundled scene, path of a TOML file, or a scene. Its law and flow constants are replaced; Young's
        modulus and Poisson's ratio stay.
    law : str or None
        The law to hand on, by default the best.
    overrides : sequence of str
        ``"material.youngs_modulus=40 kPa"``; these win over the fit.

    Returns
    -------
    Scene
        With the shear data stated among its material's notes.

    Raises
    ------
    SoftcatError
        If the law was not fitted or cannot be handed on; as SceneError, if the scene makes no sense with it.
    """
    from softcat_sym.scene import Scene, load_scene
    from softcat_sym.scene.overriding import read_overrides

    own, faults = read_overrides(overrides)
    if faults:
        raise SceneError(faults)
    # The material's come after the fit: they may make no sense with the scene's own law.
    later = {change.path: change.value for change in own if change.path.startswith("material.")}
    earlier = {change.path: change.value for change in own if change.path not in later}
    base = scene.replace(earlier) if isinstance(scene, Scene) else load_scene(scene, earlier)
    changes: dict[str, object] = {f"material.{name}": None for name in REPLACED}
    changes |= fit.overrides(law)
    for path, value in later.items():
        # Taken out and put back, so that it comes last and rules out the same constant given the other way.
        changes.pop(path, None)
        changes[path] = value
    return base.replace(changes)
