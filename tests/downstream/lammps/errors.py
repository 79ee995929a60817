"""What cannot be is refused in one sentence; what leaves the validity of a card is said once and counted."""
import sys

from lammps import CARDS, OUT, card, lammps, start

GOOD = card("edmans-sinka")
TWO = """
create_atoms 1 single 0 0 0
create_atoms 1 single 1.99e-3 0 0
set group all diameter 2e-3
set group all density 1500
"""
BOX = start("-5e-3 5e-3 " * 3)


def refused(name, text, *words):
    _, said = lammps(name, text, check=False)
    lines = [line for line in said.splitlines() if line.startswith("ERROR")]
    if not lines or not all(word in lines[0] for word in words):
        sys.exit(f"{name}: {words} expected, got {lines or said[-1500:]}")


STYLE = f"pair_style platen\npair_coeff 1 1 {GOOD}\n"
refused("newton", BOX.replace("newton off", "newton on") + TWO + STYLE + "run 0\n", "newton pair off")
refused("atomic", BOX.replace("sphere", "atomic").replace("comm_modify vel yes", "")
        + "create_atoms 1 single 0 0 0\nmass 1 1\n" + STYLE + "run 0\n", "radius", "atom_style sphere")
refused("units", start("-5e-3 5e-3 " * 3, units="lj") + TWO + STYLE + "run 0\n", "units si or cgs")
refused("plane", BOX + "pair_style platen\npair_coeff 1 1 "
        + str(card("agarwal", "plane", CARDS["agarwal"] + '\nagainst = "plane"')) + "\n", "against a plane")
refused("radius", BOX + TWO + "pair_style platen\npair_coeff 1 1 "
        + str(card("agarwal", "radius", CARDS["agarwal"] + "\nradius_m = 2e-3")) + "\nrun 0\n", "does not cover", "0.001")
refused("missing", BOX + f"pair_style platen\npair_coeff 1 1 {OUT}/nothing.toml\n", "nothing.toml")
refused("unlike", BOX + TWO + f"pair_style platen\npair_coeff 1 1 {GOOD} {card('luding')}\nrun 0\n", "luding", "cannot be joined")
refused("restitution", BOX + f"pair_style platen\npair_coeff 1 1 {GOOD} damping 1.5\n", "(0, 1]")
refused("velocities", BOX.replace("comm_modify vel yes", "") + TWO + STYLE.replace("\n", " friction 0.3\n").replace(
    "platen friction 0.3", "platen") + "run 0\n", "comm_modify vel yes")
refused("wall", BOX + TWO + STYLE + f"fix wall all wall/platen {GOOD} plane q lo 0\n", "wall/platen")
for name, words in {"position": "plane x lo 1e999", "radius": "cylinder z 1e999", "mass": "plane x lo -1 force 1 mass 1e999",
                    "speed": "plane x lo -1 velocity 1e999"}.items():
    refused(f"infinite-{name}", BOX + TWO + STYLE + f"fix wall all wall/platen {GOOD} {words}\nrun 1\n", "1e999 is not finite")
refused("away", BOX + TWO + STYLE + f"fix wall all wall/platen {GOOD} plane x lo -1 force 1 mass 1e-300\ntimestep 1e9\nrun 2\n",
        "the wall's position is not finite any more")

narrow = card("edmans-sinka", "narrow", extra="\n[validity]\ndelta_bar = [0, 0.001]\n")
_, said = lammps("beyond", BOX + TWO + f"pair_style platen\npair_coeff 1 1 {narrow}\nfix m all nve/sphere\nrun 50\n")
warnings = [line for line in said.splitlines() if line.startswith("WARNING") and "validity" in line]
if len(warnings) != 2 or "1 contacts" not in warnings[1]:
    sys.exit(f"one warning and one count expected, got {warnings or said[-1500:]}")
