"""The pictures of the command, and the folders that it leaves."""

import os
import pathlib
import shutil
import subprocess

import numpy as np
import pytest

import platen

ROOT = pathlib.Path(__file__).parents[2]
needs_gnuplot = pytest.mark.skipif(not shutil.which("gnuplot"), reason="gnuplot is not here")


def is_picture(path):
    text = open(path, "rb").read(400)
    return b"<svg" in text or text.startswith(b"\x89PNG")


def test_a_press_is_saved_as_the_command_saves_it(command):
    open("case.toml", "w").write(
        'platen = 1\nexperiment = "simple"\nmaterial = "von-mises-100"\nradius_m = 1e-3\n[path]\ndelta_bar_max = 0.05\n'
        "unload_from = [0.05]\n[mesh]\nelements = 200\n[output]\nfields_at = [0.05]\n"
    )
    press = platen.press("case.toml")
    press.save("ours")
    subprocess.run([command, "press", "case.toml", "-o", "theirs"], check=True, capture_output=True)
    assert sorted(os.listdir("ours")) == sorted(os.listdir("theirs")) and "zones.svg" in os.listdir("ours")
    for name in os.listdir("ours"):
        if name != "summary.json":  # it has seconds
            assert open(f"ours/{name}").read() == open(f"theirs/{name}").read(), name
    press.as_measured("raw.csv", particles=2, seed=3)
    subprocess.run([command, "press", "case.toml", "-o", "theirs", "--as-measured", "theirs.csv", "--particles", "2", "--seed", "3"],
                   check=True, capture_output=True)  # fmt: skip
    assert open("raw.csv").read() == open("theirs.csv").read()
    assert len(platen.import_curve("raw.csv").particles) == 2


@needs_gnuplot
def test_a_derivation_leaves_what_the_command_leaves(command):
    metal = platen.Material.load("von-mises-100")
    law = metal.derive(delta_bar_max=0.05, elements=200, folder="ours")
    subprocess.run([command, "derive", "von-mises-100", "--delta_bar_max", "0.05", "--elements", "200", "-o", "theirs"],
                   check=True, capture_output=True)  # fmt: skip
    assert sorted(os.listdir("ours")) == sorted(os.listdir("theirs")) and is_picture("ours/curve.svg")
    assert platen.Law.load("ours/law.toml") == law == platen.Law.load("theirs/law.toml")
    metal.derive("edmans-sinka", delta_bar_max=0.05, elements=200, folder="other")
    assert platen.Law.load("other/law.toml").name == "edmans-sinka" and os.path.exists("other/pressed.toml")


@needs_gnuplot
def test_every_picture_is_drawn(pressed, measured, granule):
    pressed.curve.save("curve.csv")
    platen.fit(pressed.curve, "edmans-sinka", picture="fit.svg")
    platen.compare("curve.csv", ["hertz"], picture="compare.png", title="two")
    granule.point("uniaxial-strain", picture="surface.svg")
    granule.sobol(within=0.05, picture="sobol.svg")
    raw = measured / "s01_zwick_de.csv"
    platen.import_curve(raw, picture="import.svg")
    found = platen.calibrate(raw, "shahin", nu=0.3, picture="fitted.svg", profiles="profiles.svg", confined="confined.svg")
    for name in ("fit.svg", "compare.png", "surface.svg", "sobol.svg", "import.svg", "fitted.svg", "profiles.svg", "confined.svg"):
        assert is_picture(name), name
    assert {curve.loading for curve in found.confined} == {"simple", "die", "hydrostatic"}
    assert np.all(found.confined[0].F_over_pi_R2_Pa_low <= found.confined[0].F_over_pi_R2_Pa)


def test_the_name_of_a_picture_is_asked_before_any_work(pressed, measured, granule):
    raw = measured / "s01_zwick_de.csv"
    for call in (
        lambda: platen.fit(pressed.curve, "edmans-sinka", picture="fit.gif"),
        lambda: platen.compare(pressed.curve, "hertz", picture="fit.gif"),
        lambda: platen.import_curve(raw, picture="fit.gif"),
        lambda: platen.calibrate(raw, "hertz", nu=0.3, picture="fit.gif"),
        lambda: granule.point("isotropic", picture="fit.gif"),
    ):
        with pytest.raises(platen.InvalidInput, match="ends in .svg or .png"):
            call()
    with pytest.raises(platen.InvalidInput, match="there is none of the law pressed"):
        platen.fit(pressed.curve, "pressed", picture="fit.svg")


def test_without_gnuplot_the_sentence_says_what_to_install(granule, monkeypatch):
    monkeypatch.setenv("PATH", "/nowhere")
    with pytest.raises(platen.IoError, match="gnuplot-nox"):
        granule.point("isotropic", picture="surface.svg")


@needs_gnuplot
def test_a_paper_is_reproduced_as_by_the_command(command, monkeypatch):
    if not (ROOT / "catalogue/papers/numbers.csv").is_file():
        pytest.skip("the source tree is not here")
    monkeypatch.setenv("PLATEN_CATALOGUE", str(ROOT / "catalogue"))
    seen = []
    found = platen.reproduce("wang", folder="ours", progress=lambda share, what: seen.append((share, what)))
    words = subprocess.run([command, "reproduce", "wang", "-o", "theirs"], check=True, capture_output=True, text=True).stdout
    assert words == str(found) + "page in theirs/index.html\n" and seen[-1] == (1, "the page, figures")
    assert open("ours/numbers.csv").read() == open("theirs/numbers.csv").read() and found.page == "ours/index.html"
    assert found.papers["rows"].tolist() == [len(found.rows)] and {"reproduced", "differs"} <= set(found.rows["verdict"])

    def stop(share, what):
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        platen.reproduce("wang", folder="stopped", progress=stop)
    assert not os.path.exists("stopped/index.html")
