"""bundled.py WHEEL: puts the licence texts of the libraries that auditwheel copied into a wheel, and a list of them
(CycloneDX 1.5; auditwheel's own has no more those that were changed before), into its .dist-info; the list beside the wheel
too. Debian says which package a library is of."""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile


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
        (info / "licenses" / "bundled").mkdir(parents=True)
        (info / "sboms").mkdir(exist_ok=True)
        components = []
        for name in packages_of(libraries):
            shutil.copyfile(f"/usr/share/doc/{name}/copyright", info / "licenses" / "bundled" / f"{name}.txt")
            version = run("dpkg-query", "-W", "-f", "${Version}", name)
            components.append({"type": "library", "name": name, "version": version, "purl": f"pkg:deb/debian/{name}@{version}"})
        bill = {"bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1, "components": components}
        for place in (info / "sboms", wheel.parent):
            (place / "bundled.cdx.json").write_text(json.dumps(bill, indent=1) + "\n")
        run(sys.executable, "-P", "-m", "wheel", "pack", "-d", folder, str(root))
        os.replace(shutil.copy(pathlib.Path(folder, wheel.name), f"{wheel}.new"), wheel)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
