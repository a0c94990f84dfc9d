"""The constitutive laws of a scene: one entry each, which everything that depends on a law asks for its properties.

A law whose flow rule is a formula needs no other code: see ``casson``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from softcat_sym.scene.history import ChangingQuantity
from softcat_sym.scene.units import Number, Quantity, consistency_unit

LINEAR, POWER = "linear", "power"
"""Flow rules whose means over a section, or whose slope at zero stress, ``physics.constitutive_laws`` has by hand."""

_STRESS, _VISCOSITY = ChangingQuantity("stress", "9.32 kPa"), ChangingQuantity("viscosity", "13.84 kPa*s")
CONSTANTS: Mapping[str, ChangingQuantity | Quantity | Number] = MappingProxyType(
    {
        "youngs_modulus": _STRESS,
        "second_modulus": _STRESS,
        "viscosity": _VISCOSITY,
        "yield_stress": _STRESS,
        "relaxation_time": Quantity("time", "0.1 s"),
        "solvent_viscosity": Quantity("viscosity", "3 mPa*s", "non-negative"),
        "finite_extensibility": Number(above=3),
        "mobility": Number(above=0, below=1),
        "ptt_epsilon": Number(above=0),
    }
)
"""All constants of laws, tensile, with unit and bounds."""

_SHEAR = {
    **dict.fromkeys(("storage_modulus", "shear_yield_stress"), _STRESS),
    "shear_viscosity": _VISCOSITY,
    "shear_solvent_viscosity": Quantity("viscosity", "1 mPa*s", "non-negative"),
}

_GROUPED = {"youngs_modulus", "viscosity", "yield_stress"}


@dataclass(frozen=True, slots=True)
class LawSpec:
    """A constitutive law: springs in parallel, some in line with a flow rule, beside a viscous stress."""

    name: str
    source: str
    constants: tuple[str, ...] = ()  # Names in `CONSTANTS`; one that a law does not use is refused, never ignored
    springs: tuple[str, ...] = ()  # Moduli of springs that do not flow: the law is that of a solid
    flowing: tuple[str, ...] = ()  # Moduli of springs in line with the flow rule
    # `LINEAR`, `POWER`, or a formula of the strain rate in ``sigma`` and the names of constants, odd in the stress. A
    # formula with a yield stress has another for a flow in which the effect of yielding is left out.
    flow: str = ""
    flow_without_yield: str = ""
    has_index: bool = False  # Its viscosity is then a consistency, in Pa s^n
    viscous_stress: str = ""  # Constant of a stress in proportion to the strain rate, beside the springs
    has_chains: bool = False  # Polymer chains instead of springs
    lists: tuple[str, ...] = ()  # Keys of what it consists of besides constants
    # Steady shear is tau^p = tau_Y^p + (k rate^n)^p, as that of the law `flow_curve`; empty without such a curve.
    flow_curve: str = ""
    shear_exponent: float = 1.0
    contains: tuple[str, ...] = ()  # Narrower laws that are this one with some constants at a limit

    @property
    def yields(self) -> bool:
        """Whether it has a yield stress, which flow may harden."""
        return "yield_stress" in self.constants

    @property
    def is_solid(self) -> bool:
        """Whether it remembers its shape: what it leaves behind is no plastic strain."""
        return bool(self.springs)

    @property
    def has_springs(self) -> bool:
        """Whether it has springs, with a flow rule each or without."""
        return bool(self.springs or self.flowing or self.lists)

    @property
    def is_elastic(self) -> bool:
        """Whether it has an elastic strain, so that a filament has a shape and a stress to start from."""
        return self.has_springs or self.has_chains

    @property
    def flows(self) -> bool:
        """Whether any spring is in line with a flow rule, or chains relax."""
        return bool(self.flow or self.lists or self.has_chains)

    @property
    def is_linear(self) -> bool:
        """Whether stress and strain rate are in proportion."""
        return self.flow in ("", LINEAR) and not self.yields and not self.has_chains and "flow" not in self.lists

    @property
    def is_linear_fluid(self) -> bool:
        """Whether it is a Maxwell or a Newtonian fluid of one viscosity."""
        return self.is_linear and not self.is_solid and "viscosity" in self.constants

    @property
    def has_formula(self) -> bool:
        """Whether its flow rule is a formula."""
        return self.flow not in ("", LINEAR, POWER) or "flow" in self.lists

    @property
    def has_closed_means(self) -> bool:
        """Whether the means of its flow rules over a section have a closed form."""
        return self.flow != POWER and not self.has_formula

    @property
    def has_structure(self) -> bool:
        """Whether its one flow rule has constants that a structure may change."""
        return bool(self.flow) and not self.springs and not self.lists

    @property
    def has_groups(self) -> bool:
        """Whether a scene may give it by dimensionless groups."""
        return bool(self.constants) and set(self.constants) <= _GROUPED and not self.lists

    @property
    def suits_small_deflections(self) -> bool:
        """Whether it has the one plastic stretch, of a linear law, that the small-deflection model has."""
        return self.is_linear and len(self.springs + self.flowing) == 1 and not self.viscous_stress

    @property
    def loss_refused(self) -> str:
        """Why it takes no loss below yield; empty if it does."""
        if self.viscous_stress and (self.has_springs or self.has_chains):
            return f"has this viscosity as material.{self.viscous_stress}"
        return "" if self.has_springs else "has no spring that could ring"


_OF_CHAINS = ("youngs_modulus", "relaxation_time", "solvent_viscosity")
_E, _E_ETA = ("youngs_modulus",), ("youngs_modulus", "viscosity")
_E_ETA_Y = (*_E_ETA, "yield_stress")


def _chains(name: str, source: str, *constants: str) -> LawSpec:
    """Polymer chains in a solvent. Their fibres keep their volume: E is three times the modulus in shear."""
    return LawSpec(name, source, (*_OF_CHAINS, *constants), has_chains=True, viscous_stress="solvent_viscosity")


# The elastic law is no narrower one: a law that flows has a relaxation time that distinguishes it.
_FLUIDS = ("newtonian", "maxwell")
_OVER = "max(abs(sigma) - yield_stress, 0)"

_SPECS = (
    LawSpec("elastic", "Hooke 1678", _E, springs=_E),
    LawSpec("maxwell", "2.7", _E_ETA, flowing=_E, flow=LINEAR, flow_curve="newtonian", contains=("newtonian",)),
    LawSpec("newtonian", "Trouton 1906", ("viscosity",), viscous_stress="viscosity", flow_curve="newtonian"),
    LawSpec(
        "kelvin-voigt",
        "Voigt 1890",
        _E_ETA,
        springs=_E,
        viscous_stress="viscosity",
        contains=("newtonian",),
    ),
    LawSpec(
        "standard-linear",
        "Zener 1948",
        ("youngs_modulus", "second_modulus", "viscosity"),
        springs=_E,
        flowing=("second_modulus",),
        flow=LINEAR,
        contains=("maxwell", "kelvin-voigt"),
    ),
    LawSpec("multimode-maxwell", "Wiechert 1893", flow=LINEAR, lists=("modes",), flow_curve="newtonian"),
    LawSpec("bingham", "2.25", _E_ETA_Y, flowing=_E, flow=LINEAR, flow_curve="bingham", contains=_FLUIDS),
    LawSpec(
        "power-law",
        "Ostwald 1925",
        _E_ETA,
        flowing=_E,
        flow=POWER,
        has_index=True,
        flow_curve="power-law",
        contains=_FLUIDS,
    ),
    LawSpec(
        "herschel-bulkley",
        "Herschel & Bulkley 1926",
        _E_ETA_Y,
        flowing=_E,
        flow=POWER,
        has_index=True,
        flow_curve="herschel-bulkley",
        contains=(*_FLUIDS, "bingham", "power-law"),
    ),
    # tau^1/2 = tau_Y^1/2 + (mu rate)^1/2 in shear. The difference of the roots is a quotient, whose slope is finite.
    LawSpec(
        "casson",
        "Casson 1959",
        _E_ETA_Y,
        flowing=_E,
        flow=f"sign(sigma)*({_OVER}/(sqrt({_OVER} + yield_stress) + sqrt(yield_stress)))**2/viscosity",
        flow_without_yield="sigma/viscosity",
        flow_curve="casson",
        shear_exponent=0.5,
        contains=_FLUIDS,
    ),
    LawSpec("custom", "material.flow", _E, flowing=_E, lists=("flow", "parameters")),
    _chains("oldroyd-b", "Oldroyd 1950"),
    _chains("fene-p", "Bird et al. 1980", "finite_extensibility"),
    _chains("giesekus", "Giesekus 1982", "mobility"),
    _chains("ptt", "Phan-Thien & Tanner 1977", "ptt_epsilon"),
)
LAWS: Mapping[str, LawSpec] = MappingProxyType({one.name: one for one in _SPECS})
"""Every law by its name in a scene."""

OF_THE_INDEX = ("viscosity", "shear_viscosity", "shear_consistency", "consistency")
"""Keys whose unit may depend on the law and its index."""


def laws_with(constant: str) -> tuple[str, ...]:
    """Name the laws that have a constant, or consist of a list."""
    return tuple(one.name for one in LAWS.values() if constant in (*one.constants, *one.lists))


_UNKNOWN = LawSpec("", "")


def spec_of(law: str | None) -> LawSpec:
    """Properties of a law; of a name that is no law, those of one that has nothing."""
    return LAWS.get(law or "", _UNKNOWN)


def kind_of_constant(name: str, law: str | None, index: float) -> ChangingQuantity | Quantity | Number:
    """Return how a tensile constant or a shear datum is read and written: a consistency has a unit of its own."""
    if name in ("shear_consistency", "consistency") or (name == "viscosity" and spec_of(law).has_index):
        unit = consistency_unit(index)
        return ChangingQuantity("consistency", f"120 {unit}", unit=unit)
    return CONSTANTS[name] if name in CONSTANTS else _SHEAR[name]
