#!/bin/bash
# fields.sh PROGRAM PYTHON: the fields of a press as other programs read them. Exit 77 where meshio is missing.
set -eu
platen=$1
"$2" -c 'import meshio' 2>/dev/null || { echo 'python3-meshio is not installed'; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
printf '%s\n' 'platen = 1' 'experiment = "simple"' 'material = "base-case"' 'radius_m = 2e-3' '[path]' \
  'delta_bar_max = 0.1' '[mesh]' 'elements = 300' '[output]' 'fields_at = [0.05, 0.1]' >"$folder/case.toml"
"$platen" press "$folder/case.toml" -o "$folder/out" >/dev/null 2>&1

"$2" - "$folder/out" <<'PYTHON'
import csv, sys, xml.etree.ElementTree as xml
import meshio, numpy

out, R = sys.argv[1], 2e-3
series = [d.attrib for d in xml.parse(out + "/fields.pvd").iter("DataSet")]
assert [d["timestep"] for d in series] == ["0.05", "0.1"], series
for moment in series:
    delta_bar = float(moment["timestep"])
    mesh = meshio.read(out + "/" + moment["file"])
    (cells,) = mesh.cells
    assert cells.type == "quad" and len(cells.data) > 200
    value = {name: data[0] for name, data in mesh.cell_data.items()}
    x, u = mesh.points, mesh.point_data["displacement_m"]
    assert mesh.field_data["TimeValue"] == delta_bar

    # the shape: undeformed nodes lie in the sphere, deformed ones below the plane
    assert abs(numpy.hypot(*(x - u)[:, :2].T).max() / R - 1) < 1e-6
    assert x[:, 1].max() < R * (1 - delta_bar) * 1.001
    # volume by Pappus, positive where corners go around counter-clockwise
    r, z = (x[cells.data][:, :, i] for i in (0, 1))
    area = 0.5 * ((r[:, 2] - r[:, 0]) * (z[:, 3] - z[:, 1]) - (r[:, 3] - r[:, 1]) * (z[:, 2] - z[:, 0]))
    assert (area > 0).all()
    volume = 2 * numpy.pi * area * r.mean(axis=1)

    # stresses: p and q are means of the points' own, equal to those of the mean stress but for its spread
    rr, zz, rz, tt = (value[f"sigma_{k}_Pa"] for k in ("rr", "zz", "rz", "tt"))
    assert numpy.allclose(value["p_Pa"], (rr + zz + tt) / 3, rtol=1e-5, atol=1e-5 * abs(rr).max())
    q = numpy.sqrt(0.5 * ((rr - zz) ** 2 + (zz - tt) ** 2 + (tt - rr) ** 2) + 3 * rz**2)
    assert (q <= value["q_Pa"] * (1 + 1e-5)).all()

    # density follows the plastic volume strain; mass is what it was
    strain = value["plastic_hencky_strain_v"]
    assert numpy.allclose(value["rho_r"], 0.7 * numpy.exp(-strain), rtol=1e-5)
    mass = (volume * value["rho_r"]).sum() / (0.7 * 2 / 3 * numpy.pi * R**3)
    assert abs(mass - 1) < 0.02, mass  # elastic compression, and the straight edges of the mesh
    assert set(value["zone"]) <= {0, 1, 2, 3} and len(set(value["zone"])) > 1

    # the force through the edges on the equator, z = 0, is that of the curve
    on = z < 1e-9 * R
    edge = on.sum(axis=1) == 2
    squares = numpy.where(on, r**2, 0)[edge]
    ring = numpy.pi * (2 * squares.max(axis=1) - squares.sum(axis=1))
    force = -(zz[edge] * ring).sum()
    rows = csv.DictReader(line for line in open(out + "/curve.csv") if not line.startswith("#"))
    (wanted,) = [float(row["force_N"]) for row in rows if float(row["delta_bar"]) == delta_bar]
    print(f"delta_bar = {delta_bar}: {len(cells.data)} cells, mass {mass:.4f}, force {force / wanted:.4f} of the curve's")
    assert abs(force / wanted - 1) < 0.01
PYTHON

# the picture of ParaView, where it is, and a display for it
look=$(dirname "$0")/../../examples/look-inside.py
command -v pvbatch >/dev/null && command -v xvfb-run >/dev/null || exit 0
for field in zone rho_r; do
  if ! xvfb-run -a pvbatch "$look" "$folder/out" "$folder/$field.png" "$field" >"$folder/log" 2>&1; then
    grep -q 'bad X server' "$folder/log" && { echo 'there is no display for ParaView'; exit 0; }
    cat "$folder/log"
    exit 1
  fi
  [ "$(stat -c %s "$folder/$field.png")" -gt 20000 ] || { echo "the picture of $field is empty"; exit 1; }
done
