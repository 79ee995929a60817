"""What Python costs: a step of many contacts beside the same loop in C++, and the import.

contacts.py PROGRAM [COUNT], where PROGRAM is bench_python_contacts
"""

import subprocess
import sys
import tempfile
import time

import numpy as np

import platen


def least_ns(count, work):
    """The smallest of many times, of the processor: the machine may have other work."""
    least = float("inf")
    for _ in range(15):
        start = time.process_time()
        work()
        least = min(least, 1e9 * (time.process_time() - start) / count)
    return least


def overlaps(count, end):
    """As contacts.cpp draws them."""
    seed, mask, drawn = 1, (1 << 64) - 1, np.empty(count)
    for i in range(count):
        seed = (seed * 6364136223846793005 + 1442695040888963407) & mask
        drawn[i] = (seed >> 11) * 2.0**-53
    return end * drawn


def main():
    program, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 1_000_000
    law = platen.Material.load("mcc-ph-200").predict()
    contact = law.pair(radius=0.5e-3)
    drawn = overlaps(count, 0.2 / contact.delta_bar_per_overlap)
    with tempfile.NamedTemporaryFile(suffix=".toml") as card:
        law.save(card.name)
        loop = subprocess.run([program, card.name, "0.5e-3", str(count)], capture_output=True, text=True, check=True)
    cpp = [float(word) for word in loop.stdout.split()]
    print(f"{count} contacts, ns each            C++ loop   Python   ratio")
    for name, only, reference in (("force", ["force"], cpp[0]), ("all quantities", platen.QUANTITIES, cpp[1])):
        state = contact.new_state(count)
        out = contact.step(state, drawn, only=only)
        took = least_ns(count, lambda: contact.step(state, drawn, out=out))
        print(f"  {name:<28} {reference:10.2f} {took:8.2f} {took / reference:7.2f}")
        took = least_ns(count, lambda: contact.step(state, drawn, only=only))
        print(f"  {name + ', new arrays':<28} {reference:10.2f} {took:8.2f} {took / reference:7.2f}")
    empty, whole = (min(_seconds([sys.executable, "-c", line]) for _ in range(7)) for line in ("import numpy", "import platen"))
    start = min(_seconds([sys.executable, "-c", ""]) for _ in range(7))
    print(f"import platen: {whole - start:.3f} s, of which numpy {empty - start:.3f} s")


def _seconds(command):
    start = time.perf_counter()
    subprocess.run(command, check=True)
    return time.perf_counter() - start


if __name__ == "__main__":
    main()
