import json
import subprocess

import pytest

import platen


def test_compare_says_what_the_command_says(pressed, command):
    pressed.curve.save("curve.csv")
    pressed.fit().save("law.toml")
    metal = platen.von_mises(sigma_y=20e6, E=2e9, nu=0.3)
    metal.save("metal.toml")
    laws = ["law.toml", "hertz", "agarwal/hertz-radius", "thornton-ning"]
    with pytest.warns(platen.Warning, match="outside its validity"):
        found = platen.compare("curve.csv", laws, ranges=[0.02], p_y=5e7, material=metal)
    line = [command, "compare", "curve.csv", *laws, "--ranges", "0.02", "-p", "p_y_Pa=5e7", "--material", "metal.toml"]
    theirs = subprocess.run(line, check=True, capture_output=True, text=True).stdout
    assert str(found) == theirs
    numbers = json.loads(subprocess.run([*line, "--json"], check=True, capture_output=True, text=True).stdout)
    assert found.table["force"].tolist() == [row["force"] for row in numbers]
    assert found.table["rank"].tolist() == [row["rank"] for row in numbers]
    assert found.ranking[0] == "law.toml" and found.table.size == 8
    assert len(found.traces) == 4 and found.traces[1]["force_N"].shape == found.delta_m.shape
    assert "<table>" in found._repr_html_() and "law.toml" in repr(found)


def test_laws_and_curves_are_named(pressed):
    law = pressed.fit()
    found = platen.compare(pressed.curve, {"the law": law, "itself": pressed.curve})
    assert found.ranking == ["itself", "the law"] and found.table["force"][1] == pytest.approx(0, abs=1e-12)
    assert platen.compare(pressed.curve, law).table["law"].tolist() == ["pressed"]
    assert platen.compare(pressed.curve, [law, law]).table["law"].tolist() == ["pressed", "pressed 2"]


def test_a_comparison_is_drawn(pressed):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    ax = platen.compare(pressed.curve, ["hertz"]).plot()
    assert ax.get_xlabel() and len(ax.lines) == 2


@pytest.mark.parametrize(
    "call, sentence",
    [
        (lambda c: platen.compare("curve.txt", "hertz"), "is no curve"),
        (lambda c: platen.compare("nowhere.csv", "hertz"), "nowhere.csv"),
        (lambda c: platen.compare(c, "herz"), "there is no law or law card 'herz'"),
        (lambda c: platen.compare(c, []), "compare needs a law or a second curve"),
        (lambda c: platen.compare(c, "hertz", k=1.0), "none of the laws has this parameter"),
        (lambda c: platen.compare(c, "hertz", ranges=[0.1, 0.01]), "is not a number above the one before it"),
        (lambda c: platen.compare(c, "hertz", material="mcc-ph-20"), "did you mean 'mcc-ph-200'?"),
    ],
)
def test_sentences(pressed, call, sentence):
    with pytest.raises(platen.InvalidInput) as raised:
        call(pressed.curve)
    assert sentence in str(raised.value)


def test_what_is_no_curve_is_a_type_error(pressed):
    with pytest.raises(TypeError):
        platen.compare(3, "hertz")
    with pytest.raises(TypeError):
        platen.compare(pressed.curve, "hertz", E=True)
