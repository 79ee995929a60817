"""docs/reference/python.md has every command of the program, and what it names is there."""

import inspect
import pathlib
import pickle
import re
import subprocess

import pytest

import platen

PAGE = pathlib.Path(__file__).parents[2] / "docs/reference/python.md"


@pytest.fixture(scope="module")
def table():
    """Command and counterpart of each row."""
    if not PAGE.is_file():
        pytest.skip("the source tree is not here")
    section = PAGE.read_text(encoding="utf-8").split("## Every command")[1]
    return re.findall(r"^\| `(platen [^`]+)` \| (.+) \|$", section, re.M)


def test_the_page_has_every_command(command, table):
    manual = subprocess.run([command, "manual"], check=True, capture_output=True, text=True).stdout
    commands = [line.replace("\\-", "-") for line in re.findall(r"^\.SS (.+)$", manual, re.M)]
    assert "platen study sobol" in commands and [row[0] for row in table] == commands


def test_what_the_page_names_is_in_the_package(table):
    for name, counterpart in table:
        names = [word for word in re.findall(r"`([^`]+)`", counterpart) if not word.startswith("-")]
        if counterpart.startswith("none"):
            continue
        assert names, name
        for word in names:
            if word.endswith("="):
                called = [found(other) for other in names if not other.endswith("=")]
                keywords = {key for one in called if not inspect.isclass(one) for key in inspect.signature(one).parameters}
                assert word[:-1] in keywords, (name, word)
            else:
                assert found(word) is not None, (name, word)


def found(dotted):
    """What `platen.X.y` is; of a property its function."""
    value = platen
    for part in dotted.split("."):
        value = getattr(value, part)
    return value.fget if isinstance(value, property) else value


def test_what_is_public_has_a_docstring():
    for name in platen.__all__:
        value = getattr(platen, name)
        if inspect.isclass(value) or inspect.isfunction(value):
            assert inspect.getdoc(value), name


def test_results_are_shown_and_pickled(pressed, law, granule, measured):
    results = [
        law, granule, pressed.curve, law.error, law.valid, law.prediction, law.pair(radius=1e-3), law.pair(radius=1e-3)([0, 1e-5]),
        law.pair(radius=1e-3).new_state(3), platen.laws()["hertz"], platen.import_curve(measured / "s01_zwick_de.csv"),
        platen.compare(pressed.curve, [pressed.fit()]), law.to_parameters(radius=1e-3),
    ]  # fmt: skip
    for result in results:
        again = pickle.loads(pickle.dumps(result))
        assert type(again) is type(result) and repr(again) == repr(result) and str(again) == str(result)
        assert isinstance(result, dict) or " object at 0x" not in repr(result)
