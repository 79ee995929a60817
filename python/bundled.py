"""bundled.py WHEEL: puts the licence texts of the libraries that auditwheel copied into a wheel, and of what is compiled into its
module, and a list of them (auditwheel's own has no more those that were changed before), into its .dist-info; the list beside the
wheel too. Debian says which package a library is of."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cmake"))
import third_party  # noqa: E402

COMPILED_IN = ["debian:libceres-dev", "debian:libeigen3-dev", "debian:libfmt-dev", "debian:libtomlplusplus-dev", "debian:nlohmann-json3-dev",
               "pypi:nanobind"]

def run(*command: str) -> str:
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def packages_of(libraries: list[str]) -> list[str]:
    """Of libamd-9f58162f.so.2.4.6: that of /usr/lib/x86_64-linux-gnu/libamd.so.2, libamd2."""
    paths = {}
    for line in run("/sbin/ldconfig", "-p").splitlines():
        if "=>" in line:
            name, path = (word.strip() for word in line.split("=>"))
            paths.setdefault(name.split(".so")[0], os.path.realpath(path))
    packages = set()
    for library in libraries:
        path = paths[library.split(".so")[0].split("-")[0]]
        owner = subprocess.run(["dpkg-query", "-S", path], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        if owner.returncode != 0:  # known by its place before /lib moved to /usr/lib
            owner = subprocess.run(["dpkg-query", "-S", path.removeprefix("/usr")], check=True, stdout=subprocess.PIPE, text=True)
        packages.add(owner.stdout.split(":")[0])
    return sorted(packages)


def main(wheel: pathlib.Path) -> None:
    with tempfile.TemporaryDirectory() as folder:
        run(sys.executable, "-P", "-m", "wheel", "unpack", "-d", folder, str(wheel))
        (root,) = pathlib.Path(folder).iterdir()
        (info,) = root.glob("*.dist-info")
        libraries = [file.name for file in root.glob("*.libs/*")]
        if not libraries:
            sys.exit(f"bundled.py: {wheel} carries no libraries; auditwheel must have repaired it")
        (info / "sboms").mkdir(exist_ok=True)
        third_party.write([f"debian:{name}" for name in packages_of(libraries)] + COMPILED_IN, info / "licenses" / "bundled",
                          info / "sboms" / "bundled.cdx.json", wheel.parent / "bundled.cdx.json")
        run(sys.executable, "-P", "-m", "wheel", "pack", "-d", folder, str(root))
        os.replace(shutil.copy(pathlib.Path(folder, wheel.name), f"{wheel}.new"), wheel)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
