#!/usr/bin/env python3
"""Checks JSON against a schema of docs/schema: check_schema.py [--lines] SCHEMA FILE

Knows the words that these schemas use: type, enum, const, anyOf, properties, required, additionalProperties, items,
minItems, maxItems, minimum. --lines: each line of the file is a value of its own. Exit 1 and one line a fault.
"""

import json
import sys

TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "null": type(None)}
KNOWN = {"$schema", "title", "type", "enum", "const", "anyOf", "properties", "required", "additionalProperties", "items",
         "minItems", "maxItems", "minimum"}


def is_type(value, name):
    if name in ("number", "integer"):
        return isinstance(value, (int, float) if name == "number" else int) and not isinstance(value, bool)
    return isinstance(value, TYPES[name])


def object_faults(value, schema, place):
    properties, extra = schema.get("properties", {}), schema.get("additionalProperties", True)
    for key in schema.get("required", []):
        if key not in value:
            yield f"{place}: {key} is missing"
    for key, item in value.items():
        if key in properties:
            yield from faults(item, properties[key], f"{place}/{key}")
        elif extra is False:
            yield f"{place}: {key} is not expected"
        elif isinstance(extra, dict):
            yield from faults(item, extra, f"{place}/{key}")


def faults(value, schema, place=""):
    for word in set(schema) - KNOWN:
        yield f"{place}: the schema's word {word} is unknown here"
    names = schema.get("type", [])
    names = [names] if isinstance(names, str) else names
    if names and not any(is_type(value, name) for name in names):
        yield f"{place}: {value!r} is not of type {names}"
        return
    if "enum" in schema and value not in schema["enum"]:
        yield f"{place}: {value!r} is none of {schema['enum']}"
    if "const" in schema and value != schema["const"]:
        yield f"{place}: {value!r} is not {schema['const']!r}"
    if "anyOf" in schema and all(any(True for _ in faults(value, choice, place)) for choice in schema["anyOf"]):
        yield f"{place}: fits none of the {len(schema['anyOf'])} choices"
    if is_type(value, "number") and value < schema.get("minimum", value):
        yield f"{place}: {value} is too small"
    if isinstance(value, dict):
        yield from object_faults(value, schema, place)
    if isinstance(value, list):
        if not schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", len(value)):
            yield f"{place}: {len(value)} items"
        for i, item in enumerate(value):
            yield from faults(item, schema.get("items", {}), f"{place}/{i}")


def main():
    words = sys.argv[1:]
    lines = "--lines" in words
    schema_name, name = [word for word in words if word != "--lines"]
    with open(schema_name, encoding="utf-8") as file:
        schema = json.load(file)
    with open(name, encoding="utf-8") as file:
        values = [json.loads(line) for line in file] if lines else [json.load(file)]
    found = [fault for value in values for fault in faults(value, schema)]
    for fault in found:
        print(fault)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
