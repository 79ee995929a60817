"""Pools, surrogates, refinements and sensitivities, beside the program."""

import _thread
import os
import pathlib
import pickle
import shutil
import stat
import subprocess
import threading
import time

import numpy as np
import pytest
from test_study import CARD

import platen

POOLS = pathlib.Path(__file__).parents[2] / "catalogue/pools"


@pytest.fixture
def pools():
    if not (POOLS / "von-mises/curves.csv").is_file():
        pytest.skip("the source tree is not here")
    return POOLS


@pytest.fixture(scope="module")
def small(tmp_path_factory):
    """A pool of three presses of a second."""
    folder = tmp_path_factory.mktemp("pool")
    (folder / "study.toml").write_text(CARD)
    study = platen.Study.load(folder / "study.toml", store=folder / "store")
    study.run(workers=2)
    study.export(folder / "runs.csv", curves=folder / "curves.csv")
    shutil.rmtree(folder / "store")
    return folder


def said(command, *words):
    return subprocess.run([command, *map(str, words)], check=True, capture_output=True, text=True).stdout


def test_runs_of_a_pool_are_pressed_again(small, command):
    pool = platen.Pool(small)
    seen = []
    check = pool.check(share=1, workers=2, progress=lambda *counts: seen.append(counts))
    assert check.table["run"].tolist() == [1, 2, 3] and check.table["same"].all() and seen[-1] == (3, 0, 3)
    assert check.table["difference"].max() <= check.tolerance == 1e-3
    assert str(check) == said(command, "study", "check", small, "--share", 1)
    assert pool.check(cheapest=True, workers=2).table.size == 2 and "3 of 3 runs" in repr(check)
    assert pool.study.name == "small" and pickle.loads(pickle.dumps(pool)) == pool
    assert str(pickle.loads(pickle.dumps(check))) == str(check)


def test_a_pool_that_is_not_what_is_pressed_is_refused(small, tmp_path):
    shutil.copytree(small, tmp_path / "pool")
    lines = (tmp_path / "pool/curves.csv").read_text().splitlines()
    head = next(line for line in lines if line.startswith("run,")).split(",")
    rows = [line.split(",") for line in lines if line[0].isdigit()]
    force = head.index("F_bar")
    most = max((row for row in rows if row[0] == "3"), key=lambda row: float(row[force]))
    wrong = [*most[:force], str(2 * float(most[force])), *most[force + 1 :]]
    text = "\n".join(lines).replace(",".join(most), ",".join(wrong))
    (tmp_path / "pool/curves.csv").write_text(text + "\n")
    with pytest.raises(platen.InvalidInput, match="1 of 3 runs differ from the pool by more than 0.001") as raised:
        platen.Pool(tmp_path / "pool").check(share=1, workers=2)
    assert raised.value.check.table["same"].tolist() == [True, True, False]
    assert raised.value.check.table["difference"][2] == pytest.approx(0.5)  # over the largest, twice what it was


def test_a_surrogate_is_that_of_the_command(pools, command):
    surrogate = platen.Pool(pools / "von-mises").surrogate()
    surrogate.save("ours.txt")
    words = said(command, "study", "surrogate", pools / "von-mises", "-o", "theirs.txt", "--beside", pools / "fresh-von-mises")
    assert open("ours.txt").read() == open("theirs.txt").read()
    beside = surrogate.beside(pools / "fresh-von-mises")
    assert str(surrogate).replace("ours.txt", "theirs.txt") + str(beside) == words
    assert surrogate.model == "von-mises" and surrogate.pool == "von-mises" and surrogate.materials == 28
    assert surrogate.left_out.force.median < surrogate.left_out.force.p95 < surrogate.left_out.force.worst < 0.01
    assert surrogate.ranges["E_bar"][0] < surrogate.ranges["E_bar"][1] and surrogate.guided is None
    assert np.all(beside["force"] < 0.05) and len(beside) == len(beside.table)
    again = pickle.loads(pickle.dumps(surrogate))
    assert again.text == surrogate.text and platen.Surrogate.load("ours.txt").text == surrogate.text


def test_grains_of_rock_are_a_surrogate_too(pools, command):
    surrogate = platen.Pool(pools / "wang").surrogate()
    surrogate.save("ours.csv")
    words = said(command, "study", "surrogate", pools / "wang", "-o", "theirs.csv")
    assert open("ours.csv").read() == open("theirs.csv").read()
    assert str(surrogate).replace("ours.csv", "theirs.csv") == words
    again = pickle.loads(pickle.dumps(surrogate))
    assert again.text == surrogate.text == platen.Surrogate.load("ours.csv").text and again.model == "drucker-prager"
    with pytest.raises(platen.InvalidInput, match="of rock"):
        surrogate.beside(pools / "von-mises")


def test_methods_are_side_by_side_as_in_the_command(pools, command):
    methods = platen.Pool(pools / "wang").methods()
    assert str(methods) == said(command, "study", "methods", pools / "wang")
    best = methods.table[methods["method"] == "natural neighbours, nu, phi, ln F_y"]
    assert best["force_median"] < 0.001 and best["materials"] == 150 and np.isnan(best["residual_worst"])
    assert str(pickle.loads(pickle.dumps(methods))) == str(methods)


def test_what_to_press_next_is_written_as_a_study(pools, command, tmp_path):
    card = tmp_path / "candidates.toml"
    card.write_text(
        'platen = 1\nname = "candidates"\n'
        'case = { platen = 1, experiment = "simple", material = "von-mises-100", radius_m = 1e-3 }\n'
        '[design]\nkind = "latin-hypercube"\nruns = 40\n'
        '[factors]\n"material.E_bar" = { min = 3, max = 2000, scale = "log" }\n[fit]\nlaws = ["edmans-sinka"]\n'
    )
    study = platen.Study.load(card)
    refined = study.refine(pools / "von-mises", target=1e-5, most=3)
    assert len(refined.runs) == 3 and refined.candidates == 40 and len(refined.study) == 3
    assert refined.expected[0] >= refined.expected[-1] > 1e-5 and "3 presses" in repr(refined)
    chosen = study.design()["material.E_bar"][refined.runs - 1]
    assert refined.study.design()["material.E_bar"] == pytest.approx(chosen)
    theirs = said(command, "study", "refine", card, "--surrogate", pools / "von-mises", "--target", "1e-5", "--most", 3)
    assert str(refined) == theirs
    none = study.refine(platen.Surrogate.load(pools / "von-mises"), target=0.05)
    assert none.study is None and len(none.runs) == 0
    with pytest.raises(platen.InvalidInput, match="the surrogate of vmdc"):
        study.refine(pools / "powders")
    assert "runs" not in study.beside(refined.study) and study.beside(study) == study.spread


def test_sensitivities_are_those_of_the_command(granule, command):
    found = granule.sobol(within=0.1)
    assert str(found) == said(command, "study", "sobol", "mcc-ph-200", "--within", 0.1)
    table = found.table
    force = table[(table["number"] == "Gamma_bar") & (table["output"] == "F at 0.3")]
    assert 0.8 < force["alone"][0] <= force["total"][0] + 0.05 and found.pool == "powders"
    assert str(pickle.loads(pickle.dumps(found))) == str(found) and "12 numbers" in repr(found)


def test_a_job_is_handed_to_sbatch_and_its_tasks_press(tmp_path, monkeypatch):
    (tmp_path / "a study.toml").write_text(CARD)
    study = platen.Study.load("a study.toml", store="a store")
    script = study.batch_script(tasks=2, slurm=["--time=5"])
    assert "#SBATCH --array=1-2\n" in script and "#SBATCH --time=5\n" in script and not os.path.exists("a store")
    with pytest.raises(platen.IoError, match="sbatch did not take the job .*submit.sh"):
        monkeypatch.setenv("PATH", "/nowhere")
        study.submit()
    monkeypatch.undo()
    monkeypatch.chdir(tmp_path)
    sbatch = tmp_path / "bin/sbatch"
    sbatch.parent.mkdir()
    sbatch.write_text('#!/bin/sh\ncd / && bash "$1" >/dev/null && echo Submitted batch job 12\n')
    sbatch.chmod(sbatch.stat().st_mode | stat.S_IXUSR)
    monkeypatch.setenv("PATH", f"{sbatch.parent}:{os.environ['PATH']}")
    monkeypatch.setenv("PYTHONPATH", str(pathlib.Path(platen.__file__).parents[1]))
    answer = platen.Study.load(tmp_path / "a study.toml", store=tmp_path / "a store").submit(tasks=2)
    assert answer == "Submitted batch job 12" and study.status().done == 3
    assert study.submit() == ""


def test_ctrl_c_ends_a_surrogate(pools):
    threading.Timer(0.5, _thread.interrupt_main).start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        while True:
            platen.Pool(pools / "edmans-sinka").methods()
    assert time.monotonic() - start < 20


def test_other_threads_run_while_sensitivities_are_found(granule):
    turns, done = 0, threading.Event()
    thread = threading.Thread(target=lambda: (granule.sobol(), done.set()))
    thread.start()
    while not done.is_set():
        turns += 1
        time.sleep(1e-3)
    thread.join()
    assert turns > 20


@pytest.mark.parametrize(
    "call, sentence",
    [
        (lambda pool: platen.Pool("nowhere"), "nowhere: it is no pool"),
        (lambda pool: pool.check(share=2), "share = 2"),
        (lambda pool: pool.check(share=float("nan")), "share = nan"),
        (lambda pool: pool.check(until=3), "until = 3"),
        (lambda pool: pool.check(workers=0), "workers = 0"),
        (lambda pool: pool.check(seed=-1), "seed = -1"),
        (lambda pool: pool.methods(), "a surrogate wants 5 at least"),
        (lambda pool: pool.study.submit(tasks=0), "tasks = 0"),
        (lambda pool: pool.study.submit(old="burn"), "keep or recompute"),
        (lambda pool: platen.Material.load("base-case").sobol(within=2), "within = 2"),
        (lambda pool: platen.Material.load("base-case").sobol(picture="sobol.gif"), "sobol.gif"),
        (lambda pool: platen.Material.load("dical-emcompress").sobol(), "it locks"),
        (lambda pool: platen.reproduce("edmans"), "there is no paper 'edmans'"),
        (lambda pool: platen.keys("law"), "there are no keys of 'law'"),
        (lambda pool: platen.yield_from_hardness(E=1e9, nu=0.3, hardness=1e9), "partly elastic"),
        (lambda pool: platen.yield_from_crushing(E=1e9, nu=0.3, force=1, overlap=1, radius=1), "0.01 to 0.5 of R"),
    ],
)
def test_sentences(small, call, sentence):
    with pytest.raises(platen.InvalidInput) as raised:
        call(platen.Pool(small))
    assert sentence in str(raised.value)


def test_a_file_that_is_not_there_is_an_input_output_error(small):
    for call in (lambda: platen.Surrogate.load("nowhere.txt"), lambda: platen.Pool(small).study.refine("nowhere")):
        with pytest.raises(platen.IoError, match="nowhere.*cannot be read"):
            call()


def test_types(small):
    for call in (lambda: platen.Pool(3), lambda: platen.Surrogate.load(3), lambda: platen.Pool(small).check(progress=3),
                 lambda: platen.Pool(small).study.submit(slurm=[3])):  # fmt: skip
        with pytest.raises(TypeError):
            call()
