"""Two spheres pressed, released and pressed further: the same numbers as `platen eval` for the same overlaps."""
import csv
import subprocess

from lammps import OUT, PLATEN, CARDS, card, dump_rows, lammps, near, start

R1, R2 = 1e-3, 0.8e-3


def eval_path(law_card, overlaps, *more):
    path = OUT / "path.csv"
    path.write_text("overlap_m\n" + "".join(f"{o!r}\n" for o in overlaps))
    text = subprocess.run([PLATEN, "eval", law_card, "-p", f"radius_m={R1!r}", *more, "--path", path], check=True,
                          text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    return list(csv.DictReader(text.splitlines()))


def compare(law, units, R, accuracy):
    """The second sphere comes, goes, and comes again further."""
    global most
    length, force = {"si": (1.0, 1.0), "cgs": (1e-2, 1e-5)}[units]
    law_card = card(law)
    gap, depth = 1e-5, 4e-4
    folder, _ = lammps(f"two-{law}-{units}-{R}", start(f"{-5e-3/length} {5e-3/length} " * 3, units=units) + f"""
create_atoms 1 single 0 0 0
create_atoms 1 single {(R1 + R + gap)/length!r} 0 0
set atom 1 diameter {2*R1/length!r}
set atom 2 diameter {2*R/length!r}
set group all density {1500 if units == "si" else 1.5}
pair_style platen
pair_coeff 1 1 {law_card}
timestep 1e-4
group second id 2
variable move equal {-depth/length!r}*v_t*(1-0.6*sin(PI*v_t*3)^2)
variable t equal step/300
variable rate equal 0
fix move second move variable v_move NULL NULL v_rate NULL NULL
compute contact all pair/local dist p1 p2 p3 p4 p5
dump contacts all local 1 contacts.txt index c_contact[*]
dump_modify contacts format line "%d %.17g %.17g %.17g %.17g %.17g %.17g"
thermo 300
run 300
""")
    rows = [frame[0] for frame in dump_rows(folder / "contacts.txt") if frame]
    rows = [row for row in rows if row[2] > 0]
    assert len(rows) > 150, f"{law}: only {len(rows)} steps in contact"
    touched = [row[2] * length for row in rows]
    assert any(b < a for a, b in zip(touched, touched[1:])), "nothing was unloaded"
    both = eval_path(law_card, touched, "-p", f"radius2_m={R!r}")
    for row, other in zip(rows, both):
        scale = (force, length, force / length**2, force * length)
        for value, key, unit in zip(row[3:], ("force_N", "contact_radius_m", "mean_pressure_Pa", "dissipated_work_J"), scale):
            largest = max(float(r[key]) for r in both)
            sensitive = key in ("contact_radius_m", "mean_pressure_Pa")
            if accuracy > 1e-9 and sensitive and float(other["force_N"]) < 0.05 * max(float(r["force_N"]) for r in both):
                continue
            near(f"{law} {units} {key} at {row[2]}, radius {R}", value * unit, float(other[key]), 0, accuracy * largest)
            most = max(most, abs(value * unit - float(other[key])) / largest if largest else 0)


# Of equal spheres the same table; of others the next of 512 values of A R_e (law/pair.hpp). Near the parting mean pressure
# and radius go with the root of what is left of the overlap: they are looked at where 5 % of the force is left.
for R, accuracy in ((R1, 1e-10), (R2, 3e-3)):
    most = 0.0
    for law in CARDS:
        compare(law, "si", R, accuracy)
    compare("edmans-sinka", "cgs", R, accuracy)
    print(f"radius of the second {R}: largest difference from platen eval {most:.1e} of the largest value")
