import os
import pathlib
import shutil
import signal

import pytest

import platen

# A shell that starts tests in the background ignores Ctrl-C for them; the tests of Ctrl-C want it.
signal.signal(signal.SIGINT, signal.default_int_handler)

ROOT = pathlib.Path(__file__).parents[2]


@pytest.fixture(autouse=True)
def in_a_folder_of_its_own(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


@pytest.fixture(scope="session")
def command():
    """The program, which the package must agree with."""
    program = os.environ.get("PLATEN_PROGRAM") or shutil.which("platen")
    if not program:
        pytest.skip("the program is not here: PLATEN_PROGRAM")
    return program


@pytest.fixture(scope="session")
def measured():
    folder = ROOT / "tests/data/measured"
    if not folder.is_dir():
        pytest.skip("the source tree is not here")
    return folder


@pytest.fixture(scope="session")
def granule():
    return platen.Material.load("mcc-ph-200")


@pytest.fixture(scope="session")
def law(granule):
    return granule.predict()


@pytest.fixture(scope="session")
def hertz():
    return platen.law("hertz", E=1e9, nu=0.3)


@pytest.fixture(scope="session")
def pressed():
    """A press that takes a second."""
    metal = platen.von_mises(sigma_y=20e6, E=2e9, nu=0.3, name="metal")
    return metal.press(delta_bar_max=0.1, unload_from=[0.05, 0.1], elements=200, fields_at=[0.05, 0.1])
