"""WebAssembly computes what C compiled for this machine does, whatever the parameters."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.generation import export
from tests.common.table import show
from tests.common.web_module import How, NativePage, WasmPage, as_the_scene, need_wasmtime

# Time [s] and number of equal steps, within any tolerance.
CASES = {"ink-bridge": (0.1, 400), "continual-descent": (0.5, 400), "hot-glue-string": (0.1, 400)}
VARIED = ("rest_length", "thickness", "viscosity", "yield_stress", "surface_tension", "youngs_modulus")
SETS = 10
NEAR = 1e-10
# Over the accuracy, which the time error of a run is to be a tenth of. Where ink comes to rest, roundings of its grid
# decide between half and twice as many steps, native or not: two runs differ by the sum of their time errors.
FREE, TIGHTER, TIGHT = 0.3, 0.01, 0.01


def varied(page: WasmPage, number: int) -> list[float]:
    """Parameters of the scene, the first set as it is; the span goes with the rest length."""
    random, found = np.random.default_rng(number), {one.name: one.value for one in page.described.parameters}
    for name in VARIED:
        factor = float(random.uniform(0.8, 1.25)) if number else 1.0
        for one in (name, *(["span"] if name == "rest_length" else [])):
            if one in found:
                found[one] *= factor
    found["time_scale"] = 0.0 if number % 2 else found["time_scale"]
    return list(found.values())


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_it_is_the_native_run(name: str) -> None:
    need_wasmtime()
    described = export(sc.load_scene(name))[0]
    wasm, native, rows = WasmPage(described), NativePage(described), []
    duration, count = CASES[name]
    loose = [1e-3] * len(described.model.slots)
    equal = as_the_scene(
        described, duration=duration, frames=21, relative=0.5, absolute=loose, largest_step=duration / count
    )
    usual = as_the_scene(described)
    tight = as_the_scene(
        described, relative=TIGHTER * usual.relative, absolute=[TIGHTER * one for one in usual.absolute]
    )

    def compared(number: int, how: How) -> tuple[float, float, list[int]]:
        one, other = (page.solve(varied(wasm, number), how) for page in (wasm, native))
        assert one.code == other.code == 0, (one.words, other.words)
        far = float(np.abs(other.midpoint).max())
        midpoint = float(np.abs(one.midpoint - other.midpoint).max()) / far
        rest = max(
            float(np.abs(one.fields[key] - other.fields[key]).max() / np.abs(other.fields[key]).max())
            for key in ("x", "y", "stretch")
        )
        return midpoint, rest, [one.steps, other.steps]

    for number in range(SETS):
        midpoint, rest, steps = compared(number, equal)
        assert count <= steps[0] == steps[1] <= count + 1, "steps that are not equal, but for a last one by rounding"
        free, _, steps = compared(number, usual)
        held = compared(number, tight)[0]
        shares = [one / described.scene.run.accuracy for one in (free, held)]
        rows.append([number, f"{midpoint:.1e}", f"{rest:.1e}", *(f"{one:.1e}" for one in shares), *steps])
        assert midpoint < NEAR and rest < NEAR
        assert shares[0] < FREE and shares[1] < TIGHT
    header = ("set", "equal steps", "its fields", "free, over accuracy", "tightly", "steps", "native")
    show(f"{name}: WebAssembly and native", header, rows)
