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
TIMES = np.linspace(0.01, 0.3, 40)
NO_SURFACE = {"surroundings.surface_tension": "0 N/m"}


def filmed(**changes: str) -> str:
    """The film of a thread of 390 Pa s in tension, as CSV."""
    fall = sc.simulate(sc.load_scene("cold-honey", {"material.viscosity": "390 Pa*s", **changes})).data
    noise = np.random.default_rng(15).normal(0.0, 0.1, TIMES.size)
    midpoint = 1e3 * np.interp(TIMES, fall.time, fall.midpoint) + noise
    rows = [f"{t:.4f},{y:.3f}" for t, y in zip(TIMES, midpoint, strict=True)]
    return "\n".join(["time_s,midpoint_mm", *rows, ""])


# %% [markdown]
# ## The fit
#
# The scene says what is known, with a rough value of what is not: here half as viscous as it is.
# The film is the model's own, so that its camera and the theory are taken for exact; of a film of yours neither is,
# and a fit without the last two arguments knows that. `softcat fit film.csv --scene cold-honey --free viscosity
# --calibrated --no-discrepancy -o DIR` does the same, and writes a page about it.


# %%
def fitted(film: str, free: list[str], *, profiles: bool = True, **changes: str) -> sc.Fit:
    """What a film tells of the parameters that are free."""
    rough = sc.load_scene("cold-honey", {"material.viscosity": "200 Pa*s", **changes})
    with TemporaryDirectory() as folder:
        path = Path(folder) / "film.csv"
        path.write_text(film, encoding="utf-8")
        return sc.fit(path, rough, free=free, profiles=profiles, calibrated=True, discrepancy=False)


film = filmed()
found = fitted(film, ["viscosity"])
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
# How fast it falls at first is gravity. How it goes on is the viscosity over the density: a thread without surface
# tension that is twice as viscous and twice as heavy falls alike, no film of it tells the two apart, and the fit says
# so instead of choosing.

# %%
THREE = ["viscosity", "gravity", "density"]
ratio = fitted(filmed(**NO_SURFACE), THREE, profiles=False, **NO_SURFACE)
for name, parameter in ratio.parameters.items():
    print(f"{name}: {parameter.verdict}")
print("identified instead:", "; ".join(ratio.combinations))

# %% [markdown]
# Honey has a surface tension, which the scene states: 60 mN/m. A force whose size is known is a scale for the other
# forces, so the film does tell viscosity from density, but only by the few per cent of the sag that the surface takes:
# the ends of their intervals lie a factor of three apart, which is called poorly determined, where those of the
# viscosity alone differ by one per cent.
# Weigh the honey, and leave its density fixed.

# %%
three = fitted(film, THREE, profiles=False)
for name, parameter in three.parameters.items():
    least, most = parameter.ci95
    print(f"{name}: {parameter.verdict}, 95 % between {least:.3g} and {most:.3g}")

# %% [markdown]
# That this is physics and no accident of the noise: twice as viscous and twice as heavy, the thread falls otherwise,
# and it falls alike again if its surface pulls twice as much.


# %%
def height(factor: float, tension: str) -> float:
    """Of the midpoint in the end [m], of a thread so many times as viscous and heavy."""
    changes = {"material.viscosity": f"{factor * 390} Pa*s", "filament.density": f"{factor * 1420} kg/m^3"}
    thread = sc.load_scene("cold-honey", {**changes, "surroundings.surface_tension": tension})
    return float(sc.simulate(thread).data.midpoint[-1])


once = height(1, "60 mN/m")
other, alike, bare = height(2, "60 mN/m") / once, height(2, "120 mN/m") / once, height(2, "0 N/m") / height(1, "0 N/m")
print(f"sag, times that of honey: {other:.4f}; of twice the surface tension too {alike:.6f}; of none at all {bare:.6f}")

# %%
assert low < 390 < high
assert abs(viscosity.value / 390 - 1) < 0.02
assert viscosity.verdict == "identified"
assert abs(found.noise / 1e-4 - 1) < 0.4
assert {name: one.verdict == "identified" for name, one in ratio.parameters.items()} == {
    "viscosity": False,
    "gravity": True,
    "density": False,
}
for name, truth in (("viscosity", 390), ("gravity", 9.81), ("density", 1420)):
    least, most = three.parameters[name].ci95
    assert three.parameters[name].verdict == ("identified" if name == "gravity" else "poorly determined")
    assert least < truth < most
    assert (most / least < 1.2) == (name == "gravity")
assert other > 1.01
assert abs(alike - 1) < 1e-4
assert abs(bare - 1) < 1e-4
