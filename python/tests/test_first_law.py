"""The lines of the tutorial."""

import numpy as np
import pytest

import platen


def test_from_a_material_to_a_law_to_arrays_of_contacts():
    granule = platen.Material.load("mcc-ph-200")
    law = granule.predict()
    assert 0 < law.error.l2 < 0.1
    assert law.valid.delta_bar[0] == 0 < law.valid.delta_bar[1] <= 0.5
    contact = law.pair(radius=0.5e-3, partner=law, partner_radius=0.3e-3)
    out = contact(np.linspace(0, 1e-4, 201))
    assert out.force.shape == out.contact_radius.shape == out.stiffness.shape == (201,)
    assert np.all(np.diff(out.force) > 0) and out.force[0] == 0
    state = contact.new_state(10_000)
    overlaps = np.linspace(1e-6, 1e-4, 10_000)
    loaded = contact.step(state, overlaps)
    unloaded = contact.step(state, 0.98 * overlaps)
    assert np.all(unloaded.force < loaded.force)
    law.save("law.toml")
    assert platen.Law.load("law.toml") == law
    lines = law.to_lammps(radius=0.3e-3, density=1500)
    assert "pair_style platen" in lines and "timestep" in lines


def test_plot_draws_law_unloading_and_curve(law, pressed):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("svg")
    ax = law.plot()
    assert len(ax.lines) == 4
    own = pressed.fit()
    assert len(own.plot().lines) == 5
    assert len(pressed.plot().lines) == 1
    ax.figure.savefig("law.svg")


def test_plot_without_matplotlib_says_what_to_install(law, monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(ImportError, match="pip install matplotlib"):
        law.plot()


def test_notebooks_show_pictures_and_tables(law, granule, pressed):
    for shown in (law, pressed, pressed.curve):
        assert "<svg" in shown._repr_html_() and "nan" not in shown._repr_html_()
    assert "Young's modulus" in granule._repr_html_() or "Young&#x27;s modulus" in granule._repr_html_()
    assert "pressed" in repr(law) and "MCC PH-200" in repr(granule)
    assert "E_Pa" in str(law) and "rho_r0" in str(granule)
