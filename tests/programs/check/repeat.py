#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Usage: tests/programs/check/repeat.py BUILD TIMES [GTEST_FILTER]

Runs each kind of team of check_tests that many times, wrong ones and harmless ones, and prints how often
`mirocup check` gave the right verdict, how often the right sentence, and how long the check took. The
kinds and their sentences are those of mistakes_test.cpp, python_test.cpp and check_test.cpp. Exits with 1
if an answer was wrong once. Catches an answer that a busy machine, a clock or luck changes.
"""
import collections
import json
import pathlib
import subprocess
import sys
import tempfile


class Kind:
    """What became of the runs of one kind."""

    def __init__(self):
        self.runs = self.wrong_verdicts = self.wrong_sentences = 0
        self.seconds = []
        self.messages = []

    def add(self, test):
        messages = [failure["failure"] for failure in test.get("failures", [])]
        self.runs += 1
        self.seconds.append(float(test["time"].rstrip("s")))
        is_verdict = any("exit_code" in message for message in messages)
        self.wrong_verdicts += is_verdict
        self.wrong_sentences += bool(messages)
        self.messages += messages


def run_once(program, gtest_filter, kinds):
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / "report.json"
        subprocess.run([program, f"--gtest_filter={gtest_filter}", f"--gtest_output=json:{report}"],
                       stdout=subprocess.DEVNULL, check=False)
        suites = json.loads(report.read_text())["testsuites"]
    for suite in suites:
        for test in suite["testsuite"]:
            if test["result"] == "COMPLETED":
                kinds[f'{suite["name"]}.{test["name"]}'].add(test)


def row(name, kind):
    middle = sorted(kind.seconds)[len(kind.seconds) // 2]
    return (f"{name:64} {kind.runs - kind.wrong_verdicts:4}/{kind.runs:<4} "
            f"{kind.runs - kind.wrong_sentences:4}/{kind.runs:<4} {middle:7.2f} {max(kind.seconds):7.2f}")


def main():
    if len(sys.argv) not in (3, 4) or not sys.argv[2].isdigit():
        sys.exit(__doc__)
    program = str(pathlib.Path(sys.argv[1]).resolve() / "check_tests")
    gtest_filter = sys.argv[3] if len(sys.argv) == 4 else "*"
    kinds = collections.defaultdict(Kind)
    for time in range(int(sys.argv[2])):
        run_once(program, gtest_filter, kinds)
        wrong = sum(kind.wrong_sentences for kind in kinds.values())
        print(f"{time + 1} times, {wrong} wrong answers", file=sys.stderr)
    print(f'{"kind":64} {"verdict":>9} {"sentence":>9} {"median s":>8} {"max s":>6}')
    for name, kind in sorted(kinds.items()):
        print(row(name, kind))
    failed = {name: kind for name, kind in kinds.items() if kind.wrong_sentences > 0}
    for name, kind in failed.items():
        print(f"\n{name}:\n" + "\n".join(dict.fromkeys(kind.messages)))
    if not kinds:
        sys.exit("no test has that name")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
