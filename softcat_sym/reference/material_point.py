"""One material point of the three-dimensional law: its C, and its step under a prescribed deformation."""

from __future__ import annotations

import ctypes
import functools
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from importlib.resources import files
from types import MappingProxyType
from typing import Any

import casadi as ca
import numpy as np
import numpy.typing as npt

from softcat_sym.codegen.library import compile_library, load
from softcat_sym.discretization.casadi_printer import CellFunction
from softcat_sym.errors import SoftcatError
from softcat_sym.physics import bulk
from softcat_sym.physics import bulk as bulk_step
from softcat_sym.physics import symbols as sy
from softcat_sym.physics.constitutive_laws import bingham_rate, maxwell_rate

_HAND_WRITTEN = ("point.h", "point.c")


@dataclass(frozen=True, slots=True)
class PointCode:
    """C text of a material point."""

    # C text by file name. ``point.c`` includes the others; an element loop includes ``point.c``.
    source: Mapping[str, str]
    # What the array ``material`` holds, in order; the names are those of a scene's ``material``.
    parameters: tuple[str, ...]


LAWS: Mapping[str, tuple[Any, Mapping[str, Any]]] = MappingProxyType(
    {
        "elastic": (bulk_step.no_flow(), {}),
        "maxwell": (maxwell_rate(), {"viscosity": sy.eta}),
        "bingham": (bingham_rate(), {"viscosity": sy.eta, "yield_stress": sy.sigma_Y}),
    }
)
"""Flow rule phi(sigma), and the symbols that occur in it besides by the names that a scene gives them."""


@functools.lru_cache(maxsize=8)
def point_code(law: str) -> PointCode:
    """C of the implicit step (3.8) in plane stress."""
    if law not in LAWS:
        raise SoftcatError(f"no flow rule {law!r} for a material point; there are {', '.join(LAWS)}")
    rate, own = LAWS[law]
    constants = {"youngs_modulus": sy.E, "poisson": bulk.nu, **own}
    hand_written = {name: (files(__package__) / "c" / name).read_text(encoding="utf-8") for name in _HAND_WRITTEN}
    generator = ca.CodeGenerator("point_law", {"with_header": False, "casadi_int": "int"})
    for function in _functions(rate, tuple(constants.values())):
        generator.add(function)
    # CasADi asks `a ? b : c` of a double a, which clang's -Wfloat-conversion refuses.
    text = re.sub(r"\((a\d+)\?", r"((\1!=0)?", str(generator.dump()))
    source = {**hand_written, "point_law.h": text}
    return PointCode(MappingProxyType(source), tuple(constants))


Symbols = tuple[Any, ...]
Stage = Mapping[Any, Any]


def _functions(rate: Any, constants: Symbols) -> list[ca.Function]:
    """The links that point.c calls: what each takes and gives stands here and there, in the same order."""
    sigma, rate_now = bulk.sigma_eq, rate.subs(sy.sigma, bulk.sigma_eq)
    trial, relaxed = bulk_step.trial_strains(), bulk_step.relaxed_strains(rate)
    stiffness = tuple(bulk_step.stiffness())
    under_way = ((sigma,), tuple(trial), (bulk.step,), stiffness, constants)
    geometry = (tuple(bulk_step.deformation), (bulk_step.inverse_jacobian,), tuple(bulk_step.axes()), tuple(relaxed))
    new = bulk_step.new_state()
    return [
        _trial(constants),
        _function("softcat_rate", ((sigma,), constants), ((rate_now,),)),
        _with_slope(_function("softcat_residual", under_way, ((bulk_step.residual(rate),),))),
        _function(
            "softcat_relaxed", under_way, (tuple(relaxed.values()), (rate_now,), (bulk_step.plastic_work(rate),))
        ),
        _function("softcat_state", geometry, ((new[0, 0], new[0, 1], new[1, 1]),)),
        _function(
            "softcat_stress",
            (*geometry, stiffness, bulk_step.state, constants),
            (
                tuple(bulk_step.first_piola_stress()),
                (bulk_step.plane_stress_elastic_energy(),),
                (bulk_step.width_stretch(),),
            ),
        ),
    ]


def _trial(constants: Symbols) -> ca.Function:
    """Geometry, stiffness, strains and equivalent stress of a step in which nothing flows."""
    axes, trial, stiffness = bulk_step.axes(), bulk_step.trial_strains(), bulk_step.stiffness()
    strains = (bulk_step.strain_sum, bulk_step.strain_gap)
    stages = (
        {bulk_step.jacobian: bulk_step.deformation.det()},
        bulk_step.trial_determinants(),
        axes,
        stiffness,
        trial,
        dict(zip(strains, trial, strict=True)),
        {bulk.sigma_eq: bulk_step.plane_stress_equivalent_stress()},
    )
    outputs = (
        (bulk_step.jacobian,),
        (bulk_step.inverse_jacobian,),
        tuple(axes),
        tuple(stiffness),
        tuple(trial),
        (bulk.sigma_eq,),
    )
    return _function("softcat_trial", (tuple(bulk_step.deformation), bulk_step.state, constants), outputs, stages)


def _function(
    name: str, inputs: Sequence[Symbols], outputs: Sequence[Symbols], stages: Iterable[Stage] = ()
) -> ca.Function:
    """CasADi function of vectors of symbols; each stage computes symbols that the later ones and the outputs hold."""
    vectors = [ca.SX.sym(f"i{n}", len(symbols)) for n, symbols in enumerate(inputs)]
    values = {
        symbol: vector[i] for symbols, vector in zip(inputs, vectors, strict=True) for i, symbol in enumerate(symbols)
    }
    for stage in stages:
        named = {str(symbol): expression for symbol, expression in stage.items()}
        found = CellFunction(named, tuple(values))(values)
        values |= {symbol: ca.SX(found[str(symbol)]) for symbol in stage}
    places = [(n, i) for n, group in enumerate(outputs) for i in range(len(group))]
    found = CellFunction({f"{n} {i}": outputs[n][i] for n, i in places}, tuple(values))(values)
    # A structural zero would be left out of the vector: an elastic point has a rate, and it is zero.
    columns = [
        ca.densify(ca.vertcat(*(ca.SX(found[f"{n} {i}"]) for i in range(len(group)))))
        for n, group in enumerate(outputs)
    ]
    return ca.Function(name, vectors, columns)


def _with_slope(function: ca.Function) -> ca.Function:
    """The function and its derivative by its first argument."""
    arguments = function.sx_in()
    value = function(*arguments)
    return ca.Function(function.name(), arguments, [value, ca.densify(ca.jacobian(value, arguments[0]))])


Floats = npt.NDArray[np.float64]

_FAULTS = {
    1: "the deformation gradient has no positive determinant, or it is not finite",
    2: "the scalar equation of the step was not solved: take a shorter step",
}


class MaterialPoint:
    """A point of the law (3.1)-(3.8) in plane stress, from rest."""

    def __init__(self, law: str, parameters: Mapping[str, float]) -> None:
        code = point_code(law)
        if set(parameters) != set(code.parameters):
            raise SoftcatError(f"a point of this law takes {', '.join(code.parameters)}; got {', '.join(parameters)}")
        library = load(compile_library(code.source), "softcat_point")
        self._advance = library.softcat_point
        doubles = np.ctypeslib.ndpointer(dtype=np.float64, flags="C_CONTIGUOUS")
        self._advance.argtypes = [doubles, doubles, ctypes.c_double, doubles, doubles, doubles]
        self._advance.restype = ctypes.c_int
        self._material = np.array([parameters[name] for name in code.parameters], dtype=float)
        self._record = np.array([0.0, 0.0, 0.0, 1.0])
        self.deformation: Floats = np.eye(2)
        self.state: Floats = np.array([1.0, 0.0, 1.0])
        self.stress: Floats = np.zeros((2, 2))
        self.work = 0.0

    @property
    def energy(self) -> float:
        """Stored elastic energy per reference volume."""
        return float(self._record[0])

    @property
    def rate(self) -> float:
        """Equivalent (tensile) plastic rate."""
        return float(self._record[2])

    @property
    def width_stretch(self) -> float:
        """F_33."""
        return float(self._record[3])

    @property
    def kirchhoff(self) -> Floats:
        """Kirchhoff stress tau = P F^T in the plane, shape (2, 2)."""
        return np.asarray(self.stress @ self.deformation.T)

    @property
    def cauchy(self) -> Floats:
        """Cauchy stress tau/J in the plane, shape (2, 2)."""
        return self.kirchhoff / (float(np.linalg.det(self.deformation)) * self.width_stretch)

    def step(self, deformation: npt.ArrayLike, duration: float) -> None:
        """Advance to a deformation gradient."""
        target = np.ascontiguousarray(deformation, dtype=float)
        if target.shape != (2, 2):
            raise SoftcatError(f"a deformation gradient in the plane is 2 x 2, not of shape {target.shape}")
        if not 0 <= duration < np.inf:
            raise SoftcatError(f"a step takes a finite time >= 0, not {duration}")
        state, stress, record = self.state.copy(), np.empty((2, 2)), np.empty(4)
        fault = int(self._advance(target, state, duration, self._material, stress, record))
        if fault:
            raise SoftcatError(f"material point at F = {target.tolist()}: {_FAULTS[fault]}")
        self.deformation, self.state, self.stress = target.copy(), state, stress
        self._record = record
        self.work += float(record[1])
