# %% [markdown]
# # Errata of "Soft catenaries"
#
# Each notebook before this one records the misprints that it has proved. Here they become one table, `ERRATA.md`.
# Nothing is written by hand: a row exists because a derivation failed with what is printed and closed with what is
# correct.

# %%
import json

from proving import ERRATA

rows = [
    {**row, "notebook": path.stem}
    for path in sorted(ERRATA.glob("*.json"))
    for row in json.loads(path.read_text("utf-8"))
]
for row in rows:
    assert all(row[key].strip() for key in ("equation", "printed", "correct", "proof"))

# %% [markdown]
# The misprints that any edition of this table must hold, wherever they were proved.

# %%
found = " ".join(row["equation"] for row in rows)
for equation in ("2.4", "2.18", "2.21", "3.7", "3.8", "figure 2", "3.2"):
    assert equation in found.lower(), f"no notebook has recorded {equation}"


# %%
def cell(text: str) -> str:
    """Text that a Markdown table can hold; bare LaTeX among words is shown as code."""
    line = " ".join(text.split()).replace("|", "\\|")
    return f"`{line}`" if "\\" in line and "$" not in line and "`" not in line else line


head = ['# Errata of Kamrin & Mahadevan, "Soft catenaries", J. Fluid Mech. (2012)', ""]
head += ["Made by `derivations/10_errata.py` from what the other notebooks prove; do not edit.", ""]
head += ["| equation | printed | correct | proof | notebook |", "|---|---|---|---|---|"]
body = [
    "| " + " | ".join(cell(row[key]) for key in ("equation", "printed", "correct", "proof", "notebook")) + " |"
    for row in rows
]
(ERRATA.parent / "ERRATA.md").write_text("\n".join([*head, *body]) + "\n", encoding="utf-8")
print("\n".join(body))
