"""Two spheres meet: what `restitution` promises of an elastic contact, that momentum is kept, and that friction turns them no
faster than Coulomb allows."""
import sys

from liggghts import START, card, dump_rows, liggghts

hertz = card("hertz", "E_Pa = 1e8\nnu = 0.3")
MEET = START.format(types=1) + """
create_atoms 1 single -1e-3 0 0 units box
create_atoms 1 single 1e-3 0 0 units box
set group all diameter 2e-3 density 1500
group left id 1
group right id 2
velocity left set 0.1 {slide} 0 units box
velocity right set -0.1 -{slide} 0 units box
variable law string {law}
fix friction all property/global coefficientFriction peratomtypepair 1 0.3
pair_style gran model platen tangential history restitution {e}
pair_coeff * *
timestep 2e-8
fix move all nve/sphere
dump out all custom 1000 out.dump id vx vy omegaz
dump_modify out format "%d %.17g %.17g %.17g" sort id
run 30000
"""
for e in (0.9, 0.5):
    folder, _ = liggghts(f"restitution-{e}", MEET.format(law=hertz, e=e, slide=0))
    (_, a, *_), (_, b, *_) = dump_rows(folder / "out.dump")[-1]
    print(f"restitution {e}: {-(a - b) / 0.2:.5f}")
    if abs(-(a - b) / 0.2 - e) > 1e-3 * e or abs(a + b) > 1e-12:
        sys.exit(f"restitution {e} is not what was asked for")

# sliding all the way: the impulse that turns a sphere, 2/5 m R omega, is mu times the normal one, m dv; while they touch, the normal
# turns by a hundredth
folder, _ = liggghts("slide", MEET.format(law=hertz, e=1, slide=0.25))
(_, ax, ay, wa), (_, bx, by, wb) = dump_rows(folder / "out.dump")[-1]
ratio = 0.4e-3 * abs(wa) / (0.1 - ax)
print(f"sliding: tangential over normal impulse {ratio:.4f}")
if not 0.29 < ratio < 0.305 or abs(ay + by) > 1e-12 or abs(wa - wb) > 1e-9 * abs(wa):
    sys.exit("friction is not Coulomb's")
