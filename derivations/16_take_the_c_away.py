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
# # 16. Take the C away
#
# The solver of a scene as C99 that needs no Python: a program, and a function to call from your own. What follows
# builds it with your compiler (`CC`, or `cc`), runs it, and holds it against the run in Python. Without a compiler the
# files are written all the same, and nothing is compared.

# %%
import csv
import os
import shutil
import subprocess
import sys
from pathlib import Path
from tempfile import mkdtemp

import matplotlib.pyplot as plt
import numpy as np

import softcat_sym as sc

scene = sc.load_scene("cold-honey", {"numerics.estimate": False})
folder = Path(mkdtemp())
written = sc.generate(scene, folder)
print(f"{len(written)} files, {sum(path.stat().st_size for path in written) / 1000:.0f} kB")
print(", ".join(path.name for path in written if not path.name.startswith("softcat_")))

# %% [markdown]
# ## The call
#
# Every number of the scene is a parameter, which can be changed without writing the C again.

# %%
print((folder / "parameters.txt").read_text(encoding="utf-8")[:640])

# %% [markdown]
# ## Build and run
#
# `make -C DIR` does it, or one line: all C files, and `libm`.

# %%
compiler = shutil.which(os.environ.get("CC", "cc").split()[0])
if compiler is None:
    print("No C compiler here: the files are for a machine that has one.")
else:
    program = folder / "filament"
    sources = sorted(path for path in folder.rglob("*.c"))
    flags = ["-std=c99", "-O2", *(f"-I{place}" for place in sorted({path.parent for path in folder.rglob("*.h")}))]
    subprocess.run([compiler, *flags, *sources, "-o", program, "-lm"], check=True)
    table = folder / "midpoint.csv"
    subprocess.run([program, folder / "parameters.txt", "-o", table], check=True)
    print(table.read_text(encoding="utf-8")[:200])

# %% [markdown]
# ## The same numbers

# %%
if compiler is not None:
    with table.open(newline="", encoding="utf-8") as stream:
        rows = [row for row in csv.reader(stream) if row and not row[0].startswith("#")]
    time, height = np.array([[float(cell) for cell in row[:2]] for row in rows[1:]]).T
    run = sc.simulate(scene)
    there = np.interp(time, run.data.time, run.data.midpoint)
    apart = float(np.abs(height - there).max() / np.abs(there).max())
    print(f"C beside Python: {apart:.1e} of the sag, over {time.size} times")
    assert time.size > 10
    assert apart < 1e-4

# %%
if compiler is not None:
    figure, axes = plt.subplots(figsize=(6.4, 3.6))
    axes.plot(run.data.time, 1e3 * run.data.midpoint, lw=3, alpha=0.4, label="Python")
    axes.plot(time, 1e3 * height, "k--", lw=1, label="C alone")
    axes.set(xlabel="time [s]", ylabel="midpoint [mm]", title="Cold honey")
    axes.legend()

# %% [markdown]
# ## From Python, without this package
#
# `filament.py` beside the C needs NumPy and a compiler alone: it builds the library, runs it, or steps it while its
# parameters change.

# %%
STEPS = """
import sys
from filament import DURATION, Filament

strand = Filament()
print("at half time:", strand.step(0.5 * DURATION), "m")
strand.set(gravity=0.0)  # from now on
print("at the end, without weight:", strand.step(DURATION), "m;", "softcat_sym" in sys.modules)
"""

if compiler is not None:
    done = subprocess.run([sys.executable, "-c", STEPS], cwd=folder, capture_output=True, text=True, check=True)
    print(done.stdout)
    assert done.stdout.rstrip().endswith("False")

# %% [markdown]
# `filament.h` tells how to call it from a program of your own: `softcat_defaults(params)`, then
# `softcat_midpoint(params, cells, times, n, height, workspace, status)`, whose workspace is memory of yours; `softcat
# generate SCENE -o DIR --rhs` adds the right-hand side for an integrator of yours.

# %%
shutil.rmtree(folder)
