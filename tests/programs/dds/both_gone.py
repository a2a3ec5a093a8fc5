#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
#
# Teams that vanish in the middle of legs: killed, stopped (SIGSTOP) or cut off from the network; both at once or one alone; in
# real time and in lockstep. Nobody wins a leg from which both have vanished. One that vanishes alone has lost. If the server
# itself is cut off, the leg is void.
#
# Usage: both_gone.py BUILD TIMES [HOW...]; HOW: kill stop cut host alone (default: all). Prints a line for each kind and fails if
# one leg ends otherwise. Exit 77: this system allows no hosts (network namespaces). `both_gone.py build 30` takes ten minutes.
#
# Each process has a host of its own on one switch: the server 10.77.0.1, blue 10.77.0.2, yellow 10.77.0.3.
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

HOSTS = {"server": "10.77.0.1", "blue": "10.77.0.2", "yellow": "10.77.0.3"}
AT_ONCE = 3  # legs that are played beside each other
LIMIT = 2  # s


def enter_namespace():
    """Starts this program again in a network of its own."""
    if os.environ.get("MIROCUP_IN_NAMESPACE") == "yes":
        return
    unshare = ["unshare"] + ([] if os.geteuid() == 0 else ["--map-root-user"]) + ["--net", "--mount"]
    if shutil.which("ip") is None or subprocess.run(unshare + ["true"], stderr=subprocess.DEVNULL, check=False).returncode != 0:
        print("skipped: network namespaces (unshare, ip) cannot be had here")
        sys.exit(77)
    os.environ["MIROCUP_IN_NAMESPACE"] = "yes"
    os.execvp("unshare", unshare + [sys.executable] + sys.argv)


def shell(*lines):
    for line in lines:
        subprocess.run(line.split(), check=True)


def build_network():
    os.makedirs("/run/netns", exist_ok=True)
    shell("mount -t tmpfs none /run/netns", "ip link set lo up", "ip link add switch type bridge", "ip link set switch up")
    for host, address in HOSTS.items():
        shell(
            f"ip netns add {host}",
            f"ip link add {host} type veth peer name eth0 netns {host}",
            f"ip link set {host} master switch",
            f"ip link set {host} up",
            f"ip -n {host} link set lo up",
            f"ip -n {host} address add {address}/24 dev eth0",
            f"ip -n {host} link set eth0 up",
        )


def cable(host, state):
    shell(f"ip link set {host} {state}")


class Leg:
    """A match server and its two teams."""

    def __init__(self, build, folder, name, speed):
        self.record = os.path.join(folder, name + ".json")
        self.log = os.path.join(folder, name + ".log")
        mirocup = os.path.join(build, "mirocup")
        match = [mirocup, "match", "--blue", "dds:blue", "--yellow", "dds:yellow", "--match", name, "--interface", HOSTS["server"]]
        match += ["--speed", speed, "--half", "6000", "--away-limit", str(LIMIT), "--record", self.record]
        self.server = self.start("server", match)
        self.teams = {}
        for colour in ("blue", "yellow"):
            join = [mirocup, "join", "--match", name, "--server", HOSTS["server"], "--team", colour, "--name", colour]
            self.teams[colour] = self.start(colour, join + [os.path.join(build, "house/striker.so")])

    def start(self, host, command):
        with open(self.log, "a", encoding="utf-8") as log:
            return subprocess.Popen(["ip", "netns", "exec", host] + command, stdout=log, stderr=log)

    def is_played(self):
        with open(self.log, encoding="utf-8", errors="replace") as log:
            return log.read().count(" plays ") >= 2

    def end(self):
        """Waits for the server; returns its exit code and how the leg ended."""
        try:
            code = self.server.wait(60)
        except subprocess.TimeoutExpired:
            return None, {"end": "it does not end"}
        with open(self.record, encoding="utf-8") as record:
            return code, json.load(record)["result"]

    def clean_up(self):
        for process in [self.server, *self.teams.values()]:
            if process.poll() is None:
                process.send_signal(signal.SIGCONT)
                process.kill()
            process.wait()


def vanish(how, legs, colours):
    if how == "host":
        cable("server", "down")
    elif how == "cut":
        for colour in colours:
            cable(colour, "down")
    else:
        for leg in legs:
            for colour in colours:
                leg.teams[colour].send_signal(signal.SIGKILL if how == "kill" else signal.SIGSTOP)


def is_right(how, colours, code, result):
    if how == "host":
        return code == 5 and result["end"] == "void"
    if len(colours) == 2:
        faults = [fault["code"] for fault in result.get("faults", [])]
        return code == 0 and result["end"] == "double_forfeit" and result["winner"] is None and faults == ["disconnected"] * 2
    winner = "yellow" if colours == ["blue"] else "blue"
    return code == 0 and result["end"] == "forfeit" and result["winner"] == winner


def play(build, folder, how, speed, colours, number):
    """Plays legs beside each other from which these teams vanish; returns how many ended wrongly."""
    legs = [Leg(build, folder, f"{how}-{speed}-{'-'.join(colours)}-{number}-{i}", speed) for i in range(AT_ONCE)]
    wrong = 0
    try:
        begin = time.monotonic()
        while not all(leg.is_played() for leg in legs):
            if time.monotonic() > begin + 60:
                raise RuntimeError("the teams do not come")
            time.sleep(0.02)
        time.sleep(random.uniform(0.3, 0.8))
        vanish(how, legs, colours)
        for leg in legs:
            code, result = leg.end()
            if not is_right(how, colours, code, result):
                wrong += 1
                with open(leg.log, encoding="utf-8", errors="replace") as log:
                    print(f"  wrong: exit {code}, {json.dumps(result)}\n{log.read()}")
    finally:
        for host in HOSTS:
            cable(host, "up")
        for leg in legs:
            leg.clean_up()
    return wrong


def main():
    build, times, kinds = os.path.realpath(sys.argv[1]), int(sys.argv[2]), sys.argv[3:]
    enter_namespace()
    build_network()
    folder = tempfile.mkdtemp()
    random.seed(1)
    cases = [(how, ["blue", "yellow"]) for how in ("kill", "stop", "cut", "host")]
    cases += [("kill", ["blue"]), ("stop", ["yellow"]), ("cut", ["blue"]), ("cut", ["yellow"])]
    bad = 0
    try:
        for how, colours in cases:
            if kinds and (how if len(colours) == 2 else "alone") not in kinds:
                continue
            for speed in ("1", "max"):
                batches = -(-times // AT_ONCE)
                # Now blue vanishes first, now yellow.
                orders = [colours if batch % 2 == 0 else colours[::-1] for batch in range(batches)]
                wrong = sum(play(build, folder, how, speed, order, number) for number, order in enumerate(orders))
                print(f"{how} {' and '.join(colours)}, --speed {speed}: {wrong} of {batches * AT_ONCE} ended wrongly", flush=True)
                bad += wrong
    finally:
        shutil.rmtree(folder)
    sys.exit(1 if bad else 0)


main()
