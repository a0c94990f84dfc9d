"""Names, dimensions, units and meanings of what a trajectory holds."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Variable:
    """One variable of ``trajectory.nc``.

    Attributes
    ----------
    name : str
        As in the file.
    place : str
        ``node``, ``cell`` or empty for one number a frame.
    unit : str
        Pint symbol.
    meaning : str
        ``long_name`` in the file.
    per_area : bool
        Whether the graph computes it per unit undeformed area.
    """

    name: str
    place: str
    unit: str
    meaning: str
    per_area: bool = False


VARIABLES: tuple[Variable, ...] = (
    Variable("x", "node", "m", "horizontal position of the centreline, 0 at midspan"),
    Variable("y", "node", "m", "height of the centreline above the left support"),
    Variable("stretch", "cell", "1", "stretch of the centreline"),
    Variable("curvature", "cell", "1/m", "curvature theta_s of the centreline, k/Lam of a filament that shears"),
    Variable("shear", "cell", "1", "shear strain of the section"),
    Variable("tension", "cell", "N", "tension T = A <sigma>", per_area=True),
    Variable("axial_force", "cell", "N", "force along the centreline, tension and surface tension", per_area=True),
    Variable("moment", "cell", "N*m", "bending moment M", per_area=True),
    Variable(
        "shear_force", "cell", "N", "transverse force N = M_X/s, A <tau> of a filament that shears", per_area=True
    ),
    Variable("yielded_fraction", "cell", "1", "share of the section that flows"),
    Variable("plastic_rate", "cell", "1/s", "largest plastic strain rate over the section"),
    Variable("thickness", "cell", "m", "thickness of the section"),
    Variable("stress_mean", "cell", "Pa", "section mean sigma_0 of the axial stress"),
    Variable(
        "stress_bending",
        "cell",
        "Pa",
        "sigma_1 = <sigma zeta>/<zeta^2>: the axial stress nearest to sigma_0 + sigma_1 zeta",
    ),
    Variable("core_low", "cell", "1", "zeta below which fibres yield, of a section resolved fibre by fibre"),
    Variable("core_high", "cell", "1", "zeta above which fibres yield, of a section resolved fibre by fibre"),
    Variable("energy_kinetic", "", "J", "kinetic energy", per_area=True),
    Variable("energy_elastic", "", "J", "elastic energy", per_area=True),
    Variable("energy_surface", "", "J", "surface tension times the growth of the area since t = 0", per_area=True),
    Variable("energy_potential", "", "J", "potential energy of the weight, 0 when straight", per_area=True),
    Variable("energy_dissipated", "", "J", "plastic work since t = 0", per_area=True),
    Variable("energy_gradient", "", "J", "work against the necking gradient since t = 0", per_area=True),
    Variable("work_external", "", "J", "work of the changing load since t = 0", per_area=True),
)

ENERGIES = tuple(v.name for v in VARIABLES if v.unit == "J")
