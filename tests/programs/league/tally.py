#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Computes the numbers of a nightly league again, from its journal alone, and compares them with the digests and the grades.

Usage: tests/programs/league/tally.py LEAGUE [GRADES.csv]

Shares no code with the program. Says what was compared; exit code 1 and a line for each number that differs. Legs that
a team left open when it withdrew, which its opponents win, are not in the journal, so they count as differences.
"""
import csv
import json
import math
import os
import sys

VIRTUAL_LEGS_OF_REPLACED = 0.01  # the same of an entry that its team has replaced
VIRTUAL_LEGS = 0.5  # each player draws half a leg against the mean, and half a leg in the league is a draw
NO_STRENGTH = -1e9  # of a team without a leg that counts


class Tally:
    """The league after the first `lines` lines of its journal."""

    def __init__(self, folder, lines=None):
        self.lines = journal(folder)[:lines]
        config = read(folder, "league.json")
        self.teams = [team["name"] for team in config["teams"]]
        self.legs_of_fixture = config["format"].get("legs", 2) if isinstance(config["format"], dict) else 2
        self.entries, self.legs, self.nights = {}, {}, 0
        self.withdrawn = set()
        undone = {line["line"] for line in self.lines if line["kind"] == "undo"}
        for line in self.lines:
            self.take(line, line["n"] in undone)
        self.players = {team: {"points": 0, "legs": 0, "strength": NO_STRENGTH} for team in self.teams}
        for leg in self.legs.values():
            for own, other in (("home", "away"), ("away", "home")):
                if leg["entry"][own] == self.entries.get(leg[own]):
                    player = self.players[leg[own]]
                    player["legs"] += 1
                    ahead = leg["goals"][own] - leg["goals"][other]
                    player["points"] += 3 if ahead > 0 else 1 if ahead == 0 else 0
        self.fit()

    def take(self, line, is_undone):
        kind = line["kind"]
        if kind == "join":
            self.teams.append(line["team"])
        if kind in ("entry", "night"):
            self.nights += kind == "night"
            for entry in line["entries"] if kind == "night" else [line]:
                self.entries[entry["team"]] = entry["entry"]
                self.annul(entry["team"])
        if kind == "withdraw" and not is_undone:
            self.withdrawn.add(line["team"])
            if line["results"] == "annul":
                self.legs = {key: leg for key, leg in self.legs.items() if line["team"] not in (leg["home"], leg["away"])}
        if kind not in ("leg", "void", "ruling") or is_undone:
            return
        key = line["fixture"], line["leg"]
        if kind == "leg":
            self.legs[key] = {"home": line["home"], "away": line["away"], "goals": line["score"], "night": self.nights,
                              "entry": {own: self.entries[line[own]] for own in ("home", "away")}}
        elif kind == "void":
            self.legs.pop(key, None)
        elif key in self.legs:
            self.legs[key]["goals"] = line["score"]

    def annul(self, team):
        """A fixture of which legs are left counts for nothing when one of its teams plays with another entry."""
        halves = [key for key, leg in self.legs.items()
                  if team in (leg["home"], leg["away"]) and sum(fixture == key[0] for fixture, _ in self.legs) < self.legs_of_fixture]
        for key in halves:
            del self.legs[key]

    def fit(self):
        """Strengths after Bradley and Terry, draws after Davidson, by steps along the gradient. Each entry is a player."""
        def player(leg, own):
            return leg[own], leg["entry"][own]

        pairs = {}
        for leg in self.legs.values():
            home, away = player(leg, "home"), player(leg, "away")
            ahead = leg["goals"]["home"] - leg["goals"]["away"]
            if home > away:
                home, away, ahead = away, home, -ahead
            wins, draws, legs = pairs.get((home, away), (0, 0, 0))
            pairs[home, away] = wins + (ahead > 0), draws + (ahead == 0), legs + 1
        present = {team: (team, self.entries.get(team)) for team in self.teams if self.players[team]["legs"] > 0}
        x = {name: 0.0 for pair in [present.values(), *pairs] for name in pair}
        v = 0.0
        virtual = {name: VIRTUAL_LEGS if name in present.values() else VIRTUAL_LEGS_OF_REPLACED for name in x}
        for _ in range(20_000):
            wins_of = {name: 1.0 / (1.0 + math.exp(-value)) for name, value in x.items()}
            slope = {name: virtual[name] * (1.0 - 2.0 * wins_of[name]) for name in x}
            bend = {name: 2.0 * virtual[name] * wins_of[name] * (1.0 - wins_of[name]) for name in x}
            slope_v = VIRTUAL_LEGS * (1.0 - 2.0 / (1.0 + math.exp(math.log(2.0) - v)))
            for (home, away), (wins, draws, legs) in pairs.items():
                win, loss, draw = math.exp(x[home]), math.exp(x[away]), math.exp(v + 0.5 * (x[home] + x[away]))
                whole = win + loss + draw
                surplus = wins + 0.5 * draws - legs * (win + 0.5 * draw) / whole
                slope[home] += surplus
                slope[away] -= surplus
                score = (win + 0.5 * draw) / whole
                for name in (home, away):
                    bend[name] += legs * ((win + 0.25 * draw) / whole - score * score)
                slope_v += draws - legs * draw / whole
            for name, value in slope.items():
                x[name] += max(-0.5, min(0.5, 0.5 * value / bend[name]))
            v += slope_v / max(1, sum(legs for _, _, legs in pairs.values()))
            if max(map(abs, slope.values()), default=0.0) < 1e-6 and abs(slope_v) < 1e-3:
                break
        mean = sum(x[name] for name in present.values()) / max(1, len(present))
        for team, name in present.items():
            self.players[team]["strength"] = 400.0 * (x[name] - mean) / math.log(10.0)

    def told_strength(self, team):
        strength = self.players[team]["strength"]
        return None if strength == NO_STRENGTH else strength

    def house_beaten(self, folder, team):
        """The house teams against which the present entry has won more legs than it has lost."""
        beaten = []
        for other in read(folder, "league.json")["teams"]:
            ahead = 0
            for leg in self.legs.values():
                for own, opponent in (("home", "away"), ("away", "home")):
                    if (leg[own], leg[opponent]) == (team, other["name"]) and leg["entry"][own] == self.entries[team]:
                        difference = leg["goals"][own] - leg["goals"][opponent]
                        ahead += (difference > 0) - (difference < 0)
            if ahead > 0 and other["entry"].startswith("house:"):
                beaten.append(other["name"])
        return beaten


def read(folder, name):
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        return json.load(file)


def journal(folder):
    with open(os.path.join(folder, "journal.jsonl"), encoding="utf-8") as file:
        return [json.loads(line) for line in file]


def nights_of(lines):
    """For each night how many lines the journal had before it, and how many when its digests were written."""
    found = []
    for index, line in enumerate(lines):
        if line["kind"] == "night":
            found.append([index, index + 1])
        elif found and (line["kind"] == "leg" or line["kind"] == "void" and line["cause"] != "ruling"
                        or line["kind"] == "pause" and line.get("cause") == "strikes"):
            found[-1][1] = index + 1
    return found


class Comparison:
    def __init__(self):
        self.numbers, self.wrong = 0, []

    def expect(self, what, told, computed, tolerance=0.0):
        self.numbers += 1
        same = told == computed if not tolerance or told is None or computed is None else abs(told - computed) <= tolerance
        if not same:
            self.wrong.append(f"{what}: told {told}, computed {computed}")


def compare_digests(folder, comparison, night=None):
    """Compares the digests of a night (default: of all nights). Returns their number."""
    count = 0
    for number, (begin, end) in enumerate(nights_of(journal(folder)), 1):
        if night is not None and number != night:
            continue
        before, now = Tally(folder, begin), Tally(folder, end)
        digests = {team: read(folder, f"nights/{number}/{team}.json") for team in now.entries if team not in now.withdrawn}
        for team, told in digests.items():
            count += 1
            where = f"night {number}, {team}"
            own_legs = [leg for leg in now.legs.values() if leg["night"] == number and team in (leg["home"], leg["away"])]
            ahead, losses = [], []
            for leg in own_legs:
                own, other = ("home", "away") if leg["home"] == team else ("away", "home")
                ahead.append(leg["goals"][own] - leg["goals"][other])
                if ahead[-1] < 0:
                    losses.append((leg[other], f"{leg['goals'][own]}:{leg['goals'][other]}"))
            comparison.expect(where + ": won", told["won"], sum(a > 0 for a in ahead))
            comparison.expect(where + ": drawn", told["drawn"], sum(a == 0 for a in ahead))
            comparison.expect(where + ": lost", told["lost"], sum(a < 0 for a in ahead))
            # A score may be followed by that of a shoot-out.
            told_losses = sorted((loss["to"], loss["score"].split()[0]) for loss in told["losses"])
            comparison.expect(where + ": lost to", told_losses, sorted(losses))
            comparison.expect(where + ": entry", told["entry"], now.entries[team])
            comparison.expect(where + ": new entry", told["new_entry"], before.entries.get(team) != now.entries[team])
            comparison.expect(where + ": strength", told["strength"], now.told_strength(team), 1.0)
            comparison.expect(where + ": rank only of who played", told["rank"] is None, now.players[team]["legs"] == 0)
            has_before = team in before.players and before.players[team]["legs"] > 0
            comparison.expect(where + ": strength before", told["strength_before"],
                              before.players[team]["strength"] if has_before else None, 1.0)
            comparison.expect(where + ": at most three moments", len(told["moments"]) <= 3, True)
            for other, told_other in digests.items():
                if told["rank"] and told_other["rank"] and told["rank"] < told_other["rank"]:
                    ahead = now.players[team]["strength"] - now.players[other]["strength"]
                    comparison.expect(where + f": before {other}", ahead > -1.5, True)
    return count


def compare_grades(folder, text, comparison):
    """Compares what `mirocup league grades` prints. Returns the number of its rows."""
    tally = Tally(folder)
    rows = [row for row in csv.DictReader(text.splitlines()) if row["state"] != "not in the league"]
    for row in rows:
        player = tally.players[row["team"]]
        comparison.expect(f"grades, {row['team']}: points", int(row["points"]), player["points"])
        comparison.expect(f"grades, {row['team']}: legs", int(row["played"]), player["legs"])
        comparison.expect(f"grades, {row['team']}: no rank", row["rank"] == "", player["legs"] == 0)
        strength = int(row["strength"]) if row["strength"] else None
        comparison.expect(f"grades, {row['team']}: strength", strength, tally.told_strength(row["team"]), 1.0)
        if strength is not None:
            comparison.expect(f"grades, {row['team']}: interval", int(row["strength_low"]) < strength < int(row["strength_high"]), True)
        comparison.expect(f"grades, {row['team']}: house", row["house_beaten"].split(),
                          tally.house_beaten(folder, row["team"]))
    # Teams that have withdrawn come after those that play, and teams without a leg that counts come last.
    ranked = [row["team"] for row in rows if tally.players[row["team"]]["legs"] > 0]
    comparison.expect("grades: who has no rank comes last", [row["team"] for row in rows][:len(ranked)], ranked)
    strengths = [tally.players[team]["strength"] - (1e6 if team in tally.withdrawn else 0.0) for team in ranked]
    comparison.expect("grades: order", all(a - b > -1.5 for a, b in zip(strengths, strengths[1:])), True)
    comparison.expect("grades: teams", sorted(row["team"] for row in rows), sorted(tally.teams))
    return len(rows)


def main():
    if len(sys.argv) not in (2, 3):
        raise SystemExit(__doc__)
    folder = sys.argv[1]
    comparison = Comparison()
    digests = compare_digests(folder, comparison)
    rows = 0
    if len(sys.argv) == 3:
        with open(sys.argv[2], encoding="utf-8") as file:
            rows = compare_grades(folder, file.read(), comparison)
    for line in comparison.wrong:
        print(line)
    print(f"{digests} digests, {rows} rows of grades: {comparison.numbers} values compared, {len(comparison.wrong)} differ")
    return 1 if comparison.wrong else 0


if __name__ == "__main__":
    sys.exit(main())
