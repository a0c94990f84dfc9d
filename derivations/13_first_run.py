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
# # 13. A first run
#
# Two filaments of the paper, alike but for their weight. Before a run the program says what it expects; afterwards the
# run says how it ended, and how far it may be off.

# %%
import matplotlib.pyplot as plt
import numpy as np

import softcat_sym as sc
from softcat_sym.plotting.run import shapes_figure

# %% [markdown]
# ## Ask first
#
# `load_scene` takes the name of a bundled scene (`softcat scenes` lists them) or the path of a TOML file. `explain`
# builds the equations, and integrates nothing. Any value of a scene is changed by its dotted key: here the accuracy of
# the midpoint, to 0.3 % of the sag.

# %%
heavy = sc.load_scene("continual-descent", {"run.accuracy": 0.003})
told = sc.explain(heavy)
print(f"expected: {told.regime.name}, since {told.regime.reason}")
print("physics in force:", ", ".join(told.in_force))

# %% [markdown]
# ## Run
#
# `G` is the weight over the yield stress. Groups are changed like any other value.

# %%
light = sc.load_scene("continual-descent", {"run.accuracy": 0.003, "groups.G": 0.6, "title": "Yields, and is held"})
runs = {"G = 1.9": sc.simulate(heavy), "G = 0.6": sc.simulate(light)}
for name, run in runs.items():
    sag, error = -1e3 * run.summary["midpoint_final_m"], run.summary["error_estimate"]["total"]
    print(f"{name}: {run.outcome.name}, {run.summary['regime']}, sag {sag:.1f} mm, within {100 * error:.2f} %")

# %% [markdown]
# The trajectory is an `xarray.Dataset`, in SI units that stand beside every variable.

# %%
figure, axes = plt.subplots(figsize=(6.4, 3.6))
for name, run in runs.items():
    axes.plot(run.data.time, 1e3 * run.data.midpoint, label=name)
axes.set(xlabel="time [s]", ylabel="midpoint [mm]", title="One goes on, the other stops")
axes.legend()
figure.tight_layout()

# %%
lighter = runs["G = 0.6"]
shapes_figure(lighter.data, lighter.summary, lighter.scene)

# %% [markdown]
# ## What it shows
#
# A catenary carries no more than $\sqrt 2$ yield stresses of weight (3.12): above, a filament descends
# for ever; well below, it is soon held. The work of its weight is accounted for, in both.

# %%
assert told.regime.name == runs["G = 1.9"].summary["regime"] == "descending"
assert runs["G = 0.6"].summary["regime"].startswith("arrested")
for run in runs.values():
    assert run.outcome is sc.Outcome.solved
    assert run.summary["error_estimate"]["total"] < run.scene.run.accuracy
    assert run.summary["energy_residual"] < 1e-3
last = {name: np.diff(run.data.midpoint.values[[-21, -1]])[0] / 20 for name, run in runs.items()}
print({name: f"{1e6 * pace:.1f} um a frame at the end" for name, pace in last.items()})
assert abs(last["G = 0.6"]) < 0.1 * abs(last["G = 1.9"])
