"""Random materials of every law on random paths: the same bits as the headers."""

import json
import pathlib
import subprocess

import numpy as np

import platen


def test_random_laws_are_those_of_the_headers(command):
    program = pathlib.Path(command).resolve().parent / "random_laws"  # ./run wheel builds it
    subprocess.run([program, "70", "."], check=True)
    laws = json.loads(pathlib.Path("laws.json").read_text())
    assert {law["law"] for law in laws} == set(platen.laws())
    for law in laws:
        out = platen.Law.load(law["card"]).pair(radius=law["radius_m"])(law["overlap_m"])
        for name, column in {
            "force": "force_N", "stiffness": "stiffness_N_per_m", "contact_radius": "contact_radius_m",
            "mean_pressure": "mean_pressure_Pa", "dissipated_work": "dissipated_work_J",
        }.items():  # fmt: skip
            assert np.array_equal(getattr(out, name), law[column]), (law["card"], name)
