import subprocess

import numpy as np
import pytest

import platen


def test_a_file_of_a_machine_is_read(measured):
    m = platen.import_curve(measured / "s01_zwick_de.csv")
    assert len(m.particles) == 1 and m.particles[0].diameter_m > 0
    assert {"travel_m", "force_N", "branch"} <= set(m.curve.columns)
    assert "rows" in str(m)
    m.save("curve.csv")
    assert open("curve.csv").read() == m.curve.text


def test_import_writes_what_the_command_writes(measured, command):
    subprocess.run([command, "import", measured / "s01_zwick_de.csv", "-o", "theirs.csv"], check=True, capture_output=True)
    assert platen.import_curve(measured / "s01_zwick_de.csv").curve.text == open("theirs.csv").read()


def test_calibrate_finds_what_the_command_finds(measured, command):
    raw = measured / "s01_zwick_de.csv"
    found = platen.calibrate(raw, "shahin", nu=0.3)
    subprocess.run([command, "calibrate", raw, "--law", "shahin", "--nu", "0.3", "-o", "theirs.toml"], check=True, capture_output=True)
    assert found.law.parameters == platen.Law.load("theirs.toml").parameters
    assert found.R2 > 0.99 and set(found.parameters) == set(found.standard_errors)
    assert found.words == str(found) and "shahin" in repr(found)


def test_a_measured_curve_becomes_a_law(pressed):
    x, F = pressed.curve.loading["delta_m"], pressed.curve.loading["force_N"]
    np.savetxt("measured.csv", np.column_stack([x, F]), delimiter=",", header="delta_m,force_N", comments="")
    with pytest.warns(platen.Warning, match="says no reference stress"):
        law = platen.fit("measured.csv", "pressed", radius=1e-3, E=2e9, nu=0.3)
    assert law.on_plane(radius=1e-3)(x).force == pytest.approx(F, rel=0.03, abs=1e-3)
    with pytest.raises(platen.InvalidInput, match="radius_m"):
        platen.fit("measured.csv")
    with pytest.raises(platen.InvalidInput, match="E_Pa"):
        platen.fit("measured.csv", radius=1e-3, sigma_ref=2e7)
