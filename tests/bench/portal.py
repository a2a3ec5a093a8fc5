#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How calm a portal stays: pages for somebody, for a lecture hall and for a team, without attackers and beside them.

Usage: tests/bench/portal.py BUILD [--seconds 25] [--streams 200] [--halves 600] [--hall 30]

From four addresses come 200 anonymous streams, and 600 requests that are never sent to their end; each that the server closes comes
again at once. 30 viewers of one address have their streams before that; a team hands in a source that compiles for a minute and
follows it. Prints milliseconds of pages, and their ratio to those before the attack. It judges nothing: the attackers compute on
the same processors.
"""
import argparse
import os
import resource
import shutil
import socket
import statistics
import subprocess
import tempfile
import threading
import time

options = argparse.ArgumentParser()
options.add_argument("build")
options.add_argument("--seconds", type=float, default=25.0)
options.add_argument("--streams", type=int, default=200)
options.add_argument("--halves", type=int, default=600)
options.add_argument("--hall", type=int, default=30)
options = options.parse_args()
mirocup = os.path.join(os.path.abspath(options.build), "mirocup")
attackers = [f"127.0.0.{i}" for i in (2, 3, 4, 5)]
source = b"""template <int n> constexpr int sum() { int s = n; for (int i = 0; i < 100000; ++i) s += i % 7; return s; }
template <int n> struct Sums { static constexpr int value = sum<n>() % 2 + Sums<n - 1>::value; };
template <> struct Sums<0> { static constexpr int value = 0; };
int value = Sums<800>::value;
"""


def run(*words):
    return subprocess.run([mirocup, *words], check=True, capture_output=True, text=True).stdout


class Portal:
    def __init__(self, league):
        run("league", "init", league, "--team", "alpha=house:chaser", "--team", "beta=house:keeper", "--half", "20")
        self.token = run("league", "token", league, "alpha").strip()
        self.process = subprocess.Popen([mirocup, "league", "serve", league, "--hand-in", "--at", "0.0.0.0:0"], stdout=subprocess.PIPE,
                                        text=True, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (1024, 4096)))
        self.port = int(self.process.stdout.readline().strip().rstrip("/").rsplit(":", 1)[1])

    def connect(self, address, patience=60):
        end = socket.socket()
        end.settimeout(patience)
        end.bind((address, 0))
        end.connect(("127.0.0.1", self.port))
        return end

    def send(self, address, method, target, token=None, body=b""):
        end = self.connect(address)
        known = f"Authorization: Bearer {token}\r\n" if token else ""
        length = f"Content-Length: {len(body)}\r\n" if body else ""
        end.sendall(f"{method} {target} HTTP/1.1\r\nHost: x\r\n{known}{length}\r\n".encode() + body)
        return end

    def ask(self, *words, **more):
        """Returns the status (0: none) and the seconds until all of the answer is there."""
        begun = time.monotonic()
        received = b""
        try:
            with self.send(*words, **more) as end:
                while part := end.recv(65536):
                    received += part
        except OSError:
            pass
        return int(received[9:12] or 0), time.monotonic() - begun

    def stream(self, *words, **more):
        """Returns an open stream, or nothing if the server gives none."""
        try:
            end = self.send(*words, **more)
            return end if end.recv(4096).startswith(b"HTTP/1.1 200") else None
        except OSError:
            return None


def is_open(end):
    end.setblocking(False)
    try:
        while end.recv(65536):
            pass
        return False
    except BlockingIOError:
        return True
    except OSError:
        return False


def measure(portal):
    pages = {"somebody": ("127.0.0.1", "GET", "/"), "the hall": ("127.0.0.50", "GET", "/table.json"),
             "the team": ("127.0.0.9", "GET", "/api/v1/entries/2", portal.token)}
    told = {name: [] for name in pages}
    end = time.monotonic() + options.seconds
    while time.monotonic() < end:
        for name, words in pages.items():
            told[name].append(portal.ask(*words))
        time.sleep(0.1)
    return told


def p95(times):
    return sorted(times)[int(0.95 * len(times))]


class Halves:
    """Requests that are never sent to their end. One that is closed comes again."""

    def __init__(self, portal, count):
        self.portal, self.came, self.is_over = portal, 0, False
        self.threads = [threading.Thread(target=self.keep, args=(count // 10,)) for _ in range(10)]
        for thread in self.threads:
            thread.start()

    def keep(self, count):
        mine = []
        while not self.is_over:
            while len(mine) < count and not self.is_over:
                try:
                    end = self.portal.connect(attackers[len(mine) % 4], 3)
                    end.sendall(b"GET / HTTP/1.1\r\nHost: x\r\nX: ")
                    mine.append(end)
                    self.came += 1
                except OSError:
                    time.sleep(0.01)
            for end in [one for one in mine if not is_open(one)]:
                end.close()
                mine.remove(end)
            time.sleep(0.02)
        for end in mine:
            end.close()

    def end(self):
        self.is_over = True
        for thread in self.threads:
            thread.join()


def main(folder):
    portal = Portal(os.path.join(folder, "l"))
    print("load of the machine:", os.getloadavg()[0])
    portal.ask("127.0.0.9", "PUT", "/api/v1/entries?name=slow.cpp", token=portal.token, body=source)
    hall = [portal.stream("127.0.0.50", "GET", "/events") for _ in range(options.hall)]
    team = portal.stream("127.0.0.9", "GET", "/api/v1/entries/2/events", token=portal.token)
    calm = measure(portal)
    streams = [None] * options.streams

    def open_streams(first):
        for i in range(first, options.streams, 20):
            streams[i] = portal.stream(attackers[i % 4], "GET", "/events")

    openers = [threading.Thread(target=open_streams, args=(i,)) for i in range(20)]
    for opener in openers:
        opener.start()
    for opener in openers:
        opener.join()
    halves = Halves(portal, options.halves)
    time.sleep(3)
    attacked = measure(portal)
    late = portal.stream("127.0.0.9", "GET", "/api/v1/entries/2/events", token=portal.token)
    print(f"streams of the attackers: {sum(one is not None for one in streams)} opened, "
          f"{sum(one is not None and is_open(one) for one in streams)} open; half requests: {halves.came} came")
    print(f"streams of the hall: {sum(one is not None and is_open(one) for one in hall)} of {options.hall} open; "
          f"of the team: {'open' if team and is_open(team) else 'ended'}, another one: {'given' if late else 'refused'}")
    halves.end()
    for name, told in attacked.items():
        times = [1e3 * seconds for _, seconds in told]
        before = [1e3 * seconds for _, seconds in calm[name]]
        print(f"pages for {name}: {sum(status == 200 for status, _ in told)} of {len(told)}; ms median {statistics.median(times):.1f}, "
              f"p95 {p95(times):.1f}, most {max(times):.1f}; before: {statistics.median(before):.1f}, {p95(before):.1f}, "
              f"{max(before):.1f}; ratio {statistics.median(times) / statistics.median(before):.1f}, {p95(times) / p95(before):.1f}")
    with open(f"/proc/{portal.process.pid}/status") as file:
        print("server:", ", ".join(" ".join(line.split()) for line in file if line.startswith(("VmHWM", "Threads"))))
    print("load of the machine:", os.getloadavg()[0])
    portal.process.terminate()
    portal.process.wait(60)


resource.setrlimit(resource.RLIMIT_NOFILE, (4096, resource.getrlimit(resource.RLIMIT_NOFILE)[1]))
scratch = tempfile.mkdtemp(prefix="mirocup-calm-")
try:
    main(scratch)
finally:
    shutil.rmtree(scratch, ignore_errors=True)
