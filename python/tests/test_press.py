import _thread
import threading
import time

import numpy as np
import pytest

import platen


def test_a_press_gives_its_curve_and_fields(pressed):
    curve = pressed.curve
    assert curve.notes.radius_m == 1e-3 and curve.notes.material == "metal"
    assert curve.delta_bar.max() == pytest.approx(0.1) and curve["force_N"].shape == (len(curve),)
    assert set(curve.branch) == {"loading", "unloading"}
    assert np.all(np.diff(curve.loading["force_N"]) > 0)
    assert [field.delta_bar for field in pressed.fields] == pytest.approx([0.05, 0.1])
    field = pressed.fields[-1]
    elements = len(field.elements)
    assert field.elements.max() < len(field.nodes_m) == len(field.displacement_m)
    for name in ("zone", "p_Pa", "q_Pa", "sigma_zz_Pa", "rho_r", "plastic_hencky_strain_q"):
        assert field[name].shape == (elements,)
    # The pole has moved to the plane, and the particle was a millimetre.
    assert field.nodes_m[:, 1].max() == pytest.approx(0.9e-3, rel=1e-3)
    assert np.linalg.norm(field.nodes_m - field.displacement_m, axis=1).max() == pytest.approx(1e-3)
    assert field.q_Pa.max() == pytest.approx(20e6, rel=0.05)
    assert pressed.summary.material if "material" in pressed.summary else pressed.summary


def test_files_of_vtk(pressed):
    paths = pressed.write_vtu("fields")
    assert [path.rsplit("/")[-1] for path in paths] == ["fields-0.05.vtu", "fields-0.1.vtu", "fields.pvd"]
    assert "UnstructuredGrid" in open(paths[0]).read()


def test_a_law_of_a_press_lies_on_its_curve(pressed):
    law = pressed.fit()
    assert law.error.l2 < 0.01 and law.curve is pressed.curve
    contact = law.on_plane(radius=1e-3)
    loading = pressed.curve.loading
    at = loading["delta_bar"] > 0.01
    force = contact(loading["delta_m"]).force
    assert force[at] == pytest.approx(loading["force_N"][at], rel=0.02)
    again = pressed.curve.fit()
    assert np.array_equal(again.parameters.F_bar, law.parameters.F_bar)
    assert pressed.fit("edmans-sinka").name == "edmans-sinka"


def test_a_curve_is_saved_and_loaded(pressed):
    pressed.curve.save("curve.csv")
    again = platen.Curve.load("curve.csv")
    assert again.text == pressed.curve.text
    assert platen.fit("curve.csv").parameters.keys() == pressed.fit().parameters.keys()


def test_the_resolved_case_presses_the_same_again(pressed):
    assert platen.press(pressed.case).curve.text == pressed.curve.text


def test_derive_presses_and_fits():
    metal = platen.von_mises(sigma_y=20e6, E=2e9, nu=0.3, name="metal")
    seen = []
    law = metal.derive(delta_bar_max=0.05, elements=100, unload_from=[], progress=lambda *step: seen.append(step))
    assert law.name == "pressed" and law.curve is not None and law.valid.delta_bar == (0, 0.05)
    assert seen[-1][0] == pytest.approx(1) and seen[-1][1] == pytest.approx(0.05)


def test_progress_is_a_bar_on_standard_error(capsys):
    metal = platen.von_mises(sigma_y=20e6, E=2e9, nu=0.3)
    metal.press(delta_bar_max=0.02, elements=100, progress=True)
    assert "100 %" in capsys.readouterr().err


def long_press(progress=False):
    return platen.von_mises(sigma_y=20e6, E=2e9, nu=0.3).press(elements=20000, progress=progress)


def test_what_the_progress_function_raises_ends_the_press():
    def stop(fraction, delta_bar, force):
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        long_press(stop)


def test_ctrl_c_ends_a_press():
    timer = threading.Timer(0.5, _thread.interrupt_main)
    timer.start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        long_press()
    assert time.monotonic() - start < 20


def test_other_threads_run_while_it_presses():
    turns, done = 0, threading.Event()
    thread = threading.Thread(target=lambda: (platen.von_mises(sigma_y=20e6, E=2e9, nu=0.3).press(delta_bar_max=0.1, elements=400), done.set()))
    thread.start()
    while not done.is_set():
        turns += 1
        time.sleep(1e-3)
    thread.join()
    assert turns > 20
