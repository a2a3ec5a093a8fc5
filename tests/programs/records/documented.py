#!/usr/bin/python3
# SPDX-License-Identifier: MIT
#
# Compares the keys of records with what record.schema.json, schema.md and docs/laws.md say about them.
# Usage: documented.py SCHEMA_JSON SCHEMA_MD LAWS_MD RECORD...; the records together must have every key.
# Catches a key that is written but not described, and one that is described but no longer written.
import json
import re
import sys


def paths_of_value(value, path=""):
    """The paths of all keys of a JSON value: "decisions[].ball"."""
    if isinstance(value, list):
        for item in value:
            yield from paths_of_value(item, path + "[]")
    elif isinstance(value, dict):
        for key, member in value.items():
            below = f"{path}.{key}" if path else key
            yield below
            yield from paths_of_value(member, below)


def paths_of_schema(schema, root, path=""):
    """The paths of all keys that a JSON Schema names."""
    if "$ref" in schema:
        yield from paths_of_schema(root["$defs"][schema["$ref"].rsplit("/", 1)[1]], root, path)
    for part in schema.get("anyOf", []):
        yield from paths_of_schema(part, root, path)
    if "items" in schema:
        yield from paths_of_schema(schema["items"], root, path + "[]")
    for key, member in schema.get("properties", {}).items():
        below = f"{path}.{key}" if path else key
        yield below
        yield from paths_of_schema(member, root, below)


def of_a_colour(paths):
    """The same paths for both teams: a record may have a report of one of them only."""
    return {re.sub(r"(?<=\.)(blue|yellow)\b", "COLOUR", path) for path in paths}


def rows_of_table(section):
    """The rows of the table of keys in schema.md: path -> the whole row."""
    rows = {}
    for line in section.split("\n| key |")[1].split("\n\n")[0].splitlines():
        if line.startswith("| `"):
            for path in re.findall(r"`([^`]+)`", line.split("|")[1]):
                rows[path] = line
    return rows


def is_described(path, rows, section, laws):
    if path in rows:
        return True
    parent, _, key = path.rpartition(".")
    if key == "COLOUR":
        return is_described(parent, rows, section, laws)
    if parent == "rules":
        return f"`{key}`" in laws
    # The key may also stand in the row of an object that is described as a whole, or in the text of a reference.
    ancestor = parent
    while ancestor and ancestor not in rows:
        ancestor = re.sub(r"(\[\]|\.[^.]+|^[^.]+)$", "", ancestor)
    return f"`{key}`" in rows.get(ancestor, "") or (ancestor != "" and f"`{key}`" in section)


def main(schema_path, text_path, laws_path, *records):
    with open(schema_path, encoding="utf-8") as file:
        schema = json.load(file)
    with open(text_path, encoding="utf-8") as file:
        text = file.read()
    with open(laws_path, encoding="utf-8") as file:
        laws = file.read()
    problems = []
    written = set()
    for path in records:
        with open(path, encoding="utf-8") as file:
            written |= set(paths_of_value(json.load(file)))
    written = of_a_colour(written)
    named = of_a_colour(paths_of_schema(schema, schema))
    section = text.split("\n## Keys\n")[1].split("\n## ")[0]
    rows = rows_of_table(section)
    problems += [f"{path} is written, but not in record.schema.json" for path in written - named]
    problems += [f"{path} is in record.schema.json, but not written" for path in named - written]
    problems += [f"{path} is in schema.md, but not written" for path in set(rows) - written]
    problems += [f"{path} is written, but not in schema.md"
                 for path in written if not is_described(path, rows, section, laws)]
    for problem in sorted(problems):
        print(problem, file=sys.stderr)
    print(f"{len(written)} keys, {len(problems)} problems")
    return 0 if records and not problems else 1


sys.exit(main(*sys.argv[1:]))
