#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fails if a room has more lines of code than layers.txt allows it.

Usage: lines.py [ROOT]; lines.py --count prints the lines of each room beside its limit, and the sums. A line of code has something
else than a comment and blanks. A file belongs to the innermost room that it is in. What git does not know is not counted.
"""
import re
import subprocess
import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
STRINGS = r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|'
C = re.compile(STRINGS + r"(?P<comment>//[^\n]*|/\*.*?\*/)", re.S)
CSS = re.compile(r"(?P<comment>/\*.*?\*/)", re.S)
HTML = re.compile(r"(?P<comment><!--.*?-->)", re.S)
HASH = re.compile(STRINGS + r"(?P<comment>#[^\n]*)", re.S)
# A text that stands alone is the description of a module or of a function.
TEXT = r'"""(?:\\.|[^\\])*?"""'
PYTHON = re.compile(rf"(?P<comment>^[ \t]*{TEXT}[ \t]*$|#[^\n]*)|{TEXT}|{STRINGS[:-1]}", re.S | re.M)
LANGUAGES = {".c": C, ".cpp": C, ".h": C, ".hpp": C, ".idl": C, ".js": C, ".mjs": C, ".css": CSS, ".html": HTML, ".py": PYTHON, ".awk": HASH}


def code_lines(path):
    """Returns the lines of a file that have code; 0 for a file in none of the languages."""
    language = LANGUAGES.get(path.suffix)
    if language is None:
        return 0
    text = language.sub(lambda found: re.sub(r"[^\n]", "", found[0]) if found["comment"] else found[0],
                        path.read_text(errors="replace"))
    return sum(1 for line in text.splitlines() if line.strip())


def limits():
    """Returns {room: most lines} of layers.txt."""
    rows = re.findall(r"^([^#|\n][^|\n]*?) \|.*\| (\d+) lines$", (PROJECT / "layers.txt").read_text(), re.M)
    return {room: int(most) for room, most in rows}


def files(root):
    if (root / ".git").exists():
        known = subprocess.run(["git", "ls-files", "-z"], cwd=root, check=True, capture_output=True, text=True).stdout
        return [root / name for name in known.split("\0") if name and (root / name).is_file()]
    return [path for path in root.rglob("*") if path.is_file() and "build" not in path.relative_to(root).parts]


def count(root, rooms):
    """Returns {room: its lines}."""
    lines = dict.fromkeys(rooms, 0)
    for path in files(root):
        name = path.relative_to(root).as_posix()
        room = max((room for room in rooms if name.startswith(room + "/")), key=len, default=None)
        if room:
            lines[room] += code_lines(path)
    return lines


def main():
    most = limits()
    if sys.argv[1:] == ["--count"]:
        lines = count(PROJECT, most)
        for room, number in lines.items():
            print(f"{number:6} of {most[room]:6} {room}")
        beside = ("tests", "labs", "examples")
        print(f"{sum(number for room, number in lines.items() if room.split('/')[0] not in beside):6} outside of {', '.join(beside)}")
        return 0
    lines = count(Path(sys.argv[1]).resolve() if sys.argv[1:] else PROJECT, most)
    over = [room for room in lines if lines[room] > most[room]]
    for room in over:
        print(f"layering: {room} has {lines[room]} lines of code, but at most {most[room]} are allowed (layers.txt)", file=sys.stderr)
    return 1 if over else 0


if __name__ == "__main__":
    sys.exit(main())
