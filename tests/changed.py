#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the unit tests that a change concerns, for ./check --changed: lines "PROGRAM FILTER", a program of unit tests and the
suites of it as GoogleTest's filter.

The rooms of layers.txt that differ from the last commit, or if none does, that it changed; the rooms that name one of them; and what
tests/unit has for each. Usage: changed.py [COMMIT], which compares with another commit."""
import re
import subprocess
import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[1]
UNITS = PROJECT / "tests/unit"


def git(*arguments):
    text = subprocess.run(["git", *arguments], cwd=PROJECT, check=True, capture_output=True, text=True).stdout
    return text.splitlines()


def changed_files(commit):
    here = git("diff", "--name-only", commit) + git("ls-files", "--others", "--exclude-standard")
    return here or git("diff", "--name-only", commit + "~1", commit)


def main():
    rooms = {}  # room: the rooms and files that it names
    for line in (PROJECT / "layers.txt").read_text().splitlines():
        parts = [part.strip() for part in line.split("|")]
        if len(parts) == 4 and not line.startswith("#"):
            rooms[parts[0]] = parts[2].split(", ")
    changed = set()
    for file in changed_files(sys.argv[1] if sys.argv[1:] else "HEAD"):
        file = file.removeprefix("tests/unit/")
        changed.add(max((room for room in rooms if file.startswith(room + "/")), key=len, default=None))
    concerned = {room for room in rooms if room in changed or changed.intersection(rooms[room])}

    suites = {}  # program: its suites
    for file in UNITS.rglob("*_test.cpp"):
        folder = file.relative_to(UNITS).parent.as_posix()
        # The tests of core/simulator/model, say, stand in a folder of this name or in the next one above it.
        if any((room + "/").startswith(folder + "/") or (folder + "/").startswith(room + "/") for room in concerned):
            found = re.findall(r"^(?:TYPED_)?TEST(?:_[FP])?\((\w+),", file.read_text(), re.M)
            suites.setdefault("unit_" + folder.split("/")[0], set()).update(found)
    for program, names in sorted(suites.items()):
        print(program, ":".join(f"{name}.*:*/{name}.*:{name}/*" for name in sorted(names)))


main()
