#!/usr/bin/env python3
"""What a granule carries on the Drucker-Prager Cap, over what it carries on the von Mises Double Cap, at delta/R0 = 0.3.

Usage: compare.py [README]: prints the table; with a file, ends with 1 if that has another. Standard library alone."""

import csv, pathlib, statistics, sys

here = pathlib.Path(__file__).resolve().parent
E, Lambda, Gamma = "material.E_bar", "material.Lambda_bar", "material.Gamma_bar"


def table(path):
    with open(path) as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def forces(pool, at):
    """Of every run that was done: its three numbers, and the force."""
    done = {r["run"]: tuple(float(r[k]) for k in (E, Lambda, Gamma)) for r in table(pool / "runs.csv") if r["state"] == "done"}
    return {done[r["run"]]: float(r["F_bar"]) for r in table(pool / "curves.csv")
            if r["branch"] == "loading" and r["run"] in done and float(r["delta_bar"]) == at}


dpc, vmdc = forces(here, 0.3), forces(here.parent / "edmans-sinka", 0.3)
columns, rows = (sorted({m[k] for m in vmdc}) for k in (2, 1))
lines = ["| Λ̄₀ | " + " | ".join(f"Γ̄₀ = {g:g}" for g in columns) + " |", "|---" * (len(columns) + 1) + "|"]
for one in rows:
    cells = []
    for g in columns:
        ratios = [F / vmdc[m] for m, F in dpc.items() if m[1:] == (one, g)]
        cells.append(f"{statistics.median(ratios):.2g}, {len(ratios)}" if ratios else "–, 0")
    lines.append(f"| {one:g} | " + " | ".join(cells) + " |")
text = "\n".join(lines)
print(text)
if len(sys.argv) > 1 and text not in pathlib.Path(sys.argv[1]).read_text():
    sys.exit(f"{sys.argv[1]} has another table")
