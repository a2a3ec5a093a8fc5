#!/usr/bin/python3
# SPDX-License-Identifier: MIT
#
# Validates records against record.schema.json, or other files against files.schema.json, with Debian's validator (python3-jsonschema).
# Usage: schema.py SCHEMA FILE...; a file may be a page, in which each block ```json with a "schema" is validated. The keys that
# sources among the files read by expect_object({…}) must be those that the schema names.
# Catches a file that the schema does not allow, a key that the schema does not describe, and a schema that allows anything: a file
# without one of its required keys, or with a key of another type, must not pass.
import json
import re
import sys
from pathlib import Path

import jsonschema


def closed(schema):
    """The same schema with no keys allowed but the described ones."""
    if isinstance(schema, list):
        return [closed(part) for part in schema]
    if not isinstance(schema, dict):
        return schema
    result = {key: closed(part) for key, part in schema.items()}
    if schema.get("type") == "object":
        result.setdefault("additionalProperties", False)
    return result


def spoilt(record, required):
    for key in required:
        yield f"without {key}", {name: value for name, value in record.items() if name != key}
    for key in record:
        yield f"with {key} [[]]", {**record, key: [[]]}


def keys_of(schema):
    """The keys that a schema names, except those of ranges."""
    if isinstance(schema, list):
        return set().union(*map(keys_of, schema))
    if not isinstance(schema, dict):
        return set()
    named = set(schema.get("properties", {})) | set(schema.get("propertyNames", {}).get("enum", []))
    return named.union(*map(keys_of, schema.values())) - {"from", "to"}


def documents(path):
    """The JSON documents of a file."""
    text = Path(path).read_text(encoding="utf-8")
    if not path.endswith(".md"):
        return [json.loads(text)]
    blocks = [block for block in re.findall(r"```json\n(.*?)```", text, re.S) if '"schema": "mirocup/' in block]
    return [json.loads(block) for block in blocks]


def main(schema_path, *files):
    schema = json.loads(Path(schema_path).read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    base = schema.get("$id", Path(schema_path).resolve().as_uri())  # where files.schema.json finds record.schema.json

    def validator(root):
        return jsonschema.Draft202012Validator(root, resolver=jsonschema.RefResolver(base, root))

    strict, plain = validator(closed(schema)), validator(schema)
    sources = [path for path in files if path.endswith(".cpp")]
    lists = re.findall(r"expect_object\(\s*\{(.*?)\}", "".join(Path(path).read_text(encoding="utf-8") for path in sources), re.S)
    keys = set(re.findall(r'"(\w+)"', "".join(lists)))
    problems = [f"{key}: only the schema names it, or only a source reads it" for key in sources and keys_of(schema) ^ keys]
    records = [(path, record) for path in files if path not in sources for record in documents(path)]
    for path, record in records:
        problems += [f"{path}: {error.json_path}: {error.message}" for error in strict.iter_errors(record)]
        problems += [f"{path}: {what} it is valid, too" for what, changed in spoilt(record, schema.get("required", []))
                     if plain.is_valid(changed)]
    print(f"{len(records)} records, {len(problems)} problems", *problems, sep="\n")
    return 0 if records and not problems else 1


sys.exit(main(*sys.argv[1:]))
