"""The engine for Kratos DEM, in Kratos."""

import importlib.util
import os
import re
import subprocess
import sys

import pytest
from conftest import ROOT


def test_kratos_moves_spheres_as_the_law_says_and_presses_a_bed(tmp_path):
    if not importlib.util.find_spec("KratosMultiphysics") or not (ROOT / "plugins/kratos").is_dir():
        pytest.skip("Kratos is not here: pip install KratosMultiphysics KratosDEMApplication")
    path = os.pathsep.join([str(ROOT / "plugins/kratos"), *sys.path])
    environment = dict(os.environ, PYTHONPATH=path, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", PYTHONWARNINGS="ignore")
    command = [sys.executable, ROOT / "plugins/kratos/examples.py"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr
    assert float(re.search(r"worst difference (\S+)", done.stdout)[1]) < 1e-9
    assert "us a contact and step" in done.stdout
