#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the speed of a match over the network with that of the machine without mirocup.

    tests/programs/dds/benchmark.py BUILD [--seconds S] [--rounds N]

Round trips: raw UDP, ddsperf and a match in real time take turns, each with two processes that
answer, at the same rate. Lateness of ticks: a match at four times real time plays enough ticks for a
quantile of 99.9 %, beside a loop of clock_nanosleep() with the same period and number; the same loop
alone follows each match. At the end eight matches play in real time at once. All durations are in
microseconds; a round trip lasts from a state to the answer. Only the ratios can be compared between
machines, because both of their numbers come from the same minutes. The load of the machine is
printed, too: quote it with the results.
"""

import argparse
import json
import os
import re
import statistics
import subprocess
import sys
import tempfile

PERIOD = 0.033
TICKS = 6000  # in a round of lateness
FACTOR = 4  # of real time, in it
LO = ('<CycloneDDS><Domain Id="any"><General><Interfaces><NetworkInterface name="lo"/></Interfaces>'
      '<AllowMulticast>false</AllowMulticast></General><Discovery><ParticipantIndex>auto</ParticipantIndex>'
      '<MaxAutoParticipantIndex>40</MaxAutoParticipantIndex><Peers><Peer Address="127.0.0.1"/></Peers>'
      '</Discovery></Domain></CycloneDDS>')


def baseline(build, kind, seconds, period=PERIOD):
    return subprocess.Popen([f"{build}/dds/baseline", kind, str(period), str(seconds)],
                            stdout=subprocess.PIPE, text=True)


def result_of(process):
    return json.loads(process.communicate()[0])


def ddsperf(seconds):
    """Returns the medians of the round trips of each second, for both answering processes."""
    environment = dict(os.environ, CYCLONEDDS_URI=LO)
    domain = ["-i", "77", "-u", "-D", str(seconds)]
    pongs = [subprocess.Popen(["ddsperf", *domain, "pong", "waitset"], env=environment,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
             for _ in range(2)]
    said = subprocess.run(["ddsperf", *domain, "ping", f"{1 / PERIOD:.2f}Hz", "size", "1000", "waitset"],
                          env=environment, capture_output=True, text=True, check=False).stdout
    for pong in pongs:
        pong.wait()
    # Each is half a round trip, with its unit.
    units = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3}
    return [2.0 * float(value) * units[unit] for value, unit in re.findall(r" 50% ([0-9.]+)(ns|us|ms)", said)]


class Match:
    """Plays one match between two teams on the network, at a factor of real time."""

    def __init__(self, build, folder, name, seconds, factor=1):
        self.record = f"{folder}/{name}.json"
        self.teams = [subprocess.Popen(
            [f"{build}/mirocup", "join", "--match", name, "--team", colour, "--name", colour,
             f"{build}/house/idle.so"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            for colour in ("blue", "yellow")]
        self.server = subprocess.Popen(
            [f"{build}/mirocup", "match", "--blue", "dds:blue", "--yellow", "dds:yellow", "--match", name,
             "--speed", str(factor), "--half", str(factor * seconds / 2), "--record", self.record],
            stdout=subprocess.DEVNULL)

    def wait(self):
        if self.server.wait() != 0:
            sys.exit("a match has failed")
        for team in self.teams:
            team.wait()
        with open(self.record, encoding="utf-8") as file:
            return json.load(file)


def us(seconds):
    return f"{1e6 * seconds:.0f}"


def median(values):
    return statistics.median(values) if values else float("nan")


def round_trips(build, folder, seconds, rounds):
    udp, dds, ours = [], [], []
    for i in range(rounds):
        udp.append(result_of(baseline(build, "udp", seconds))["p50"])
        dds += ddsperf(seconds)
        record = Match(build, folder, f"benchmark-{i}", seconds).wait()
        ours += [record["network"][team]["answers"]["p50"] for team in ("blue", "yellow")]
    print(f"round trip, median: raw UDP {us(median(udp))}, ddsperf {us(median(dds))}, "
          f"match {us(median(ours))}; match / ddsperf {median(ours) / median(dds):.2f}, "
          f"match / UDP {median(ours) / median(udp):.2f}")


def lateness(build, folder, rounds):
    period = PERIOD / FACTOR
    seconds = TICKS * period
    late = {"match": [], "loop beside it": [], "loop alone": []}
    for i in range(rounds):
        beside = baseline(build, "sleep", seconds, period)
        match = Match(build, folder, f"benchmark-of-lateness-{i}", seconds, FACTOR).wait()
        late["match"].append(match["pace"]["lateness"])
        late["loop beside it"].append(result_of(beside))
        late["loop alone"].append(result_of(baseline(build, "sleep", seconds, period)))
    at = {who: {share: median([x[share] for x in found]) for share in ("p50", "p99", "p999", "longest")}
          for who, found in late.items()}
    for who, found in at.items():
        print(f"lateness of {TICKS} ticks, {who}: 50 % {us(found['p50'])}, 99 % {us(found['p99'])}, "
              f"99.9 % {us(found['p999'])}, longest {us(found['longest'])} "
              f"(99.9 % of the rounds: {', '.join(us(x['p999']) for x in late[who])})")
    print("lateness, 99.9 %: match / " + ", match / ".join(
        f"{who} {at['match']['p999'] / at[who]['p999']:.2f}" for who in ("loop beside it", "loop alone")))


def eight_at_once(build, folder, seconds):
    loop = baseline(build, "sleep", seconds)
    matches = [Match(build, folder, f"benchmark-of-eight-{i}", seconds) for i in range(8)]
    records = [match.wait() for match in matches]
    slept = result_of(loop)
    late = [record["pace"]["lateness"] for record in records]
    missed = sum(record["budget"][team]["late_ticks"] for record in records for team in ("blue", "yellow"))
    ticks = sum(record["ticks"] for record in records)
    print(f"eight matches at once: {ticks} ticks, {missed} without an answer in time; lateness of ticks, 99.9 %: "
          f"{us(median([x['p999'] for x in late]))} (clock_nanosleep beside them {us(slept['p999'])}), "
          f"longest {us(max(x['longest'] for x in late))} ({us(slept['longest'])})")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build")
    parser.add_argument("--seconds", type=float, default=60.0, help="of each round trip and eight")
    parser.add_argument("--rounds", type=int, default=3)
    arguments = parser.parse_args()
    print(f"{os.cpu_count()} cores, load {os.getloadavg()[0]:.2f} at the start")
    with tempfile.TemporaryDirectory() as folder:
        round_trips(arguments.build, folder, arguments.seconds, arguments.rounds)
        lateness(arguments.build, folder, arguments.rounds)
        eight_at_once(arguments.build, folder, arguments.seconds)
    print(f"load {os.getloadavg()[0]:.2f} at the end")


main()
