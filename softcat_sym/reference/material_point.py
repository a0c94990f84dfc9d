"""One material point of the three-dimensional law: its C."""

from __future__ import annotations

import functools
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from importlib.resources import files
from types import MappingProxyType
from typing import Any

import casadi as ca

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
