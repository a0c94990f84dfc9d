"""The one table of symbols: name, LaTeX, dimension, meaning and where the paper introduces it.

Every expression in :mod:`softcat_sym.physics` is written in these symbols and no others, so that a machine can check
the dimension of every term and print every equation.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

Symbol = sp.Symbol
Expr = sp.Expr

Dimension = tuple[int, int, int]
"""Exponents of (kg, m, s)."""

ONE: Dimension = (0, 0, 0)
LENGTH: Dimension = (0, 1, 0)
PER_LENGTH: Dimension = (0, -1, 0)
AREA: Dimension = (0, 2, 0)
TIME: Dimension = (0, 0, 1)
RATE: Dimension = (0, 0, -1)
STRESS: Dimension = (1, -1, -2)
FORCE: Dimension = (1, 1, -2)
MOMENT: Dimension = (1, 2, -2)
VISCOSITY: Dimension = (1, -1, -1)
DENSITY: Dimension = (1, -3, 0)
ACCELERATION: Dimension = (0, 1, -2)


@dataclass(frozen=True, slots=True)
class Entry:
    """One row of the table: what a symbol means, its dimension (kg, m, s), its LaTeX and its place in the paper."""

    symbol: sp.Symbol
    latex: str
    dimension: Dimension
    meaning: str
    source: str


_TABLE: dict[sp.Symbol, Entry] = {}


def enter(
    name: str, latex: str, dimension: Dimension, meaning: str, source: str, *, positive: bool = False
) -> sp.Symbol:
    """Enter a symbol into the table and return it."""
    symbol = sp.Symbol(name, positive=True) if positive else sp.Symbol(name, real=True)
    row = Entry(symbol, latex, dimension, meaning, source)
    if any(other.symbol.name == name and other != row for other in _TABLE.values()):
        raise ValueError(f"symbol {name} stands in the table already")
    _TABLE[symbol] = row
    return symbol


# coordinates
X = enter("X", "X", LENGTH, "material coordinate along the centreline", "x_0 in the paper")
t = enter("t", "t", TIME, "time", "2.1")
z = enter("z", "z", LENGTH, "distance from the centreline along the normal", "2.6")
zeta = enter("zeta", r"\zeta", ONE, "material through-thickness coordinate 2z/h in [-1, 1]", "A 1")
c = enter("c", "c", ONE, "edge of a yielded zone on the zeta axis", "2.26")

# kinematics
x = enter("x", "x", LENGTH, "horizontal position of the centreline", "2.1")
y = enter("y", "y", LENGTH, "height of the centreline", "2.1")
x_X = enter("x_X", "x_X", ONE, "horizontal component of the tangent r_X", "2.5")
y_X = enter("y_X", "y_X", ONE, "vertical component of the tangent r_X", "2.5")
x_X_before = enter("x_X_before", "x_X^-", ONE, "x_X in the cell to the left of a node", "2.5")
y_X_before = enter("y_X_before", "y_X^-", ONE, "y_X in the cell to the left of a node", "2.5")
s = enter("s", "s_X", ONE, "stretch of the centreline", "2.5", positive=True)
theta = enter("theta", r"\theta", ONE, "tangent angle from the horizontal", "2.5")
theta_X = enter("theta_X", r"\theta_X", PER_LENGTH, "turning per unit material length", "2.5")

# strain at which the material is without stress: a mean, what the top has more, and their rates
n_0 = enter("n_0", r"\epsilon^n_0", ONE, "natural strain, a mean over the thickness", "Timoshenko 1925")
n_1 = enter("n_1z", r"\epsilon^n_1", ONE, "natural strain at the top less the mean", "Timoshenko 1925")
n_0_t = enter("n_0_t", r"\dot\epsilon^n_0", RATE, "rate of the mean natural strain", "Timoshenko 1925")
n_1_t = enter(
    "n_1z_t", r"\dot\epsilon^n_1", RATE, "rate of the natural strain at the top less the mean", "Timoshenko 1925"
)

# rates of the kinematics, for what depends on them
x_t = enter("x_t", "x_t", (0, 1, -1), "horizontal velocity of the centreline", "2.1")
y_t = enter("y_t", "y_t", (0, 1, -1), "vertical velocity of the centreline", "2.1")
x_Xt = enter("x_Xt", "x_{Xt}", RATE, "rate of x_X", "2.5")
y_Xt = enter("y_Xt", "y_{Xt}", RATE, "rate of y_X", "2.5")
x_Xt_before = enter("x_Xt_before", "x_{Xt}^-", RATE, "rate of x_X in the cell to the left of a node", "2.5")
y_Xt_before = enter("y_Xt_before", "y_{Xt}^-", RATE, "rate of y_X in the cell to the left of a node", "2.5")
s_t = enter("s_t", r"\dot s_X", RATE, "rate of the stretch", "2.5")
theta_Xt = enter("theta_Xt", r"\dot\theta_X", (0, -1, -1), "rate of theta_X", "2.5")

# section
A0 = enter("A0", "A_0", AREA, "area of the undeformed section", "2.9", positive=True)
h0 = enter("h0", "h_0", LENGTH, "thickness of the undeformed section (diameter of a circle)", "2.9", positive=True)
L = enter("L", "L", LENGTH, "span between the supports", "2.1", positive=True)
L_0 = enter("L_0", "L_0", LENGTH, "rest length: X lies in [-L_0/2, L_0/2]", "2.1", positive=True)
kappa_0 = enter("kappa_0", r"\kappa_0", PER_LENGTH, "natural curvature", "2.11")

# material
E = enter("E", "E", STRESS, "Young's modulus", "2.8", positive=True)
eta = enter("eta", r"\eta", VISCOSITY, "extensional (tensile) viscosity", "2.7", positive=True)
eta_s = enter("eta_s", r"\eta_s", VISCOSITY, "tensile viscosity beside spring and flow", "Voigt 1892", positive=True)
sigma_Y = enter("sigma_Y", r"\sigma_Y", STRESS, "tensile yield stress", "2.25", positive=True)
rho = enter("rho", r"\rho", DENSITY, "density", "2.1", positive=True)

# surroundings
rho_b = enter("rho_b", r"\rho_b", DENSITY, "density of what surrounds the filament", "Archimedes", positive=True)
mu_b = enter("mu_b", r"\mu_b", VISCOSITY, "shear viscosity of what surrounds the filament", "Cox 1970", positive=True)

# load
g_t = enter("g_t", "g(t)", ACCELERATION, "gravity while it is switched on", "section 3")
g = enter("g", "g", ACCELERATION, "acceleration of gravity", "2.1", positive=True)
g_on = enter("g_on", r"g_{on}", TIME, "time over which gravity is switched on", "section 3", positive=True)
a_g = enter("a_g", "a_g", ONE, "amplitude with which gravity oscillates, over g", "Rayleigh 1877", positive=True)
f_g = enter("f_g", "f_g", RATE, "frequency with which gravity oscillates", "Rayleigh 1877", positive=True)

# stress and plastic state
sigma = enter("sigma", r"\sigma", STRESS, "axial stress of a fibre", "2.8")
sigma_0 = enter("sigma_0", r"\sigma_0", STRESS, "section mean of the axial stress", "2.23")
sigma_1 = enter("sigma_1", r"\sigma_1", STRESS, "axial stress of bending at zeta = 1", "2.23")
a_0 = enter("a_0", "a_0", ONE, "axial plastic strain (material); P/A_0 (printed)", "A 1, 2.11")
a_1 = enter(
    "a_1", "a_1", ONE, "bending plastic strain at zeta = 1 (material); C/(A_0 h_0 <zeta^2>/2) (printed)", "A 1, 2.11"
)

# resultants
Q = enter("Q", "Q", FORCE, "axial force conjugate to the stretch", "2.4")
T = enter("T", "T", FORCE, "tension, area times mean stress", "2.10")
M = enter("M", "M", MOMENT, "bending moment", "2.10")
M_X = enter("M_X", "M_X", FORCE, "change of moment per unit material length", "2.3")


def table() -> tuple[Entry, ...]:
    """Every symbol of the theory, in the order of the theory."""
    return tuple(_TABLE.values())


def entry(symbol: sp.Symbol) -> Entry:
    """Look a symbol up."""
    return _TABLE[symbol]
