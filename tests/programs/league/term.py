#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A term of a class, three weeks of nights, with a newer program in the middle: eight teams, their hand-ins over the
network, bad entries, an appeal, grades. The clock of the programs is moved, so it takes about ten minutes.

Usage: tests/programs/league/term.py BUILD OLDER [--folder DIR] [--half 20] [--days 21]

BUILD and OLDER are build folders with mirocup, mirocup-league and their hosts. OLDER plays; it has to be a version that plays
otherwise (core/golden_hash.txt), and that knows `league nightly`. BUILD is refused in the middle, and publishes at the end. --folder keeps the league, its pages and its grades there.

Prints a line for each day. Stops with what was not as it should be, exit code 1. tally.py computes the numbers of all digests and of
the grades again, from the journal alone.
"""
import argparse
import filecmp
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import tally

options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
options.add_argument("build")
options.add_argument("older")
options.add_argument("--folder")
options.add_argument("--half", type=float, default=20.0, help="seconds of a half")
options.add_argument("--days", type=int, default=21)
options = options.parse_args()

builds = {"newer": os.path.abspath(options.build), "older": os.path.abspath(options.older)}
home = os.path.abspath(options.folder) if options.folder else tempfile.mkdtemp(prefix="mirocup-term-")
league = os.path.join(home, "term")
students = ["alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta"]
upgrade_day, release_day, last_day = 10, 15, options.days - 1

MINE = r"""
#include "mirocup/skills/attack.hpp"
#include "mirocup/strategy.hpp"

#include <cstdlib>

using namespace mirocup::strategy;

class Mine : public Team {
 public:
  using Team::Team;
  void decide(const Observation& now, Command& command) override {
    CRASH
    const Point goal{setup().half_length, 0.0};
    command.wheels[0] = keep_goal(setup(), now, now.own[0]);
    command.wheels[1] = must_kick_off(now) ? kick_off(setup(), now.own[1])
                        : is_stuck(now)    ? free_ball(setup(), now, now.own[1])
                                           : attack_ball(setup(), now, 1, open_corner(setup(), now));
    for (int i = 2; i < now.robots; ++i) {
      const Point post{now.ball_x - WAIT - 0.2 * (i - 2), -0.5 * now.ball_y};
      const Point legal = make_way(setup(), now, keep_out(setup(), i, inside(setup(), post)));
      command.wheels[i] = drive_clear(setup(), now, now.own[i], legal);
    }
    avoid_own_goals(setup(), now, command);
    keep_laws(setup(), now, command);
  }
};

MIROCUP_EXPORT_TEAM(Mine, "mine")
"""


class Failed(Exception):
    pass


def expect(holds, what):
    if not holds:
        raise Failed(what)


def has(text, part):
    expect(part in text, f"{part!r} is not in {text!r}")


def read(*parts):
    with open(os.path.join(*parts), encoding="utf-8") as file:
        return file.read()


class Clock:
    """The day of the term: noon (UTC) for all programs that are started from then on."""

    def __init__(self):
        self.begun = int(time.time())
        self.day = 0

    def environment(self):
        offset = self.day * 86_400 + 43_200 - self.begun % 86_400
        return {**os.environ, "MIROCUP_CLOCK_OFFSET": str(offset)}


clock = Clock()


def run(words, *codes):
    """What a command prints; its exit code is one of `codes`, by default 0."""
    done = subprocess.run(words, capture_output=True, text=True, env=clock.environment())
    code = " or ".join(map(str, codes or (0,)))
    expect(done.returncode in (codes or (0,)), f"{' '.join(words)}: exit code {done.returncode}, expected {code}: {done.stdout}{done.stderr}")
    return done.stdout + done.stderr


class Host:
    """The lecturer with one version of the program, and its server."""

    def __init__(self, version):
        self.program = os.path.join(builds[version], "mirocup")
        self.server = None
        self.url = ""

    def ask(self, command, *more, code=0):
        return run([self.program, "league", command, league, *more], *(code if isinstance(code, tuple) else (code,)))

    def open_desk(self):
        words = [self.program, "league", "serve", league, "--hand-in", "--at", "0"]
        with open(os.path.join(home, "server.log"), "ab") as log:
            self.server = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=log, text=True, env=clock.environment())
        self.url = self.server.stdout.readline().strip().rstrip("/")
        expect(self.url.startswith("http"), "the server does not start: " + read(home, "server.log"))

    def close_desk(self):
        if self.server:
            self.server.terminate()
            expect(self.server.wait() == 0, "the server ended badly: " + read(home, "server.log"))
        self.server = None

    def hand_in(self, team, file, code=0):
        return run([self.program, "hand-in", self.url, "--token-file", os.path.join(home, team + ".token"), file], code)


def source(team, wait, crash=""):
    path = os.path.join(home, f"{team}{wait}.cpp")
    with open(path, "w", encoding="utf-8") as file:
        file.write(MINE.replace("WAIT", str(wait)).replace("CRASH", crash))
    return path


def library(name, version, more=b""):
    with open(os.path.join(builds[version], "house", name + ".so"), "rb") as file:
        data = file.read()
    path = os.path.join(home, f"{name}{len(more)}.so")
    with open(path, "wb") as file:
        file.write(data + more)
    return path


def table_of_page():
    """The teams in the order of the front page, with their points and legs, as either program writes them."""
    rows = re.findall(r'<tr data-team="\d+"><td class="number">\d+</td><th scope="row"><a href="teams/([^"]+)\.html">.*?'
                      r'(?:<td class="number points">[\d.]+</td>)?<td class="number (?:points|roomy)">(\d+)</td>'
                      r'<td class="number(?: mid)?">(\d+)</td>',
                      read(league, "site/index.html").split("</table>")[0])
    return [(team, int(points), int(legs)) for team, points, legs in rows]


def expect_pages(night):
    """The pages show that night, all links lead somewhere, and the table is that of the journal."""
    site = os.path.join(league, "site")
    has(read(site, "night.html"), f"Night {night}")
    now = tally.Tally(league, tally.nights_of(tally.journal(league))[night - 1][1])
    rows = table_of_page()
    expect(len(rows) == len(now.teams), f"the table has {len(rows)} of {len(now.teams)} teams")
    for team, points, legs in rows:
        player = now.players[team]
        expect((points, legs) == (player["points"], player["legs"]), f"index.html, {team}: {points}, {legs}; computed {player}")
    for folder, _, names in os.walk(site):
        for name in names:
            if not name.endswith(".html"):
                continue
            for link in re.findall(r'(?:href|src)="([^"#:]+)(?:#[^"]*)?"', read(folder, name)):
                expect(os.path.exists(os.path.join(folder, link)), f"{folder}/{name}: {link} is not there")


class Term:
    def __init__(self):
        self.host = Host("older")
        self.comparison = tally.Comparison()
        self.digests = 0
        self.grades = 0
        self.nights = 0
        self.shown = None  # the last night that the public sees; None: every one

    # ---- what happens on single days

    def first_day(self):
        teams = [{"name": team, "entry": "submitted"} for team in students]
        teams += [{"name": team, "entry": "house:" + team} for team in ("chaser", "keeper")]
        with open(os.path.join(home, "league.json"), "w", encoding="utf-8") as file:
            json.dump({"schema": "mirocup/league/1", "title": "A term", "zone": "Europe/Berlin", "seed": 9,
                       "format": {"kind": "nightly", "opponents": 0}, "rules": {"half_s": options.half}, "teams": teams}, file)
        self.host.ask("init", "--config", os.path.join(home, "league.json"))
        with open(os.path.join(home, "class.csv"), "w", encoding="utf-8") as file:
            file.write("team,display,members\nalpha,Zoë & Co,Zoë Brandt; Max Öz\nbeta,Löwen <3,Ada\n")
        self.host.ask("team", "--csv", os.path.join(home, "class.csv"))
        for line in self.host.ask("token", "--all", "--csv").splitlines()[1:]:
            team, _, token = line.split(",")
            with open(os.path.join(home, team + ".token"), "w", encoding="utf-8") as file:
                file.write(token + "\n")
        self.host.open_desk()
        has(self.host.hand_in("alpha", source("alpha", 0.45)), "accepted")
        has(self.host.hand_in("beta", source("beta", 0.3)), "accepted")
        self.host.hand_in("gamma", library("keeper", "older", b"gamma"))
        self.host.hand_in("delta", library("navigator", "older", b"two of them"))
        self.host.hand_in("epsilon", library("navigator", "older", b"two of them"))
        self.host.hand_in("zeta", library("idle", "older", b"zeta"))
        bad = os.path.join(home, "bad.so")
        with open(bad, "wb") as file, open(library("chaser", "older"), "rb") as whole:
            file.write(whole.read(3000))
        has(self.host.hand_in("eta", bad, 1), "not accepted")
        entries = self.host.ask("status", "--entries")
        for part in ("theta: nothing handed in", "eta: refused", "the same file as epsilon", 'alpha "Zoë & Co": accepted'):
            has(entries, part)
        return "6 hand-ins, 1 refused, 1 missing; 2 alike"

    def second_day(self):
        self.host.open_desk()
        self.host.hand_in("eta", source("eta", 0.6))
        return "eta hands in a good one"

    def late_team(self):
        self.host.open_desk()
        self.host.hand_in("theta", library("striker", "older", b"theta"))
        self.host.hand_in("zeta", source("zeta", 0.35))
        return "theta for the first time, zeta anew"

    def bad_entry(self):
        # The check does not see it: no goal falls in its legs.
        self.host.open_desk()
        crash = "if (now.tick > 600 && now.own_score + now.opponent_score > 0) std::abort();"
        self.host.hand_in("gamma", source("gamma", 0.5, crash))  # in the check no goal stands so late
        return "gamma hands in what crashes ten seconds into a leg that has a goal"

    def resume(self):
        """The team was paused by three legs that it lost by its own fault. It plays what is left with a better entry."""
        faults = [line for line in tally.journal(league) if line["kind"] == "leg" and line["fault"]]
        expect(len(faults) >= 3 and all(line["fault"]["team"] == "gamma" for line in faults), f"faults: {faults}")
        expect(self.has_paused_team(), "gamma is not paused")
        left = re.search(r"(\d+) legs of the league are not decided", read(league, f"nights/{self.nights}/report.txt"))
        self.host.open_desk()
        self.host.hand_in("gamma", source("gamma", 0.4))
        self.host.ask("resume", "gamma", "--reason", "it has a new entry", "--by", "A. Host")
        return f"gamma: {len(faults)} legs lost by crashes, paused; resumed with a new entry, {left.group(1)} legs left"

    def appeal(self):
        line = [line for line in tally.journal(league) if line["kind"] == "leg" and not line["fault"]][-1]
        record = os.path.join(league, line["record"])
        run([self.host.program, "verify", record])
        run([self.host.program, "rerun", record])
        decided = [line["fixture"], "--leg", str(line["leg"]), "--reason", "the goal was valid", "--by", "A. Host"]
        has(self.host.ask("rule", *decided, "--score", "2:1", "--dry-run"), "was ")
        self.host.ask("rule", *decided, "--score", "1:2")
        number = len(json.loads(self.host.ask("decisions", "--json"))["decisions"])
        self.host.ask("undo", str(number), "--reason", "home and away were mixed up", "--by", "A. Host")
        self.host.ask("rule", *decided, "--score", "2:1")
        return f"appeal: {line['fixture']} leg {line['leg']} verified, rerun, ruled 2:1 (once undone)"

    def upgrade(self):
        lines = len(tally.journal(league))
        newer = Host("newer")
        has(newer.ask("nightly", code=2), "Continue with mirocup")
        has(newer.ask("start", code=2), "Continue with mirocup")
        expect(len(tally.journal(league)) == lines, "a program that is refused writes no line")
        self.nightly()
        self.host.open_desk()
        self.host.hand_in("beta", source("beta", 0.55))
        return "upgrade: the newer program is refused, the older one goes on"

    def verify(self):
        whole = len([name for name in os.listdir(os.path.join(league, "records")) if name.endswith(".json")])
        said = self.host.ask("verify", code=(0, 4))  # 4: the older version plays otherwise and has no module
        if f"{whole} of {whole} records reproduced" not in said:
            has(said, "another version of the game")
        return f"verify: {said.splitlines()[-1]}"

    def void_leg(self):
        line = [line for line in tally.journal(league) if line["kind"] == "leg"][-1]
        self.host.ask("void", line["fixture"], "--leg", str(line["leg"]), "--reason", "a cable was loose")
        return f"{line['fixture']} leg {line['leg']} is void"

    def newcomer(self):
        void = self.void_leg()
        token = self.host.ask("token", "iota").splitlines()[0]
        with open(os.path.join(home, "iota.token"), "w", encoding="utf-8") as file:
            file.write(token + "\n")
        self.host.open_desk()
        self.host.hand_in("iota", library("tactician", "older", b"iota"))
        self.host.ask("team", "iota", "--display", "Étoile")
        return f"{void}; iota comes to the course"

    def release(self):
        self.shown = self.nights
        self.host.ask("release", "--level", "teams", "--through", f"r{self.shown}", "--reason", "the rest is shown on Friday")
        return f"the public sees the nights until {self.nights}"

    def last(self):
        self.host.ask("freeze", "--reason", "last day")
        self.host.open_desk()
        has(self.host.hand_in("alpha", source("alpha", 0.2), 2), "frozen")
        return "entries are frozen"

    def has_paused_team(self):
        lines = [line["kind"] for line in tally.journal(league) if line["kind"] in ("pause", "resume")]
        return bool(lines) and lines[-1] == "pause"

    # ---- every day

    def nightly(self, *more):
        report = self.host.ask("nightly", *more, code=(0, 1))
        self.nights += 1
        # Legs are left only where a team is paused.
        has(report, "is paused" if self.has_paused_team() else "; 0 legs of the league are not decided")
        lines = tally.journal(league)
        begun = [line for line in lines if line["kind"] == "night"]
        expect(len(begun) == self.nights, f"day {clock.day}: {len(begun)} nights were begun, not {self.nights}")
        has(report, f"night {self.nights}, ")
        expect(read(league, f"nights/{self.nights}/report.txt") in report, "report.txt is not the report")
        self.digests += tally.compare_digests(league, self.comparison, self.nights)
        expect(not self.comparison.wrong, "; ".join(self.comparison.wrong))
        has(self.host.ask("nightly", *more, code=(0, 1)), f"night {self.nights} continues")
        expect(len(tally.journal(league)) == len(lines), "the same night again writes nothing")
        return report

    def day(self, number, events):
        clock.day = number
        begun = time.monotonic()
        before = len([line for line in tally.journal(league) if line["kind"] == "leg"]) if number else 0
        told = events.get(number, lambda: "")()
        if number != upgrade_day:
            self.nightly()
        self.host.close_desk()
        expect_pages(self.shown or self.nights)
        if self.shown:
            hidden = os.path.join(league, f"site/rounds/r{self.shown + 1}.html")
            expect(not os.path.exists(hidden), hidden + " shows a night that is held back")
        legs = len([line for line in tally.journal(league) if line["kind"] == "leg"]) - before
        print(f"{number:3}  {self.nights:5}  {legs:4}  {time.monotonic() - begun:5.1f} s  {told}", flush=True)

    def end(self):
        host = self.host = Host("newer")
        self.shown = None
        host.ask("release", "--level", "all", "--reason", "it is Friday")
        host.ask("close", "--reason", "the term is over")
        has(host.ask("nightly", code=2), "closed")
        host.ask("publish")
        expect_pages(self.nights)
        has(read(league, "site/index.html"), "Champion")
        has(read(league, "site/index.html"), "Zoë &amp; Co")
        text = host.ask("grades")
        with open(os.path.join(home, "grades.csv"), "w", encoding="utf-8") as file:
            file.write(text)
        self.grades = tally.compare_grades(league, text, self.comparison)
        expect(not self.comparison.wrong, "; ".join(self.comparison.wrong))
        print(f"\n{self.digests} digests and {self.grades} rows of grades, {self.comparison.numbers} values: all as tally.py "
              "computes them from the journal")
        print(self.verify())
        self.restored()
        print("\n" + host.ask("decisions").rstrip())
        print("\n" + text.rstrip())

    def restored(self):
        """A backup of the league makes the same pages by the program that played it."""
        copy = os.path.join(home, "copy/term")
        run([self.host.program, "league", "backup", league, copy])
        run([Host("older").program, "league", "publish", copy])
        run([Host("older").program, "league", "verify", copy])
        differing = []

        def compare(pair):
            differing.extend(pair.left_only + pair.right_only + pair.diff_files)
            for below in pair.subdirs.values():
                compare(below)

        compare(filecmp.dircmp(os.path.join(league, "site"), os.path.join(copy, "site")))
        expect(not differing, f"pages of the copy differ: {differing[:5]}")
        print("the copy of the league is verified, and makes the same pages")

    def whole(self):
        events = {0: self.first_day, 1: self.second_day, 3: self.late_team, 8: self.appeal, upgrade_day: self.upgrade,
                  12: self.bad_entry, 13: self.resume, 14: self.newcomer,
                  release_day: self.release, last_day: self.last}
        print("day  night  legs     time  what happened")
        for number in range(options.days):
            self.day(number, events)
        self.end()


def main():
    os.makedirs(home, exist_ok=True)
    if os.path.exists(league):
        raise SystemExit(league + " is there already")
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(130))  # so that the server ends, too
    begun = time.monotonic()
    term = Term()
    try:
        term.whole()
    except Failed as failure:
        print(f"\nday {clock.day}: {failure}\nkept: {home}", file=sys.stderr)
        return 1
    finally:
        if term.host.server:
            term.host.server.kill()
    print(f"\n{options.days} days in {(time.monotonic() - begun) / 60.0:.1f} minutes")
    if not options.folder:
        shutil.rmtree(home)
    return 0


sys.exit(main())
