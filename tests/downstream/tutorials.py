"""Runs the commands of tutorials and compares what they print with what the pages say.

tutorials.py PROGRAM [--write] [--plugin platen.lmp] PAGE.md...

Every block ```sh of a page is run, in order, in one empty folder; where a block ```text follows it, what the commands
printed must be that text. Seconds and folders are masked; numbers may differ in the last digits, as processors do.
```sh norun is not run, ```sh exit=2 must end so; of ```text shape the numbers are not compared. --write puts what was printed into the page. Exit code 77: LAMMPS is missing.
"""
import argparse
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FENCE = re.compile(r"^```(\S*) ?(.*)$")
NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?(?![\w])", re.IGNORECASE)
RELATIVE_TOLERANCE = 1e-3


def blocks(lines):
    """(language, rest of the fence, first line inside, line of the closing fence)"""
    found, start = [], None
    for at, line in enumerate(lines):
        fence = FENCE.match(line)
        if fence and start is None:
            start = (fence[1], fence[2].strip(), at + 1)
        elif line.startswith("```") and start is not None:
            found.append((*start, at))
            start = None
    return found


def mask(text, folder, program):
    text = text.replace(program, "platen").replace(folder + "/", "").replace(folder, ".").replace(SOURCE + "/", "")
    text = re.sub(r"\b\d+(\.\d+)? s\b", "… s", text)
    lines = [line.rstrip() for line in text.split("\n")]
    lines = [line for line in lines if not re.match(r"(pressing .*|study \S+): \d+ %", line)]
    return "\n".join(lines).strip("\n")


def same_number(a, b):
    x, y = float(a), float(b)
    last = max(10.0 ** -len(n.lower().split("e")[0].partition(".")[2]) for n in (a, b))
    exponent = max(int(n.lower().partition("e")[2] or 0) for n in (a, b))
    return math.isclose(x, y, rel_tol=RELATIVE_TOLERANCE) or abs(x - y) <= 2.001 * last * 10.0**exponent


def same(printed, said, shape):
    """Words are equal, numbers nearly; columns may be as wide as they like."""
    squeeze = lambda line: re.sub(r"\s+", " ", NUMBER.sub("#", line)).strip()
    for a, b in zip(printed.split("\n"), said.split("\n")):
        numbers = NUMBER.findall(a), NUMBER.findall(b)
        if squeeze(a) != squeeze(b) or not (shape or all(map(same_number, *numbers))):
            return f"  page:    {b}\n  program: {a}"
    if printed.count("\n") != said.count("\n"):
        return f"  page: {said.count(chr(10)) + 1} lines, program: {printed.count(chr(10)) + 1} lines"
    return None


def run(page, program, plugin, write):
    with open(page, encoding="utf-8") as file:
        lines = file.read().split("\n")
    found = blocks(lines)
    if any("lmp " in line for line in lines) and not (shutil.which("lmp") and os.path.exists(plugin or "")):
        print(f"{page}: skipped, LAMMPS or the plug-in is missing")
        return None
    folder = os.path.realpath(tempfile.mkdtemp())
    bin_folder = tempfile.mkdtemp()
    os.symlink(program, os.path.join(bin_folder, "platen"))
    environment = dict(os.environ, PATH=bin_folder + ":" + os.environ["PATH"], OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1",
                       PLATEN_CATALOGUE=os.path.join(SOURCE, "catalogue"), LC_ALL="C.UTF-8")
    os.symlink(os.path.join(SOURCE, "tests/data/measured"), os.path.join(folder, "measured"))
    if plugin:
        os.symlink(os.path.realpath(plugin), os.path.join(folder, "platen.lmp"))
    failures, replaced, compared, ran = [], [], 0, 0
    try:
        for at, (language, rest, first, last) in enumerate(found):
            if language != "sh" or rest == "norun":
                continue
            ran += 1
            result = subprocess.run(["bash", "-eu", "-c", "\n".join(lines[first:last])], cwd=folder, env=environment, text=True,
                                    stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
            printed = mask(result.stdout, folder, program)
            expected = int(rest.removeprefix("exit=")) if rest.startswith("exit=") else 0
            if result.returncode != expected:
                failures.append(f"{page}:{first}: exit code {result.returncode}\n{printed}")
                break
            after = found[at + 1] if at + 1 < len(found) else None
            if not after or after[0] != "text" or "".join(lines[last + 1 : after[2] - 1]).strip():
                continue
            compared += 1
            said = "\n".join(lines[after[2] : after[3]])
            replaced.append((after[2], after[3], printed))
            difference = same(printed, said, after[1] == "shape")
            if difference and not write:
                failures.append(f"{page}:{after[2]}: the program prints something else\n{difference}")
    finally:
        shutil.rmtree(folder)
        shutil.rmtree(bin_folder)
    if write and not failures:
        for first, last, printed in reversed(replaced):
            lines[first:last] = printed.split("\n")
        with open(page, "w", encoding="utf-8") as file:
            file.write("\n".join(lines))
    print("\n".join(failures) if failures else f"{page}: {ran} blocks run, {compared} outputs compared")
    return not failures


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--plugin")
    parser.add_argument("pages", nargs="+")
    asked = parser.parse_args()
    results = [run(page, os.path.realpath(asked.program), asked.plugin, asked.write) for page in asked.pages]
    if False in results:
        sys.exit(1)
    if all(result is None for result in results):
        sys.exit(77)


main()
