#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Two teams hand in the worst files that we know, again and again, while a third one waits for the answers to good ones.

Usage: tests/programs/handin/worst.py BUILD [--files 10] [--pause 5] [--jobs 2] [--half 60] [--port 18473]

The bad files crash with a thousand tables of symbols, sleep or compute while they are loaded, compute in each tick as long as they may,
and are sources that take a compiler as long as they can. Prints one JSON object: s from sending to the answer of each good file, what
the bad ones were answered, the most checks of one team at once, and the load of the machine. Exit code 1 if a good file was not
accepted, or if a team had two checks at once. Nothing else should run: the times are measured on the clock.
"""
import argparse
import http.client
import json
import os
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time

options = argparse.ArgumentParser()
options.add_argument("build")
options.add_argument("--files", type=int, default=10, help="good files")
options.add_argument("--pause", type=float, default=5.0, help="s between an answer and the next good file")
options.add_argument("--jobs", type=int, default=2)
options.add_argument("--half", type=float, default=60.0, help="s of a half in the league: a check plays legs of that length")
options.add_argument("--port", type=int, default=18473)
options = options.parse_args()

mirocup = os.path.abspath(os.path.join(options.build, "mirocup"))
headers = os.path.abspath(os.path.join(options.build, "include"))
folder = tempfile.mkdtemp(prefix="mirocup-worst-")
league = os.path.join(folder, "l")

TEAM = """
#include "mirocup/strategy.h"
#include <time.h>
static void burn(double seconds) {
  struct timespec begin, now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &begin);
  do clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  while ((now.tv_sec - begin.tv_sec) + 1e-9 * (now.tv_nsec - begin.tv_nsec) < seconds);
}
static void wait(int seconds) {
  struct timespec time = {seconds, 0};
  nanosleep(&time, 0);
}
static volatile int* nowhere;
static int deep(int n) { return n == 0 ? *nowhere : deep(n - 1) + 1; }
__attribute__((constructor)) static void loading(void) { LOADING; }
static void* create(const mirocup_setup* setup) { (void)setup; return (void*)&nowhere; }
static void decide(void* team, const mirocup_observation* now, mirocup_command* command) {
  (void)team; (void)command; (void)burn; (void)wait; (void)deep;
  const int tick = now->tick;
  TICK;
}
const mirocup_strategy* mirocup_entry(void) {
  static const mirocup_strategy entry = {MIROCUP_ABI_VERSION, sizeof entry, "worst", create, decide, 0, 0};
  return &entry;
}
"""
SLOW_SOURCE = """
template <int N, int M> struct S { static constexpr long v = S<N - 1, M>::v + S<N - 1, M + 1>::v; };
template <int M> struct S<0, M> { static constexpr long v = M; };
constexpr long loop(long n) { long s = 0; for (long i = 0; i < n; ++i) s += i % 7; return s; }
template <long N> constexpr long many = loop(200000 + N) + many<N - 1>;
template <> constexpr long many<0> = 0;
long a = many<800>;
"""


def run(*words):
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def library(loading="", tick=""):
    source, path = os.path.join(folder, "team.c"), os.path.join(folder, "team.so")
    with open(source, "w") as file:
        file.write(TEAM.replace("LOADING", loading).replace("TICK", tick))
    run("gcc", "-O1", "-fno-optimize-sibling-calls", "-shared", "-fPIC", "-w", "-I", headers, "-o", path, source)
    with open(path, "rb") as file:
        return file.read()


# Sections that all claim the same table of a million symbols, which no address is in.
def with_many_tables(library, sections=1022):
    data = bytearray(library)
    data += bytes(-len(data) % 16)
    count = min((31 << 20) - len(data) - sections * 64, 24 << 20) // 24
    symbols = len(data)
    data += struct.pack("<IBBHQQ", 1, 2, 0, 1, 0xFFFFFFFFFFF00000, 1) * count
    texts = len(data)
    data += b"\0evil\0" + bytes(10)
    at = len(data)
    data += bytes(64) + struct.pack("<IIQQQQIIQQ", 0, 3, 0, 0, texts, 16, 0, 0, 1, 0)
    for i in range(sections - 2):
        data += struct.pack("<IIQQQQIIQQ", 0, 2 if i % 2 else 11, 0, 0, symbols, count * 24, 1, 0, 8, 24)
    data[40:48] = struct.pack("<Q", at)
    data[58:64] = struct.pack("<HHH", 64, sections, 1)
    return bytes(data)


run(mirocup, "league", "init", league, "--team", "one=house:chaser", "--team", "two=house:keeper", "--half", str(options.half))
tokens = {team: run(mirocup, "league", "token", league, team).strip() for team in ("alpha", "beta", "gamma")}
bad = {
    "many_tables.so": with_many_tables(library(tick="deep(20)")),
    "many_tables_late.so": with_many_tables(library(tick="if (tick > 2000) deep(20)")),
    "sleeps_while_loaded.so": library(loading="wait(9)"),
    "burns_while_loaded.so": library(loading="burn(3.5)"),
    "burns_ticks.so": library(tick="burn(1.2e-3)"),
    "burns_some_ticks.so": library(tick="if (tick % 500 == 0) burn(0.4)"),
    "slow.cpp": SLOW_SOURCE.encode(),
}
with open(os.path.join(os.path.abspath(options.build), "house", "striker.so"), "rb") as file:
    good = file.read()

server = subprocess.Popen([mirocup, "league", "serve", league, "--hand-in", "--at", str(options.port), "--jobs", str(options.jobs)],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
if not server.stdout.readline():
    raise SystemExit("the server does not start: " + server.stderr.read())
told = []
threading.Thread(target=lambda: told.extend(server.stderr), daemon=True).start()


def ask(method, path, token, body=None):
    connection = http.client.HTTPConnection("127.0.0.1", options.port, timeout=60)
    try:
        connection.request(method, path, body=body, headers={"Authorization": "Bearer " + token})
        reply = connection.getresponse()
        return reply.status, json.loads(reply.read())
    finally:
        connection.close()


over = threading.Event()
answers = {}  # of bad files, by name
most_at_once = {}


# Keeps as many files waiting as a team may.
def attack(team):
    waiting, number, before = {}, 0, set()
    while not over.wait(0.3):
        name = list(bad)[number % len(bad)]
        if len(waiting) < 4:
            # Each is another file.
            body = bad[name] + (b"//" if name.endswith(".cpp") else b"") + str(number).encode()
            status, reply = ask("PUT", f"/api/v1/entries?name={name}", tokens[team], body)
            if status == 202:
                waiting[reply["entry"]] = name
                number += 1
        running = set()
        for entry in list(waiting):
            state = ask("GET", f"/api/v1/entries/{entry}", tokens[team])[1]
            if state["state"] in ("compiling", "checking"):
                running.add(entry)
            if state["state"] in ("accepted", "refused", "void"):
                answers.setdefault(waiting.pop(entry), []).append(f"{state['state']}: {str(state.get('reason') or state.get('message'))[:120]}")
        # The states are not of one moment: what two looks have seen ran at once.
        most_at_once[team] = max(len(running & before), most_at_once.get(team, 0))
        before = running


attackers = [threading.Thread(target=attack, args=(team,), daemon=True) for team in ("alpha", "beta")]
for attacker in attackers:
    attacker.start()
time.sleep(10)
waits, wrong = [], []
for i in range(options.files):
    sent = time.monotonic()
    status, reply = ask("PUT", "/api/v1/entries?name=good.so", tokens["gamma"], good + str(i).encode())
    if status != 202:
        wrong.append(reply)
        break
    while True:
        state = ask("GET", f"/api/v1/entries/{reply['entry']}", tokens["gamma"])[1]
        if state["state"] in ("accepted", "refused", "void"):
            break
        time.sleep(0.1)
    waits.append(round(time.monotonic() - sent, 2))
    if state["state"] != "accepted":
        wrong.append(state)
    time.sleep(options.pause)
over.set()
server.send_signal(signal.SIGTERM)
server.wait()
print(json.dumps({"wait_s": waits, "longest_s": max(waits, default=None), "wrong": wrong, "checks_of_a_team_at_once": most_at_once,
                  "gave_way": sum("gives way" in line for line in told), "stopped": sum("was stopped after" in line for line in told),
                  "bad_answers": answers, "load": os.getloadavg()}, indent=1))
shutil.rmtree(folder)
sys.exit(1 if wrong or max(most_at_once.values(), default=0) > 1 else 0)
