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
# # 15. Fit your data
#
# A film of the midpoint becomes the constants of a material, with intervals and a verdict. Here the film is made by
# the program itself, with noise, so that the truth is known; put your own CSV in its place.

# %%
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib.pyplot as plt
import numpy as np

import softcat_sym as sc

# %% [markdown]
# ## A film
#
# Columns `time_s, midpoint_mm`; `midpoint_std_mm` beside them if you know it. Honey of 130 Pa s in shear, which is
# three times that in tension, read every few milliseconds with an error of 0.1 mm.

# %%
truth = sc.load_scene("cold-honey", {"material.viscosity": "390 Pa*s"})
fall = sc.simulate(truth).data
time = np.linspace(0.01, 0.3, 40)
noise = np.random.default_rng(15).normal(0.0, 0.1, time.size)
midpoint = 1e3 * np.interp(time, fall.time, fall.midpoint) + noise
rows = "\n".join(f"{t:.4f},{y:.3f}" for t, y in zip(time, midpoint, strict=True))

# %% [markdown]
# ## The fit
#
# The scene says what is known, with a rough value of what is not: here half as viscous as it is.
# `softcat fit film.csv --scene cold-honey --free viscosity -o DIR` does the same, and writes a page about it.

# %%
rough = sc.load_scene("cold-honey", {"material.viscosity": "200 Pa*s"})
with TemporaryDirectory() as folder:
    film = Path(folder) / "film.csv"
    film.write_text(f"time_s,midpoint_mm\n{rows}\n", encoding="utf-8")
    found = sc.fit(film, rough, free=["viscosity"])
viscosity = found.parameters["viscosity"]
low, high = viscosity.ci95
print(f"{viscosity.value:.1f} Pa s, 95 % between {low:.1f} and {high:.1f}: {viscosity.verdict}")
print(f"{found.outcome.word}: {found.outcome.value}; noise {1e3 * found.noise:.2f} mm")

# %%
(one,) = found.films
figure, (above, below) = plt.subplots(2, 1, figsize=(6.4, 4.6), sharex=True, height_ratios=(3, 1))
above.plot(one.time, 1e3 * one.measured, ".", label="film")
above.plot(one.time, 1e3 * one.model, label="fit")
above.set(ylabel="midpoint [mm]", title="Honey, filmed and fitted")
above.legend()
below.plot(one.time, one.residuals, ".")
below.axhline(0, color="0.6", lw=0.8)
below.set(xlabel="time [s]", ylabel="residual / noise")
figure.tight_layout()

# %% [markdown]
# ## What is not in the film
#
# How fast it falls at first is gravity. How it goes on is the viscosity over the density, and no film of a thread under
# its own weight tells the two apart: the fit says so instead of choosing.

# %%
with TemporaryDirectory() as folder:
    film = Path(folder) / "film.csv"
    film.write_text(f"time_s,midpoint_mm\n{rows}\n", encoding="utf-8")
    both = sc.fit(film, rough, free=["viscosity", "gravity", "density"], profiles=False)
for name, parameter in both.parameters.items():
    print(f"{name}: {parameter.verdict}")
print("identified instead:", "; ".join(both.combinations))

# %%
assert low < 390 < high
assert abs(viscosity.value / 390 - 1) < 0.02
assert viscosity.verdict == "identified"
assert abs(found.noise / 1e-4 - 1) < 0.4
assert {name: one.verdict == "identified" for name, one in both.parameters.items()} == {
    "viscosity": False,
    "gravity": True,
    "density": False,
}
