"""third_party.py FOLDER BILL.json KIND:PACKAGE...: the licence texts of what is compiled into a file that is published, into FOLDER,
and a list of it with versions (CycloneDX 1.5) as BILL.json. KIND is debian, pypi (of this Python) or npm (site/node_modules)."""

import importlib.metadata
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
LICENCE = re.compile(r"(licen[cs]e|copying|notice)", re.IGNORECASE)


def debian(name: str) -> tuple[str, str, str]:
    """Its version, its name for the list, and its licence; so of all kinds. CalledProcessError, OSError where it is not there."""
    version = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", name], check=True, stdout=subprocess.PIPE, text=True).stdout
    return version, f"pkg:deb/debian/{name}@{version}", pathlib.Path(f"/usr/share/doc/{name}/copyright").read_text()


def pypi(name: str) -> tuple[str, str, str]:
    package = importlib.metadata.distribution(name)
    texts = [package.locate_file(file).read_text() for file in package.files or [] if LICENCE.match(file.name)]
    return package.version, f"pkg:pypi/{name}@{package.version}", "\n".join(texts)


def npm(name: str) -> tuple[str, str, str]:
    folder = ROOT / "site/node_modules" / name
    about = json.loads((folder / "package.json").read_text())
    texts = [file.read_text() for file in sorted(folder.iterdir()) if LICENCE.match(file.name)]
    return about["version"], f"pkg:npm/{name.replace('@', '%40')}@{about['version']}", "\n".join(texts)


def write(parts: list[str], folder: pathlib.Path, *bills: pathlib.Path) -> None:
    """A text for each of "debian:libfmt-dev", ... in the folder, and the list."""
    components = []
    folder.mkdir(parents=True, exist_ok=True)
    for part in sorted(set(parts)):
        kind, name = part.split(":", 1)
        version, purl, text = {"debian": debian, "pypi": pypi, "npm": npm}[kind](name)
        if not text:
            sys.exit(f"third_party.py: {part} has no licence text")
        (folder / f"{name.replace('/', '-')}.txt").write_text(text)
        components.append({"type": "library", "name": name, "version": version, "purl": purl})
    bill = {"bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1, "components": components}
    for file in bills:
        file.write_text(json.dumps(bill, indent=1) + "\n")


if __name__ == "__main__":
    write(sys.argv[3:], pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
