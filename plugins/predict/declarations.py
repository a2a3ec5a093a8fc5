#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Declares the functions of skills.h for C++ and for Python: the build puts them into c_skills.cpp and into team.py.

Usage: declarations.py HEADER SOURCE OUTPUT. OUTPUT is SOURCE with the functions in place of the line that has only "SKILLS" in a
comment. In C++ a function calls the one of its name in mirocup::strategy, and usual values in braces are a structure there. In Python
it calls C, and the comment of the header is its description. SOURCE itself defines what is not as simple, and such a function is left
out. Python gets _NAME for every function of C, also for those that SOURCE calls from a class or from a function of its own.
"""
import os
import re
import sys
import textwrap

FUNCTION = re.compile(r"(?:/\* ([^*]*) \*/\n)?^((?:const )?\w+\*?) mirocup_(\w+)\(([^)]*)\);(?: +/\* (.*) \*/)?$", re.M)


def functions(header):
    """Returns for each function its comment, result, name, parameters, and the usual values of the last parameters."""
    for comment, result, name, parameters, usual in FUNCTION.findall(header):
        parameters = [] if parameters == "void" else re.split(r",\s+", parameters)
        yield " ".join(comment.split()), result, name, parameters, usual


def cpp_function(result, name, parameters, usual, is_of_class):
    arguments = [f"Cpp::of({parameter.split()[-1]})" for parameter in parameters]
    if usual.startswith("{"):
        members = usual.count(",") + 1
        arguments[-members:] = ["{" + ", ".join(arguments[-members:]) + "}"]
    called = "strategy::" + name
    if name.endswith("_new"):
        called = f"made<{result[:-1]}>"
    elif name.endswith("_free"):
        called, arguments = "destroy", [parameters[0].split()[-1]]
    elif is_of_class:
        called = f"{arguments.pop(0)}.{name.partition('_')[2]}"
    call = f"{called}({', '.join(arguments)})"
    call = call if result == "void" else f"return {call}" if name.endswith("_new") else f"return C::of({call})"
    return f"{result} mirocup_{name}({', '.join(parameters)}) {{\n  {call};\n}}\n"


def python_function(comment, result, name, parameters, usual):
    names = [parameter.split()[-1] for parameter in parameters]
    values = ["=" + str(float(value)) for value in usual.strip("{}").split(", ") if value]
    if parameters[-1] == "mirocup_command* command":
        return f"def {name}(setup, now, wheels):\n    \"\"\"{comment}\"\"\"\n    return _changed(_{name}, setup, now, wheels)\n\n\n"
    kind = {"double": "float", "int32_t": "bool", "void": "None"}.get(result) or result.removeprefix("mirocup_").title()
    text = textwrap.fill(f'"""{comment}"""', 110, initial_indent="    ", subsequent_indent="    ")
    call = f"_{name}({', '.join(f'_own({n}, now.robots)' if n in ('i', 'me') and 'now' in names else n for n in names)})"
    return (f"def {name}({', '.join(map(str.__add__, names, (len(names) - len(values)) * [''] + values))}) -> {kind}:\n{text}\n"
            f"    try:\n        return {f'bool({call})' if kind == 'bool' else call}\n"
            f"    except Exception:\n        _explain(_{name}, locals())\n        raise\n\n\n")


def declarations(header, source, is_python):
    classes = re.findall(r"typedef struct mirocup_(\w+) mirocup_\1;", header)
    skills, predict = header.split("/* ---- predict.hpp")
    part = header if is_python else predict if "mirocup/predict.hpp" in source else skills
    text = ""
    for comment, result, name, parameters, usual in functions(part):
        is_of_class = name.split("_")[0] in classes
        is_by_hand = re.search(rf"^(def |\w.* mirocup_){name}\(", source, re.M)
        if is_python:
            text += f'_{name} = _bound("{result}", "{name}",\n    "{", ".join(parameters)}")\n'
        if is_python and not is_of_class and not is_by_hand:
            text += f"\n\n{python_function(comment, result, name, parameters, usual)}"
        if not is_python and not is_by_hand:
            text += cpp_function(result, name, parameters, usual, is_of_class)
    return text


def main():
    header, source, output = sys.argv[1:]
    with open(header) as h, open(source) as s:
        header, text = h.read(), s.read()
    before, after = re.split(r"^(?:#|//) SKILLS$\n", text, flags=re.M)
    with open(output + ".new", "w") as file:
        file.write(before + declarations(header, text, source.endswith(".py")) + after)
    os.replace(output + ".new", output)


main()
