"""Random materials of every law on random paths: LAMMPS and `platen eval` say what the headers say."""
import csv
import json
import subprocess

from lammps import OUT, PLATEN, dump_rows, lammps, near, start

COUNT = 70
QUANTITIES = {"force_N": 2, "contact_radius_m": 3, "mean_pressure_Pa": 4, "dissipated_work_J": 5}  # and their columns
subprocess.run([PLATEN.parent / "random_laws", str(COUNT), OUT], check=True)
laws = json.loads((OUT / "laws.json").read_text())
assert len(laws) == COUNT


def eval_path(law, overlaps):
    path = OUT / "path.csv"
    path.write_text("overlap_m\n" + "".join(f"{o!r}\n" for o in overlaps))
    text = subprocess.run([PLATEN, "eval", law["card"], "-p", f"radius_m={law['radius_m']!r}", "--path", path], check=True,
                          text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    rows = list(csv.DictReader(text.splitlines()))
    return {key: [float(row[key]) for row in rows] for key in (*QUANTITIES, "stiffness_N_per_m")}


for law in laws:
    for key, values in eval_path(law, law["overlap_m"]).items():
        assert values == law[key], f"eval {law['card']} {key}: {values} and {law[key]}"

# Each law has a type and two spheres of its own, which nothing moves but `set`. Where LAMMPS says that they are, eval is
# asked.
cell = 3 * max(law["radius_m"] for law in laws)
text = start(f"0 {4 * COUNT * cell} {-cell} {cell} {-cell} {cell}", types=COUNT)
place = [4 * (i + 0.5) * cell for i in range(COUNT)]
for i, law in enumerate(laws):
    for x in (place[i], place[i] + 2 * law["radius_m"]):
        text += f"create_atoms {i + 1} single {x!r} 0 0\n"
    text += f"set type {i + 1} diameter {2 * law['radius_m']!r}\n"
text += "set group all density 1500\npair_style platen\npair_coeff * * " + laws[0]["card"] + "\n"
text += "".join(f"pair_coeff {i + 1} {i + 1} {law['card']}\n" for i, law in enumerate(laws))
text += """
compute pairs all property/local ptype1
compute contacts all pair/local p1 p2 p3 p4 p5
dump contacts all local 1 contacts.txt c_pairs c_contacts[*]
dump_modify contacts format line "%.0f %.17g %.17g %.17g %.17g %.17g"
"""
steps = len(laws[0]["overlap_m"])
for step in range(steps):
    for i, law in enumerate(laws):
        text += f"set atom {2 * i + 2} x {place[i] + 2 * law['radius_m'] - law['overlap_m'][step]!r}\n"
    text += "run 1\n"
folder, _ = lammps("laws", text)
frames = dump_rows(folder / "contacts.txt")[1:]  # before the first step
assert len(frames) == steps and all(len(frame) == COUNT for frame in frames), f"{len(frames)} frames"
far = []  # of each law its largest difference, over the largest force, radius, pressure, and force times overlap
for i, law in enumerate(laws):
    rows = [next(row for row in frame if row[0] == i + 1) for frame in frames]
    answers = eval_path(law, [row[1] for row in rows])
    scale = {key: max(values) for key, values in answers.items()}
    scale["dissipated_work_J"] = scale["force_N"] * max(law["overlap_m"])
    far.append(max(abs(row[column] - value) / scale[key] for key, column in QUANTITIES.items()
                   for row, value in zip(rows, answers[key])))
near_enough = sum(difference <= 1e-12 for difference in far)
worst = max(range(COUNT), key=lambda i: far[i])
print(f"{near_enough} of {COUNT} laws to 1e-12, the worst to {far[worst]:.1e}: {laws[worst]['card']}")
# LAMMPS makes the table for R = 1. Where a last bit decides whether a cell is halved, both are within the tables' accuracy.
near("LAMMPS, the worst law", far[worst], 0, 0, 5e-5)
near("LAMMPS, laws to 1e-12", near_enough, COUNT, 0.15)
