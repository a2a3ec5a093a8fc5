#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Fails on an include, a link or a path in a CMakeLists.txt against layers.txt, and on a use of labs/ outside of
it, in tests, too.

Usage: layers.py [ROOT]. The order is that of this project in any ROOT.
"""
import re
import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
INCLUDE_ROOTS = ["", "plugins/include", "labs/training/include"]


def read_layers():
    """Returns {room: (subject, [what it names])} and [([begin of a header], [room])]."""
    rooms, headers = {}, []
    for line in (PROJECT / "layers.txt").read_text().splitlines():
        if not line or line.startswith("#"):
            continue
        parts = [part.strip() for part in line.split("|")]
        if len(parts) == 4:
            rooms[parts[0]] = (parts[1], [name for name in parts[2].split(", ") if name])
        elif len(parts) == 2:
            headers.append((parts[0].split(), parts[1].split()))
    return rooms, headers


ROOMS, HEADERS = read_layers()
TOPS = sorted({room.split("/")[0] for room in ROOMS})


def below(path, folder):
    return path == folder or path.startswith(folder + "/")


def room_of(path):
    return max((room for room in ROOMS if below(path, room)), key=len, default=None)


def allowed(room):
    """Returns the rooms and the single files that a room may use."""
    rooms, files, todo = {room}, set(), list(ROOMS[room][1])
    while todo:
        name = todo.pop()
        if name not in ROOMS:
            files.add(name)
        elif name not in rooms:
            rooms.add(name)
            todo += ROOMS[name][1]
    return rooms, files


ALLOWED = {room: allowed(room) for room in ROOMS}


def may_use(room, path):
    rooms, files = ALLOWED[room]
    return path in files or room_of(path) in rooms


def resolve(root, source, name):
    """Returns the path below `root` of a header that a source includes with quotes; None for one of a library or of a team."""
    for folder in [*INCLUDE_ROOTS, str(Path(source).parent)]:
        path = Path(folder) / name
        if (root / path).exists() or (PROJECT / path).exists() or (folder == "" and room_of(name)):
            return str(path)
    return None


def sources(root):
    for top in TOPS:
        for path in sorted((root / top).rglob("*")):
            if path.suffix in (".c", ".cpp", ".h", ".hpp") and path.is_file():
                yield str(path.relative_to(root)), path.read_text(errors="replace").splitlines()


def bad_includes(root):
    for source, lines in sources(root):
        room = room_of(source)
        for number, line in enumerate(lines, 1):
            if found := re.match(r'#include "([^"]+)"', line):
                path = resolve(root, source, found[1])
                if path and (room_of(path) or path.split("/")[0] in TOPS) and not may_use(room, path):
                    yield f"{source}:{number}:{line}: {room} may not use {path}"
            elif found := re.match(r"#include <([^>]+)>", line):
                for begins, homes in HEADERS:
                    if any(found[1].startswith(begin) for begin in begins) and not any(below(room, home) for home in homes):
                        yield f"{source}:{number}:{line}: not in this room"


class Folder:
    """A CMakeLists.txt: its commands as lists of words, loops over words in the file unrolled."""

    def __init__(self, root, file):
        self.path = str(file.relative_to(root))
        self.folder = str(file.relative_to(root).parent)
        text = re.sub(r"#.*", "", file.read_text())
        words = re.findall(r'"[^"]*"|[()]|[^\s()"]+', text)
        commands, i = [], 0
        while i + 1 < len(words):
            if words[i + 1] == "(":
                depth, j = 1, i + 2
                while depth and j < len(words):
                    depth += {"(": 1, ")": -1}.get(words[j], 0)
                    j += 1
                commands.append([words[i], *(word.strip('"') for word in words[i + 2:j - 1])])
                i = j
            else:
                i += 1
        self.commands = list(self.with_globs(self.unrolled(commands)))

    @staticmethod
    def with_globs(commands):
        """Puts the patterns of file(GLOB …) in the place of its variable."""
        globs = {}
        for command in commands:
            if command[0] == "file" and command[1].startswith("GLOB"):
                globs["${" + command[2] + "}"] = [word for word in command[3:] if word != "CONFIGURE_DEPENDS"]
            yield [part for word in command for part in globs.get(word, [word])]

    def unrolled(self, commands):
        i = 0
        while i < len(commands):
            if commands[i][0] != "foreach":
                yield commands[i]
                i += 1
                continue
            end, depth = i + 1, 1
            while depth and end < len(commands):
                depth += {"foreach": 1, "endforeach": -1}.get(commands[end][0], 0)
                end += 1
            _, variable, *values = commands[i]
            body = commands[i + 1:end - 1]
            for value in values:
                yield from self.unrolled([[word.replace("${" + variable + "}", value) for word in command] for command in body])
            i = end

    def paths(self, command):
        """Returns the paths below the root that the words of a command name."""
        for word in command[1:]:
            word = word.replace("${PROJECT_SOURCE_DIR}/", "/").replace("${CMAKE_CURRENT_SOURCE_DIR}/", "")
            if "$" in word or "/" not in word and "." not in word:
                continue
            path = word[1:] if word.startswith("/") else str(Path(self.folder, word))
            path = str(Path("/", path).resolve())[1:] if ".." in path else path
            if room_of(path):
                yield path


def targets_of(folders):
    """Returns {target: its rooms}: those of its sources, or all rooms of the folder if it names no source."""
    targets = {}
    for f in folders:
        for command in f.commands:
            if command[0] in ("add_library", "add_executable") and "ALIAS" not in command:
                of_sources = {room_of(path) for path in f.paths(command[1:]) if path.endswith((".c", ".cpp"))}
                targets[command[1]] = of_sources or {room for room in ROOMS if below(room, f.folder)}
    return targets


def bad_links_and_paths(root):
    folders = [Folder(root, file) for top in TOPS for file in sorted((root / top).rglob("CMakeLists.txt"))]
    targets = targets_of(folders)
    # A tree of a few files links against the libraries of the project.
    known = targets_of([Folder(PROJECT, file) for top in TOPS for file in sorted((PROJECT / top).rglob("CMakeLists.txt"))])
    for f in folders:
        for command in f.commands:
            if command[0] == "target_link_libraries" and command[1] in targets:
                users = targets[command[1]]
                for library in command[2:]:
                    name = library.replace("::", "_")
                    used = known.get(name, known.get(name + "_lib", set()))
                    if used and not any(ALLOWED[user][0] & used for user in users):
                        yield f"{f.path}: {command[1]} may not link {library}"
            own = [room for room in ROOMS if below(room, f.folder) or below(f.folder, room)]
            for path in f.paths(command):
                if not any(may_use(room, path) or below(path, room) for room in own):
                    yield f"{f.path}: {command[0]} may not use {path}"


def uses_of_labs(root):
    """What layers.txt says of rooms holds for tests and examples, too: they are built without labs/."""
    names = {command[1] for file in (PROJECT / "labs").rglob("CMakeLists.txt") for command in Folder(PROJECT, file).commands
             if command[0] in ("add_library", "add_executable")}
    in_cmake = re.compile(r"\blabs/|(?<![\w:-])(" + "|".join(map(re.escape, names)) + r")(?![\w:-])")
    for top in ("browser", "examples", "tests"):
        for path in sorted((root / top).rglob("*")):
            file = str(path.relative_to(root))
            is_cmake = path.name == "CMakeLists.txt" or path.suffix == ".cmake"
            if below(file, "tests/layering") or not (is_cmake or path.suffix in (".c", ".cpp", ".h", ".hpp")):
                continue
            for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
                if in_cmake.search(re.sub("#.*", "", line)) if is_cmake else line.startswith('#include "labs/'):
                    yield f"{file}:{number}:{line}: only labs/ uses labs/"


def main():
    root = Path(sys.argv[1]).resolve() if sys.argv[1:] else PROJECT
    complaints = [f"layers.txt: {room} uses a room that uses it" for room, (_, names) in ROOMS.items()
                  if any(name in ROOMS and room in ALLOWED[name][0] for name in names)]
    complaints += [f"layers.txt: {room} uses labs" for room in ROOMS
                   if not below(room, "labs") and any(below(name, "labs") for name in ROOMS[room][1])]
    complaints += [*bad_includes(root), *bad_links_and_paths(root), *uses_of_labs(root)]
    for complaint in complaints:
        print("layering: " + complaint, file=sys.stderr)
    return 1 if complaints else 0


sys.exit(main())
