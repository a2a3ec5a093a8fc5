#!/usr/bin/python3
# SPDX-License-Identifier: MIT
#
# Validates records against record.schema.json with Debian's validator (python3-jsonschema). Usage: schema.py SCHEMA RECORD...
# Catches a record that the schema does not allow, a key that the schema does not describe, and a schema that allows
# anything: a record without one of its required keys, or with one of another type, must not pass.
import copy
import json
import sys

import jsonschema


def closed(schema):
    """The same schema with no keys allowed but the described ones."""
    if isinstance(schema, list):
        return [closed(part) for part in schema]
    if not isinstance(schema, dict):
        return schema
    result = {key: closed(part) for key, part in schema.items()}
    if schema.get("type") == "object":
        result["additionalProperties"] = False
    return result


def spoilt(record, required):
    for key in required:
        without = copy.deepcopy(record)
        del without[key]
        yield f"without {key}", without
        other = copy.deepcopy(record)
        other[key] = True
        yield f"with {key} true", other


def main(schema_path, *records):
    with open(schema_path, encoding="utf-8") as file:
        schema = json.load(file)
    kind = jsonschema.Draft202012Validator
    kind.check_schema(schema)
    strict = kind(closed(schema))
    problems = 0
    for path in records:
        with open(path, encoding="utf-8") as file:
            record = json.load(file)
        for error in strict.iter_errors(record):
            print(f"{path}: {error.json_path}: {error.message}", file=sys.stderr)
            problems += 1
        for what, changed in spoilt(record, schema["required"]):
            if kind(schema).is_valid(changed):
                print(f"{path}: {what} it is valid, too", file=sys.stderr)
                problems += 1
    print(f"{len(records)} records, {problems} problems")
    return 0 if records and problems == 0 else 1


sys.exit(main(*sys.argv[1:]))
