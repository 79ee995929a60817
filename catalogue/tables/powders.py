#!/usr/bin/env python3
"""Draws powders.csv, the granules of the pools powders and powders-coarse (NumPy): powders.py > powders.csv

A granule is a powder pressed to a relative density rho_r0. The powders fill a box about those of Edmans & Sinka,
Table 4, each range about a tenth longer at both ends; they are described at relative density 0.4, as there, and moved
to rho_r0 by eqs 4a-5b. Each row is the one of many random granules that makes the MaxPro criterion of all rows so far
smallest: any first N rows fill the box.

`powders.py fresh > fresh-powders.csv` draws 30 more from another seed, each at random: no surrogate is made of them.
"""
import sys

import numpy as np

ROWS, CANDIDATES, SEED, REFERENCE = 600, 20000, 23, 0.4
# name: low, high, whether filled evenly in the logarithm. Values at relative density 0.4; epsilon_1 is epsilon at 1.
BOX = {
    "rho_r0": (0.38, 0.72, False),
    "E_bar": (28, 600, True),
    "nu": (0.05, 0.19, False),
    "Gamma_bar": (0.87, 1.95, True),
    "Lambda_bar": (0.0011, 0.25, True),
    "epsilon": (-0.15, 0.72, False),
    "epsilon_1": (0.8, 1.8, False),
    "eta": (5.3, 17.5, False),
    "xi": (4, 10.5, False),
    "zeta_over_eta": (0.52, 2.1, True),
    "omega_over_zeta": (0.88, 1.4, True),
    "xi_1": (0.08, 0.92, False),
}
# The box has corners that no powder comes near. At rho_r0; epsilon is negative at 0.4 for two powders of Table 4, which
# are then not pressed there.
BOUNDS = {
    "E_bar": (10, 700),
    "nu": (0.03, 0.45),
    "Gamma_bar": (0.4, 4),
    "Lambda_bar": (0.001, 0.5),
    "epsilon": (0.1, 1.2),
    "zeta": (4.3, 20.5),
}


def granules(u):
    p = {n: lo * (hi / lo) ** u[:, i] if log else lo + (hi - lo) * u[:, i] for i, (n, (lo, hi, log)) in enumerate(BOX.items())}
    d = p["rho_r0"] - REFERENCE
    zeta = p["zeta_over_eta"] * p["eta"]
    omega = p["omega_over_zeta"] * zeta
    xi_2 = (p["epsilon_1"] - p["epsilon"]) / (1 - REFERENCE)
    return {
        "rho_r0": p["rho_r0"],
        "E_bar": p["E_bar"] * np.exp((p["xi"] - p["eta"]) * d),
        "nu": p["nu"] + p["xi_1"] * d,
        "Gamma_bar": p["Gamma_bar"] * np.exp((zeta - p["eta"]) * d),
        "Lambda_bar": p["Lambda_bar"] * np.exp((omega - p["eta"]) * d),
        "epsilon": p["epsilon"] + xi_2 * d,
        "eta": p["eta"],
        "xi": p["xi"],
        "zeta": zeta,
        "omega": omega,
        "xi_1": p["xi_1"],
        "xi_2": xi_2,
    }


def candidates(seed, count):
    u = np.random.default_rng(seed).random((count, len(BOX)))
    g = granules(u)
    return u[np.all([(g[n] >= low) & (g[n] <= high) for n, (low, high) in BOUNDS.items()], axis=0)]


def spread(u, count):
    rows = [int(np.argmin(((u - 0.5) ** 2).sum(1)))]
    cost = np.zeros(len(u))
    while len(rows) < count:
        cost += np.exp(-2 * np.log(np.abs(u - u[rows[-1]]) + 1e-9).sum(1))
        cost[rows] = np.inf
        rows.append(int(np.argmin(cost)))
    return u[rows]


fresh = "fresh" in sys.argv
table = granules(candidates(2026, 200)[:30] if fresh else spread(candidates(SEED, CANDIDATES), ROWS))
print("# granules of powders like those of Edmans & Sinka, Table 4; values at rho_r0; drawn by powders.py" + " fresh" * fresh)
print(",".join(table))
for row in zip(*table.values()):
    print(",".join(f"{value:.5g}" for value in row))
