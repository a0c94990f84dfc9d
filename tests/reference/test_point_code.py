"""The C of a material point: clean under every warning, the same text every time, its parameters as announced."""

from __future__ import annotations

import ctypes
import math
import subprocess
import sys

import numpy as np
import pytest
import sympy as sp

from softcat_sym.codegen.library import OPTIMISED, compile_library, load
from softcat_sym.errors import PrintingError, SoftcatError
from softcat_sym.physics.symbols import sigma
from softcat_sym.reference.material_point import LAWS, MaterialPoint, PointLaw, point_code

from .paths import BINGHAM

STRICT = ("-Wall", "-Wextra", "-pedantic", "-Werror", "-Wshadow", "-Wconversion", "-Wstrict-prototypes")
# An element loop in small: the point in its own translation unit.
LOOP = """
#define SOFTCAT_POINT_API static
#include "point.c"
double pulled(double stretch, const double *material);
double pulled(double stretch, const double *material) {
    double F[4] = {1.0, 0.0, 0.0, 1.0}, state[SOFTCAT_POINT_STATE] = {1.0, 0.0, 1.0};
    double P[4], record[SOFTCAT_POINT_RECORD];
    F[0] = stretch;
    if (softcat_point(F, state, 0.0, material, P, record) != SOFTCAT_POINT_DONE) return -1.0;
    return P[0];
}
"""


@pytest.mark.parametrize("law", LAWS)
def test_it_compiles_clean_under_every_warning(law: str) -> None:
    source = point_code(law).source
    compile_library(source, flags=(*OPTIMISED, *STRICT))
    compile_library({**source, "loop.c": LOOP}, flags=(*OPTIMISED, *STRICT), units=["loop.c"])


def test_the_point_works_inside_another_translation_unit() -> None:
    library = load(compile_library({**point_code("elastic").source, "loop.c": LOOP}, units=["loop.c"]))
    library.pulled.restype, library.pulled.argtypes = ctypes.c_double, [ctypes.c_double, ctypes.c_void_p]
    material = np.array([2.0, 0.3])
    wanted = 2.0 / (1 - 0.3**2) * math.log(1.2) / 1.2
    assert library.pulled(1.2, material.ctypes.data) == pytest.approx(wanted, rel=1e-14)
    assert library.pulled(-1.2, material.ctypes.data) == -1


def test_the_parameters_are_named_as_a_scene_names_them() -> None:
    assert {law: point_code(law).parameters for law in LAWS} == {
        "elastic": ("youngs_modulus", "poisson"),
        "maxwell": ("youngs_modulus", "poisson", "viscosity"),
        "bingham": ("youngs_modulus", "poisson", "viscosity", "yield_stress"),
    }


def test_the_text_does_not_depend_on_the_hash_seed() -> None:
    code = "from softcat_sym.reference.material_point import point_code as p; print(p('bingham').source['point_law.h'])"
    # the seed of this process is another, unless someone fixed it at 1
    done = subprocess.run(
        [sys.executable, "-c", code], env={"PYTHONHASHSEED": "1"}, capture_output=True, text=True, check=True
    )
    assert done.stdout == point_code("bingham").source["point_law.h"] + "\n"


def test_what_a_point_does_not_take_is_refused() -> None:
    with pytest.raises(SoftcatError, match=r"no flow rule 'binghan'.*elastic, maxwell, bingham"):
        point_code("binghan")
    with pytest.raises(
        SoftcatError, match="takes youngs_modulus, poisson, viscosity, yield_stress; got youngs_modulus"
    ):
        MaterialPoint("bingham", {"youngs_modulus": 1.0})
    with pytest.raises(PrintingError, match="no input for"):
        point_code(PointLaw(sigma / sp.Symbol("forgotten"), {}))
    point = MaterialPoint("bingham", BINGHAM)
    for duration in (-1.0, math.nan, math.inf):
        with pytest.raises(SoftcatError, match="a finite time >= 0"):
            point.step(np.eye(2), duration)
    with pytest.raises(SoftcatError, match="2 x 2"):
        point.step(np.eye(3), 0.1)
