#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Many teams hand in within a short time while viewers read pages, on this computer only, with real checks.

Usage: tests/programs/handin/load.py BUILD [--teams 200] [--viewers 50] [--seconds 60] [--pause 5] [--kills N] [--patience 600] [--alone] [--format F] [--no-tls]

Prints one JSON object: how many files were sent and taken, what became of them, seconds until the last verdict, times of pages,
memory of the server. --alone first checks the same files without a server, with as many processes as processors, for comparison.
--kills N kills the server, a check or a team's process N times at random moments; a killed server is started again.
Exit code 1 if a file was lost, was answered twice, or got another verdict than it should.
"""
import argparse
import concurrent.futures
import http.client
import json
import os
import random
import resource
import shutil
import signal
import ssl
import statistics
import subprocess
import sys
import tempfile
import threading
import time

options = argparse.ArgumentParser()
options.add_argument("build")
options.add_argument("--teams", type=int, default=200)
options.add_argument("--viewers", type=int, default=50)
options.add_argument("--seconds", type=float, default=60.0)
options.add_argument("--pause", type=float, default=5.0, help="s that a viewer looks at a page, in the mean")
options.add_argument("--kills", type=int, default=0)
options.add_argument("--patience", type=float, default=600.0, help="s after the last file until the last verdict")
options.add_argument("--alone", action="store_true")
options.add_argument("--format", default="double_round_robin", help="of the league: a round robin of n teams has n² / 2 fixtures")
options.add_argument("--no-tls", action="store_true")
options.add_argument("--port", type=int, default=18443)
options.add_argument("--seed", type=int, default=1)
options = options.parse_args()

mirocup = os.path.abspath(os.path.join(options.build, "mirocup"))
house = os.path.abspath(os.path.join(options.build, "house"))
folder = tempfile.mkdtemp(prefix="mirocup-load-")
league = os.path.join(folder, "l")
chance = random.Random(options.seed)


def run(*words):
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def bytes_of(path):
    with open(path, "rb") as file:
        return file.read()


# Three of four files are good; each has bytes of its own behind the library.
def file_of(number):
    kinds = ("chaser", "keeper", "striker", "navigator")
    if number % 4 == 3:
        return f"no library, number {number}".encode(), "refused"
    return bytes_of(os.path.join(house, kinds[number % 4] + ".so")) + str(number).encode(), "accepted"


class Server:
    def __init__(self):
        self.starts = 0
        self.peak = 0
        self.cpu_s = 0.0  # of the server that runs now, without the programs that it starts
        self.checks_cpu_s = 0.0  # of the programs that it started and that have ended
        self.lock = threading.Lock()
        self.start()

    def start(self):
        words = [mirocup, "league", "serve", league, "--hand-in", "--at", str(options.port)]
        if not options.no_tls:
            words += ["--tls", os.path.join(folder, "cert.pem"), os.path.join(folder, "key.pem")]
        self.log = open(os.path.join(folder, "server.log"), "ab")
        self.process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=self.log)
        # One that is killed while it starts is started again by the next who asks for it.
        if not self.process.stdout.readline() and not options.kills:
            raise SystemExit("the server does not start: " + open(self.log.name).read())
        self.starts += 1

    def ensure(self):
        with self.lock:
            if self.process.poll() is not None:
                self.start()

    def watch_memory(self):
        try:
            with open(f"/proc/{self.process.pid}/status") as status:
                for line in status:
                    if line.startswith("VmHWM"):
                        self.peak = max(self.peak, int(line.split()[1]))
            with open(f"/proc/{self.process.pid}/stat") as stat:
                fields = stat.read().rsplit(")", 1)[1].split()
            self.cpu_s = (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
            self.checks_cpu_s = (int(fields[13]) + int(fields[14])) / os.sysconf("SC_CLK_TCK")
        except OSError:
            pass

    def processes(self):
        pids = [self.process.pid]
        for pid in pids:
            try:
                with open(f"/proc/{pid}/task/{pid}/children") as children:
                    pids += [int(child) for child in children.read().split()]
            except OSError:
                pass
        return pids


def connect():
    if options.no_tls:
        return http.client.HTTPConnection("127.0.0.1", options.port, timeout=60)
    return http.client.HTTPSConnection("127.0.0.1", options.port, timeout=60, context=context)


def ask(method, path, token=None, body=None):
    connection = connect()
    try:
        headers = {"Authorization": "Bearer " + token} if token else {}
        connection.request(method, path, body=body, headers=headers)
        reply = connection.getresponse()
        return reply.status, reply.read()
    finally:
        connection.close()


run(mirocup, "league", "init", league, "--team", "one=house:chaser", "--team", "two=house:keeper", "--half", "20", "--format", options.format)
run("openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-days", "2",
    "-subj", "/CN=127.0.0.1", "-addext", "subjectAltName=IP:127.0.0.1", "-keyout", os.path.join(folder, "key.pem"),
    "-out", os.path.join(folder, "cert.pem"))
tokens = {}
for i in range(options.teams):
    team = f"team{i}"
    tokens[team] = run(mirocup, "league", "token", league, team).strip()

# Made once: it costs more than a request.
context = ssl.create_default_context(cafile=os.path.join(folder, "cert.pem"))
report = {"teams": options.teams, "viewers": options.viewers, "pause_s": options.pause, "seconds": options.seconds}
if options.alone:
    def check(number):
        path = os.path.join(folder, f"{number}.so")
        with open(path, "wb") as file:
            file.write(file_of(number)[0])
        # As the server starts it.
        subprocess.run([mirocup, "check", path, "--half", "20", "--json", "--steps", "--record", os.path.join(folder, f"{number}.json")],
                       capture_output=True)
        os.remove(path)

    def cpu_of_children():
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        return used.ru_utime + used.ru_stime

    begun, cpu_before = time.monotonic(), cpu_of_children()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(check, range(options.teams)))
    report["alone_s"] = round(time.monotonic() - begun, 2)
    report["alone_cpu_s"] = round(cpu_of_children() - cpu_before, 1)

server = Server()
begun, begun_at = time.monotonic(), time.time()
own_cpu_s = time.process_time()
over = threading.Event()
taken = {}    # (team, entry): the verdict that it should get
latency = []  # s
lost = []     # replies that were none
verdicts = {}  # (team, entry): (state, s)
waits = {}    # (team, entry): s from sending to the verdict


# Sends one file, again and again while the server is being started.
def hand_in(number, at):
    team = f"team{number}"
    body, expected = file_of(number)
    time.sleep(max(0.0, begun + at - time.monotonic()))
    sent = time.monotonic()
    while True:
        try:
            status, reply = ask("PUT", "/api/v1/entries?name=team.so", tokens[team], body)
        except (OSError, http.client.HTTPException):
            time.sleep(0.2)
            server.ensure()
            continue
        if status == 503:
            time.sleep(0.2)
            continue
        if status != 202:
            lost.append((team, status, reply.decode(errors="replace")))
            return
        entry = json.loads(reply)["entry"]
        taken[team, entry] = expected
        break
    while time.monotonic() - begun < options.seconds + options.patience:
        try:
            status, reply = ask("GET", f"/api/v1/entries/{entry}", tokens[team])
            state = json.loads(reply).get("state")
        except (OSError, ValueError, http.client.HTTPException):
            time.sleep(0.3)
            server.ensure()
            continue
        if state in ("accepted", "refused", "void"):
            verdicts[team, entry] = (state, time.monotonic() - begun)
            waits[team, entry] = time.monotonic() - sent
            return
        # As mirocup hand-in asks.
        time.sleep(min(10.0, 0.5 + 0.1 * json.loads(reply).get("before", 0)))


def view(number):
    paths = ("/", "/table.json", "/hand-in", "/teams/one.html")
    while not over.is_set():
        path = paths[number % len(paths)]
        number += 1
        asked = time.monotonic()
        try:
            status, _ = ask("GET", path)
            if status == 200:
                latency.append(time.monotonic() - asked)
        except (OSError, http.client.HTTPException):
            pass
        over.wait(options.pause * (0.5 + chance.random()))


def kill_some():
    killed = {"server": 0, "below": 0}
    for _ in range(options.kills):
        if over.wait(chance.random() * 2.0 * options.seconds / max(1, options.kills)):
            break
        pids = server.processes()
        pid = pids[0] if chance.random() < 0.25 else chance.choice(pids)
        killed["server" if pid == pids[0] else "below"] += 1
        try:
            os.kill(pid, signal.SIGKILL)
        except OSError:
            pass
        server.process.poll()
        time.sleep(0.05)
        server.ensure()
    report["kills"] = killed


def watch_memory():
    while not over.wait(0.2):
        server.watch_memory()


helpers = [threading.Thread(target=view, args=(i,)) for i in range(options.viewers)]
helpers += [threading.Thread(target=kill_some), threading.Thread(target=watch_memory)]
for helper in helpers:
    helper.start()
teams = [threading.Thread(target=hand_in, args=(i, chance.random() * options.seconds)) for i in range(options.teams)]
for team in teams:
    team.start()
for team in teams:
    team.join()
over.set()
for helper in helpers:
    helper.join()
server.process.send_signal(signal.SIGTERM)
server.process.wait()

answers = {}
numbers = set()
with open(os.path.join(league, "hand-ins.jsonl")) as book:
    for line in map(json.loads, book):
        key = line["team"], line["entry"]
        if line["kind"] == "answer":
            answers.setdefault(key, []).append(line["state"])
        else:
            numbers.add(key)
wrong = {f"{key[0]} {key[1]}": answers.get(key) for key, state in taken.items() if answers.get(key) != [state]}
# Taken, but the reply was lost with the server; the client sent the same bytes again and got the same number.
more = [key for key in numbers if key not in taken]
report.update({
    "taken": len(taken), "not_taken": lost, "numbered": len(numbers), "numbered_for_nobody": len(more),
    "wrong": wrong, "server_starts": server.starts,
    # When the server had written it, and when its team had read it, which asks from time to time.
    "last_answer_s": round(os.stat(os.path.join(league, "hand-ins.jsonl")).st_mtime - begun_at, 2),
    "last_verdict_s": round(max((s for _, s in verdicts.values()), default=0.0), 2),
    "wait_s": {"median": round(statistics.median(waits.values()), 2), "most": round(max(waits.values()), 2)} if waits else None,
    "pages": len(latency),
    "page_ms": {"median": round(1e3 * statistics.median(latency), 1),
                "p95": round(1e3 * sorted(latency)[int(0.95 * len(latency))], 1),
                "most": round(1e3 * max(latency), 1)} if latency else None,
    "cpu_s": {"server": round(server.cpu_s, 1), "checks": round(server.checks_cpu_s, 1),
              "clients": round(time.process_time() - own_cpu_s, 1)},
    "server_peak_mib": round(server.peak / 1024, 1)})
print(json.dumps(report, indent=1))
bad = bool(wrong or lost or more or len(taken) != options.teams or len(verdicts) != options.teams)
if bad:
    print("kept: " + folder, file=sys.stderr)
else:
    shutil.rmtree(folder)
sys.exit(1 if bad else 0)
