import json
import pathlib
import pickle
import subprocess

import numpy as np
import pytest

import platen


@pytest.mark.parametrize("name", platen.materials())
def test_every_material_of_the_catalogue_can_be_written_in_python(name):
    material = platen.Material.load(name)
    make = getattr(platen, material.model.replace("-", "_"))
    if "hardening" in material.text:
        pytest.skip("its hardening is a table")
    again = make(name=material.name, **material.parameters)
    assert again == material and again.parameters == material.parameters


def test_keywords_take_si_or_ratios():
    metal = platen.von_mises(sigma_y=20e6, E=2e9, nu=0.3)
    assert metal == platen.von_mises(sigma_y_Pa=20e6, E_bar=100, nu=0.3)
    assert metal.E == 2e9 and metal.nu == 0.3 and metal.sigma_ref == 20e6 and metal.density is None
    lead = platen.von_mises(E=16e9, nu=0.43, hardening={"kind": "hollomon", "kappa": 3e7, "inverse_m": 0.2}, density=11300)
    assert lead.density == 11300 and lead.sigma_ref == 3e7


def test_cards_are_saved_and_loaded(granule):
    granule.save("card.toml")
    assert platen.Material.load("card.toml") == granule
    assert granule.sources["default"].startswith("Edmans & Sinka")


def test_predict_is_what_the_command_predicts(command, granule):
    granule.predict().save("ours.toml")
    subprocess.run([command, "predict", "mcc-ph-200", "-o", "theirs.toml"], check=True, capture_output=True)
    assert open("ours.toml").read() == open("theirs.toml").read()
    law = granule.predict("edmans-sinka", variant="c1")
    assert law.name == "edmans-sinka" and law.variant == "c1" and len(law.near) == 3


def test_outside_of_what_was_pressed_it_is_refused_unless_asked_to_guess():
    strange = platen.von_mises(sigma_y=1e6, E=1e12, nu=0.3)
    with pytest.raises(platen.InvalidInput, match="outside of what was pressed"):
        strange.predict()
    with pytest.warns(platen.Warning, match="extrapolated"):
        strange.predict(extrapolate=True)


def test_another_surface_through_the_same_strengths(granule):
    assert granule.as_model("dpc").model == "dpc"
    with pytest.raises(platen.InvalidInput):
        granule.as_model("nothing")


def test_section_of_a_rock():
    rock = {"E": 10e9, "nu": 0.38, "beta": 47.84, "sigma_c": 10.61e6}
    assert "flow_stress_ratio = 0.778" in platen.drucker_prager(**rock, flow_stress_ratio=0.778).text
    with pytest.raises(platen.InvalidInput, match="flow_stress_ratio"):
        platen.drucker_prager(**rock, flow_stress_ratio=0.7)


def test_a_powder_from_compaction_is_that_of_the_command(command, tmp_path):
    example = pathlib.Path(__file__).parents[2] / "examples/compaction.sh"
    if not example.is_file():
        pytest.skip("the source tree is not here")
    words = subprocess.run([example, command, tmp_path], check=True, capture_output=True, text=True).stdout
    powder = platen.Material.from_compaction("die.csv", "tablets.csv", rho_r0=0.45, model="dpc")
    theirs = platen.Material.load("powder.toml")
    assert powder == theirs and powder.sources == theirs.sources and "regression" in powder.sources["sigma_y_Pa"]
    assert words.startswith("\n".join(powder.remarks))
    assert powder.parameters.sigma_y_Pa == pytest.approx(9e6, rel=0.02)  # of the powder of the example
    for call, sentence in (
        (lambda: platen.Material.from_compaction("die.csv", "tablets.csv", rho_r0=2), "must be in"),
        (lambda: platen.Material.from_compaction("die.csv", "tablets.csv", rho_r0=0.45, model="elastic"), "vmdc or dpc"),
        (lambda: platen.Material.from_compaction("die.csv", "die.csv", rho_r0=0.45), "there is no column compressive_strength"),
        (lambda: platen.Material.from_compaction("none.csv", "die.csv", rho_r0=0.45), "none.csv"),
    ):
        with pytest.raises(platen.InvalidInput, match=sentence):
            call()


@pytest.mark.parametrize("name", ["mcc-ph-200", "wang-type-1"])
def test_what_is_known_of_a_prediction_is_what_the_command_says(name, command):
    line = [command, "predict", name, "-o", "theirs.toml", "--json"]
    theirs = json.loads(subprocess.run(line, check=True, capture_output=True, text=True).stdout)
    law = platen.Material.load(name).predict()
    for key, value in law.prediction.items():
        assert theirs[key] == (pytest.approx(value) if isinstance(value, (float, np.ndarray)) else value), key
    assert {"platen", "material", "nearest_runs", "left_out"} >= set(theirs) - set(law.prediction)
    assert pickle.loads(pickle.dumps(law)).prediction.verdict == law.prediction.verdict


def test_a_yield_stress_from_what_people_know(command):
    line = [command, "predict", "--E_Pa", "2e9", "--nu", "0.3"]
    subprocess.run([*line, "--hardness_Pa", "56e6", "-o", "hardness.toml"], check=True, capture_output=True)
    sigma_y = platen.yield_from_hardness(E=2e9, nu=0.3, hardness=56e6)
    assert sigma_y == pytest.approx(20e6)  # Tabor: H = 2.8 sigma_y
    assert platen.yield_from_heckel(E=2e9, nu=0.3, pressure=60e6) == pytest.approx(20e6)  # Heckel: P_y = 3 sigma_y
    assert platen.von_mises(sigma_y=sigma_y, E=2e9, nu=0.3).predict().parameters.sigma_ref_Pa == pytest.approx(
        platen.Law.load("hardness.toml").parameters.sigma_ref_Pa)  # fmt: skip
    ball = platen.von_mises(sigma_y=20e6, E=2e9, nu=0.3).predict().on_plane(radius=1e-3)
    found = platen.yield_from_crushing(E=2e9, nu=0.3, force=ball(1e-4).force, overlap=1e-4, radius=1e-3)
    assert found == pytest.approx(20e6, rel=0.01)


def test_a_granule_from_indices(command):
    indices = {"strain": 0.02, "bonding": 0.01, "hardness": 56e6}
    granule = platen.Material.from_indices(**indices, relative_density=0.7)
    parameters = granule.parameters
    assert parameters.Gamma_Pa == pytest.approx(20e6)
    assert parameters.E_Pa / (1 - parameters.nu**2) == pytest.approx(56e6 / 0.02)
    line = [command, "predict", "--strain_index", "0.02", "--bonding_index", "0.01", "--hardness_Pa", "56e6"]
    subprocess.run([*line, "--relative_density", "0.7", "-o", "indices.toml"], check=True, capture_output=True)
    assert granule.predict().parameters.F_bar == pytest.approx(platen.Law.load("indices.toml").parameters.F_bar)
    with pytest.raises(platen.InvalidInput, match="shear strength"):
        platen.Material.from_indices(**{**indices, "bonding": 0.5}, relative_density=0.7)


def test_keys_are_those_of_the_command(command):
    for of, line in {"material": ["materials"], "case": ["press"], "study": ["study", "design"]}.items():
        assert platen.keys(of) == subprocess.run([command, *line, "--keys"], check=True, capture_output=True, text=True).stdout
