"""The blocks of the tutorial, one after another."""

import re
import shutil

import pytest
from conftest import ROOT


@pytest.mark.filterwarnings("ignore::platen.Warning")
def test_the_tutorial_runs(measured):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    text = (ROOT / "docs/tutorials/python.md").read_text()
    shutil.copy(ROOT / "examples/study.toml", ".")
    for block in re.findall(r"```python\n(.*?)```", text, re.S):
        exec(block, globals())
