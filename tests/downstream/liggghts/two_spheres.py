"""Two spheres, and a sphere on a wall, pressed, released, pressed again and parted: forces of `platen eval` to 1e-9; those of
spheres of unlike radii, whose table is the next of 512 (dem/contacts.hpp), to 1e-3."""
import pathlib
import sys

from liggghts import OUT, START, card, dump_rows, evaluated, liggghts

R1, R2 = 1e-3, 0.6e-3
granule = pathlib.Path(__file__).resolve().parents[3] / "examples/lammps/mcc-ph-200.toml"
metal = card("similarity", "E_Pa = 5e8\nnu = 0.3\nkappa_Pa = 1e6\ninverse_m = 0.3")

WAY = """
timestep 1e-4
group led id 2
variable t equal step/100
variable x equal -4e-4*(v_t<1)*v_t-4e-4*(v_t>=1)*(v_t<2)*(1-2/3*(v_t-1))-4e-4*(v_t>=2)*(1/3+7/6*(v_t-2))*(v_t<3)-6e-4*(v_t>=3)*(4-v_t)
variable nothing equal 0
fix lead led move variable v_x NULL NULL v_nothing NULL NULL units box
dump out all custom 1 out.dump id x radius fx
dump_modify out format "%d %.17g %.17g %.17g" sort id
"""


def compared(name, law, overlaps, forces, *options, folder, within=1e-9):
    theirs = evaluated(folder, law, overlaps, *options)
    scale = max(theirs)
    worst = max(abs(a - b) for a, b in zip(forces, theirs)) / scale
    print(f"{name}: {len(overlaps)} steps, largest force {scale:.6g} N, worst difference {worst:.1e} of it")
    if not (worst < within and len(overlaps) > 300):
        sys.exit(f"{name}: the forces are not those of platen eval")


for name, law, radii in (("equal", granule, (R1, R1)), ("unequal", granule, (R1, R2)), ("metal", metal, (R1, R1)), ("ranks", granule, (R1, R1))):
    ranks = 2 if name == "ranks" else 1
    folder, _ = liggghts(name, f"processors {ranks} 1 1" + START.format(types=1) + f"""
create_atoms 1 single 0 0 0 units box
create_atoms 1 single {radii[0] + radii[1]!r} 0 0 units box
set atom 1 diameter {2 * radii[0]!r} density 1500
set atom 2 diameter {2 * radii[1]!r} density 1500
variable law string {law}
pair_style gran model platen
pair_coeff * *
{WAY}
run 400
""", ranks=ranks)
    frames = dump_rows(folder / "out.dump")
    pairs = [((a[2] + b[2]) - (b[1] - a[1]), -a[3], b[3]) for a, b in frames]
    touching = [row for row in pairs if row[0] > 0]
    overlaps = [row[0] for row in touching]
    for side in (1, 2):
        compared(f"{name}, sphere {side}", law, overlaps, [row[side] for row in touching], "-p", f"radius_m={radii[0]!r}",
                 "-p", f"radius2_m={radii[1]!r}", folder=folder, within=1e-9 if radii[0] == radii[1] else 1e-3)

# two materials: the sphere of the first type may come first or second
for name, types in (("unlike", (1, 2)), ("unlike-turned", (2, 1))):
    folder, _ = liggghts(name, START.format(types=2) + f"""
create_atoms {types[0]} single 0 0 0 units box
create_atoms {types[1]} single {2 * R1!r} 0 0 units box
set group all diameter {2 * R1!r} density 1500
variable law_1 string {granule}
variable law_2 string {metal}
pair_style gran model platen
pair_coeff * *
{WAY}
run 400
""")
unlike = [[(a[2] + b[2] - (b[1] - a[1]), b[3]) for a, b in dump_rows(OUT / name / "out.dump")] for name in ("unlike", "unlike-turned")]
if unlike[0] != unlike[1] or max(force for _, force in unlike[0]) <= 0:
    sys.exit("which of two unlike spheres comes first changes the force")

folder, _ = liggghts("wall", START.format(types=1) + f"""
create_atoms 1 single -4e-3 0 0 units box
create_atoms 1 single 0 0 0 units box
set group all diameter {2 * R1!r} density 1500
variable law string {granule}
pair_style gran model platen
pair_coeff * *
fix wall all wall/gran model platen primitive type 1 xplane {-R1!r}
group other id 1
fix nothing other move linear 0 0 0
{WAY}
run 400
""")
rows = [(b[2] - abs(b[1] + R1), b[3]) for _, b in dump_rows(folder / "out.dump")]
touching = [row for row in rows if row[0] > 0]
compared("wall", granule, [row[0] for row in touching], [row[1] for row in touching], "-p", f"radius_m={R1!r}", "--against", "plane",
         folder=folder)
