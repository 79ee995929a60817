"""Material points, and materials from decks."""

import csv
import math
import pickle
import subprocess

import numpy as np
import pytest

import platen

DECK = """*MATERIAL, NAME=STEEL
*ELASTIC
210000., 0.3
*PLASTIC
250., 0.
300., 0.1
*CONDUCTIVITY
45.
*MATERIAL, NAME=RUBBER
*ELASTIC
10., 0.45
"""


@pytest.mark.parametrize("way, options", [("uniaxial-strain", {"strain": -0.3}), ("isotropic", {}), ("triaxial", {"lateral_Pa": -1e6}),
                                          ("shear", {"compaction": 0.1, "steps": 20})])  # fmt: skip
def test_point_says_what_the_command_says(granule, command, way, options):
    line = [command, "point", "mcc-ph-200", "--path", way] + [str(word) for key, value in options.items() for word in ("--" + key, value)]
    theirs = list(csv.DictReader(subprocess.run(line, check=True, capture_output=True, text=True).stdout.splitlines()))
    table = granule.point(way, **{"lateral" if key == "lateral_Pa" else key: value for key, value in options.items()})
    assert list(table.dtype.names) == list(theirs[0]) and len(table) == len(theirs)
    for name in table.dtype.names:
        ours = table[name].tolist()
        assert ours == [row[name] if name == "zone" else float(row[name]) for row in theirs]


def test_an_elastic_point_obeys_hooke():
    E, nu, eps = 2e9, 0.3, -1e-4
    table = platen.elastic(E=E, nu=nu).point("uniaxial-strain", strain=eps, steps=4)
    modulus = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / math.exp(eps)  # stress of Cauchy, logarithmic strain
    assert table["sigma_1_Pa"][-1] == pytest.approx(modulus * eps, rel=1e-12)
    assert table["sigma_2_Pa"][-1] == pytest.approx(nu / (1 - nu) * modulus * eps, rel=1e-12)


def test_a_way_is_an_array_or_a_file():
    metal = platen.von_mises(sigma_y=20e6, E=2e9, nu=0.3)
    rows = np.array([[0, 0, 0], [-0.05, 0.025, 0.025], [-0.04, 0.02, 0.02]])
    table = metal.point(rows)
    assert len(table) == 4 and table["eps_1"].tolist() == [0, 0, -0.05, -0.04]
    assert table["q_Pa"][2] == pytest.approx(20e6) and table["zone"].tolist()[2] == "shear"
    np.savetxt("way.csv", rows, delimiter=",", header="eps_1,eps_2,eps_3", comments="")
    assert np.array_equal(metal.point("way.csv"), table)
    with pytest.raises(platen.InvalidInput, match="shape"):
        metal.point(np.zeros((2, 2)))
    with pytest.raises(platen.InvalidInput, match="finite"):
        metal.point([[0, 0, math.nan]])
    with pytest.raises(TypeError):
        metal.point([["a", "b", "c"]])


@pytest.mark.parametrize(
    "options, sentence",
    [
        ({"way": "triaxal"}, "did you mean 'triaxial'?"),
        ({"way": "shear", "strain": 9}, "[-3, 3]"),
        ({"way": "shear", "strain": math.nan}, "strain nan"),
        ({"way": "shear", "steps": 0}, "[1, 1000000]"),
        ({"way": "shear", "moduli": "explicit"}, "implicit or after-step"),
    ],
)
def test_sentences(granule, options, sentence):
    with pytest.raises(platen.InvalidInput) as raised:
        granule.point(**options)
    assert sentence in str(raised.value)


def test_a_refused_step_leaves_the_way_until_then():
    with pytest.raises(platen.ConvergenceError, match="step 1 was refused") as raised:
        platen.Material.load("base-case").point("uniaxial-strain", strain=3, steps=1)
    assert len(raised.value.points) == 1


@pytest.fixture
def deck(tmp_path):
    path = tmp_path / "deck.inp"
    path.write_text(DECK)
    return path


def test_a_deck_becomes_what_the_command_makes_of_it(deck, command):
    with pytest.warns(platen.Warning, match="CONDUCTIVITY"):
        steel = platen.Material.from_abaqus(deck, units="mm-tonne-MPa", material="STEEL")
    line = [command, "convert", deck, "--units", "mm-tonne-MPa", "--material", "STEEL", "-o", "steel.toml"]
    subprocess.run(line, check=True, capture_output=True)
    theirs = platen.Material.load("steel.toml")
    assert steel.text == theirs.text and steel.sources == theirs.sources
    assert steel.E == 210e9 and "deck.inp" in steel.sources["default"]
    assert pickle.loads(pickle.dumps(steel)).remarks == steel.remarks
    again = steel.to_abaqus("mm-tonne-MPa")
    (deck.parent / "again.inp").write_text(again)
    assert platen.Material.from_abaqus(deck.parent / "again.inp", units="mm-tonne-MPa").parameters == steel.parameters


def test_a_deck_that_cannot_be_believed_is_refused(deck):
    with pytest.raises(platen.InvalidInput, match="STEEL.*RUBBER"):
        platen.Material.from_abaqus(deck, units="si")
    with pytest.raises(platen.InvalidInput, match="mm-tonne-MPa"):
        platen.Material.from_abaqus(deck, material="RUBBER")
    with pytest.raises(platen.InvalidInput, match="that of no material"):
        platen.Material.from_abaqus(deck, units="si", material="RUBBER")
    with pytest.warns(platen.Warning, match="doubted"):
        platen.Material.from_abaqus(deck, units="si", material="RUBBER", despite_doubts=True)
    with pytest.raises(platen.InvalidInput, match="there is no such file"):
        platen.Material.from_abaqus("nowhere.inp", units="si")
    with pytest.raises(platen.InvalidInput):
        platen.Material.load("mcc-ph-200").to_abaqus("mm-tonne-MPa")  # vmdc
    with pytest.raises(platen.InvalidInput, match="furlong"):
        platen.Material.load("elastic").to_abaqus("furlong")
