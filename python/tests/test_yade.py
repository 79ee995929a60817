"""The engine for YADE, in YADE."""

import os
import pathlib
import re
import shutil
import subprocess

import nanobind_backend
import pytest
from conftest import ROOT

import platen


@pytest.fixture(scope="module")
def yade(tmp_path_factory):
    """Runs a script of plugins/yade with the package under test; YADE's Python is Debian's."""
    program = shutil.which("yade")
    if not program:
        pytest.skip("YADE is not here: apt-get install yade")
    if not (ROOT / "plugins/yade").is_dir():
        pytest.skip("the source tree is not here")
    folder = tmp_path_factory.mktemp("packages")
    for module in (platen, nanobind_backend):
        place = pathlib.Path(module.__file__).parent
        for part in place.parent.glob(place.name + "*"):
            (folder / part.name).symlink_to(part)
    environment = dict(os.environ, PYTHONPATH=f"{folder}:{ROOT / 'plugins/yade'}", PYTHONWARNINGS="ignore", OPENBLAS_NUM_THREADS="1")
    if subprocess.run(["/usr/bin/python3", "-c", "import platen"], env=environment, capture_output=True).returncode != 0:
        pytest.skip("YADE's Python cannot load the package: another version")

    def run(script, *arguments, **more):
        command = [program, "-n", "-x", ROOT / "plugins/yade" / script, *arguments]
        done = subprocess.run(command, env={**environment, **more}, capture_output=True, text=True, timeout=250)
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    return run


def test_two_spheres_have_the_forces_of_the_command(yade, command):
    said = yade("two_spheres.py", PLATEN_PROGRAM=command)
    assert float(re.search(r"worst difference from platen eval: (\S+)", said)[1]) < 1e-9


def test_a_die_compaction_runs(yade):
    said = yade("die_compaction.py", "3")
    assert "27 granules" in said and "us a contact and step" in said
