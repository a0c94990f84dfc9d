"""A custom law put together: its formula, its parameters and its modulus must make sense with each other."""

from __future__ import annotations

from pydantic_core import PydanticCustomError

from softcat_sym.scene.constituents import Parameter
from softcat_sym.scene.flow_rule import check_rule
from softcat_sym.scene.formula import Formula
from softcat_sym.scene.formula_units import check_units
from softcat_sym.scene.kinds import refusal, refusals
from softcat_sym.scene.units import STRESS, same_dimension


def stress_scales(parameters: tuple[Parameter, ...], youngs_modulus: float | None) -> tuple[float, ...]:
    """Return the stresses that the parameters of a flow rule set, and the modulus; positive [Pa]."""
    sizes = [abs(parameter.value) for parameter in parameters if same_dimension(parameter.dimension, STRESS)]
    return tuple(size for size in (*sizes, youngs_modulus) if size)


def check_own_law(formula: Formula, parameters: tuple[Parameter, ...], youngs_modulus: float | None) -> None:
    """Refuse unknown symbols, unused parameters, units that do not fit, and rules that no material has.

    Parameters
    ----------
    formula : Formula
        phi(sigma).
    parameters : tuple of Parameter
        Its constants.
    youngs_modulus : float or None
        E [Pa].

    Raises
    ------
    ValidationError
        With every fault at its key.
    """
    known = {parameter.name: parameter for parameter in parameters}
    faults: list[tuple[tuple[str, ...], PydanticCustomError]] = [
        (("flow",), refusal(f"unknown symbol '{name}'", f"sigma, pi, and the parameters: {', '.join(known) or 'none'}"))
        for name in sorted(formula.names - set(known))
    ]
    faults += [
        (("parameters", name), refusal("not used by material.flow", "leaving it out"))
        for name in known
        if name not in formula.names
    ]
    if not formula.names - set(known):
        values = {name: parameter.value for name, parameter in known.items()}
        try:
            check_units(formula, {name: parameter.dimension for name, parameter in known.items()}, values)
            check_rule(formula, values, stress_scales(parameters, youngs_modulus))
        except PydanticCustomError as error:
            faults.append((("flow",), error))
    if faults:
        raise refusals("material", faults)
