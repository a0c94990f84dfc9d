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
# # 12. Own rheology in one line
#
# A material that is in no catalogue: write how fast it flows under a tensile stress $\sigma$, $\varphi(\sigma)$, name
# its constants with their units, and run. The formula is read by a whitelist, never executed; SymPy differentiates it,
# and it is compiled like the built-in laws.

# %%
import tomllib
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib.pyplot as plt
import numpy as np

import softcat_sym as sc
from softcat_sym.fitting.flow_curve import fitted_scene

STRAND = """
[filament]
span = "40 mm"
thickness = "3 mm"
section = "circle"
density = "1100 kg/m^3"
[load]
ramp = "50 ms"
[run]
duration = "2 s"
[numerics]
cells = 20
"""


def scene_of(material: str) -> sc.Scene:
    """The strand, of a material written as the table of a scene file."""
    return sc.Scene.model_validate(tomllib.loads(STRAND + "[material]\n" + material))


def run(material: str) -> sc.Run:
    done = sc.simulate(scene_of(material))
    assert done.outcome is sc.Outcome.solved, done.summary["message"]
    return done


# %% [markdown]
# ## A formula, and the law that it is
#
# `sigma/eta0` is Maxwell's law. Written by hand it gives the built-in trajectory.

# %%
own = run("""
law = "custom"
youngs_modulus = "60 kPa"
flow = "sigma/eta0"
parameters = { eta0 = "30 kPa*s" }
""")
maxwell = run("""
law = "maxwell"
youngs_modulus = "60 kPa"
viscosity = "30 kPa*s"
""")
size = np.abs(maxwell.data.midpoint.values).max()
difference = np.abs(own.data.midpoint.values - maxwell.data.midpoint.values).max() / size
print(f"custom against built-in Maxwell: {difference:.1e} of the sag")
assert difference < 1e-3

# %% [markdown]
# ## Eyring's law
#
# Bonds that open sooner under stress: $\varphi = \sinh(\sigma/s_0)/t_0$. At rest its viscosity is $s_0 t_0$, here the
# 30 kPa s of before; beside it the Newtonian fluid of that viscosity, which has no spring. Only the exponential tells
# them apart, where the stress is above $s_0$.

# %%
eyring = run("""
law = "custom"
youngs_modulus = "60 kPa"
flow = "sinh(sigma/s0)/t0"
parameters = { s0 = "500 Pa", t0 = "1 min" }
""")
newtonian = run("""
law = "newtonian"
viscosity = "30 kPa*s"
""")
figure, axes = plt.subplots(figsize=(6.4, 4))
for name, done in (("Newtonian", newtonian), ("Maxwell", maxwell), ("Eyring", eyring)):
    axes.plot(done.data.time, 1e3 * done.data.midpoint, label=name)
axes.set(xlabel="time [s]", ylabel="midpoint [mm]", title="Three materials of the same viscosity at rest")
axes.legend()
figure.tight_layout()
sag = {name: -float(done.data.midpoint[-1]) for name, done in (("Maxwell", maxwell), ("Eyring", eyring))}
print({name: f"{1e3 * value:.2f} mm" for name, value in sag.items()})
assert sag["Eyring"] > 1.1 * sag["Maxwell"]

# %% [markdown]
# ## What is refused
#
# Anything that is no arithmetic, whose units do not make a rate, or that no material does, before a number is computed.


# %%
def refusal(flow: str, parameters: str) -> str:
    """The message that a law is refused with."""
    try:
        scene_of(f'law = "custom"\nyoungs_modulus = "60 kPa"\nflow = {flow!r}\nparameters = {{ {parameters} }}')
    except sc.SceneError as error:
        return str(error)
    raise AssertionError(f"{flow} was taken")


for flow, parameters, word in (
    ('__import__("os").getcwd()', 's0 = "500 Pa", t0 = "1 min"', "__import__"),
    ("sinh(sigma/s0)/t0", 's0 = "500 Pa", t0 = 60', "check the units"),
    ("sinh(sigma/s0)", 's0 = "500 Pa"', "flow"),
    ("-sigma/eta0", 'eta0 = "30 kPa*s"', "flow"),
    ("sigma**2/(s0**2*t0)", 's0 = "500 Pa", t0 = "1 min"', "flow"),
    ("sigma/eta", 'eta0 = "30 kPa*s"', "eta0"),
):
    message = refusal(flow, parameters)
    print(f"{flow}, {parameters}\n{message}\n")
    assert word in message

# %% [markdown]
# ## From a rheometer
#
# Where the law is one of the catalogue, a measured flow curve gives its constants: here a paste of 25 Pa yield stress,
# with the 3 % scatter of a rheometer, as a CSV file. `softcat flow-curve CSV -o DIR --scene SCENE` does the same.

# %%
noise = np.random.default_rng(12)
rate = np.logspace(-2, 2, 17)
stress = (25 + 6 * np.sqrt(rate)) * (1 + 0.03 * noise.standard_normal(rate.size))
rows = "\n".join(f"{x:.4g},{y:.4g}" for x, y in zip(rate, stress, strict=True))
with TemporaryDirectory() as folder:
    table = Path(folder) / "paste.csv"
    table.write_text(f"shear_rate_1_s,shear_stress_Pa\n{rows}\n", encoding="utf-8")
    fit = sc.fit_flow_curve(table)
for one in fit.candidates:
    print(f"{one.law:17} misses the data by {100 * one.relative_rms:4.1f} %, criterion {one.criterion:6.1f}")
assert fit.best.law == "herschel-bulkley"

figure, axes = plt.subplots(figsize=(6.4, 4))
axes.loglog(rate, stress, "o", label="measured")
for one in fit.candidates:
    axes.loglog(rate, one.fitted, label=one.law)
axes.set(xlabel="shear rate [1/s]", ylabel="shear stress [Pa]", title="Flow curve and the laws")
axes.legend()
figure.tight_layout()

# %% [markdown]
# The best law goes on to a scene, turned from shear to tension; a flow curve knows nothing of the modulus or of the
# surface, which are the scene's own. This paste is weaker than the toothpaste of the scene: by its yield stress alone
# it does not hold in a gap of 6 mm: it runs away, and what flows gathers in so short a piece that the run is given up.
# The surface tension of 40 mN/m that the scene states holds it: on a strand of 2 mm its pull, over the section, is as
# much as the yield stress.

# %%
changes = ["filament.span=6 mm", "filament.thickness=2 mm", "material.youngs_modulus=1 kPa", "run.accuracy=0.01"]
regimes = {}
for tension in ("0 N/m", "40 mN/m"):
    short = [*changes, "run.duration=0.2 s", f"surroundings.surface_tension={tension}"]
    scene = fitted_scene(fit, "toothpaste", overrides=short)
    done = sc.simulate(scene)
    regimes[tension] = done.summary["regime"] or done.outcome.name
    print(f"{tension}: {regimes[tension]}, sag {-1e6 * done.summary['midpoint_final_m']:.0f} um")
print("\n".join(scene.material.notes))
pull = 0.04 / 1e-3
print(f"surface: {pull:.0f} Pa, yield stress in tension: {scene.material.yield_stress:.0f} Pa")
assert regimes == {"0 N/m": "localised", "40 mN/m": "arrested-overdamped"}
assert abs(scene.material.yield_stress / (25 * np.sqrt(3)) - 1) < 0.1
assert 0.5 < pull / scene.material.yield_stress < 1.5
