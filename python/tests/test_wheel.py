"""What the wheel carries."""

import importlib.metadata
import json

import pytest


def test_every_library_in_the_wheel_comes_with_its_licence_and_is_listed():
    files = importlib.metadata.distribution("platen").files or []
    libraries = [file for file in files if file.parent.name == "platen.libs"]
    if not libraries:
        pytest.skip("built where it runs, it carries no libraries")
    licences = {file.stem: file for file in files if file.parent.name == "bundled"}
    (bill,) = [file for file in files if file.name == "bundled.cdx.json"]
    listed = {part["name"] for part in json.loads(bill.read_text())["components"]}
    assert listed == set(licences)
    for library in libraries:  # libamd-9f58162f.so.2.4.6 is of libamd2
        name = library.name.split(".so")[0].split("-")[0].removeprefix("lib")
        assert any(name in package for package in listed), library
    assert listed >= {"libeigen3-dev", "libtomlplusplus-dev", "nanobind"}, "of what is compiled in"
    assert all(file.read_text().strip() for file in licences.values())
    assert "GPL-2+" in licences["libcholmod3"].read_text()
