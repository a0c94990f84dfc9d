"""The lists of a material: modes of a relaxation spectrum, and named parameters of a user's own flow rule."""

# `scene.kinds.Kind` documents the three methods once for all kinds.
# ruff: noqa: D102

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from keyword import iskeyword

from pydantic_core import PydanticCustomError

from softcat_sym.scene.formula import CONSTANTS, FUNCTIONS, STRESS_NAME
from softcat_sym.scene.kinds import AsValidator, Quantity, refusal, refusals
from softcat_sym.scene.units import Dimension, NotAQuantity, shown, si_unit, to_si_of_any

# Names that already mean something where the parameters of a rule become numbers of the computation.
RESERVED = frozenset(
    {
        "span",
        "thickness",
        "density",
        "gravity",
        "ramp",
        "shake",
        "shake_frequency",
        "youngs_modulus",
        "viscosity",
        "yield_stress",
        "index",
        "poisson",
        "aspect",
        "time_scale",
        "second_modulus",
        "rest_length",
        STRESS_NAME,
        *CONSTANTS,
        *FUNCTIONS,
    }
)

_MODE = {"youngs_modulus": Quantity("stress", "1 MPa"), "viscosity": Quantity("viscosity", "2 kPa*s")}
_MOST = 50


@dataclass(frozen=True, slots=True)
class Mode:
    """A spring in line with a dashpot; SI.

    Attributes
    ----------
    youngs_modulus : float
        [Pa].
    viscosity : float
        [Pa s], extensional.
    """

    youngs_modulus: float
    viscosity: float


@dataclass(frozen=True, slots=True)
class Parameter:
    """A named constant of a flow rule.

    Attributes
    ----------
    name : str
        As it stands in the rule.
    value : float
        SI.
    dimension : tuple of float
        Exponents of kg, m and s.
    """

    name: str
    value: float
    dimension: Dimension


@dataclass(frozen=True, slots=True)
class Modes(AsValidator):
    """A list of modes."""

    accepted: str = 'a list of modes, such as [{youngs_modulus = "1 MPa", viscosity = "2 kPa*s"}]'

    def read(self, value: object) -> tuple[Mode, ...]:
        if not isinstance(value, (list, tuple)):
            raise refusal(f"{shown(value)} is not a list", self.accepted)
        if len(value) > _MOST:
            raise refusal(f"{len(value)} modes", f"at most {_MOST} modes")
        faults: list[tuple[tuple[str, ...], PydanticCustomError]] = []
        modes = []
        for number, item in enumerate(value, start=1):
            read = self._constants(item, str(number), faults)
            if len(read) == len(_MODE):
                modes.append(Mode(**read))
        if faults:
            raise refusals("modes", faults)
        return tuple(modes)

    def _constants(
        self, item: object, number: str, faults: list[tuple[tuple[str, ...], PydanticCustomError]]
    ) -> dict[str, float]:
        if isinstance(item, Mode):
            return {name: getattr(item, name) for name in _MODE}
        if not isinstance(item, Mapping):
            faults.append(((number,), refusal(f"{shown(item)} is not a mode", self.accepted)))
            return {}
        for key in item:
            if key not in _MODE:
                faults.append(((number, str(key)), refusal("unknown key", ", ".join(_MODE))))
        read = {}
        for name, kind in _MODE.items():
            try:
                if name not in item:
                    raise refusal("missing", kind.accepted)
                read[name] = kind.read(item[name])
            except PydanticCustomError as error:
                faults.append(((number, name), error))
        return read

    def write(self, value: tuple[Mode, ...]) -> object:
        return [{name: kind.write(getattr(mode, name)) for name, kind in _MODE.items()} for mode in value]


@dataclass(frozen=True, slots=True)
class Parameters(AsValidator):
    """A table of named constants of any unit."""

    accepted: str = 'a table of named constants, such as {s0 = "1 kPa", t0 = "2 s", m = 3}'

    def read(self, value: object) -> tuple[Parameter, ...]:
        if isinstance(value, tuple) and all(isinstance(item, Parameter) for item in value):
            return value
        if not isinstance(value, Mapping):
            if isinstance(value, (str, list, tuple)) and not value:
                return ()
            raise refusal(f"{shown(value)} is not a table", self.accepted)
        if len(value) > _MOST:
            raise refusal(f"{len(value)} parameters", f"at most {_MOST} parameters")
        faults = []
        parameters = []
        for name, given in value.items():
            try:
                parameters.append(_parameter(name, given))
            except PydanticCustomError as error:
                faults.append(((str(name),), error))
        if faults:
            raise refusals("parameters", faults)
        return tuple(sorted(parameters, key=lambda parameter: parameter.name))

    def write(self, value: tuple[Parameter, ...]) -> object:
        return {
            parameter.name: f"{parameter.value!r} {unit}" if (unit := si_unit(parameter.dimension)) else parameter.value
            for parameter in value
        }


def _parameter(name: object, given: object) -> Parameter:
    if not isinstance(name, str) or not (name.isascii() and name.isidentifier()) or iskeyword(name):
        raise refusal(f"{shown(name)} is no name", "letters, digits and _, not starting with a digit")
    if name in RESERVED or name.startswith("_"):
        raise refusal(f"the name {name!r} already means something", "another name")
    try:
        value, dimension = to_si_of_any(given)
    except NotAQuantity as found:
        raise refusal(str(found), 'a bare number, or text with a number and a unit, such as "1 kPa"') from None
    return Parameter(name, value + 0.0, dimension)
