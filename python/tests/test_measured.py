import pickle
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


@pytest.fixture
def beads(pressed):
    return pressed.as_measured("beads.csv", particles=3, noise=0.005)


def test_a_material_is_calibrated_as_by_the_command(beads, command):
    asked = {"sigma_y": [20e6, 1000.0], "E": [2e9, 2e9]}
    found = platen.calibrate(beads, material="von-mises", nu=0.3, asked=asked, profiles=True)
    open("asked.csv", "w").write("sigma_y_Pa,E_Pa\n20e6,2e9\n1000,2e9\n")
    line = [command, "calibrate", beads, "--material", "von-mises", "--nu", "0.3", "-o", "theirs.toml", "--law-card", "law.toml",
            "--ask", "asked.csv", "--tell", "told.csv", "--profiles"]  # fmt: skip
    words = subprocess.run(line, check=True, capture_output=True, text=True).stdout
    assert str(found) == words and found.material.parameters == platen.Material.load("theirs.toml").parameters
    assert found.law == platen.Law.load("law.toml")
    assert found.parameters["sigma_y_Pa"] == pytest.approx(20e6, rel=0.05)  # of which the press was
    profile = found.profiles["sigma_y_Pa"]
    assert profile.low < found.parameters["sigma_y_Pa"] < profile.high and profile.deviance.min() == pytest.approx(0, abs=1e-6)
    theirs = np.genfromtxt("told.csv", delimiter=",", names=True, comments="#")
    assert found.told["deviance"] == pytest.approx(theirs["deviance"]) and np.isinf(found.told["deviance"][1])
    assert len(found.told_forces[0]) == 3 and found.told_forces[1] == [] and "von-mises" in repr(found)
    assert str(pickle.loads(pickle.dumps(found))) == str(found)


def test_a_material_is_calibrated_by_presses_that_are_kept(pressed):
    beads = pressed.as_measured("beads.csv", noise=0.005)
    said = []
    found = platen.calibrate(beads, material="von-mises", nu=0.3, by_presses=True, store="kept", workers=2, progress=said.append)
    assert found.parameters["sigma_y_Pa"] == pytest.approx(20e6, rel=0.05) and len(said) > 1

    def stop(sentence):
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        platen.calibrate(beads, material="von-mises", nu=0.25, by_presses=True, store="other", progress=stop)


@pytest.mark.filterwarnings("ignore::platen.Warning")
def test_a_law_of_one_loading_is_not_for_confinement(beads):
    with pytest.raises(platen.InvalidInput, match="knows one loading only"):
        platen.calibrate(beads, "hertz", nu=0.3, confined=True, despite_doubts=True)


@pytest.mark.parametrize(
    "call, sentence",
    [
        (lambda f: platen.calibrate(f, nu=0.3), "law is required"),
        (lambda f: platen.calibrate(f, "hertz", material="elastic"), "give one of the two"),
        (lambda f: platen.calibrate(f, "hertz", nu=0.3, by_presses=True), "by_presses is for a material"),
        (lambda f: platen.calibrate(f, "hertz", nu=0.3, free=["E"]), "free is for a material"),
        (lambda f: platen.calibrate(f, material="von-mises", nu=0.3, variant="c1"), "variant is for a law"),
        (lambda f: platen.calibrate(f, material="von-mises"), "nu is missing"),
        (lambda f: platen.calibrate(f, material="vmdc"), "--material CARD"),
        (lambda f: platen.calibrate(f, material="von-mises", nu=0.3, asked={"E": [2e9]}), "there is no sigma_y_Pa"),
        (lambda f: platen.calibrate(f, material="von-mises", nu=0.3, asked={"colour": [2e9]}), "colour is not looked for"),
        (lambda f: platen.calibrate(f, material="von-mises", nu=0.3, asked={"E": [2e9], "sigma_y": [1, 2]}), "has 2 numbers"),
        (lambda f: platen.calibrate(f, "hertz", nu=0.3), "did the particle break?"),
    ],
)
def test_sentences(beads, call, sentence):
    with pytest.raises(platen.InvalidInput) as raised:
        call(beads)
    assert sentence in str(raised.value)
