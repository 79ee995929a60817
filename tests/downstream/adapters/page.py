"""What docs/how-to/other-dem-codes.md says of the numbers of the example's card.

page.py PLATEN FOLDER
"""
import pathlib
import re
import subprocess
import sys

platen, out = sys.argv[1], pathlib.Path(sys.argv[2])
root = pathlib.Path(__file__).resolve().parents[3]
card = root / "examples/lammps/mcc-ph-200.toml"
page = (root / "docs/how-to/other-dem-codes.md").read_text()
said = subprocess.run([platen, "export", "parameters", card, "--radius", "1e-3", "--delta-bar", "0.2"], check=True, text=True,
                      stdout=subprocess.PIPE).stdout
if said not in page:
    sys.exit(f"the page does not say what the command says:\n{said}")
subprocess.run([platen, "export", "dem-engine", card, "-o", out], check=True, stdout=subprocess.DEVNULL)
off = re.search(r"force within (\S+ %) of the law", (out / "functions.cu").read_text()).group(1)
if f"how far it is off, {off} for the granule" not in page:
    sys.exit(f"the text is off by {off}, and the page says otherwise")
