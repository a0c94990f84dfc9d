# ---
# jupyter:
#   jupytext:
#     formats: py:percent
#     text_representation:
#       extension: .py
#       format_name: percent
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 14. Does the ink bridge the gap?
#
# A strand of colloidal ink leaves a nozzle of diameter $D$ and spans a gap $L$. Three rules, all of a beam, and what
# the solver says where they end.

# %%
import matplotlib.pyplot as plt
import numpy as np

import softcat_sym as sc
from softcat_sym.plotting.run import shapes_figure

ink = sc.load_scene("ink-bridge", {"numerics.estimate": False})
D, E, g = ink.filament.thickness, ink.material.youngs_modulus, ink.load.gravity
weight, strength = ink.filament.density * g, ink.material.yield_stress
print(f"D = {1e3 * D:.1f} mm, E = {E / 1e3:.0f} kPa, tensile yield stress {strength:.0f} Pa")

# %% [markdown]
# ## The rules
#
# A pinned elastic beam sags by $5 w L^4/(384 E I)$. For a sag below $0.05 D$ that asks for $G' \ge 1.4\,\rho g s^4 D$,
# $s = L/D$, the rule of Smay, Cesarano & Lewis (2002). Between clamps the sag is five times smaller, and yield begins
# at the clamps, where the moment is $w L^2/12$: at $L^2 = 3 D \sigma_Y/(2 \rho g)$. The beam collapses when ends and
# middle are hinges, $w L^2/16 = \sigma_Y D^3/6$.


# %%
def sag_of_beam(span: np.ndarray | float, factor: float) -> np.ndarray | float:
    """Sag w L^4/(factor E I) of a circular beam [m]."""
    return weight * (np.pi * D**2 / 4) * span**4 / (factor * E * np.pi * D**4 / 64)


smay = (0.05 * D / sag_of_beam(1.0, 384 / 5)) ** 0.25
first_yield = np.sqrt(1.5 * D * strength / weight)
collapse = np.sqrt(32 / (3 * np.pi) * D * strength / weight)
print(f"Smay's rule allows a gap of {1e3 * smay:.2f} mm")
print(f"the first fibre yields at {1e3 * first_yield:.2f} mm, the beam collapses at {1e3 * collapse:.2f} mm")
assert abs(E / 3 / (weight * (smay / D) ** 4 * D) - 1.4) < 0.02

# %% [markdown]
# ## The solver
#
# One run for each gap, all in threads: without surface tension, as the rules have it, and with it.

# %%
spans = np.array([2.0, 2.9, 3.3, 3.7, 4.2, 5.2]) * 1e-3
bare = ink.replace({"surroundings.surface_tension": "0 N/m"})
runs = {name: sc.simulate_many(one, {"filament.span": spans}) for name, one in (("bare", bare), ("pulled", ink))}
sags, pulled = (-run.data.midpoint_final.values for run in runs.values())
assert all(outcome is sc.Outcome.solved for run in runs.values() for outcome in run.outcomes)

figure, axes = plt.subplots(figsize=(6.4, 4))
fine = np.linspace(spans[0], spans[-1], 100)
axes.semilogy(1e3 * fine, 1e6 * sag_of_beam(fine, 384 / 5), "--", label="elastic beam, pinned (Smay)")
axes.semilogy(1e3 * fine, 1e6 * sag_of_beam(fine, 384), ":", label="elastic beam, clamped")
axes.semilogy(1e3 * spans, 1e6 * sags, "o-", label="solver, without surface tension")
axes.semilogy(1e3 * spans, 1e6 * pulled, "s-", label="solver")
for gap in (first_yield, collapse):
    axes.axvline(1e3 * gap, color="0.6", lw=0.8)
axes.axhline(1e6 * 0.05 * D, color="0.6", lw=0.8)
axes.set(xlabel="gap [mm]", ylabel="sag [um]", title="Lines: first yield, collapse, and a sag of 0.05 D")
axes.legend()
figure.tight_layout()

# %% [markdown]
# ## Where the rules end
#
# Short strands are beams, but stubby ones: shear adds $9 (D/L)^2/\kappa$, $\kappa = 0.9$, to a clamped circular beam.
# From the first yield on, hinges grow at the ends and in the middle; beyond the collapse of the beam the strand sinks
# until it hangs, several times deeper. Smay's rule, made for pins and a sag that hardly shows, knows of neither.
#
# Nor does it know of the surface, which pulls with $F = \pi\gamma R$ and carries $8Ff/L^2$ of the weight at a sag $f$:
# no strand sags by more than $\rho g R L^2/(8\gamma)$. Where the beam collapses, that is what holds it.

# %%
thick = sag_of_beam(spans, 384) * (1 + 9 / 0.9 * (D / spans) ** 2)
elastic = spans < first_yield
print("solver over beam with shear:", np.round(sags / thick, 2))
assert np.all(np.abs(sags[elastic] / thick[elastic] - 1) < 0.02)
assert np.all(sags[spans < 0.95 * collapse] < 1.3 * thick[spans < 0.95 * collapse])
assert np.all(sags[spans > collapse] > 5 * thick[spans > collapse])
limit = weight * D / 2 * spans**2 / (8 * ink.surroundings.surface_tension)
print("with surface tension over without:", np.round(pulled / sags, 2))
assert np.all(pulled < limit)
assert np.all(pulled < sags)
assert pulled[-1] < sags[-1] / 4

# %% [markdown]
# Yield begins where the moment at the clamp says, between the two gaps beside it.

# %%
beside = (spans[elastic][-1], spans[~elastic][0])
shorter, longer = (sc.simulate(bare.replace({"filament.span": f"{span} m"})) for span in beside)
print([run.summary["regime"] for run in (shorter, longer)])
assert float(shorter.data.yielded_fraction.max()) == 0 < float(longer.data.yielded_fraction.max())

# %%
wide = sc.simulate(ink)
shapes_figure(wide.data, wide.summary, wide.scene)
