"""Heat of a filament: one temperature over the section, what it makes of the viscosity, and what passes the surface.

A kelvin and a mole count as pure numbers in the dimensions (kg, m, s) of the table of symbols.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import sympy as sp

from softcat_sym.physics.clocks import varying
from softcat_sym.physics.constitutive_laws import Constant, Law
from softcat_sym.physics.loads import SURFACES, surface_tension
from softcat_sym.physics.sections import Section
from softcat_sym.physics.symbols import ONE, E, enter, eta, g, h0, s, t
from softcat_sym.physics.terms import Warming
from softcat_sym.scene.temperature_table import PREFIX

_SOURCE = "Incropera 2007"
temperature = enter("theta_K", r"\vartheta", ONE, "temperature of a section, in kelvin", _SOURCE, positive=True)
_FLUX, _CAPACITY, _CONDUCTIVITY, _POWER = (1, 0, -3), (0, 2, -2), (1, 1, -3), (1, 1, -3)


def _kelvin(name: str, latex: str, meaning: str, source: str) -> sp.Symbol:
    return enter(name, latex, ONE, meaning, source, positive=True)


initial = _kelvin("theta_i", r"\vartheta_i", "temperature at the start, in kelvin", _SOURCE)
ambient = _kelvin("theta_a", r"\vartheta_a", "temperature of the surroundings, in kelvin", _SOURCE)
outside = _kelvin("theta_o", r"\vartheta_o", "temperature around what is not in the furnace", _SOURCE)
around = _kelvin("theta_s", r"\vartheta_s", "temperature around a place of the filament", _SOURCE)
reference = _kelvin("theta_r", r"\vartheta_r", "temperature of the stated viscosity", "Ferry 1980")
heat_capacity = enter("c_p", "c_p", _CAPACITY, "specific heat capacity", _SOURCE, positive=True)
transfer = enter("h_T", "h_T", _FLUX, "heat transfer coefficient", _SOURCE, positive=True)
conductivity = enter("k_T", "k_T", _CONDUCTIVITY, "thermal conductivity", _SOURCE, positive=True)
begin = enter("X_1", "X_1", (0, 1, 0), "where the furnace begins, from the left end", "ASTM C338")
end = enter("X_2", "X_2", (0, 1, 0), "where the furnace ends, from the left end", "ASTM C338")
A_V = enter("A_V", "A_V", ONE, "log10 of the viscosity at infinite temperature", "Fulcher 1925")
B_V = _kelvin("B_V", "B_V", "slope of log10 of the viscosity, in kelvin", "Fulcher 1925")
T_V = _kelvin("T_V", "T_V", "temperature of infinite viscosity", "Fulcher 1925")
C_1 = enter("C_1", "C_1", ONE, "first constant of Williams, Landel and Ferry", "Williams et al. 1955", positive=True)
C_2 = _kelvin("C_2", "C_2", "second constant of Williams, Landel and Ferry", "Williams et al. 1955")
B_A = _kelvin("B_A", "B_A", "activation energy over the gas constant", "Arrhenius 1889")
T_F = _kelvin("theta_F", r"\vartheta_F", "temperature below which a strand is frozen", "THEORY 4")
alpha_T = enter("alpha_T", r"\alpha_T", ONE, "coefficient of linear thermal expansion", "Timoshenko 1925")
heat_source = enter("D_h", r"\mathcal{D}", _POWER, "plastic and viscous power per unit material length", "THEORY 4")
viscosity_factor = enter("a_T", "a_T", ONE, "viscosity over the stated one", "Ferry 1980")
modulus_factor = enter("m_T", "m_T", ONE, "modulus over the stated one", "Ferry 1980")
stored = enter("W_e", "W", (1, 1, -2), "elastic energy per unit material length", "THEORY 4")

_OF_C = {
    "initial": initial,
    "ambient": ambient,
    "outside": outside,
    "reference": reference,
    "heat_capacity": heat_capacity,
    "heat_transfer": transfer,
    "conductivity": conductivity,
    "heated_begin": begin,
    "heated_end": end,
    "A": A_V,
    "B": B_V,
    "T_0": T_V,
    "C1": C_1,
    "C2": C_2,
    "activation_temperature": B_A,
    "expansion": alpha_T,
    "frozen": T_F,
}


def shift(law: str, *, by_reference: bool, freezes: bool = False) -> sp.Expr:
    """Viscosity over the one that the material states, of the temperature.

    Parameters
    ----------
    law : str
        ``vft`` (Vogel 1921, Fulcher 1925, Tammann & Hesse 1926), ``wlf`` (Williams, Landel & Ferry 1955),
        ``arrhenius``, or ``constant``.
    by_reference : bool
        Whether VFT is one at the reference temperature; otherwise A says how large it is.
    freezes : bool
        Whether temperatures are below where VFT or WLF end: the viscosity stays what it is where the strand is frozen.
    """
    T = sp.Piecewise((T_F, temperature < T_F), (temperature, True)) if freezes else temperature
    if law == "vft":
        at_reference = -B_V / (reference - T_V) if by_reference else A_V
        return sp.exp(sp.log(10) * (at_reference + B_V / (T - T_V)))
    if law == "wlf":
        return sp.exp(-sp.log(10) * C_1 * (T - reference) / (C_2 + T - reference))
    return sp.exp(B_A / temperature - B_A / reference) if law == "arrhenius" else sp.S.One


# Dry air at one atmosphere, of its temperature in kelvin: Sutherland's viscosity, conductivity (U.S. Standard
# Atmosphere 1976, equations 51 and 53), density of the ideal gas; Prandtl number of Churchill & Chu's air.
_PRESSURE, _GAS, _PRANDTL = 101325, sp.Float("287.05287", 17), sp.Rational(7, 10)


def air(kelvin: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Conductivity [W/(m K)] and kinematic viscosity [m^2/s] of air."""
    power = kelvin ** sp.Rational(3, 2)
    conducts = sp.Float("2.64638e-3", 17) * power / (kelvin + sp.Float("245.4", 17) * sp.exp(-12 * sp.log(10) / kelvin))
    viscosity = sp.Float("1.458e-6", 17) * power / (kelvin + sp.Float("110.4", 17))
    return conducts, viscosity * _GAS * kelvin / _PRESSURE


_ROUNDED = sp.Rational(1, 100)
"""Difference of temperature, in kelvin, within which the correlation is rounded: its slope at none is infinite."""


def cylinder_in_air() -> sp.Expr:
    """Heat transfer coefficient of a horizontal cylinder in still air (Churchill & Chu 1975, equation 9).

    Nu = (0.60 + 0.387 Ra^(1/6)/(1 + (0.559/Pr)^(9/16))^(8/27))^2 for Ra up to 10^12, of the mean of both temperatures.
    """
    film, apart = (temperature + around) / 2, (temperature - around) ** 2 + _ROUNDED**2
    conducts, nu = air(film)
    # Ra = g |dT| d^3 Pr/(T nu^2), its sixth root.
    diameter = h0 / sp.sqrt(s)
    root = (g * diameter**3 * _PRANDTL / (film * nu**2)) ** sp.Rational(1, 6) * apart ** sp.Rational(1, 12)
    slope = sp.Float("0.387", 17) / (1 + (sp.Rational(559, 1000) / _PRANDTL) ** sp.Rational(9, 16)) ** sp.Rational(
        8, 27
    )
    nusselt = (sp.Rational(3, 5) + slope * root) ** 2
    return nusselt * conducts / diameter


CORRELATIONS: dict[str, Callable[[], sp.Expr]] = {"cylinder-in-air": cylinder_in_air}


@dataclass(frozen=True, slots=True)
class Heat:
    """What the equations of a filament with a temperature are made of."""

    coefficient: sp.Expr = sp.S.Zero  # Of heat transfer, of the temperature and of that around; zero: none
    ambient: sp.Expr = ambient  # Temperature of the surroundings, of the time
    viscosity: sp.Expr = sp.S.One  # Viscosity and modulus over the stated ones, of the temperature
    modulus: sp.Expr = sp.S.One
    conducts: bool = False  # Whether heat is conducted along the filament
    expands: bool = False
    partial: bool = False  # Whether a part only is in the furnace
    factors: tuple[tuple[sp.Symbol, sp.Expr], ...] = ()  # Constants of the law that change, and by which of the two
    numbers: tuple[Constant, ...] = ()  # Of the tables of the surroundings and of the modulus

    @property
    def softens(self) -> bool:
        """Whether the moduli change with the temperature."""
        return bool(self.modulus != 1)

    @property
    def stiffens(self) -> bool:
        """Whether the stored energy depends on the temperature."""
        return self.softens or self.expands

    @property
    def strain(self) -> sp.Expr:
        """Natural strain of the expansion."""
        return alpha_T * (temperature - initial)

    @property
    def constants(self) -> tuple[Constant, ...]:
        """Numbers that a run is given."""
        return (*(Constant(PREFIX + name, symbol) for name, symbol in _OF_C.items()), *self.numbers)

    def thick(self) -> Heat:
        """The same of a section that does not shrink."""
        return replace(self, coefficient=self.coefficient.subs(s, 1))


def heat_of(warming: Warming, law: Law) -> Heat:
    """The balance of heat, and what the temperature makes of the constants of a law."""
    around, modulus, numbers = ambient, sp.S.One, tuple[Constant, ...]()
    if warming.ambient is not None:
        varies = varying(warming.ambient)
        around, numbers = varies.value, varies.constants
    if warming.modulus is not None:
        varies = varying(warming.modulus)
        modulus, numbers = varies.value.xreplace({t: temperature}), (*numbers, *varies.constants)
    coefficient = CORRELATIONS[warming.exchange]() if warming.exchange in CORRELATIONS else transfer
    viscosity = shift(warming.law, by_reference=warming.by_reference, freezes=warming.freezes)
    factors = dict[sp.Symbol, sp.Expr]()
    if viscosity != 1:
        # Of chains the modulus stays: the time in which they relax goes with their viscosity.
        factors |= dict.fromkeys((*_named(law, "viscosity", eta), *_named(law, "relaxation_time")), viscosity)
    if modulus != 1:
        factors |= dict.fromkeys((*_named(law, "youngs_modulus", E), *_named(law, "second_modulus")), modulus)
    return Heat(
        coefficient=coefficient if warming.exchange else sp.S.Zero,
        ambient=around,
        viscosity=viscosity,
        modulus=modulus,
        conducts=warming.conducts,
        expands=warming.expands,
        partial=warming.partial,
        factors=tuple(factors.items()),
        numbers=numbers,
    )


def _named(law: Law, name: str, *shared: sp.Symbol) -> tuple[sp.Symbol, ...]:
    """Symbols of a law's constants of one sort: the one that several laws share, and its own."""
    own = tuple(one.symbol for one in law.constants if one.name == name or one.name.endswith(f"_{name}"))
    return (*shared, *own)


def lateral_area(shape: Section, *, thins: bool) -> sp.Expr:
    """Lateral area over volume of the undeformed section, of the stretch: 4 sqrt(s)/d of a circle."""
    whole = sp.simplify(SURFACES[shape.name].energy() / surface_tension)
    return whole if thins else whole.subs(s, 1)
