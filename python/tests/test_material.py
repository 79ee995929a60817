import subprocess

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
