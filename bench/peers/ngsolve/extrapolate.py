#!/usr/bin/env python3
"""Two curves of von_mises.py or vmdc.py with steps c and c/2, to steps of zero; at delta_bar itself, not less the penetration.

    extrapolate.py c4.csv c2.csv [finer_mesh_c4.csv]     # the third: its mesh, the step error of the first two
"""
import csv
import sys


def read(name):
    return [[float(v) for v in row.values()] for row in csv.DictReader(l for l in open(name) if l[0] != "#")]


def at_overlap(rows):                              # F over delta less penetration, moved to delta
    out = []
    for i, (d, e, F, a) in enumerate(rows):
        j, k = max(i - 1, 0), min(i + 1, len(rows) - 1)
        slope = (rows[k][2] - rows[j][2]) / (rows[k][1] - rows[j][1])
        slope_a = (rows[k][3] - rows[j][3]) / (rows[k][1] - rows[j][1])
        out.append((d, F + slope * (d - e), a + slope_a * (d - e)))
    return out


one, two = (at_overlap(read(f)) for f in sys.argv[1:3])
base = at_overlap(read(sys.argv[3])) if len(sys.argv) > 3 else one
print("delta_bar   F_bar   a_bar   (step error of the first: F, a, %)")
for (d, F1, a1), (_, F2, a2), (_, F, r) in zip(one, two, base):
    f, g = 2 * F2 / F1 - 1, 2 * a2 / a1 - 1
    print(f"{d:9.3f} {F * f:7.4f} {r * g:7.4f}   {100 * (1 / f - 1):+.2f} {100 * (1 / g - 1):+.2f}")
