"""The notebooks run, and what their cells end with can be shown."""

import ast
import json
import pathlib

import pytest

NOTEBOOKS = pathlib.Path(__file__).parents[1] / "notebooks"


@pytest.mark.parametrize("name", sorted(path.stem for path in NOTEBOOKS.glob("*.ipynb")))
def test_notebook(name):
    pytest.importorskip("matplotlib").use("agg")
    cells = json.loads((NOTEBOOKS / f"{name}.ipynb").read_text())["cells"]
    space = {"__name__": "notebook"}
    for cell in cells:
        if cell["cell_type"] != "code":
            continue
        body = ast.parse("".join(cell["source"]))
        shown = body.body.pop() if body.body and isinstance(body.body[-1], ast.Expr) else None
        exec(compile(body, name, "exec"), space)
        if shown is not None:
            value = eval(compile(ast.Expression(shown.value), name, "eval"), space)
            html = getattr(value, "_repr_html_", lambda: "")()
            assert "nan" not in html and repr(value)
