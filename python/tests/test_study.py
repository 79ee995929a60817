import _thread
import subprocess
import threading
import time

import numpy as np
import pytest

import platen

CARD = """
platen = 1
name = "small"
[case]
platen = 1
experiment = "simple"
radius_m = 1e-3
[case.path]
delta_bar_max = 0.05
unload_from = [0.05]
[case.mesh]
elements = 100
[case.material]
platen = 1
model = "von-mises"
name = "metal"
[case.material.parameters]
sigma_y_Pa = 20e6
nu = 0.3
E_bar = 100
[design]
kind = "factorial"
[factors]
"material.E_bar" = { values = [50, 100, 200] }
[fit]
laws = ["edmans-sinka"]
"""


@pytest.fixture
def card(tmp_path):
    path = tmp_path / "study.toml"
    path.write_text(CARD)
    return path


def test_a_study_is_pressed_and_read_as_arrays(card, command):
    study = platen.Study.load(card, store="store")
    assert len(study) == 3 and "small" in repr(study)
    before = study.status()
    assert before.left == 3 and before.done == 0
    with pytest.warns(platen.Warning, match="no run of the study is done"):
        assert set(study.runs()["state"]) == {"missing"}
    seen = []
    after = study.run(workers=2, progress=lambda *counts: seen.append(counts))
    assert after.done == 3 and after.failed == 0 and seen[-1] == (3, 0, 3)
    table = study.runs()
    assert table["material.E_bar"].tolist() == [50, 100, 200] and set(table["state"]) == {"done"}
    assert table["run"].dtype.kind == "i" and np.all(table["k"] > 0) and np.all(table["relative_l2"] < 0.1)
    curves = study.curves(step=0.01)
    one = curves[(curves["run"] == 2) & (curves["branch"] == "loading")]
    assert one["delta_bar"].max() == pytest.approx(0.05) and np.all(np.diff(one["F_bar"]) > 0)
    whole = study.curve(table["key"][1])
    assert whole.notes.material == "metal"
    assert np.interp(0.03, whole.loading["delta_bar"], whole.loading["F_bar"]) == pytest.approx(
        one["F_bar"][np.isclose(one["delta_bar"], 0.03)][0], rel=0.01)  # fmt: skip
    study.export("runs.csv", curves="curves.csv")
    subprocess.run([command, "study", "export", card, "--store", "store", "-o", "theirs.csv", "--curves", "theirs-curves.csv"], check=True)
    assert open("runs.csv").read() == open("theirs.csv").read()
    assert open("curves.csv").read() == open("theirs-curves.csv").read()
    study.export("study.sqlite")
    assert open("study.sqlite", "rb").read(6) == b"SQLite"
    assert study.run(workers=1).done == 3  # nothing is left to press
    assert platen.Study.load(card, store="other").merge(["store"]) == 3


def test_a_design_is_shown_before_it_is_pressed(card):
    study = platen.Study.load(card)
    design = study.design()
    assert design["material.E_bar"].tolist() == [50, 100, 200]
    assert design["lambda"] == pytest.approx(np.array([50, 100, 200]) / (1 - 0.3**2))
    assert study.spread.min_distance == pytest.approx(1 / 3)  # of 0, 1/3, 1 in the unit interval
    assert study.store == "out/small"


def test_what_the_progress_function_raises_ends_a_study(card):
    study = platen.Study.load(card, store="store")

    def stop(done, failed, runs):
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        study.run(workers=1, progress=stop)


def test_ctrl_c_ends_a_study_and_the_same_call_goes_on(card):
    card.write_text(CARD.replace("elements = 100", "elements = 20000"))
    study = platen.Study.load(card, store="store")
    threading.Timer(1, _thread.interrupt_main).start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        study.run(workers=2)
    assert time.monotonic() - start < 20
    assert study.status().claimed == 0


def test_other_threads_run_while_a_study_is_pressed(card):
    study, turns, done = platen.Study.load(card, store="store"), 0, threading.Event()
    thread = threading.Thread(target=lambda: (study.run(workers=1), done.set()))
    thread.start()
    while not done.is_set():
        turns += 1
        time.sleep(1e-3)
    thread.join()
    assert turns > 20 and study.status().done == 3


@pytest.mark.parametrize(
    "call, sentence",
    [
        (lambda card: platen.Study.load("nowhere.toml"), "nowhere.toml"),
        (lambda card: platen.Study.load(card).run(workers=0), "workers = 0"),
        (lambda card: platen.Study.load(card).run(workers=2000), "workers = 2000"),
        (lambda card: platen.Study.load(card).run(old="burn"), "keep or recompute"),
        (lambda card: platen.Study.load(card).curves(step=0), "step = 0"),
        (lambda card: platen.Study.load(card).curve("nothing"), "run nothing"),
        (lambda card: platen.Study.load(card, store="a").merge(["b"]), "b"),
    ],
)
def test_sentences(card, call, sentence):
    with pytest.raises(platen.InvalidInput) as raised:
        call(card)
    assert sentence in str(raised.value)
