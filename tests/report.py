#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints what ./check did: the output of each test that failed, the seconds of each phase, the slowest tests, the seconds of each
label beside its limit (limits.txt), what was skipped and why, and how many tests passed and failed. Exit 1 if one failed.

Usage: report.py RESULTS, a folder with phases.txt (lines "SECONDS PHASE"), and for each build BUILD.xml (ctest --output-junit) and
BUILD.json (ctest --show-only=json-v1); and for commands COMMAND.code and COMMAND.log. A ctest test that is a part of a program of
unit tests (mirocup_add_parts in CMakeLists.txt) counts as the tests that it ran, which stand in the file that its GTEST_OUTPUT
names."""
import collections
import json
import pathlib
import re
import sys
import xml.etree.ElementTree

Test = collections.namedtuple("Test", "name label seconds verdict text")  # verdict: passed, failed, skipped


def read_properties(path):
    """Returns the properties of each ctest test: {name: {property: value}}."""
    tests = json.loads(path.read_text())["tests"]
    return {test["name"]: {p["name"]: p["value"] for p in test.get("properties", [])} for test in tests}


def reason_of(text):
    """Returns the line after GoogleTest's "Skipped", or the last line of a script that was skipped."""
    found = re.search(r"Skipped\n(.*)", text)
    lines = [line for line in text.strip().splitlines() if line]
    return found.group(1) if found else (lines[-1] if lines else "it does not say why").removeprefix("skipped: ")


def without_passed(text):
    """Returns the output of GoogleTest without the lines of tests that passed. A test that crashed keeps its line."""
    return re.sub(r"\[ RUN      \] (.*)\n\[       OK \] \1 .*\n|\[-{10}\].*\n|(?m:^)\n", "", text)


def parts_of(properties, build, label):
    """Returns the tests that a part of a program ran; none if it did not come to its end."""
    output = dict(line.split("=", 1) for line in properties.get("ENVIRONMENT", [])).get("GTEST_OUTPUT", "")
    path = pathlib.Path(output.removeprefix("xml:"))
    if not output or not path.is_file():
        return []
    tests = []
    for case in xml.etree.ElementTree.parse(path).iter("testcase"):
        if case.get("status") == "notrun":
            continue
        skipped, failed = case.find("skipped"), case.findall("failure")
        verdict = "failed" if failed else "passed" if skipped is None else "skipped"
        text = (skipped.get("message", "") if skipped is not None else "").split("\n", 1)[-1]
        tests.append(Test(f"{build}: {case.get('classname')}.{case.get('name')}", label, float(case.get("time")), verdict, text))
    return tests


def read_build(path):
    """Returns all tests of a build, the seconds of each label, and the output of what failed."""
    properties = read_properties(path.with_suffix(".json"))
    tests, labels, failures = [], collections.Counter(), []
    for case in xml.etree.ElementTree.parse(path).iter("testcase"):
        name, status = case.get("name"), case.get("status")
        own = properties.get(name, {})
        label, seconds = own.get("LABELS", ["no label"])[0], float(case.get("time"))
        text = case.findtext("system-out") or ""
        if status == "disabled":
            continue
        labels[label] += seconds
        skipped = case.find("skipped")
        is_skipped = skipped is not None and skipped.get("message", "").startswith("SKIP_")  # others could not be started
        verdict = "passed" if status == "run" else "skipped" if is_skipped else "failed"
        parts = parts_of(own, path.stem, label)
        if verdict == "failed":
            failures.append(f"== failed: {path.stem}: {name}\n{without_passed(text)}")
        if verdict == "failed" and not any(test.verdict == "failed" for test in parts):
            parts = []  # it crashed, at the end or before
        reason = reason_of(text) if verdict == "skipped" else ""
        tests += parts or [Test(f"{path.stem}: {name}", label, seconds, verdict, reason)]
    return tests, labels, failures


def read_command(path):
    code, text = int(path.read_text()), path.with_suffix(".log").read_text()
    verdict = {0: "passed", 3: "skipped", 77: "skipped"}.get(code, "failed")
    failures = [f"== failed: {path.stem}\n{text}"] if verdict == "failed" else []
    return [Test(path.stem, "all", 0.0, verdict, reason_of(text) if verdict == "skipped" else "")], failures


def main(results):
    here = pathlib.Path(__file__).parent
    tests, labels, failures = [], collections.Counter(), []
    for path in sorted(results.glob("*.xml")):
        more, seconds, failed = read_build(path)
        tests += more
        labels += seconds
        failures += failed
    for path in sorted(results.glob("*.code")):
        more, failed = read_command(path)
        tests += more
        failures += failed
    for text in failures:
        print(text)
    print("== seconds of each phase")
    for line in (results / "phases.txt").read_text().splitlines():
        print("{:>6} {}".format(*line.split(" ", 1)))
    print("== the slowest tests, in seconds")
    for test in sorted(tests, key=lambda test: -test.seconds)[:20]:
        print(f"{test.seconds:6.1f} {test.name}")
    print("== seconds of each label, and its limit (tests/limits.txt)")
    limits = dict(line.split() for line in (here / "limits.txt").read_text().splitlines() if line and line[0] != "#")
    for label, seconds in sorted(labels.items()):
        limit = int(limits.get(label, 0))
        print(f"{seconds:6.0f} of {limit:5} {label}" + (": over its limit, see CONTRIBUTING.md" if seconds > limit else ""))
    count = collections.Counter(test.verdict for test in tests)
    if count["skipped"]:
        reasons = collections.Counter(test.text for test in tests if test.verdict == "skipped")
        told = "; ".join(f"{reason} ({number})" for reason, number in reasons.most_common())
        print(f"{count['skipped']} tests were skipped: {told}")
    print(f"{count['passed']} passed, {count['failed']} failed")
    return 1 if count["failed"] or not count["passed"] else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
