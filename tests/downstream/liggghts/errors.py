"""What is wrong ends the run with a sentence."""
import sys

from liggghts import START, card, liggghts

TWO = START.format(types=1) + """
create_atoms 1 single 0 0 0 units box
create_atoms 1 single 2e-3 0 0 units box
set group all diameter 2e-3 density 1500
{}
pair_style gran model platen {}
pair_coeff * *
fix still all move linear 0 0 0
run 1
"""
hertz = card("hertz", "E_Pa = 1e8\nnu = 0.3")
for name, law, options, sentence in (
    ("none", "", "", "no law for particles of type 1; say: variable law_1 string CARD"),
    ("missing", "variable law string nowhere.toml", "", "nowhere.toml"),
    ("restitution", f"variable law string {hertz}", "restitution 2", "is not a restitution coefficient in (0, 1]"),
    ("infinite", f"variable law string {hertz}", "restitution 1e999", "is not a restitution coefficient in (0, 1]"),
    ("no-number", f"variable law string {hertz}", "restitution nan", "is not a restitution coefficient in (0, 1]"),
    ("plane", f"variable law string {card('hertz', 'E_Pa = 1e8' + chr(10) + 'nu = 0.3' + chr(10) + 'against = ' + chr(34) + 'plane' + chr(34), 'plane')}",
     "", "the card is for a sphere against a plane"),
    ("cohesion", f"variable law string {hertz}", "cohesion sjkr", "Unknown normal model"),
):
    _, said = liggghts(name, TWO.format(law, options), check=False)
    if sentence not in said:
        sys.exit(f"{name}: no '{sentence}' in\n{said[-2000:]}")
