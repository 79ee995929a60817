"""The force model of `platen export dem-engine` inside DEM-Engine, beside the engine's own. Needs an NVIDIA GPU and deme[cuda12] of PyPI.

dem_engine.py spheres MODEL OUT [LOCK]              spheres pressed, let go and pressed again: OUT/spheres.csv
dem_engine.py bed platen|hertz MODEL OUT N [LOCK]   a bed of N particles: steps a second, OUT/bed-….json
dem_engine.py compare PLATEN CARD MODEL OUT         spheres.csv against `platen eval`; fails where they differ

MODEL: the folder of `platen export dem-engine CARD -o MODEL`; for spheres without damping, of which `eval` knows nothing (restitution 1, the
default). LOCK: a file that two runs do not hold at once, while they are timed.
"""
import csv
import fcntl
import importlib.util
import json
import pathlib
import re
import subprocess
import sys
import time

R, DENSITY = 1e-3, 1500.0
WITHIN = 1e-6  # of the largest force: the engine adds forces up in float


def mass(radius):
    return DENSITY * 4 / 3 * 3.141592653589793 * radius**3


def held(lock):
    """Nobody else is timed until this process lets go."""
    file = open(lock or "/dev/null", "w")
    if lock:
        fcntl.flock(file, fcntl.LOCK_EX)
    return file


def exported(folder):
    spec = importlib.util.spec_from_file_location("platen_model", pathlib.Path(folder) / "platen_model.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def new_solver(box, step):
    import deme

    solver = deme.DEMSolver(1)
    solver.SetVerbosity("WARNING")
    solver.InstructBoxDomainDimension(*box)
    solver.SetInitTimeStep(step)
    material = solver.LoadMaterial({"E": 1.842e8, "nu": 0.1472, "CoR": 0.5, "mu": 0.3, "Crr": 0.0})
    return solver, material


def way(top):
    """In, half out, in farther, nearly out, in and farther, out and apart."""
    ends = [0, top, 0.8 * top, 1.3 * top, 0.95 * top, 2 * top, -0.1 * top]
    return [a + (b - a) * (i + 0.37) / 25 for a, b in zip(ends, ends[1:]) for i in range(25)]


def spheres(folder, out, lock=None):
    """Each contact is moved from outside. The overlap that the engine hands over is read back from two numbers more in its memory."""
    exported_model = exported(folder)
    solver, material = new_solver(((-0.02, 0.02), (-0.02, 0.02), (-0.02, 0.02)), 1e-9)
    solver.InstructBoxDomainBoundingBC("none", material)
    exported_model.MODEL += "\nseen = (float)overlapDepth; seen_rest = (float)(overlapDepth - (double)seen);\n"
    exported_model.WILDCARDS = exported_model.WILDCARDS | {"seen", "seen_rest"}
    exported_model.use_platen(solver)
    solver.SetCDUpdateFreq(0)
    solver.SetExpandFactor(0.3 * R)
    contacts = {"equal": (R, R, -8e-3), "unlike": (R, 0.6 * R, 0.0), "plane": (R, None, 8e-3)}
    moved = {}
    for name, (R1, R2, x) in contacts.items():
        if R2 is None:
            solver.AddBCPlane([0, 0, -1.5 * R], [0, 0, 1], material)
        else:  # high above the plane
            lower = solver.AddClumps(solver.LoadSphereType(mass(R2), R2, material), [[x, 0, 5e-3]])
        upper = solver.AddClumps(solver.LoadSphereType(mass(R1), R1, material), [[x, 0, 9e-3 if R2 else 0]])
        moved[name] = [(upper, lambda h, x=x, R1=R1, R2=R2: [x, 0, 5e-3 + R1 + R2 - h] if R2 else [x, 0, -1.5 * R + R1 - h])]
        if R2 is not None:
            moved[name].append((lower, lambda h, x=x: [x, 0, 5e-3]))
    tracked = {name: [(solver.Track(body), place) for body, place in bodies] for name, bodies in moved.items()}
    solver.Initialize()
    print("ready", flush=True)
    wait = held(lock)
    rows = []
    for overlap in way(0.05 * R):
        for bodies in tracked.values():
            for tracker, place in bodies:
                tracker.SetPos(place(overlap))
                tracker.SetVel([0, 0, 0])
        solver.DoDynamicsThenSync(1e-9)
        info = solver.GetContactDetailedInfo()
        pairs, forces = list(zip(info.GetAOwner(), info.GetBOwner())), info.GetForce()
        seen, rest = info.Get("seen"), info.Get("seen_rest")
        for name, bodies in tracked.items():
            upper = bodies[0][0].GetOwnerID()
            mine = [i for i, pair in enumerate(pairs) if upper in pair]
            if len(mine) != 1:
                continue
            (i,) = mine
            force = sum(c * c for c in forces[i]) ** 0.5
            rows.append({"contact": name, "overlap_m": repr(seen[i] + rest[i]), "force_N": repr(force)})
    wait.close()
    with open(pathlib.Path(out) / "spheres.csv", "w", newline="") as file:
        table = csv.DictWriter(file, ["contact", "overlap_m", "force_N"])
        table.writeheader()
        table.writerows(rows)
    print(f"spheres: {len(rows)} rows")


def bed(law, folder, out, N, lock=None):
    """A cubic lattice of spheres between six walls, in touch from the beginning, that rattle and settle."""
    step, N = 1e-6, int(N)
    wide = round(N ** (1 / 3))
    gap = 2 * R * (1 - 2e-3)
    points = []
    while len(points) < N:  # simple cubic, 6 neighbours each
        n = len(points)
        points.append([(n % wide + 0.5) * gap, (n // wide % wide + 0.5) * gap, (n // wide**2 + 0.5) * gap])
    top = points[-1][2] + gap
    solver, material = new_solver(((0, wide * gap), (0, wide * gap), (0, top)), step)
    solver.InstructBoxDomainBoundingBC("all", material)
    solver.SetGravitationalAcceleration([0, 0, -9.81])
    if law == "platen":
        exported(folder).use_platen(solver)
    else:
        solver.UseFrictionalHertzianModel()
    solver.AddClumps(solver.LoadSphereType(mass(R), R, material), points)
    solver.SetMaxVelocity(1)  # the same lists of neighbours for both laws
    solver.SetCDUpdateFreq(40)
    solver.DisableAdaptiveUpdateFreq()
    solver.DisableAdaptiveBinSize()
    begin = time.perf_counter()
    solver.Initialize()
    solver.DoDynamicsThenSync(500 * step)
    result = {"law": law, "particles": N, "compiled_s": round(time.perf_counter() - begin, 2), "steps_per_s": []}
    print("ready", flush=True)
    for _ in range(6):
        wait = held(lock)
        begin = time.perf_counter()
        solver.DoDynamicsThenSync(1000 * step)
        result["steps_per_s"].append(round(1000 / (time.perf_counter() - begin), 1))
        wait.close()
    result["pairs_listed"] = solver.GetNumContacts()
    result["contacts"] = len(solver.GetContactDetailedInfo(1e-12).GetAOwner())
    result["seconds_simulated"] = solver.GetSimTime()
    (pathlib.Path(out) / f"bed-{law}-{N}.json").write_text(json.dumps(result) + "\n")
    print(json.dumps(result), flush=True)
    solver.ShowTimingStats()


def compare(platen, card, folder, out):
    """Fails where a contact has fewer rows than steps, or a force is off."""
    out = pathlib.Path(out)
    promised = float(re.search(r"force within ([0-9.e-]+) %", (pathlib.Path(folder) / "functions.cu").read_text()).group(1)) / 100
    rows = list(csv.DictReader(open(out / "spheres.csv")))
    wrong = False
    for name, options, within in (
        ("equal", ["-p", f"radius_m={R!r}"], WITHIN),
        ("plane", ["-p", f"radius_m={R!r}", "--against", "plane"], WITHIN),
        ("unlike", ["-p", f"radius_m={R!r}", "-p", f"radius2_m={0.6 * R!r}"], 1.5 * promised + WITHIN),
    ):
        ours = [row for row in rows if row["contact"] == name]
        (out / "path.csv").write_text("overlap_m\n" + "".join(row["overlap_m"] + "\n" for row in ours))
        done = subprocess.run([platen, "eval", card, *options, "--path", out / "path.csv"], check=True, text=True, stdout=subprocess.PIPE)
        theirs = [float(row["force_N"]) for row in csv.DictReader(done.stdout.splitlines())]
        largest = max(theirs)
        off = max(abs(float(row["force_N"]) - F) for row, F in zip(ours, theirs)) / largest
        print(f"{name}: {len(ours)} steps, largest force {largest:.4g} N, within {off:.1e} of it")
        wrong |= len(ours) < len(way(1)) - 8 or not off < within
    if wrong:
        sys.exit("the forces inside DEM-Engine are not those of platen eval")


if __name__ == "__main__":
    {"spheres": spheres, "bed": bed, "compare": compare}[sys.argv[1]](*sys.argv[2:])
